// SPDX-License-Identifier: Apache-2.0
// P12: |a| <= a_max and |v| <= v_max in every step of a dense scene; orca tells its excess.
#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <vector>

#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

constexpr double kRounding = 1.0 + 1e-9;

void expect_limits_in_every_step(const Scenario& scene, int steps,
                                 std::map<PlanStatus, int>& seen) {
  Simulation simulation(scene, 2);
  const FleetView start = simulation.fleet();
  std::vector<Vec2> last(start.velocity.begin(), start.velocity.end());
  for (int k = 0; k < steps && !testing::Test::HasFailure(); ++k) {
    simulation.step();
    const FleetView fleet = simulation.fleet();
    for (std::size_t i = 0; i < last.size(); ++i) {
      const RobotSetup& setup = fleet.setup[i];
      EXPECT_LE(fleet.applied_acceleration[i], setup.max_acceleration * kRounding);
      EXPECT_LE(norm(fleet.velocity[i]), setup.max_speed * kRounding);
      // measured, not told: the mean acceleration over the step
      const double mean = norm(fleet.velocity[i] - last[i]) / scene.time_step;
      EXPECT_LE(mean, setup.max_acceleration * kRounding);
      EXPECT_LE(mean, fleet.applied_acceleration[i] * (1.0 + 1e-9) + 1e-12);
      ++seen[fleet.plan[i].status];
    }
    last.assign(fleet.velocity.begin(), fleet.velocity.end());
  }
}

TEST(SimLimits, P12_hold_in_every_step_of_dense_scenes) {
  std::map<PlanStatus, int> seen;
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    for (const double delta : {0.1, 0.4, 2.0, 8.0}) {
      Scenario scene = test::dense_scene(150, motion, 11);
      scene.control_time = delta;
      expect_limits_in_every_step(scene, 120, seen);
    }
  }
  // dense enough that the limits are what holds the robots back
  EXPECT_GT(seen[PlanStatus::overlapping], 1'000);
  EXPECT_GT(seen[PlanStatus::least_unsafe], 1'000);
}

TEST(SimLimits, P12_hold_in_every_step_of_dense_scenes_of_avo) {
  for (const test::AvoKind kind : test::kAvoKinds) {
    std::map<PlanStatus, int> seen;
    for (const double delta : {0.1, 2.0, 8.0}) {
      Scenario scene = test::dense_avo_scene(150, kind.motion, kind.certificate, 11);
      scene.control_time = delta;
      expect_limits_in_every_step(scene, 100, seen);
    }
    // dense enough that the limits are what holds the robots back
    EXPECT_GT(seen[PlanStatus::refused], 1'000);
    EXPECT_GT(seen[PlanStatus::overlapping], 30);
  }
}

TEST(SimLimits, P12_orca_exceeds_the_acceleration_limit_and_says_so) {
  Scenario scene = test::dense_scene(100, Motion::held, 11);
  for (RobotSetup& robot : scene.robots) robot.model = Holonomic{};
  scene.method = Method::orca;
  Simulation simulation(scene, 2);
  double most = 0.0;
  for (int k = 0; k < 50; ++k) {
    const FleetView before = simulation.fleet();
    const std::vector<Vec2> last(before.velocity.begin(), before.velocity.end());
    simulation.step();
    const FleetView fleet = simulation.fleet();
    for (std::size_t i = 0; i < last.size(); ++i) {
      const double a = norm(fleet.velocity[i] - last[i]) / scene.time_step;
      EXPECT_NEAR(fleet.applied_acceleration[i], a, 1e-9 * (1.0 + a));
      EXPECT_LE(norm(fleet.velocity[i]), fleet.setup[i].max_speed * kRounding);
      most = std::max(most, fleet.applied_acceleration[i] / fleet.setup[i].max_acceleration);
    }
  }
  EXPECT_GT(most, 5.0);
}

// Too fast at the start: the speed comes down as fast as a_max allows, and then stays down.
TEST(SimLimits, a_robot_that_is_too_fast_brakes_down_to_its_limit) {
  for (const int kind : {0, 1, 2, 3}) {
    Scenario scene;
    scene.method = kind < 2 ? Method::avo_paper : Method::avo;
    scene.motion = kind % 2 == 0 ? Motion::held : Motion::exponential;
    scene.control_time = 1.0;
    scene.robots = {test::robot_at({0, 0}, {100, 0}), test::robot_at({0, 90}, {0, 90})};
    scene.robots[0].velocity = {5, 0};
    scene.allow_broken_assumptions = true;
    Simulation simulation(scene, 1);
    double last = 5.0;
    for (int k = 0; k < 100; ++k) {
      simulation.step();
      const double speed = norm(simulation.fleet().velocity[0]);
      EXPECT_LE(simulation.fleet().applied_acceleration[0], kRounding);
      EXPECT_LE(speed, std::max(last, 2.0) * kRounding);
      if (last > 3.0) {
        EXPECT_EQ(simulation.fleet().plan[0].status, PlanStatus::braking);
        EXPECT_NEAR(simulation.fleet().applied_acceleration[0], 1.0, 1e-9);
      }
      last = speed;
    }
    EXPECT_LE(last, 2.01);
  }
}

}  // namespace
}  // namespace avo
