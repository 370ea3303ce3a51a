// SPDX-License-Identifier: Apache-2.0
// Pairs that may have to brake for each other, as many at once as Pack has lanes:
// docs/certificate/left_out.md and docs/certificate/wheels.md.
#ifndef AVO_CERTIFICATE_PAIR_KERNEL_H
#define AVO_CERTIFICATE_PAIR_KERNEL_H

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "certificate/braking_kernel.h"
#include "certificate/pair.h"
#include "certificate/pair_constraints.h"
#include "core/share_kernel.h"

AVO_BEGIN_KERNELS

/// See Braking.
template <typename Real, int D = 2>
struct PackBraking {
  PackProfile<Real> profile;
  Real increment;
  Vec<Real, D> direction;
  Real length, reach, intervals;
};

template <typename Real, int D = 2>
AVO_KERNEL PackBraking<Real, D> constant(const BrakingOf<D>& a) {
  return {.profile = constant<Real>(a.profile),
          .increment = a.increment,
          .direction = constant<Real>(a.direction),
          .length = a.length,
          .reach = a.reach,
          .intervals = a.intervals};
}

template <typename Real>
AVO_KERNEL PackBraking<Real> braking_of(Vec<Real> velocity, Real max_acceleration, Real max_braking,
                                        const StepLaw& law) {
  const Real zero(0.0), one(1.0), speed = norm(velocity);
  const Real u = max_braking * Real(law.braking_time);
  const auto moves = speed > zero;
  const Vec<Real> direction = velocity / select(moves, speed, one);
  PackBraking<Real> result;
  result.profile = profile(speed, u);
  result.increment = max_acceleration * Real(law.braking_time);
  result.direction = select(moves, direction, {zero, zero});
  // the robot may be faster than it is sensed
  const PackProfile<Real> top =
      profile(speed + Real(law.sensing_error.velocity) + result.increment, u);
  result.length = stopping_length(result.profile, law);
  result.reach =
      Real(law.lag) * speed + Real(law.time_step - law.lag) * top.speed + stopping_length(top, law);
  result.intervals = Real(2.0) + top.full_steps;
  return result;
}

/// See Neighbor.
template <typename Real, int D = 2>
struct PackNeighbor {
  Vec<Real, D> position, velocity;
  Real radius, max_acceleration, max_braking, priority;
};

/// See space::Neighbor.
template <typename Real>
struct PackNeighbor<Real, 3> {
  Vec<Real, 3> position, velocity;
  Real radius, max_acceleration, max_braking, priority;
  Real vertical, downwash;
};

/// Robot A.
template <typename Real, int D = 2>
struct PackSelf {
  Vec<Real, D> position, velocity;
  Real radius, max_acceleration, max_braking, priority;
  PackBraking<Real, D> braking;
};
template <typename Real>
struct PackSelf<Real, 3> {
  Vec<Real, 3> position, velocity;
  Real radius, max_acceleration, max_braking, priority;
  PackBraking<Real, 3> braking;
  Real downwash;
};

/// In space: a robot accelerates and brakes within an ellipsoid, a ball in its own space, in which
/// z is divided by `vertical`. It brakes straight there and so also in space (docs/space.md, "Any
/// norm").
template <typename Real>
AVO_KERNEL PackBraking<Real, 3> braking_of(Vec<Real, 3> velocity, Real max_acceleration,
                                           Real max_braking, Real vertical, const StepLaw& law) {
  const Real zero(0.0), one(1.0), speed = norm(velocity);
  const Real own_speed = norm(Vec<Real, 3>{velocity.x, velocity.y, velocity.z / vertical});
  const Real u = max_braking * Real(law.braking_time);
  const auto moves = own_speed > zero;
  const PackProfile<Real> own = profile(own_speed, u);
  const Real ratio = speed / select(moves, own_speed, one);
  PackBraking<Real, 3> result;
  result.profile = {speed, select(moves, u * ratio, u), own.full_steps};
  result.increment = max_acceleration * Real(law.braking_time);
  result.direction = select(moves, velocity / select(moves, speed, one), zero_vector<Real, 3>());
  const Real shortest = max(one, one / vertical), longest = max(one, vertical);
  // the robot may be faster than it is sensed
  const PackProfile<Real> top =
      profile(own_speed + shortest * Real(law.sensing_error.velocity) + result.increment, u);
  result.length = stopping_length(result.profile, law);
  result.reach = longest * (Real(law.lag) * own_speed + Real(law.time_step - law.lag) * top.speed +
                            stopping_length(top, law));
  result.intervals = Real(2.0) + top.full_steps;
  return result;
}

