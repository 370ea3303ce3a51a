// SPDX-License-Identifier: Apache-2.0
// How far two robots that brake can get.
#include "certificate/pair.h"

#include <algorithm>

#include "avo/half_plane.h"

namespace avo {
namespace {

// Rounding moves a pair by at most 2^-50 of its lengths a step. While both brake such errors add
// up, for at most so many steps; a decision shrinks what has added up by a share.
// docs/certificate.md, "Rounding"; four times what is derived there.
double rounding_margin(const Robot& robot, const Neighbor& neighbor, const BrakingPair& pair) {
  const double lengths =
      pair.contact + pair.a.reach + pair.b.reach + norm(robot.position) + norm(neighbor.position);
  const double steps = 1.0 + std::max(pair.a.intervals, pair.b.intervals);
  const double shrinks = pair.decides ? std::min(pair.share, 1.0 - pair.share) : 1.0;
  return 0x1p-48 * lengths * steps / shrinks;
}

}  // namespace

Braking braking_of(Vec2 velocity, double max_acceleration, const StepLaw& law) {
  Braking result;
  const double speed = norm(velocity), decrement = braking_decrement(max_acceleration, law);
  result.profile = braking_profile(speed, decrement);
  if (speed > 0.0) result.direction = velocity / speed;
  // it may be faster than it looks
  const BrakingProfile top =
      braking_profile(speed + law.sensing_error.velocity + decrement, decrement);
  result.length = stopping_length(result.profile, law);
  result.reach =
      law.lag * speed + (law.time_step - law.lag) * top.speed + stopping_length(top, law);
  result.intervals = 2.0 + top.full_steps;
  return result;
}

// docs/certificate.md, "What can refuse nothing"
Deviation deviation_of(const Braking& a, bool is_car, const StepLaw& law) {
  const double speed = a.profile.speed, u = a.profile.decrement;
  const double lead = law.time_step - law.lag;
  Deviation result;
  result.fast = braking_profile(speed + u, u);
  const double length = stopping_length(result.fast, law);
  constexpr double kRounding = 1.0 + 0x1p-30;
  if (is_car) {
    // |v_1 - v_1'| <= 2 u, and a velocity moves a braking path by no more than itself times the time
    result.anyhow.start = 2.0 * u * law.time_step * a.intervals;
    result.most = result.anyhow.start;
  } else if (speed < u) {
    result.anyhow = {kRounding * lead * (speed + u), kRounding};
    result.most = result.anyhow.start + kRounding * length;
  } else {
    result.slow = braking_profile(speed - u, u);
    result.ahead = {kRounding * 2.0 * lead * u, kRounding};
    result.across = {kRounding * lead * u, kRounding * u / (speed + u)};
    const double gained = length - stopping_length(result.slow, law);
    result.most = result.ahead.start + result.ahead.per_distance * gained + result.across.start +
                  result.across.per_distance * length;
  }
  return result;
}

BrakingPair braking_pair(const Robot& robot, const Neighbor& neighbor, const Braking& a,
                         const StepLaw& law) {
  BrakingPair pair;
  pair.decides = neighbor.max_acceleration > 0.0;
  pair.p = robot.position - neighbor.position;
  pair.contact = robot.radius + neighbor.radius;
  pair.share = reciprocal_share(robot.max_acceleration, neighbor.max_acceleration);
  pair.a = a;
  if (pair.decides) pair.b = braking_of(neighbor.velocity, neighbor.max_acceleration, law);
  pair.inflated = pair.contact + rounding_margin(robot, neighbor, pair);
  pair.error = law.sensing_error.position +
               law.sensing_error.velocity * law.time_step * (pair.decides ? pair.b : a).intervals;
  return pair;
}

bool cannot_meet(const BrakingPair& pair, const Neighbor& neighbor, const StepLaw& law) {
  double reach = pair.a.reach + pair.b.reach;
  if (!pair.decides) {
    const double t = law.time_step * pair.a.intervals;
    reach += t * norm(neighbor.velocity) + 0.5 * t * t * norm(neighbor.acceleration);
  }
  return norm(pair.p) - reach > pair.inflated + pair.error;
}

double held_distance(const BrakingPair& pair, double distance, int index, Invariant& invariant) {
  invariant.slack = std::min(invariant.slack, distance - pair.contact);
  if (!(distance < pair.contact - pair.error)) return pair.inflated;
  invariant.broken = index;
  return distance;
}

}  // namespace avo
