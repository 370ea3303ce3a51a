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
  result.speed = norm(velocity);
  result.decrement = braking_decrement(max_acceleration, law);
  if (result.speed > 0.0) result.direction = velocity / result.speed;
  // it may be faster than it looks
  const double top = result.speed + law.sensing_error.velocity + result.decrement;
  result.length = stopping_length(result.speed, result.decrement, law);
  result.reach = law.lag * result.speed + (law.time_step - law.lag) * top +
                 stopping_length(top, result.decrement, law);
  result.intervals = 1.0 + braking_steps(top, result.decrement);
  return result;
}

double deviation_after(const Braking& braking, double steps, const StepLaw& law) {
  // |v_1 - v_1'| <= 2 u, and a velocity moves a braking path by no more than itself times the time
  return 2.0 * braking.decrement * law.time_step * std::min(steps, braking.intervals);
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
