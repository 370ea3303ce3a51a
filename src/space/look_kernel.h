// SPDX-License-Identifier: Apache-2.0
// What the bodies that a robot sees mean for it (docs/space.md, "Cost").
#ifndef AVO_SPACE_LOOK_KERNEL_H
#define AVO_SPACE_LOOK_KERNEL_H

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "certificate/clearance_kernel.h"
#include "space/passing_kernel.h"

AVO_BEGIN_KERNELS

/// Returns whether A surely needs no constraint for a body: see collect_constraints(). The test is
/// that of are_clear(), for the longest braking of all bodies.
template <typename Real>
AVO_KERNEL auto is_clear(const PackLook<Real>& a, const PackSeen<Real>& seen,
                         const PackBody<Real>& body, const space::Viewer& look) {
  const Real zero(0.0), one(1.0), distance = sqrt(seen.squared);
  const Real lengths = a.lengths + one_norm(seen.p) + body.contact;
  const Real inflated = body.contact + rounding_margin<Real, 3>(lengths, a.intervals,
                                                                min(body.share, one - body.share));
  const Real steps = one + a.full_steps;
  const Real drift = Real(kFarther * look.law.time_step) * steps * norm(seen.v);
  const Real left = distance - drift;
  const Real towards = min(max(zero, drift - dot(seen.p, a.direction)), left);
  const Real against = select(body.wash > zero, left, towards);
  const Real gap = body.share * (left - (inflated + body.wash) - Real(0x1p-27) * distance);
  const auto clear = (left > zero) & ((gap - a.most_aside) * left > against * a.most_ahead);
  return body.are_equal & body.brake_alike & clear;
}

/// What bodies ahead add to the traffic, see Traffic::ahead. It is a multiple of 2^-40, so that the
/// sum of many is exact, in any order.
template <typename Real>
AVO_KERNEL Real traffic_of(const PackLook<Real>& a, const PackSeen<Real>& seen,
                           const PackBody<Real>& body, Real speed) {
  const Real zero(0.0), one(1.0), two(2.0), whole(0x1.8p12), distance = sqrt(seen.squared);
  const Real per_distance = one / select(distance > zero, distance, one);
  const Real in_front = -dot(seen.p, a.preferred) * per_distance * a.per_front;
  const Real closes = one - dot(seen.p, seen.v) * per_distance * a.per_closing;
  const Real rests = two - speed * a.per_slow;
  // the miss distance, in contact distances, where both keep their velocities
  const Real squared = dot(seen.v, seen.v);
  const Real time = max(-dot(seen.p, seen.v), zero) / select(squared > zero, squared, one);
  const Real miss = norm(seen.p + time * seen.v);
  const Real meets = min(max(two - miss / body.contact, zero), one);
  const Real weight = meets * body.defers * (one - distance * a.per_range) *
                      min(max(max(closes, rests), zero), one) * min(in_front, one);
  const auto counts = (distance < a.traffic_range) & (in_front > zero);
  return select(counts, (weight + whole) - whole, zero);
}

template <typename Real>
AVO_KERNEL void push(const PackSeen<Real>& seen, const PackBody<Real>& body, Real number,
                     decltype(Real() < Real()) chosen, const space::Viewer& look,
                     const space::Bodies& bodies, space::SpacePairs& pairs) {
  const std::size_t at = pairs.count;
  Vec<Real, 3> p = seen.p;
  if (look.robot.downwash > 0.0 || bodies.has_downwash) {
    // p from the ball of the pair's capsule that the relative course comes nearest to
    const Real zero(0.0), squared = dot(seen.v, seen.v);
    const auto moves = squared > zero;
    const Real nearest =
        select(moves, max(-dot(p, seen.v), zero) / select(moves, squared, Real(1.0)), zero);
    const Real height = p.z + min(nearest, Real(look.horizon.end().time)) * seen.v.z;
    const Real below = lookup(bodies.downwash.data(), seen.place);
    p.z = p.z - min(max(height, -below), Real(look.robot.downwash));
    chosen = chosen & (dot(p, p) > zero);
  }
  const auto put = [&](Real value, std::vector<double>& column) {
    return store_chosen(chosen, value, &column[at]);
  };
  put(p.x, pairs.p[0]), put(p.y, pairs.p[1]), put(p.z, pairs.p[2]);
  put(seen.v.x, pairs.v[0]), put(seen.v.y, pairs.v[1]), put(seen.v.z, pairs.v[2]);
  put(body.contact, pairs.radius), put(body.reach, pairs.reach), put(body.share, pairs.share);
  pairs.count += put(number, pairs.number);
}

