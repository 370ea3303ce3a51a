// SPDX-License-Identifier: Apache-2.0
// How far two robots that brake can move.
#include "certificate/pair.h"

#include <algorithm>
#include <cstddef>

#include "certificate/kernels.h"
#include "core/timed_places.h"

namespace avo::inline certificate {
namespace {

using Real = scalar::Pack<double>;

BrakingProfile plain(const scalar::PackProfile<Real>& profile) {
  return {profile.speed.value, profile.decrement.value, profile.full_steps.value};
}

Braking plain(const scalar::PackBraking<Real>& braking) {
  return {.profile = plain(braking.profile),
          .increment = braking.increment.value,
          .direction = plain(braking.direction),
          .length = braking.length.value,
          .reach = braking.reach.value,
          .intervals = braking.intervals.value};
}

scalar::Vec<Real> pack(Vec2 a) {
  return scalar::constant<Real>(a);
}

scalar::PackBraking<Real> pack(const Braking& braking) {
  return scalar::constant<Real>(braking);
}

// m, the largest distance of a mover on a trajectory from its sensed place until a time from now
// on, s.
double length_on_trajectory(const Neighbor& mover, double time) {
  const Trajectory& trajectory = *mover.trajectory;
  const double end = mover.trajectory_time + time;
  double length = norm(trajectory.at(mover.trajectory_time) - mover.position);
  length = std::max(length, norm(trajectory.at(end) - mover.position));
  const std::span<const TimedPlace> places = trajectory.places();
  for (std::size_t k = first_later(places, mover.trajectory_time);
       k < places.size() && places[k].time < end; ++k)
    length = std::max(length, norm(places[k].position - mover.position));
  if (trajectory.repeats_from() && !(end < places.back().time)) length += trajectory.round();
  return length + trajectory.error() + 0.5 * time * time * mover.max_deviation;
}

// m, the largest distance that a mover may move in all intervals in which A may move.
double length_of_mover(const Neighbor& mover, const Braking& a, const StepLaw& law) {
  const double t = law.time_step * a.intervals;
  if (mover.trajectory != nullptr) return length_on_trajectory(mover, t);
  const double length = t * norm(mover.velocity) + 0.5 * t * t * norm(mover.acceleration);
  if (!(mover.max_deviation > 0.0)) return length;
  return std::min(length + 0.5 * t * t * mover.max_deviation, t * mover.max_speed);
}

}  // namespace

double top_acceleration(const Neighbor& neighbor) {
  if (neighbor.behavior != Behavior::decides) return neighbor.max_deviation;
  return std::max(change_limit(neighbor), neighbor.max_deviation);
}

Braking braking_of(Vec2 velocity, const Ability& ability, const StepLaw& law) {
  return plain(
      scalar::braking_of(pack(velocity), Real(ability.acceleration), Real(ability.braking), law));
}

BrakingPair braking_pair(const Robot& robot, const Neighbor& neighbor, const Braking& a,
                         const StepLaw& law) {
  if (neighbor.behavior == Behavior::decides) {
    const scalar::PackSelf<Real> self{
        pack(robot.position), pack(robot.velocity), robot.radius, robot.max_acceleration,
        braking_limit(robot), robot.priority,       pack(a)};
    const scalar::PackNeighbor<Real> other{pack(neighbor.position), pack(neighbor.velocity),
                                           neighbor.radius,         neighbor.max_acceleration,
                                           braking_limit(neighbor), neighbor.priority};
    const auto packed = scalar::pair_of<true>(self, other, law);
    return {plain(packed.p),
            packed.contact.value,
            packed.inflated.value,
            packed.error.value,
            packed.share.value,
            true,
            a,
            plain(packed.b)};
  }
  BrakingPair pair{};
  pair.p = robot.position - neighbor.position;
  pair.contact = robot.radius + neighbor.radius;
  pair.share = 1.0;
  pair.a = a;
  double lengths = pair.contact + a.reach + norm(robot.position) + norm(neighbor.position);
  if (neighbor.max_deviation > 0.0 || neighbor.trajectory != nullptr)
    lengths += length_of_mover(neighbor, a, law);
  pair.inflated = pair.contact + scalar::rounding_margin<Real>(lengths, a.intervals, 1.0).value;
  pair.error =
      law.sensing_error.position + law.sensing_error.velocity * law.time_step * a.intervals;
  return pair;
}

SensingError error_against(const Neighbor& neighbor, const StepLaw& law) {
  const auto& [position, velocity] = law.sensing_error;
  const double time = neighbor.age * law.time_step;
  const double a = top_acceleration(neighbor);
  return {position + neighbor.position_error + (time * velocity + 0.5 * a * time * time),
          velocity + a * time};
}

bool cannot_meet(const BrakingPair& pair, const Neighbor& neighbor, const StepLaw& law) {
  double reach = pair.a.reach + pair.b.reach;
  if (!pair.decides) reach += length_of_mover(neighbor, pair.a, law);
  return norm(pair.p) - reach > pair.inflated + pair.error;
}

}  // namespace avo::inline certificate
