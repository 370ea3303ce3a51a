// SPDX-License-Identifier: Apache-2.0
// The lanes of look_at(), and the braking of bodies (docs/space.md, "Leaving out early").
#ifndef AVO_SPACE_LOOK_KERNEL_H
#define AVO_SPACE_LOOK_KERNEL_H

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "certificate/admission_kernel.h"
#include "core/share_kernel.h"
#include "planner/rules/arrival.h"
#include "space/look.h"

AVO_BEGIN_KERNELS

/// See space::fill_braking().
template <typename Real>
void fill_braking(const StepLaw& law, std::size_t first, std::size_t last, space::Bodies& bodies) {
  for (std::size_t k = first; k < last; k += Real::kLanes) {
    const auto load = [k](const std::vector<double>& column) { return Real::load(&column[k]); };
    const auto store = [k](Real value, std::vector<double>& column) { value.store(&column[k]); };
    const PackBraking<Real, 3> b =
        braking_of(load_vector<Real, 3>(bodies.velocity, k), load(bodies.max_acceleration),
                   load(bodies.max_braking), load(bodies.vertical), law);
    store_vector(b.direction, bodies.direction, k);
    store(b.profile.speed, bodies.speed), store(b.profile.decrement, bodies.decrement);
    store(b.profile.full_steps, bodies.full_steps), store(b.increment, bodies.increment);
    store(b.length, bodies.length), store(b.reach, bodies.reach);
    store(b.intervals, bodies.intervals), store(error_of(b, law), bodies.error);
  }
}

/// The values of a look in all lanes.
template <typename Real>
struct PackLook {
  Vec<Real, 3> position, velocity, direction, way;
  Real radius, acceleration, braking, priority, downwash;
  Real reach, full_steps, intervals, lengths;
  Real most_ahead, most_aside;
  Real end_time, end_lag, gain, change, speed;  // of half-spaces
  Real range_squared, traffic_range;

  AVO_KERNEL explicit PackLook(const space::Look& look)
      : position(constant<Real>(look.robot.position)),
        velocity(constant<Real>(look.robot.velocity)),
        direction(constant<Real>(look.braking.direction)),
        way(constant<Real>(look.robot.preferred_velocity)),
        radius(look.robot.radius),
        acceleration(look.robot.max_acceleration),
        braking(look.robot.max_braking.value_or(look.robot.max_acceleration)),
        priority(look.robot.priority),
        downwash(look.robot.downwash),
        reach(look.braking.reach),
        full_steps(look.braking.profile.full_steps),
        intervals(look.braking.intervals),
        lengths(one_norm(position) + radius + reach + downwash),
        most_ahead(look.deviation.most_ahead),
        // gaps are not known to bound anything else
        most_aside(look.law.is_exact() && look.robot.vertical == 1.0
                       ? look.deviation.most_aside
                       : std::numeric_limits<double>::infinity()),
        end_time(look.horizon.end().time),
        end_lag(look.horizon.end().lag),
        gain(look.horizon.end().gain),
        // a normal is no longer than this in the robot's own space
        change(std::max(look.robot.vertical, 1.0) * look.control_time *
               look.robot.max_acceleration),
        speed(std::max(look.robot.vertical, 1.0) * look.robot.max_speed),
        range_squared(look.range * look.range),
        traffic_range(look.traffic_range) {}
};

/// A body as A sees it.
template <typename Real>
struct PackSeen {
  Vec<Real, 3> p, v;
  Real squared, distance, contact, wash;
  Real share;  // see reciprocal_share()
  // equal priorities, with which the share is that of the room as well; and equal braking
  decltype(Real() < Real()) are_equal, brake_alike;
};

