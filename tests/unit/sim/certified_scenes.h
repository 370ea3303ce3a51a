// SPDX-License-Identifier: Apache-2.0
// Scenes with a certificate, and their judge.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "avo/check.h"
#include "avo/simulation.h"

namespace avo::test {

struct Kind {
  Certificate certificate = Certificate::braking_trajectories;
  Motion motion = Motion::held;
};
inline constexpr std::array kKinds{Kind{Certificate::braking_trajectories, Motion::held},
                                   Kind{Certificate::braking_trajectories, Motion::exponential}};

/// Two robots at 2 m/s towards each other and goals beyond, r 0.5 m, a_max 1 m/s².
inline Scenario head_on(double distance, Kind kind) {
  Scenario scene;
  scene.certificate = kind.certificate;
  scene.motion = kind.motion;
  scene.robots.resize(2);
  scene.robots[0].position = {0.0, 0.0};
  scene.robots[0].velocity = {2.0, 0.0};
  scene.robots[0].goal = {30.0, 0.0};
  scene.robots[1].position = {distance, 0.0};
  scene.robots[1].velocity = {-2.0, 0.0};
  scene.robots[1].goal = {-30.0, 0.0};
  return scene;
}

/// Judges what a simulation of the scene does; all robots are there from the start.
class Judge {
 public:
  // The certificate promises that movers touch robots at rest only.
  explicit Judge(const Scenario& scene)
      : check_(robots_of(scene), obstacles_of(scene), {.movers_at_rest = true}) {}

  void observe(const Simulation& simulation) {
    const FleetView fleet = simulation.fleet();
    rows_.clear();
    for (std::size_t i = 0; i < fleet.id.size(); ++i) {
      rows_.push_back({static_cast<std::int64_t>(i), fleet.position[i], fleet.velocity[i]});
    }
    check_.add(simulation.time(), rows_);
  }
  CheckReport report() const { return check_.report(); }

 private:
  // Off the cubic between two rows is a motion that is not one: by a_max Δt⁴/(384 δ²) at most.
  static std::vector<CheckedRobot> robots_of(const Scenario& scene) {
    const double delta = planner_options(scene).control_time, step = scene.time_step;
    std::vector<CheckedRobot> robots;
    for (const RobotSetup& setup : scene.robots) {
      CheckedRobot robot{setup.radius, setup.max_acceleration, setup.max_speed, setup.goal};
      if (scene.motion == Motion::exponential) {
        robot.interpolation_error =
            setup.max_acceleration * std::pow(step, 4.0) / (384.0 * delta * delta);
      }
      robots.push_back(robot);
    }
    return robots;
  }
  static std::vector<CheckedMover> obstacles_of(const Scenario& scene) {
    std::vector<CheckedMover> obstacles;
    for (const MovingObstacle& each : scene.moving_obstacles) {
      obstacles.push_back({each.position, each.velocity, each.acceleration, each.radius});
    }
    return obstacles;
  }

  Check check_;
  std::vector<CheckedState> rows_;
};

/// The whole scene, judged.
inline CheckReport judged(const Scenario& scene, std::int64_t steps) {
  Simulation simulation(scene, 1);
  Judge judge(scene);
  judge.observe(simulation);
  while (simulation.steps() < steps) {
    simulation.step();
    judge.observe(simulation);
  }
  return judge.report();
}

}  // namespace avo::test
