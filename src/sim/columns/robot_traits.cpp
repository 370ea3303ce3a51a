// SPDX-License-Identifier: Apache-2.0
// A robot's columns from its setup, and what others sense of a robot with these columns.
#include <algorithm>

#include "core/elementary.h"
#include "robots/ahead.h"
#include "robots/footprint.h"
#include "robots/model.h"
#include "sim/columns/fleet.h"

namespace avo::inline sim {

RobotTraits traits_of(const RobotSetup& setup) {
  return {.radius = disc_radius(setup),
          .route_radius = route_radius(setup.model, disc_radius(setup)),
          .max_speed = setup.max_speed,
          .max_acceleration = setup.max_acceleration,
          .max_braking = braking_limit(setup),
          .preferred_speed = setup.preferred_speed,
          .has_model = !is_holonomic(setup.model),
          .exceeds = model_traits(setup.model).reach > 1.0};
}

UsualMethod usual_method(const Scenario& scenario) {
  return {scenario.method,
          scenario.certificate.value_or(usual_certificate(scenario.method)) != Certificate::none};
}

Conduct conduct_of(const RobotSetup& setup, const UsualMethod& usual) {
  const Method method = setup.method.value_or(usual.method);
  const bool certified =
      method == usual.method ? usual.certified : usual_certificate(method) != Certificate::none;
  return {setup.priority, method, certified, setup.layers, setup.avoids, setup.behavior};
}

Vec2 start_velocity(const RobotSetup& setup) {
  if (is_holonomic(setup.model)) return setup.velocity;
  const Vec2 heading = elementary::direction(setup.heading);
  const double least = model_traits(setup.model).least_speed;
  if (setup.velocity == Vec2{} && least > 0.0)
    return std::clamp(setup.preferred_speed, least, setup.max_speed) * heading;
  const bool backwards =
      model_traits(setup.model).can_reverse && dot(setup.velocity, heading) < 0.0;
  return norm(setup.velocity) * (backwards ? -heading : heading);
}

namespace {

// Part of its max_acceleration: the likely deviation of a robot that promises nothing.
constexpr double kLikely = 0.6;

Behavior behavior_of(Expectation expected) {
  if (expected == Expectation::decides) return Behavior::decides;
  return expected == Expectation::cooperates ? Behavior::cooperates : Behavior::moves_on;
}

}  // namespace

Neighbor sensed(const RobotTraits& traits, const Conduct& conduct, Expectation expected,
                Vec2 position, Vec2 velocity) {
  const bool decides = expected == Expectation::decides;
  Neighbor neighbor{.position = position,
                    .velocity = velocity,
                    .radius = traits.radius,
                    .max_acceleration = traits.max_acceleration,
                    .behavior = behavior_of(expected),
                    .priority = conduct.priority,
                    .max_braking = max_braking_of(traits)};
  if (expected == Expectation::cooperates || expected == Expectation::moves_on) {
    neighbor.likely_deviation = kLikely * traits.max_acceleration;
    return neighbor;
  }
  if (decides && !traits.exceeds) return neighbor;
  neighbor.max_deviation = top_acceleration(traits);
  if (decides) return neighbor;
  neighbor.max_speed = std::max(traits.max_speed, norm(velocity));
  return neighbor;
}

Wall parked_wall(const MotionModel& model, Vec2 center, double radius, double heading) {
  const Footprint footprint = footprint_of(model);
  if (!footprint) return {center, center, radius};
  const Vec2 ahead = ahead_of(heading);
  return {center + footprint.first * ahead, center + footprint.ahead(footprint.discs - 1) * ahead,
          footprint.radius};
}

void cover(const MotionModel& model, const BrakingPose& pose, Neighbor& neighbor) {
  neighbor.footprint = footprint_of(model);
  neighbor.ahead = pose.ahead, neighbor.spread = pose.spread;
}

}  // namespace avo::inline sim
