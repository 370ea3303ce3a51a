// SPDX-License-Identifier: Apache-2.0
// The lanes of looks: the braking of bodies, those within the range, and the values of a look in
// all lanes (docs/space.md, "Cost").
#ifndef AVO_SPACE_SEEN_KERNEL_H
#define AVO_SPACE_SEEN_KERNEL_H

#include <algorithm>
#include <cstddef>
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

/// Whether storing chosen lanes costs more than a branch that is often taken and often not.
template <typename Real>
constexpr bool kChoosesSlowly = Real::kLanes < 8;

/// Where columns of bodies begin. The compiler cannot know that numbers that are stored change no
/// vector.
struct SeenPlaces {
  std::array<double*, 3> p, v;
  double* place;

  AVO_KERNEL explicit SeenPlaces(space::SeenColumns& columns)
      : p{columns.p[0].data(), columns.p[1].data(), columns.p[2].data()},
        v{columns.v[0].data(), columns.v[1].data(), columns.v[2].data()},
        place(columns.place.data()) {}

  /// Stores the chosen bodies from a place on, and returns their number.
  template <typename Real>
  AVO_KERNEL std::size_t put(decltype(Real() < Real()) chosen, const Vec<Real, 3>& seen_p,
                             const Vec<Real, 3>& seen_v, Real seen_place, std::size_t at) const {
    store_chosen(chosen, seen_p.x, p[0] + at), store_chosen(chosen, seen_p.y, p[1] + at);
    store_chosen(chosen, seen_p.z, p[2] + at), store_chosen(chosen, seen_v.x, v[0] + at);
    store_chosen(chosen, seen_v.y, v[1] + at), store_chosen(chosen, seen_v.z, v[2] + at);
    return store_chosen(chosen, seen_place, place + at);
  }
};

inline std::array<const double*, 3> begin_of(const std::array<std::vector<double>, 3>& columns) {
  return {columns[0].data(), columns[1].data(), columns[2].data()};
}

/// Finds the bodies within the range.
template <typename Real>
void find_seen(const space::Viewer& look, const space::Bodies& bodies,
               std::span<const space::Run> runs, space::SeenColumns& seen) {
  const Vec<Real, 3> position = constant<Real>(look.robot.position);
  const Vec<Real, 3> velocity = constant<Real>(look.robot.velocity);
  const Real self(look.self), range_squared(look.range * look.range);
  const std::array<const double*, 3> positions = begin_of(bodies.position);
  const std::array<const double*, 3> velocities = begin_of(bodies.velocity);
  const SeenPlaces places(seen);
  std::size_t count = 0;
  for (const space::Run& run : runs) {
    for (std::size_t k = run.first; k < run.last; k += Real::kLanes) {
      const Vec<Real, 3> p = position - load_vector<Real, 3>(positions, k);
      const Real squared = dot(p, p), place = Real::numbers_from(k);
      const auto sensed = (place < Real(static_cast<double>(run.last))) & (place != self) &
                          (squared <= range_squared);
      if (kChoosesSlowly<Real> && !any(sensed)) continue;
      const Vec<Real, 3> v = velocity - load_vector<Real, 3>(velocities, k);
      count += places.put(sensed, p, v, place, count);
    }
  }
  seen.count = count;
}

template <typename Real>
AVO_KERNEL Real square(Real a) {
  return a * a;
}

/// The values of a look in all lanes.
template <typename Real>
struct PackLook {
  Vec<Real, 3> position, velocity, direction, preferred;
  Real radius, acceleration, braking, priority, downwash;
  Real reach, full_steps, intervals, lengths;  // lengths: see rounding_margin()
  Real most_ahead, most_aside;
  Real end_time, end_lag, gain, change, speed;  // of half-spaces
  Real traffic_range, traffic_squared, per_range, per_front, per_closing, per_slow;

  AVO_KERNEL PackLook(const space::Viewer& look, const space::Bodies& bodies)
      : position(constant<Real>(look.robot.position)),
        velocity(constant<Real>(look.robot.velocity)),
        direction(constant<Real>(look.braking.direction)),
        preferred(constant<Real>(look.robot.preferred_velocity)),
        radius(look.robot.radius),
        acceleration(look.robot.max_acceleration),
        braking(look.robot.max_braking.value_or(look.robot.max_acceleration)),
        priority(look.robot.priority),
        downwash(look.robot.downwash),
        reach(look.braking.reach + bodies.most_reach),
        full_steps(std::max(look.braking.profile.full_steps, bodies.most_full_steps)),
        intervals(std::max(look.braking.intervals, bodies.most_intervals)),
        lengths(Real(2.0) * one_norm(position) + reach + radius + downwash +
                Real(bodies.most_downwash)),
        most_ahead(look.deviation.most_ahead),
        // gaps are not known to bound anything else
        most_aside(look.law.is_exact() && !bodies.has_ages && look.robot.vertical == 1.0
                       ? look.deviation.most_aside
                       : std::numeric_limits<double>::infinity()),
        end_time(look.horizon.end().time),
        end_lag(look.horizon.end().lag),
        gain(look.horizon.end().gain),
        // a normal is no longer than this in the robot's own space
        change(std::max(look.robot.vertical, 1.0) * look.control_time *
               look.robot.max_acceleration),
        speed(std::max(look.robot.vertical, 1.0) * look.robot.max_speed),
        traffic_range(look.traffic_range),
        traffic_squared(square(Real(kFarther) * traffic_range)),
        per_range(1.0 / look.traffic_range),
        per_front(1.0 / (kInFront * norm(look.robot.preferred_velocity))),
        per_closing(1.0 / (kCloses * look.robot.max_speed)),
        per_slow(1.0 / (kSlow * look.robot.max_speed)) {}
};