/// B's braking.
template <bool kUnlike, typename Real>
AVO_KERNEL PackBraking<Real> braking_of(const PackNeighbor<Real>& other, const StepLaw& law) {
  const Real braking = kUnlike ? other.max_braking : other.max_acceleration;
  return braking_of(other.velocity, other.max_acceleration, braking, law);
}
template <bool kUnlike, typename Real>
AVO_KERNEL PackBraking<Real, 3> braking_of(const PackNeighbor<Real, 3>& other, const StepLaw& law) {
  return braking_of(other.velocity, other.max_acceleration, other.max_braking, other.vertical, law);
}

/// See Deviation.
template <typename Real>
struct PackDeviation {
  struct Line {
    Real start, per_distance;
  };
  Line ahead, across, anyhow;
  PackProfile<Real> fast, slow;
  Real most_ahead, most_aside;
};

// docs/certificate/left_out.md
template <typename Real, int D>
AVO_KERNEL PackDeviation<Real> deviation_of(const PackBraking<Real, D>& a, Real stray_velocity,
                                            Real stray_distance, const StepLaw& law) {
  const Real zero(0.0), rounding(1.0 + 0x1p-30), lead(law.time_step - law.lag);
  const Real speed = a.profile.speed, u = a.profile.decrement, u_a = a.increment;
  const auto strays = stray_velocity > zero;
  const auto slow = speed < u_a, turns = (!strays) & slow, steady = !(strays | slow);
  PackDeviation<Real> result;
  result.fast = profile(speed + u_a, u);
  const PackProfile<Real> braked = profile(max(speed - u, zero), u);
  result.slow = braked;
  result.slow.speed = select(steady, braked.speed, zero);
  result.slow.full_steps = select(steady, braked.full_steps, zero);
  const Real length = stopping_length(result.fast, law), left = stopping_length(braked, law);
  const Real gained = length - select(steady, left, zero);
  result.ahead = {select(steady, rounding * lead * (u_a + u), zero),
                  select(steady, rounding, zero)};
  result.across = {select(steady, rounding * lead * u_a, zero),
                   select(steady, rounding * u_a / (speed + u_a), zero)};
  Real behind = zero;  // how far y falls behind x, where a candidate brakes harder than braking
  if (any(u_a > u)) {
    const Real least = stopping_length(profile(max(speed - u_a, zero), u), law);
    behind = max(lead * (u_a - u) + (left - least), zero);
  }
  // a change of velocity moves a braking path by no more than the change times the time
  const Real apart = Real(0.5) * stray_velocity * (u_a + max(u_a, u));
  const Real astray = apart * Real(law.time_step) * a.intervals + stray_distance;
  const Real slow_start = lead * (speed + u_a + braked.speed) + left;
  result.anyhow = {select(strays, astray, rounding * select(turns, slow_start, behind)),
                   select(turns, rounding, zero)};
  const auto over = [](const typename PackDeviation<Real>::Line& line, Real distance) {
    return line.start + line.per_distance * distance;
  };
  result.most_ahead = over(result.ahead, gained);
  result.most_aside = over(result.across, length) + over(result.anyhow, length);
  return result;
}

/// The distance of one candidate's path from A's braking path, m: the largest distance against A's
/// direction, and in any direction.
template <typename Real>
struct PackCandidateDeviation {
  Real ahead, aside;
};

// docs/certificate/left_out.md, applied to v_1 itself instead of all candidates of A
template <typename Real, int D>
AVO_KERNEL PackCandidateDeviation<Real> candidate_deviation(const PackBraking<Real, D>& a,
                                                            Vec<Real, D> next_velocity,
                                                            const StepLaw& law) {
  const Real zero(0.0), rounding(1.0 + 0x1p-30), lead(law.time_step - law.lag);
  const Real u = a.profile.decrement, speed = norm(next_velocity);
  const Real braked = max(a.profile.speed - u, zero),
             left = stopping_length(profile(braked, u), law);
  const auto moves = speed > zero;
  const Vec<Real, D> direction = (Real(1.0) / select(moves, speed, Real(1.0))) * next_velocity;
  const Real length = stopping_length(profile(speed, u), law);
  const auto steady = a.profile.speed >= a.increment;
  const Real far = lead * speed + length, margin = Real(0x1p-40) * a.reach;
  const Real ahead = dot(a.direction, direction) * far - lead * braked - left;
  Real aside = select(steady, across(a.direction, direction) * far, far);
  const auto weak = a.increment > u;
  if (any(weak)) {
    const Real along = dot(a.direction, next_velocity);
    const Real behind =
        lead * (braked - along) + left - stopping_length(profile(max(along, zero), u), law);
    aside = aside + select(weak, select(steady, max(behind, zero), lead * braked + left), zero);
  }
  return {select(steady, rounding * max(ahead, zero) + margin, zero), rounding * aside + margin};
}

