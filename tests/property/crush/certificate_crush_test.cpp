// SPDX-License-Identifier: Apache-2.0
// The certificate's promise through the planner: crowds of unequal robots, all sent to one point
// after the other, judged in continuous time by Check, which shares no formula with it.
#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <tuple>
#include <vector>

#include "avo/simulation.h"
#include "property/crushes.h"

namespace avo::test {
namespace {

constexpr double kRallyPeriod = 5.0;  // s

struct Crush {
  std::string name;
  Certificate kind;
  Motion motion;
  int robots;
  double extent;  // m, side of the square they start in
  int steps;      // of 0.1 s
  double most_priority = 1.0;
};

// The large ones find room first.
std::vector<RobotSetup> unequal_robots(const Crush& crush, Random& random) {
  std::vector<double> radii;
  for (int k = 0; k < crush.robots; ++k) radii.push_back(random.uniform(0.3, 0.6));
  std::sort(radii.rbegin(), radii.rend());
  std::vector<RobotSetup> robots;
  while (robots.size() < radii.size()) {
    RobotSetup robot;
    robot.radius = radii[robots.size()];
    const double x = random.uniform(-0.5, 0.5), y = random.uniform(-0.5, 0.5);
    robot.position = crush.extent * Vec2{x, y};
    const bool clear = std::all_of(robots.begin(), robots.end(), [&](const RobotSetup& other) {
      return norm(other.position - robot.position) > other.radius + robot.radius + 0.02;
    });
    if (!clear) continue;
    robot.max_acceleration = random.uniform(0.3, 3.0);
    if (crush.most_priority > 1.0)
      robot.priority = random.log_uniform(1.0 / crush.most_priority, crush.most_priority);
    robots.push_back(robot);
  }
  return robots;
}

Scenario scene_of(const Crush& crush, Random& random) {
  Scenario scene;
  scene.certificate = crush.kind;
  scene.motion = crush.motion;
  scene.sensing_radius = 40.0;  // more than any two need to stop
  scene.max_neighbors = 10;
  scene.duration = 0.1 * crush.steps;
  scene.robots = unequal_robots(crush, random);
  return scene;
}

class Crushed : public testing::TestWithParam<Crush> {};

TEST_P(Crushed, unequal_robots_at_one_point_never_overlap) {
  const Crush& crush = GetParam();
  Random random(7);
  const Scenario scene = scene_of(crush, random);
  Simulation simulation(scene, 1);
  Check check = judge_of(scene);
  observe(simulation, check);
  const int period = static_cast<int>(kRallyPeriod / scene.time_step);
  for (int step = 0; step < crush.steps; ++step) {
    if (step % period == 0) {
      const Vec2 rally = in_disc(random, 5.0);
      for (std::size_t k = 0; k < scene.robots.size(); ++k) simulation.set_goal({k}, rally);
    }
    simulation.step();
    observe(simulation, check);
    for (const Plan& plan : simulation.fleet().plan) {
      ASSERT_NE(plan.status, PlanStatus::overlapping) << "step " << step;
      ASSERT_NE(plan.status, PlanStatus::invalid_input) << "step " << step;
    }
  }
  const CheckReport report = check.report();
  EXPECT_EQ(report.overlaps.count, 0) << "deepest " << report.overlaps.worst;
  EXPECT_EQ(report.accelerations.count, 0) << "by up to " << report.accelerations.worst;
  EXPECT_EQ(report.speeds.count, 0) << "by up to " << report.speeds.worst;
  EXPECT_EQ(report.jumps.count, 0);
  EXPECT_EQ(report.robot_steps, static_cast<std::int64_t>(crush.robots) * crush.steps);
  ASSERT_TRUE(report.least_clearance);
  EXPECT_GE(*report.least_clearance, -1e-9);
  EXPECT_LT(*report.least_clearance, 0.02);  // it was tight
  EXPECT_GT(report.largest_speed, 1.0);      // and fast
}

constexpr Certificate kTrajectories = Certificate::braking_trajectories;

INSTANTIATE_TEST_SUITE_P(
    , Crushed,
    testing::Values(Crush{"braking_trajectories_60", kTrajectories, Motion::held, 60, 12.0, 2000},
                    Crush{"braking_trajectories_exponential_60", kTrajectories, Motion::exponential,
                          60, 12.0, 2000},
                    Crush{"braking_trajectories_200", kTrajectories, Motion::held, 200, 22.0, 800},
                    Crush{"braking_trajectories_exponential_200", kTrajectories,
                          Motion::exponential, 200, 22.0, 800},
                    Crush{"braking_trajectories_priorities", kTrajectories, Motion::held, 60, 12.0,
                          2000, 64.0},
                    Crush{"braking_trajectories_exponential_priorities", kTrajectories,
                          Motion::exponential, 60, 12.0, 800, 64.0}),
    [](const testing::TestParamInfo<Crush>& each) { return each.param.name; });

}  // namespace
}  // namespace avo::test