/// What matters of the bodies themselves.
template <typename Real>
struct PackBody {
  Real contact, wash, share, defers, reach;  // [δ (a_A + a_B)] m/s: reach
  Real per_share;                            // more than 1/share
  Real far_squared, beside_squared;          // m², see far_squared() and beside_squared()
  Real meets_squared;                        // m², of a course that is no traffic
  // equal priorities, with which the share is that of the room as well; and equal braking
  decltype(Real() < Real()) are_equal, brake_alike;
};

/// m²: the squared distance of a body with A's priority beyond which A surely needs no constraint
/// for it. It is the test of are_far() for the largest reach of all bodies.
template <typename Real>
AVO_KERNEL Real far_squared(const PackLook<Real>& a, const PackBody<Real>& body,
                            const space::Bodies& bodies) {
  const Real rounding(kFarther), one(1.0), infinity(std::numeric_limits<double>::infinity());
  // The margin of rounding for a length of 1 m. The place of the body is no longer than twice its
  // distance, which contains its margin.
  const Real per_length =
      rounding_margin<Real, 3>(one, a.intervals, min(body.share, one - body.share));
  const Real reach = body.contact + body.wash + a.reach + Real(bodies.most_error) +
                     per_length * (a.lengths + body.contact);
  return select(per_length < Real(0x1p-29), square(square(rounding) * reach), infinity);
}

/// m²: the squared distance beyond which a body is surely not nearly in contact.
template <typename Real>
AVO_KERNEL Real beside_squared(const PackBody<Real>& body) {
  const Real rounding(kFarther);
  return square(rounding * (rounding * (Real(1.0 + kRoom) * body.contact + body.wash)));
}

/// field: maps a column to its values.
template <typename Real, typename Field>
AVO_KERNEL PackBody<Real> body_of(const PackLook<Real>& a, const space::Viewer& look,
                                  const space::Bodies& bodies, const Field& field) {
  const auto equal = [](Real x, Real y) { return (x <= y) & (x >= y); };
  const Real acceleration = field(bodies.max_acceleration), priority = field(bodies.priority);
  PackBody<Real> body{
      a.radius + field(bodies.radius),
      max(a.downwash, field(bodies.downwash)),
      room_share(a.acceleration, acceleration, priority, a.priority),
      Real(2.0) * room_share(Real(1.0), Real(1.0), priority, a.priority),
      Real(look.control_time) * (a.acceleration + acceleration),
      Real(0.0),
      Real(0.0),
      Real(0.0),
      Real(0.0),
      equal(a.priority, priority),
      equal(a.braking, field(bodies.max_braking)) & equal(field(bodies.vertical), Real(1.0))};
  body.per_share = Real(kFarther) / body.share;
  body.far_squared = far_squared(a, body, bodies), body.beside_squared = beside_squared(body);
  body.meets_squared = square(Real(2.0 * kFarther) * body.contact);
  return body;
}

/// A body as A sees it. squared: the squared distance, m².
template <typename Real>
struct PackSeen {
  Vec<Real, 3> p, v;
  Real squared, place;
  decltype(Real() < Real()) counted;
};

/// The bodies from k on.
template <typename Real>
AVO_KERNEL PackSeen<Real> seen_at(const space::SeenColumns& all, std::size_t k) {
  PackSeen<Real> seen;
  seen.counted = lane_numbers<Real>() < Real(static_cast<double>(all.count - k));
  seen.p = load_vector<Real, 3>(all.p, k), seen.v = load_vector<Real, 3>(all.v, k);
  seen.squared = dot(seen.p, seen.p);
  seen.place = select(seen.counted, Real::load(&all.place[k]), Real(0.0));
  return seen;
}

/// Calls examine(seen, body, field) for all bodies that are seen, many at once. field: the values
/// of a column. Where all bodies are alike, they are looked at once.
template <typename Real, bool kUniform, typename Examine>
AVO_KERNEL void for_all(const PackLook<Real>& a, const space::Viewer& look,
                        const space::Bodies& bodies, const space::SeenColumns& all,
                        const Examine& examine) {
  const auto same = [](const std::vector<double>& column) { return Real(column[0]); };
  PackBody<Real> body = body_of(a, look, bodies, same);
  for (std::size_t k = 0; k < all.count; k += Real::kLanes) {
    const PackSeen<Real> seen = seen_at<Real>(all, k);
    const auto field = [&](const std::vector<double>& column) {
      return lookup(column.data(), seen.place);
    };
    if constexpr (!kUniform) body = body_of(a, look, bodies, field);
    examine(seen, body, field);
  }
}

AVO_END_KERNELS

#endif  // once per pass