/// Where clocks are free, a bound of B's distance from the path on which it holds its velocity for
/// one step and then brakes. It is start + per_time t and at most `most`, m at the time t
/// (docs/certificate/clocks.md, "Drift"). In the rest of its step B may speed up, or brake.
template <typename Real>
struct PackDrift {
  Real start, per_time, most;
};

template <typename Real>
AVO_KERNEL PackDrift<Real> drift_of(Real speed, Real increment, Real decrement,
                                    const StepLaw& law) {
  const double H = law.time_step, L = law.longest_step;  // s
  const double V = L > H ? 2.0 * L - H : H;              // s: B may be faster by a V
  const Real change = max(increment, decrement);
  const Real a = change / Real(law.braking_time), weakness = change / decrement;
  const Real start = Real(0.125 * (H * H + L * L) - 0.5 * H * H) * a;
  const Real to_rest =  // a times the time to rest
      Real(H) * a + weakness * (speed + Real(law.sensing_error.velocity));
  return {start, Real(V) * a, start + Real(V) * to_rest + Real(0.5 * V * V) * a * weakness};
}

/// Additional intervals of a pair where clocks are free: B holds its velocity, and so stops later.
template <typename Real>
AVO_KERNEL Real later_intervals(Real increment, Real decrement, const StepLaw& law) {
  if (!law.has_free_clocks()) return Real(0.0);
  const double steps = std::ceil(std::max(law.longest_step / law.time_step, 0.5));
  return Real(1.0) + floor(max(increment, decrement) / decrement * Real(steps));
}

/// See BrakingPair, for a neighbor that decides.
template <typename Real, int D = 2>
struct PackPair {
  Vec<Real, D> p;
  Real distance, contact, inflated, error, share;
  PackBraking<Real, D> b;
};

/// Rounding moves a pair by at most 2^-50 of its lengths a step. While both brake these errors add
/// up, for at most so many steps; a decision reduces the sum by a share.
/// docs/certificate/rounding.md; four times the bound that is derived there. In space:
/// docs/space.md, "Rounding".
template <typename Real, int D = 2>
AVO_KERNEL Real rounding_margin(Real lengths, Real intervals, Real shrinks) {
  return Real(D == 2 ? 0x1p-48 : 0x1p-46) * lengths * (Real(1.0) + intervals) / shrinks;
}

/// The largest error of B's path relative to the sensed one at any time, m.
template <typename Real, int D>
AVO_KERNEL Real error_of(const PackBraking<Real, D>& b, const StepLaw& law) {
  if (law.is_exact()) return Real(0.0);
  if (!law.has_free_clocks()) return braking_error(b.profile, law, b.intervals);
  const auto& [position, velocity] = law.sensing_error;
  return Real(position) + Real(velocity * law.time_step) * b.intervals +
         drift_of(b.profile.speed, b.increment, b.profile.decrement, law).most;
}

/// The pair, where B's braking is known.
/// kUnlike: with priorities and limits of braking, which matter only where some differ.
template <bool kUnlike = true, typename Real, int D>
AVO_KERNEL PackPair<Real, D> pair_of(const PackSelf<Real, D>& self,
                                     const PackNeighbor<Real, D>& other,
                                     const PackBraking<Real, D>& b, const StepLaw& law) {
  const Real one(1.0);
  const Vec<Real, D> p_A = self.position;
  const PackBraking<Real, D>& a = self.braking;
  PackPair<Real, D> pair;
  pair.b = b;
  pair.p = p_A - other.position;
  pair.distance = norm(pair.p);
  pair.contact = self.radius + other.radius;
  const Real a_A = self.max_acceleration, a_B = other.max_acceleration;
  pair.share = law.has_free_clocks() ? one
               : kUnlike             ? room_share(a_A, a_B, self.priority, other.priority)
                                     : a_A / (a_A + a_B);
  pair.b.intervals =
      pair.b.intervals + later_intervals(pair.b.increment, pair.b.profile.decrement, law);
  Real lengths = pair.contact + a.reach + pair.b.reach + one_norm(p_A) + one_norm(other.position);
  if constexpr (D == 3) lengths = lengths + (self.downwash + other.downwash);
  pair.inflated =
      pair.contact +
      rounding_margin<Real, D>(lengths, max(a.intervals, pair.b.intervals),
                               law.has_free_clocks() ? one : min(pair.share, one - pair.share));
  pair.error = error_of(pair.b, law);
  return pair;
}
template <bool kUnlike = true, typename Real, int D>
AVO_KERNEL PackPair<Real, D> pair_of(const PackSelf<Real, D>& self,
                                     const PackNeighbor<Real, D>& other, const StepLaw& law) {
  return pair_of<kUnlike>(self, other, braking_of<kUnlike>(other, law), law);
}

