// SPDX-License-Identifier: Apache-2.0
// Robots that each have a navigator of their own, and know the others by what they see.
#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "avo/navigator.h"
#include "robots/model.h"
#include "robots/motion.h"
#include "walls/segment.h"

namespace avo::test {

/// A base that does as it is told: holonomic, or with wheels.
struct Base {
  Robot robot;
  double preferred_speed = 2.0;  // m/s

  void hold(const Planner& planner, const Plan& plan) {
    const StepResponse response = step_response(planner);
    const MotionState state{robot.position, robot.velocity, robot.heading};
    const MotionStep step = is_holonomic(robot.model)
                                ? advance(state, plan, response)
                                : advance(robot.model, {planned_braking(robot), robot.max_speed},
                                          state, plan, response.time_step);
    robot.position = step.next.position, robot.velocity = step.next.velocity;
    robot.heading = step.next.heading;
  }
};

inline Base base_of(const RobotSetup& setup) {
  Base base;
  base.robot = {.position = disc_center(setup),
                .velocity = setup.velocity,
                .radius = disc_radius(setup),
                .max_acceleration = setup.max_acceleration,
                .max_speed = setup.max_speed,
                .model = setup.model,
                .heading = setup.heading,
                .priority = setup.priority,
                .max_braking = setup.max_braking};
  base.preferred_speed = setup.preferred_speed;
  return base;
}

/// What others sense of a robot: its place, velocity, radius and limits.
inline Neighbor seen_of(const Robot& robot) {
  return {.position = robot.position,
          .velocity = robot.velocity,
          .radius = robot.radius,
          .max_acceleration = robot.max_acceleration,
          .priority = robot.priority,
          .max_braking = robot.max_braking};
}

/// m, of the route through those points.
inline double off_route(Vec2 p, const std::vector<Vec2>& route) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < route.size(); ++k)
    least = std::min(least, distance(p, Segment{route[k], route[k + 1]}));
  return least;
}

/// The robots of a scene, each on its own.
struct OnBoard {
  std::vector<Base> bases;
  std::vector<Navigator> navigators;
  std::vector<NavigatorDecision> decisions;
  double time = 0.0;

  explicit OnBoard(const Scenario& scene) {
    NavigatorOptions options;
    options.planner = planner_options(scene);
    for (const RobotSetup& setup : scene.robots) options.fleet_radii.push_back(disc_radius(setup));
    for (const RobotSetup& setup : scene.robots) {
      options.preferred_speed = setup.preferred_speed;
      bases.push_back(base_of(setup));
      navigators.emplace_back(options, scene.obstacles);
      navigators.back().set_goal(setup.goal);
      ++options.id.value;
    }
    decisions.resize(bases.size());
  }

  void step() {
    std::vector<Neighbor> seen;
    for (std::size_t k = 0; k < bases.size(); ++k) {
      seen.clear();
      for (std::size_t other = 0; other < bases.size(); ++other)
        if (other != k) seen.push_back(seen_of(bases[other].robot));
      decisions[k] = navigators[k].step(bases[k].robot, seen, time);
    }
    for (std::size_t k = 0; k < bases.size(); ++k)
      bases[k].hold(navigators[k].planner(), decisions[k].plan);
    time += navigators.front().planner().options().time_step;
  }

  [[nodiscard]] bool all_reached() const {
    for (const NavigatorDecision& decision : decisions)
      if (decision.status != NavigatorStatus::reached) return false;
    return true;
  }
};

}  // namespace avo::test
