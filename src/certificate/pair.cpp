// SPDX-License-Identifier: Apache-2.0
// How far two robots that brake can get.
#include "certificate/pair.h"

#include <algorithm>

#include "certificate/kernels.h"

namespace avo {
namespace {

using Real = scalar::Pack<double>;

BrakingProfile plain(const scalar::PackProfile<Real>& profile) {
  return {profile.speed.value, profile.decrement.value, profile.full_steps.value};
}

Vec2 plain(const scalar::Vec<Real>& a) {
  return {a.x.value, a.y.value};
}

Braking plain(const scalar::PackBraking<Real>& braking) {
  return {plain(braking.profile), plain(braking.direction), braking.length.value,
          braking.reach.value, braking.intervals.value};
}

scalar::Vec<Real> pack(Vec2 a) {
  return scalar::constant<Real>(a);
}

}  // namespace

Braking braking_of(Vec2 velocity, double max_acceleration, const StepLaw& law) {
  return plain(scalar::braking_of(pack(velocity), Real(max_acceleration), law));
}

// docs/certificate.md, "What can refuse nothing"
Deviation deviation_of(const Braking& a, bool is_car, const StepLaw& law) {
  const double speed = a.profile.speed, u = a.profile.decrement;
  const double lead = law.time_step - law.lag;
  Deviation result;
  const auto fast = scalar::profile<Real>(speed + u, u);
  const double length = scalar::stopping_length(fast, law).value;
  result.fast = plain(fast);
  constexpr double kRounding = 1.0 + 0x1p-30;
  if (is_car) {
    // |v_1 - v_1'| <= 2 u, and a velocity moves a braking path by no more than itself times the
    // time
    result.anyhow.start = 2.0 * u * law.time_step * a.intervals;
    result.most_aside = result.anyhow.start;
  } else if (speed < u) {
    result.anyhow = {kRounding * lead * (speed + u), kRounding};
    result.most_aside = result.anyhow.start + kRounding * length;
  } else {
    const auto slow = scalar::profile<Real>(speed - u, u);
    result.slow = plain(slow);
    result.ahead = {kRounding * 2.0 * lead * u, kRounding};
    result.across = {kRounding * lead * u, kRounding * u / (speed + u)};
    const double gained = length - scalar::stopping_length(slow, law).value;
    result.most_ahead = result.ahead.start + result.ahead.per_distance * gained;
    result.most_aside = result.across.start + result.across.per_distance * length;
  }
  return result;
}

BrakingPair braking_pair(const Robot& robot, const Neighbor& neighbor, const Braking& a,
                         const StepLaw& law) {
  if (neighbor.max_acceleration > 0.0) {
    const auto found = scalar::pair_of<Real>(robot, a,
                                             {pack(neighbor.position), pack(neighbor.velocity),
                                              neighbor.radius, neighbor.max_acceleration},
                                             law);
    return {plain(found.p),
            found.contact.value,
            found.inflated.value,
            found.error.value,
            found.share.value,
            true,
            a,
            plain(found.b)};
  }
  BrakingPair pair{};
  pair.p = robot.position - neighbor.position;
  pair.contact = robot.radius + neighbor.radius;
  pair.share = 1.0;
  pair.a = a;
  const double lengths = pair.contact + a.reach + norm(robot.position) + norm(neighbor.position);
  pair.inflated = pair.contact + scalar::rounding_margin<Real>(lengths, a.intervals, 1.0).value;
  pair.error =
      law.sensing_error.position + law.sensing_error.velocity * law.time_step * a.intervals;
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