/// What B can refuse: B refuses no path that deviates from A's braking path by less than the gap
/// (docs/certificate/left_out.md).
template <typename Real>
struct PackClearance {
  Real gap;      // m, A's share of the gap that joint braking leaves; -∞ where it is not known
  Real against;  // in [0, 1], the largest part of any of the normals against A's direction
};

template <bool kUnlike = true, typename Real, int D>
AVO_KERNEL PackClearance<Real> clearance_of(const PackSelf<Real, D>& self,
                                            const PackPair<Real, D>& pair,
                                            const PackNeighbor<Real, D>& other,
                                            const StepLaw& law) {
  const Real zero(0.0), one(1.0), d = pair.distance, length_A = self.braking.length;
  const Vec<Real, D> d_A = self.braking.direction, d_B = pair.b.direction;
  const auto apart = d > zero;
  // along p, whenever each of them stops
  const Real towards =
      min(zero, length_A * dot(pair.p, d_A)) - max(zero, pair.b.length * dot(pair.p, d_B));
  const Real alone = d + towards / select(apart, d, one);
  // the relative velocity of robots with equal braking never grows
  const Real steps = one + max(self.braking.profile.full_steps, pair.b.profile.full_steps);
  const Real drift = Real(law.time_step) * steps * norm(self.velocity - other.velocity);
  const Real b_A = kUnlike ? self.max_braking : self.max_acceleration;
  const Real b_B = kUnlike ? other.max_braking : other.max_acceleration;
  const auto brake_alike = (b_B <= b_A) & (b_B >= b_A);
  const Real together = select(brake_alike, d - drift, alone);
  // by equal braking both keep within `off_line` of the line from p to where both rest
  const Vec<Real, D> motion = length_A * d_A - pair.b.length * d_B;
  const Real squared = dot(motion, motion), lengths = length_A + pair.b.length;
  const Real part =
      min(max(-dot(pair.p, motion), zero) / select(squared > zero, squared, one), one);
  const Real off_line = abs(length_A - pair.b.length) + Real(0x1p-40) * (d + lengths);
  const Real beside = norm(pair.p + part * motion) - off_line;
  const Real nearest = max(max(alone, together), select(brake_alike, beside, alone));
  const Real passes = pair.b.length * max(zero, dot(d_A, d_B));
  const Real shift = select(brake_alike, min(passes, drift), passes);
  const auto clear = apart & (nearest > zero);
  // with the part that rounding of p . d may hide
  const Real towards_B = max(zero, shift - dot(pair.p, d_A)) + Real(0x1p-40) * d;
  const Real against = towards_B / select(clear, nearest, one);
  const Real unknown(-std::numeric_limits<double>::infinity());
  return {select(clear, pair.share * (nearest - pair.inflated), unknown), min(against, one)};
}

/// The values of A that are_far() and are_clear() read.
template <typename Real, int D = 2>
struct BrakingPoint {
  Vec<Real, D> position, velocity, direction;
  Real speed, max_acceleration;
};

/// The values of A that do not depend on a neighbor: see BrakingColumns.
template <typename Real>
struct PackBound {
  Real far_distance;            // m
  std::array<Real, 3> reach;    // m, s, s²/m
  Real speed_squared;           // m²/s²
  Real clear_distance;          // m
  Real per_decrement;           // s/m
  Real most_ahead, most_aside;  // m
};

