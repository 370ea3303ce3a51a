// SPDX-License-Identifier: Apache-2.0
// Metrics of the trips of crowds, against the columns of whole runs.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "runs.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::robot_at;

// Everything again from the columns of a run.
struct Expected {
  double effort = 0.0, jerk_squared = 0.0, jerk_steps = 0.0, ratio = 0.0, efficacy = 0.0;
  double arrived = 0.0, deadlock = 0.0;
};
Expected expected_of(const Scenario& scene, int steps) {
  Simulation simulation(scene, 1);
  const std::size_t count = scene.robots.size();
  std::vector<std::vector<Vec2>> p(count), v(count);
  std::vector<bool> has_arrived(count, false);
  const auto look = [&] {
    for (std::size_t i = 0; i < count; ++i) {
      if (has_arrived[i]) continue;
      p[i].push_back(simulation.fleet().position[i]);
      v[i].push_back(simulation.fleet().velocity[i]);
      has_arrived[i] = norm(scene.robots[i].goal - p[i].back()) <= scene.arrival_distance;
    }
  };
  look();
  for (int k = 0; k < steps; ++k) simulation.step(), look();
  Expected all;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 goal = scene.robots[i].goal;
    double length = 0.0, nearest = norm(goal - p[i].front());
    const double preferred = scene.robots[i].preferred_speed, dt = scene.time_step;
    for (std::size_t k = 1; k < p[i].size(); ++k) {
      length += norm(p[i][k] - p[i][k - 1]);
      all.effort += norm_squared(v[i][k] - v[i][k - 1]) / dt;
      const double left = norm(goal - p[i][k]);
      const bool is_nearer = nearest - left >= 0.01 * preferred * dt;
      all.deadlock += is_nearer ? 0.0 : dt;
      nearest = is_nearer ? left : nearest;
      if (k < 2) continue;
      const Vec2 change = v[i][k] - 2.0 * v[i][k - 1] + v[i][k - 2];
      all.jerk_squared += norm_squared(change) / (dt * dt * dt * dt);
      all.jerk_steps += 1.0;
    }
    const double before = norm(goal - p[i].front()), after = norm(goal - p[i].back());
    all.efficacy += (before - after) / (preferred * dt * static_cast<double>(p[i].size() - 1));
    if (!has_arrived[i]) continue;
    all.arrived += 1.0;
    all.ratio += (length + after) / before;
  }
  return all;
}

TEST(Trips, of_a_crowd_are_those_of_its_columns) {
  for (const Method method : {Method::avo, Method::avo_paper, Method::orca}) {
    Scenario scene = test::dense_scene(20, Motion::held, 3);
    scene.method = method;
    for (RobotSetup& robot : scene.robots) {
      robot.model = Holonomic{};
      robot.goal = robot.goal + Vec2{12.0, 3.0};
    }
    const int steps = 200;
    const Expected expected = expected_of(scene, steps);
    const RunMetrics m = run(scene, steps).metrics;
    const auto count = static_cast<double>(scene.robots.size());
    EXPECT_GT(expected.arrived, 5.0);
    EXPECT_NEAR(*m.effort, expected.effort / count, 1e-9 * *m.effort);
    EXPECT_NEAR(*m.jerk, std::sqrt(expected.jerk_squared / expected.jerk_steps), 1e-9 * *m.jerk);
    EXPECT_NEAR(*m.path_ratio, expected.ratio / expected.arrived, 1e-9);
    EXPECT_NEAR(*m.efficacy, expected.efficacy / count, 1e-9);
    EXPECT_NEAR(*m.deadlock_time, expected.deadlock / count, 1e-9);
    EXPECT_NEAR(*m.success + *m.collision + *m.timeout, 1.0, 1e-12);
  }
}