/// Returns whether A surely needs no constraint for a body: see refuses_nothing(). The tests are
/// those of are_far() and are_clear(), with the body's braking at hand.
template <typename Real>
AVO_KERNEL auto can_ignore(const PackLook<Real>& a, const PackSeen<Real>& seen, std::size_t k,
                           const StepLaw& law, const space::Bodies& bodies) {
  const auto load = [k](const std::vector<double>& column) { return Real::load(&column[k]); };
  const Real zero(0.0), one(1.0), rounding(kFarther);
  const Real reach = load(bodies.reach);
  const Real lengths = a.lengths + (one_norm(load_vector<Real, 3>(bodies.position, k)) +
                                    load(bodies.radius) + reach + load(bodies.downwash));
  const Real intervals = max(a.intervals, load(bodies.intervals));
  const Real inflated = seen.contact + rounding_margin<Real, 3>(lengths, intervals,
                                                                min(seen.share, one - seen.share));
  const auto far =
      seen.distance > rounding * (inflated + a.reach + reach + seen.wash + load(bodies.error));
  const Real steps = one + max(a.full_steps, load(bodies.full_steps));
  const Real drift = Real(kFarther * law.time_step) * steps * norm(seen.v);
  const Real left = seen.distance - drift;
  const Real towards = min(max(zero, drift - dot(seen.p, a.direction)), left);
  const Real against = select(seen.wash > zero, left, towards);
  const Real gap = seen.share * (left - (inflated + seen.wash) - Real(0x1p-27) * seen.distance);
  const auto clear = (left > zero) & ((gap - a.most_aside) * left > against * a.most_ahead);
  return seen.are_equal & (far | (seen.brake_alike & clear));
}

/// Returns whether the half-space of a pair surely contains all that A can choose. It is decided
/// for half-spaces that touch the obstacle at the end of the horizon (docs/half_plane.md, lemma 2).
template <typename Real>
AVO_KERNEL auto contains_all(const PackLook<Real>& a, const PackSeen<Real>& seen) {
  const Real rounding(kFarther), beyond(1e-9);  // m/s, more than what programs tolerate
  const Vec<Real, 3> x = seen.p + a.end_time * seen.v, y = seen.p + a.end_lag * seen.v;
  const Real length = norm(x), least = rounding * seen.contact * length;
  const auto touches_at_end =
      (seen.distance > rounding * seen.contact) & (dot(seen.p, x) > least) & (dot(x, y) > least);
  const Real lift = seen.share * (seen.contact - length);  // [α h g] m
  const auto keeps_change = lift < -(a.gain * (rounding * a.change + beyond));
  const auto keeps_speed = dot(x, a.velocity) * a.gain + lift * length <
                           -(length * a.gain * (rounding * a.speed + beyond));
  return touches_at_end & (keeps_change | keeps_speed);
}

/// Returns whether a body may be traffic: see look_around().
template <typename Real>
AVO_KERNEL auto is_traffic(const PackLook<Real>& a, const PackSeen<Real>& seen) {
  const Real zero(0.0), rounding(kFarther);
  const auto ahead = (seen.distance < a.traffic_range) & (dot(seen.p, a.way) < zero);
  const auto beside = seen.distance < rounding * (Real(1.0 + kRoom) * seen.contact + seen.wash);
  return ahead | beside;
}

template <typename Real>
AVO_KERNEL void push(const PackSeen<Real>& seen, decltype(Real() < Real()) chosen, std::size_t k,
                     const space::Look& look, const space::Bodies& bodies,
                     space::SpacePairs& pairs) {
  const std::size_t at = pairs.count;
  Vec<Real, 3> p = seen.p;
  if (look.robot.downwash > 0.0 || bodies.has_downwash) {
    // p from the ball of the pair's capsule that the relative course comes nearest to
    const Real zero(0.0), squared = dot(seen.v, seen.v);
    const auto moves = squared > zero;
    const Real nearest =
        select(moves, max(-dot(p, seen.v), zero) / select(moves, squared, Real(1.0)), zero);
    const Real height = p.z + min(nearest, Real(look.horizon.end().time)) * seen.v.z;
    p.z = p.z - min(max(height, -Real::load(&bodies.downwash[k])), Real(look.robot.downwash));
    chosen = chosen & (dot(p, p) > zero);
  }
  const auto put = [&](Real value, std::vector<double>& column) {
    return store_chosen(chosen, value, &column[at]);
  };
  const Real reach = Real(look.control_time) *
                     (Real(look.robot.max_acceleration) + Real::load(&bodies.max_acceleration[k]));
  put(p.x, pairs.p[0]), put(p.y, pairs.p[1]), put(p.z, pairs.p[2]);
  put(seen.v.x, pairs.v[0]), put(seen.v.y, pairs.v[1]), put(seen.v.z, pairs.v[2]);
  put(seen.contact, pairs.radius), put(reach, pairs.reach), put(seen.share, pairs.share);
  pairs.count += put(Real::load(&bodies.number[k]), pairs.number);
}