/// An upper bound of the distance of one step and stopping for a robot of speed v, as a polynomial
/// in v: v²/2a and the loss by stopping in steps.
template <typename Real>
AVO_KERNEL std::array<Real, 3> reach_bound(Real increment, Real u, const StepLaw& law) {
  const Real h(law.time_step), half(0.5), per_u = Real(1.0) / u;
  // that a robot sensed at rest may have
  const Real top = Real(law.sensing_error.velocity) + increment;
  const Real lost(std::abs(law.lag - 0.5 * law.time_step));
  return {(h - Real(law.lag) + lost) * top + h * (half * top * top * per_u + Real(0.125) * u),
          h + h * top * per_u + lost, half * h * per_u};
}

template <typename Real, int D = 2>
AVO_KERNEL PackBound<Real> bound_of(Vec<Real, D> position, Real radius,
                                    const PackBraking<Real, D>& a,
                                    const PackDeviation<Real>& deviation, Real max_speed,
                                    const StepLaw& law) {
  const PackProfile<Real>& own = a.profile;
  const Real h(law.time_step), u = own.decrement, per_u = Real(1.0) / u;
  const Real top = Real(law.sensing_error.velocity) + a.increment;
  const std::array<Real, 3> reach = reach_bound(a.increment, u, law);
  const auto reach_at = [&reach](Real v) { return reach[0] + v * (reach[1] + v * reach[2]); };
  const Real speed = Real(kFarther) * max(max_speed, own.speed);
  const Real intervals = (Real(3.0) + later_intervals(a.increment, u, law)) + (speed + top) * per_u;
  Real error = Real(law.sensing_error.position) + Real(law.sensing_error.velocity) * h * intervals;
  if (law.has_free_clocks()) error = error + drift_of(speed, a.increment, u, law).most;
  // the part of the rounding margin that does not grow with the distance
  const Real places = one_norm(position);
  const Real lengths = radius + reach_at(own.speed);
  const Real margin = Real(0x1p-46) * (places + lengths + radius + reach_at(speed)) * intervals;
  const auto is_known = intervals <= Real(kMostIntervals);
  const Real infinity(std::numeric_limits<double>::infinity());
  return {select(is_known, lengths + error + margin, infinity),
          reach,
          speed * speed,
          select(is_known, radius + margin, infinity),
          per_u,
          deviation.most_ahead,
          deviation.most_aside};
}

/// Returns whether B has A's a_max, and is no faster than A may be. B's priority and limit of
/// braking must be A's as well.
template <typename Real, int D>
AVO_KERNEL auto is_alike(const PackBound<Real>& bound, const BrakingPoint<Real, D>& self,
                         const PackNeighbor<Real, D>& other) {
  return (dot(other.velocity, other.velocity) <= bound.speed_squared) &
         (other.max_acceleration <= self.max_acceleration) &
         (other.max_acceleration >= self.max_acceleration);
}

/// Returns whether the two are alike, and farther apart than both reach.
template <typename Real, int D>
AVO_KERNEL auto are_far(const PackBound<Real>& bound, const BrakingPoint<Real, D>& self,
                        const PackNeighbor<Real, D>& other) {
  const Real squared = dot(other.velocity, other.velocity);
  const Real reach = bound.reach[0] + bound.reach[1] * sqrt(squared) + bound.reach[2] * squared;
  const Real distance = norm(self.position - other.position);
  return is_alike(bound, self, other) &
         (distance > Real(kFarther) * (bound.far_distance + other.radius + reach));
}

/// Returns whether the two are alike, and drift towards each other too slowly for B to refuse a
/// candidate. It uses the gap of clearance_of(), with the intervals of the faster one, times the
/// part of the distance that remains after drifting. It takes no division.
template <typename Real, int D>
AVO_KERNEL auto are_clear(const PackBound<Real>& bound, const BrakingPoint<Real, D>& self,
                          const PackNeighbor<Real, D>& other, const StepLaw& law) {
  const Real zero(0.0);
  const Vec<Real, D> p = self.position - other.position;
  const Real distance = norm(p);
  const Real steps = Real(1.0) + bound.per_decrement * max(self.speed, norm(other.velocity));
  const Real drift = Real(kFarther * law.time_step) * steps * norm(self.velocity - other.velocity);
  const Real left = distance - drift;
  const Real against = min(max(zero, drift - dot(p, self.direction)), left);
  const Real gap =
      Real(0.5) * (left - (bound.clear_distance + other.radius) - Real(0x1p-27) * distance);
  return is_alike(bound, self, other) & (left > zero) &
         ((gap - bound.most_aside) * left > against * bound.most_ahead);
}

AVO_END_KERNELS

#endif  // once per pass