template <typename Real>
AVO_KERNEL void push(Real place, std::uint32_t lanes, std::vector<std::uint32_t>& places) {
  if (lanes == 0) return;
  alignas(64) double numbers[Real::kLanes];
  place.store(numbers);
  for (; lanes != 0; lanes &= lanes - 1)
    places.push_back(static_cast<std::uint32_t>(numbers[std::countr_zero(lanes)]));
}

/// The pairs of these bodies that can refuse a candidate, where they are as in the plane: see
/// collect_constraints().
template <typename Real, bool kUniform>
AVO_KERNEL void examine_near(const space::Viewer& look, const space::Bodies& bodies,
                             std::span<const double> places, std::vector<space::NearBody>& near) {
  const space::Robot& robot = look.robot;
  const PackRobot<Real, 3> self{constant<Real>(robot.position),
                                constant<Real>(robot.velocity),
                                robot.radius,
                                robot.max_acceleration,
                                robot.max_braking.value_or(robot.max_acceleration),
                                robot.priority,
                                constant<Real, 3>(look.braking),
                                robot.vertical,
                                robot.downwash};
  for (std::size_t first = 0; first < places.size(); first += Real::kLanes) {
    const std::size_t count = std::min(Real::kLanes, places.size() - first);
    const auto counted = lane_numbers<Real>() < Real(static_cast<double>(count));
    const Real place = select(counted, Real::load(&places[first]), Real(0.0));
    const auto field = [&](const std::vector<double>& column) {
      return lookup(column.data(), place);
    };
    const auto setting = [&](const std::vector<double>& column) {
      return kUniform ? Real(column[0]) : field(column);
    };
    const auto vector = [&](const std::array<std::vector<double>, 3>& columns) {
      return Vec<Real, 3>{field(columns[0]), field(columns[1]), field(columns[2])};
    };
    const PackRobot<Real, 3> other{
        vector(bodies.position),
        vector(bodies.velocity),
        setting(bodies.radius),
        setting(bodies.max_acceleration),
        setting(bodies.max_braking),
        setting(bodies.priority),
        {.profile = {field(bodies.speed), field(bodies.decrement), field(bodies.full_steps)},
         .increment = field(bodies.increment),
         .direction = vector(bodies.direction),
         .length = field(bodies.length),
         .reach = field(bodies.reach),
         .intervals = field(bodies.intervals)},
        setting(bodies.vertical),
        setting(bodies.downwash)};
    const PackPair<Real, 3> pair = pair_of(self, other, look.law);
    const PackClearance<Real> clearance = clearance_of(self, pair, other, look.law);
    const auto apart =
        pair.distance - (self.braking.reach + pair.b.reach) > pair.inflated + pair.error;
    const auto clear = clearance.gap > clearance.against * Real(look.deviation.most_ahead) +
                                           Real(look.deviation.most_aside);
    alignas(64) double gaps[Real::kLanes], against[Real::kLanes];
    alignas(64) double inflated[Real::kLanes], share[Real::kLanes];
    clearance.gap.store(gaps), clearance.against.store(against);
    pair.inflated.store(inflated), pair.share.store(share);
    for (std::uint32_t lanes = bits(counted & !(apart | clear)); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      const auto at = static_cast<std::uint32_t>(places[first + lane]);
      near.push_back(
          {at, bodies.number[at], gaps[lane], against[lane], inflated[lane], share[lane]});
    }
  }
}

/// What a body may matter for.
template <typename Real>
struct PackMatters {
  decltype(Real() < Real()) near, beside, ahead;  // constraints, nearly contact, traffic
};
template <typename Real>
AVO_KERNEL PackMatters<Real> what_matters(const PackLook<Real>& a, const PackSeen<Real>& seen,
                                          const PackBody<Real>& body, const space::Viewer& look) {
  const Real zero(0.0), least(look.certified ? 0.0 : std::numeric_limits<double>::infinity());
  const auto far = body.are_equal & (seen.squared > body.far_squared);
  return {seen.counted & !far & (seen.squared >= least),
          seen.counted & (seen.squared < body.beside_squared),
          seen.counted & (seen.squared < a.traffic_squared) & (dot(seen.p, a.preferred) < zero) &
              !stays_beyond(seen, body.meets_squared)};
}