AVO_KERNEL void push(std::uint32_t lanes, std::size_t first, std::vector<std::uint32_t>& places) {
  for (; lanes != 0; lanes &= lanes - 1)
    places.push_back(static_cast<std::uint32_t>(first) +
                     static_cast<std::uint32_t>(std::countr_zero(lanes)));
}

template <typename Real>
AVO_KERNEL PackSeen<Real> seen_at(const PackLook<Real>& a, const space::Bodies& bodies,
                                  std::size_t k) {
  PackSeen<Real> seen;
  seen.p = a.position - load_vector<Real, 3>(bodies.position, k);
  seen.squared = dot(seen.p, seen.p);
  return seen;
}

/// Sets the rest of what A sees of a body.
template <typename Real>
AVO_KERNEL void see(const PackLook<Real>& a, const space::Bodies& bodies, std::size_t k,
                    PackSeen<Real>& seen) {
  const auto load = [k](const std::vector<double>& column) { return Real::load(&column[k]); };
  const auto equal = [](Real x, Real y) { return (x <= y) & (x >= y); };
  const Real acceleration = load(bodies.max_acceleration), priority = load(bodies.priority);
  seen.v = a.velocity - load_vector<Real, 3>(bodies.velocity, k);
  seen.distance = sqrt(seen.squared);
  seen.contact = a.radius + load(bodies.radius);
  seen.wash = max(a.downwash, load(bodies.downwash));
  seen.share = room_share(a.acceleration, acceleration, priority, a.priority);
  seen.are_equal = equal(a.priority, priority);
  seen.brake_alike =
      equal(a.braking, load(bodies.max_braking)) & equal(load(bodies.vertical), Real(1.0));
}

template <typename Real>
void look_at(const space::Look& look, const space::Bodies& bodies, std::span<const space::Run> runs,
             space::Looked& looked) {
  const PackLook<Real> a(look);
  const Real self(look.self), farthest(look.farthest_squared), last_number(look.farthest_number);
  for (const space::Run& run : runs) {
    for (std::size_t k = run.first; k < run.last; k += Real::kLanes) {
      PackSeen<Real> seen = seen_at(a, bodies, k);
      const auto counted = lane_numbers<Real>() < Real(static_cast<double>(run.last - k));
      const auto sensed =
          counted & (Real::numbers_from(k) != self) & (seen.squared <= a.range_squared);
      if (!any(sensed)) continue;
      see(a, bodies, k, seen);
      if (look.certified)
        push(bits(sensed & !can_ignore(a, seen, k, look.law, bodies)), k, looked.near);
      push(bits(sensed & is_traffic(a, seen)), k, looked.traffic);
      const Real number = Real::load(&bodies.number[k]);
      const auto nearer =
          (seen.squared < farthest) | ((seen.squared <= farthest) & (number <= last_number));
      const auto cuts = look.robot.downwash > 0.0 || bodies.has_downwash
                            ? nearer
                            : nearer & !contains_all(a, seen);
      const auto chosen = sensed & cuts & (seen.squared > Real(0.0));
      if (any(chosen)) push(seen, chosen, k, look, bodies, looked.pairs);
    }
  }
}

/// The squared distances and the numbers of all bodies within the range.
template <typename Real>
void measure(const space::Look& look, const space::Bodies& bodies, std::span<const space::Run> runs,
             space::Looked& looked) {
  const PackLook<Real> a(look);
  looked.found = 0;
  for (const space::Run& run : runs) {
    for (std::size_t k = run.first; k < run.last; k += Real::kLanes) {
      const Real squared = seen_at(a, bodies, k).squared;
      const auto counted = lane_numbers<Real>() < Real(static_cast<double>(run.last - k));
      const auto sensed =
          counted & (Real::numbers_from(k) != Real(look.self)) & (squared <= a.range_squared);
      store_chosen(sensed, squared, &looked.distance_squared[looked.found]);
      looked.found +=
          store_chosen(sensed, Real::load(&bodies.number[k]), &looked.number[looked.found]);
    }
  }
}

AVO_END_KERNELS

#endif  // once per pass