TEST(Trips, are_the_same_for_any_number_of_threads) {
  Scenario scene = test::dense_scene(300, Motion::held, 5);
  const MetricsOptions options{.crowd = true, .line = MeasuringLine{{5, 0}, {5, 20}}};
  const auto metrics_of = [&](int threads) {
    Simulation simulation(scene, threads);
    Metrics metrics(scene, options);
    metrics.observe(simulation);
    for (int k = 0; k < 30; ++k) simulation.step(), metrics.observe(simulation);
    return metrics.summary().metrics;
  };
  const RunMetrics one = metrics_of(1);
  EXPECT_GT(*one.jerk, 0.0);
  EXPECT_GT(*one.turned_back, 0.0);
  EXPECT_GT(one.crossing_times->size(), 5U);
  EXPECT_EQ(one, metrics_of(2));
  EXPECT_EQ(one, metrics_of(3));
}

// As one robot among people is: the others count as those that it meets.
TEST(Trips, of_the_judged_are_those_of_a_crowd_without_the_others) {
  Scenario scene =
      alone({robot_at({0, 0}, {20, 0}), robot_at({0, 0.7}, {20, 9}), robot_at({0, 30}, {0, 900})});
  scene.certificate = Certificate::none;
  scene.allow_broken_assumptions = true;
  const auto metrics_of = [&](std::vector<RobotId> judged, bool& arrived) {
    Simulation simulation(scene, 1);
    Metrics metrics(scene, {.crowd = true, .judged = std::move(judged)});
    metrics.observe(simulation);
    for (int k = 0; k < 150; ++k) simulation.step(), metrics.observe(simulation);
    arrived = metrics.all_arrived();
    return metrics.summary().metrics;
  };
  bool arrived = false;
  const RunMetrics first = metrics_of({RobotId{0}}, arrived);
  EXPECT_TRUE(arrived);
  EXPECT_EQ(first.trips, 1);
  EXPECT_EQ(first.collision, 1.0);
  EXPECT_GT(*first.danger, 0.0);
  const RunMetrics third = metrics_of({RobotId{2}}, arrived);
  EXPECT_FALSE(arrived);
  EXPECT_EQ(third.collision, 0.0);
  EXPECT_EQ(third.danger, 0.0);
  const RunMetrics two = metrics_of({RobotId{2}, RobotId{0}}, arrived);
  EXPECT_EQ(two.trips, 2);
  EXPECT_EQ(two.collision, 0.5);
  EXPECT_DOUBLE_EQ(*two.effort, 0.5 * (*first.effort + *third.effort));
  EXPECT_EQ(metrics_of({}, arrived).trips, 3);
}

// Movers are as dangerous as robots, but take no room in a crowd.
TEST(Trips, of_a_robot_beside_a_mover_are_in_danger) {
  Scenario scene = alone({robot_at({0, 0}, {20, 0})});
  scene.certificate = Certificate::none;
  scene.moving_obstacles = {{.position = {0, 1.1}, .radius = 0.5}};
  Simulation simulation(scene, 1);
  Metrics metrics(scene, {.crowd = true});
  metrics.observe(simulation);
  for (int k = 0; k < 5; ++k) simulation.step(), metrics.observe(simulation);
  EXPECT_GT(*metrics.summary().metrics.danger, 0.9);
  EXPECT_NEAR(*metrics.summary().metrics.density_mean, 1.0 / 12.0, 1e-9);
}

// Where each decides on its own, jerk and effort are those of what is held between decisions.
TEST(Trips, of_robots_with_clocks_of_their_own) {
  Scenario scene = alone({robot_at({0, 0}, {20, 0}), robot_at({0, 30}, {20, 30})});
  const RunMetrics common = run(scene, 150).metrics;
  scene.clock = Clock::free;
  scene.robots[1].time_step = 0.07;
  const RunMetrics m = run(scene, 500).metrics;
  EXPECT_NEAR(*m.effort, *common.effort, 0.5);
  EXPECT_NEAR(*m.jerk, *common.jerk, 0.4 * *common.jerk);
  EXPECT_NEAR(*m.extra_time_mean, 0.1, 0.15);
  EXPECT_EQ(*m.reversals, 1.0);
}

}  // namespace
}  // namespace avo
