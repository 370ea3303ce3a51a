// SPDX-License-Identifier: Apache-2.0
// These are the paper's scenes with its constants (§VI). The tests check which robots arrive and
// which robots meet, and that limits are kept.
#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/metrics.h"
#include "avo_io/scene.h"

namespace avo {
namespace {

constexpr double kRounding = 1.0 + 1e-9;

struct PaperRun {
  Scenario scene;
  RunSummary summary;
  double most_acceleration = 0.0;  // measured from the velocities, part of a_max
};

PaperRun run(const std::string& name, const std::string& motion) {
  PaperRun result{avo_io::load_scenario(name, {"method=avo_paper", "motion=" + motion}), {}, 0.0};
  const Scenario& scene = result.scene;
  Simulation simulation(scene, 2);
  Metrics metrics(scene);
  metrics.observe(simulation);
  const std::int64_t steps = last_step(scene, scene.duration);
  for (std::int64_t k = 0; k < steps; ++k) {
    const FleetView before = simulation.fleet();
    const std::vector<Vec2> last(before.velocity.begin(), before.velocity.end());
    simulation.step();
    metrics.observe(simulation);
    const FleetView fleet = simulation.fleet();
    for (std::size_t i = 0; i < last.size(); ++i) {
      const double a = norm(fleet.velocity[i] - last[i]) / scene.time_step;
      result.most_acceleration =
          std::max(result.most_acceleration, a / fleet.setup[i].max_acceleration);
    }
  }
  result.summary = metrics.summary();
  return result;
}

void expect_paper_constants(const Scenario& scene) {
  EXPECT_EQ(planner_options(scene).control_time, 4.0);
  EXPECT_EQ(planner_options(scene).time_horizon, 10.0);
  EXPECT_EQ(scene.method, Method::avo_paper);
  for (const RobotSetup& robot : scene.robots) {
    EXPECT_EQ(robot.max_acceleration, 1.0);
    EXPECT_EQ(robot.max_speed, 2.0);
  }
}

void expect_limits_kept(const PaperRun& r) {
  EXPECT_LE(r.summary.max_acceleration, kRounding);
  EXPECT_LE(r.most_acceleration, kRounding);
  EXPECT_LE(r.summary.max_speed, 2.0 * kRounding);
}

void report(const std::string& name, const std::string& motion, const RunSummary& s) {
  std::printf(
      "%s %s: %lld of %lld arrived, last %.1f s, %lld pairs overlapped, clearance %.4f m,"
      " %lld infeasible robot-steps of %lld\n",
      name.c_str(), motion.c_str(), static_cast<long long>(s.arrived),
      static_cast<long long>(s.robots), s.last_arrival.value_or(-1.0),
      static_cast<long long>(s.collision_pairs), s.min_clearance.value_or(0.0),
      static_cast<long long>(s.infeasible_steps), static_cast<long long>(s.steps * s.robots));
}

class PaperScenes : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Motions, PaperScenes, testing::Values("held", "exponential"),
                         [](const auto& each) { return each.param; });

TEST_P(PaperScenes, positions_exchange_without_contact) {
  const PaperRun r = run("positions-exchange", GetParam());
  expect_paper_constants(r.scene);
  expect_limits_kept(r);
  report("positions-exchange", GetParam(), r.summary);
  EXPECT_EQ(r.summary.collision_pairs, 0);
  EXPECT_EQ(r.summary.arrived, 2);
  EXPECT_EQ(r.summary.infeasible_steps, 0);
  EXPECT_LT(*r.summary.min_clearance, 0.5) << "they do meet";
}

TEST_P(PaperScenes, the_oncoming_obstacle_is_passed) {
  const PaperRun r = run("moving-obstacle", GetParam());
  expect_paper_constants(r.scene);
  expect_limits_kept(r);
  EXPECT_EQ(r.summary.mover_collisions, 0);
  EXPECT_EQ(r.summary.arrived, 1);
  EXPECT_EQ(r.summary.infeasible_steps, 0);
  EXPECT_LT(*r.summary.last_arrival, 20.0);
}

TEST_P(PaperScenes, circle_10_crosses_without_contact) {
  const PaperRun r = run("circle-10", GetParam());
  expect_paper_constants(r.scene);
  ASSERT_EQ(r.scene.robots.size(), 10u);
  for (const RobotSetup& robot : r.scene.robots) {
    EXPECT_NEAR(norm(robot.position), 20.0, 1e-9);
    EXPECT_NEAR(norm(robot.position + robot.goal), 0.0, 1e-9);
  }
  expect_limits_kept(r);
  report("circle-10", GetParam(), r.summary);
  EXPECT_EQ(r.summary.collision_pairs, 0);
  EXPECT_EQ(r.summary.arrived, 10);
}

// The paper's method alone overlaps where so many meet: what happens is printed, not wished for.
TEST_P(PaperScenes, circle_100_keeps_the_limits) {
  const PaperRun r = run("circle-100", GetParam());
  expect_paper_constants(r.scene);
  ASSERT_EQ(r.scene.robots.size(), 100u);
  expect_limits_kept(r);
  report("circle-100", GetParam(), r.summary);
}

}  // namespace
}  // namespace avo