/// Puts those side by side that may matter for more than a half-space.
template <typename Real, bool kUniform>
AVO_KERNEL void find_close(const PackLook<Real>& a, const space::Viewer& look,
                           const space::Bodies& bodies, space::Looked& looked) {
  const SeenPlaces places(looked.close);
  std::size_t count = 0;
  for_all<Real, kUniform>(
      a, look, bodies, looked.seen,
      [&](const auto& seen, const auto& body, const auto&) __attribute__((always_inline)) {
        const PackMatters<Real> matters = what_matters(a, seen, body, look);
        const auto chosen = matters.near | matters.beside | matters.ahead;
        if (kChoosesSlowly<Real> && !any(chosen)) return;
        count += places.put(chosen, seen.p, seen.v, seen.place, count);
      });
  looked.close.count = count;
}

template <typename Real, bool kUniform>
AVO_KERNEL void examine_close(const PackLook<Real>& a, const space::Viewer& look,
                              const space::Bodies& bodies, space::Looked& looked) {
  Real ahead(0.0);
  std::size_t count = 0;
  double* places = looked.places.data();
  for_all<Real, kUniform>(
      a, look, bodies, looked.close,
      [&](const auto& seen, const auto& body, const auto& field) __attribute__((always_inline)) {
        const PackMatters<Real> matters = what_matters(a, seen, body, look);
        if (!kChoosesSlowly<Real> || any(matters.near)) {
          const auto chosen = matters.near & !is_clear(a, seen, body, look);
          count += store_chosen(chosen, seen.place, places + count);
        }
        if (any(matters.beside)) push(seen.place, bits(matters.beside), looked.beside);
        if (!kChoosesSlowly<Real> || any(matters.ahead))
          ahead = ahead +
                  select(matters.ahead, traffic_of(a, seen, body, field(bodies.speed)), Real(0.0));
      });
  looked.ahead = sum_of(ahead), looked.count = count;
}

/// See pairs_that_cut() and, with a velocity, pairs_without().
template <typename Real, bool kUniform>
AVO_KERNEL void find_pairs(const space::Viewer& look, const Vec3* velocity,
                           const space::Bodies& bodies, space::Looked& looked) {
  const PackLook<Real> a(look, bodies);
  const bool has_wash = look.robot.downwash > 0.0 || bodies.has_downwash;
  const Real farthest(look.farthest_squared), last_number(look.farthest_number);
  const Vec<Real, 3> change =
      constant<Real>(velocity != nullptr ? *velocity - look.robot.velocity : Vec3{});
  const Real length = norm(change);
  for_all<Real, kUniform>(
      a, look, bodies, looked.seen,
      [&](const auto& seen, const auto& body, const auto& field) __attribute__((always_inline)) {
        auto chosen = seen.counted & (seen.squared > Real(0.0));
        if (!has_wash) {
          if (velocity != nullptr) {
            chosen = chosen & !is_passed_by(a, seen, body, length);
            if (!any(chosen)) return;
          }
          const PackContained<Real> inside = contained(a, seen, body, change);
          chosen = chosen & !inside.everything;
          if (velocity != nullptr) chosen = chosen & !inside.velocity;
        }
        if (!any(chosen)) return;
        const Real number = field(bodies.number);
        chosen = chosen & ((seen.squared < farthest) |
                           ((seen.squared <= farthest) & (number <= last_number)));
        push(seen, body, number, chosen, look, bodies, looked.pairs);
      });
}
template <typename Real>
void find_pairs(const space::Viewer& look, const Vec3* velocity, const space::Bodies& bodies,
                space::Looked& looked) {
  looked.pairs.count = 0;
  if (looked.seen.count == 0) return;
  if (bodies.is_uniform)
    find_pairs<Real, true>(look, velocity, bodies, looked);
  else
    find_pairs<Real, false>(look, velocity, bodies, looked);
}

template <typename Real, bool kUniform>
AVO_KERNEL void examine_seen(const space::Viewer& look, const space::Bodies& bodies,
                             space::Looked& looked) {
  const PackLook<Real> a(look, bodies);
  find_close<Real, kUniform>(a, look, bodies, looked);
  examine_close<Real, kUniform>(a, look, bodies, looked);
  const auto places = std::span<const double>(looked.places).first(looked.count);
  if (look.is_plain(bodies)) return examine_near<Real, kUniform>(look, bodies, places, looked.near);
  for (const double place : places) {
    const auto at = static_cast<std::uint32_t>(place);
    looked.near.push_back({at, bodies.number[at]});
  }
}

/// Sorts out what the bodies that are seen mean for A.
template <typename Real>
void examine_seen(const space::Viewer& look, const space::Bodies& bodies, space::Looked& looked) {
  looked.ahead = 0.0;
  if (looked.seen.count == 0) return;
  looked.count = 0;
  if (bodies.is_uniform)
    examine_seen<Real, true>(look, bodies, looked);
  else
    examine_seen<Real, false>(look, bodies, looked);
}

AVO_END_KERNELS

#endif  // once per pass
