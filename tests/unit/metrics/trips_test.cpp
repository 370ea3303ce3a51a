// SPDX-License-Identifier: Apache-2.0
// Metrics of trips, against cases solved by hand.
#include "metrics/trips.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "runs.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::robot_at;

constexpr double kStep = 0.1;  // s

StaticObstacle wall(std::vector<Vec2> points, bool closed = false) {
  StaticObstacle obstacle;
  obstacle.chains = {{std::move(points), closed}};
  return obstacle;
}

// From rest over 20 m at 2 m/s and 1 m/s^2: up in 2 s, 1 s of braking until it has arrived.
TEST(Trips, of_a_robot_alone) {
  const RunSummary summary = run(alone({robot_at({0, 0}, {20, 0})}), 150);
  const RunMetrics& m = summary.metrics;
  EXPECT_EQ(m.trips, 1);
  EXPECT_EQ(*m.success, 1.0);
  EXPECT_EQ(*m.collision, 0.0);
  EXPECT_EQ(*m.timeout, 0.0);
  EXPECT_GE(*m.extra_time_mean, -1e-9);
  EXPECT_LE(*m.extra_time_mean, kStep + 1e-9);
  EXPECT_EQ(*m.extra_time_p75, *m.extra_time_mean);
  EXPECT_EQ(*m.extra_time_p90, *m.extra_time_mean);
  EXPECT_NEAR(*m.flowtime, 11.0, kStep + 1e-9);
  EXPECT_NEAR(*m.path_ratio, 1.0, 1e-12);
  EXPECT_NEAR(*m.effort, 3.0, 1.5 * kStep);
  // two changes by 1 m/s^2 in as many steps as there are, each within one or two steps
  const double steps = *m.flowtime / kStep - 1.0;
  EXPECT_LE(*m.jerk, std::sqrt(2.0 / (kStep * kStep) / steps) + 1e-9);
  EXPECT_GE(*m.jerk, std::sqrt(1.0 / (kStep * kStep) / steps));
  EXPECT_EQ(*m.reversals, 1.0);  // to braking
  EXPECT_NEAR(*m.efficacy, 19.5 / 22.0, 0.01);
  EXPECT_EQ(*m.deadlock_time, 0.0);
  EXPECT_EQ(m.collision_robot_steps, 0);
  EXPECT_EQ(m.overlap_depth, 0.0);
}

TEST(Trips, of_nobody) {
  RobotSetup parked = robot_at({0, 0}, {0, 0});
  parked.behavior = Behavior::parked;
  const RunMetrics m = run(alone({parked}), 3).metrics;
  EXPECT_EQ(m, RunMetrics{});
}

// One robot is within 0.5 m of its goal from the start on. The other robot is on a route that it
// never ends.
TEST(Trips, of_those_that_need_no_time_and_too_much) {
  RobotSetup idle = robot_at({0, 50}, {30, 50});
  idle.preferred_speed = 0.0;
  const RunMetrics m = run(alone({robot_at({0, 0}, {0.4, 0}), idle}), 20).metrics;
  EXPECT_EQ(*m.extra_time_mean, 0.0);
  EXPECT_EQ(*m.success, 0.5);
  EXPECT_EQ(*m.timeout, 0.5);
  EXPECT_FALSE(m.flowtime);
  EXPECT_FALSE(m.path_ratio);
  EXPECT_FALSE(m.efficacy);
  EXPECT_EQ(*m.deadlock_time, 0.0);  // a robot that wants to stand is not stuck
}

// Closing at 4 m/s, nearest at 0.3 m: overlap from 2.2615 s to 2.7385 s, which is in six steps.
TEST(Trips, that_overlap) {
  const Scenario scene = blind({cruising({-5, 0}, {50, 0}), cruising({5, 0.3}, {-50, 0.3})});
  const RunMetrics m = run(scene, 40).metrics;
  EXPECT_EQ(m.collision_robot_steps, 2 * 6);
  EXPECT_NEAR(m.overlap_depth, 0.7, 1e-9);
  EXPECT_EQ(*m.collision, 1.0);
  EXPECT_EQ(*m.success, 0.0);
  EXPECT_EQ(*m.timeout, 0.0);
}

// A robot in the middle of two others counts once a step, and depth is relative to both radii.
TEST(Trips, that_overlap_with_two_others) {
  Scenario scene = blind({robot_at({0, 0}, {0, 0}), robot_at({0.9, 0}, {0.9, 0}),
                          robot_at({2.1, 0}, {2.1, 0}), robot_at({40, 0}, {50, 0})});
  scene.robots[2].radius = 1.0;
  const RunMetrics m = run(scene, 10).metrics;
  EXPECT_EQ(m.collision_robot_steps, 3 * 10);
  EXPECT_NEAR(m.overlap_depth, 0.3 / 1.5, 1e-9);
  EXPECT_EQ(*m.collision, 0.75);  // at the start as well
}

// Overlaps after the arrival are no part of the trip.
TEST(Trips, that_end_before_an_overlap) {
  const Scenario scene = blind({robot_at({0, 0}, {0, 0}), cruising({-6, 0}, {60, 0})});
  const RunMetrics m = run(scene, 80).metrics;
  EXPECT_GT(m.collision_robot_steps, 0);
  EXPECT_EQ(*m.collision, 0.5);
  EXPECT_EQ(*m.success, 0.5);
}

Trip scripted() {
  Trip trip;
  trip.preferred_speed = 2.0;
  trip.progress = 10.0;
  trip.step = kStep;
  trip.acceleration_limit = 1.0;
  return trip;
}

// Velocities 0, 1, 0, 1, ... m/s: the acceleration changes its sign in each step but the first.
TEST(Trips, of_a_robot_that_oscillates) {
  Trip trip = scripted();
  for (int k = 1; k <= 10; ++k)
    go_on(trip, {0.05 * k, 0.0}, {k % 2 == 1 ? 1.0 : 0.0, 0.0}, 10.0 - 0.05 * k, kStep, true);
  EXPECT_EQ(trip.reversals, 9);
  EXPECT_NEAR(trip.length, 0.5, 1e-12);
  EXPECT_NEAR(trip.effort, 10 * 100.0 * kStep, 1e-9);
  EXPECT_NEAR(trip.jerk_squared, 9 * 200.0 * 200.0, 1e-6);
  EXPECT_EQ(trip.jerk_steps, 9.0);
  EXPECT_EQ(trip.deadlock_time, 0.0);
}

// To the side as well, across pauses, and not by less than a hundredth of the limit, nor by a turn
// of 90 degrees or less.
TEST(Trips, reverse_where_accelerations_point_against_each_other) {
  Trip trip = scripted();
  const auto accelerate = [&](Vec2 a) {
    const Vec2 next = trip.velocity + kStep * a;
    go_on(trip, trip.position, next, 10.0, kStep, true);
    return trip.reversals;
  };
  EXPECT_EQ(accelerate({0, 1}), 0);
  EXPECT_EQ(accelerate({1, 0}), 0);
  EXPECT_EQ(accelerate({0, -1}), 0);
  EXPECT_EQ(accelerate({0, 0}), 0);
  EXPECT_EQ(accelerate({0, 0.009}), 0);
  EXPECT_EQ(accelerate({0, 1}), 1);
  EXPECT_EQ(accelerate({0.1, -1}), 2);
}

// Nearer than ever before by a hundredth of 2 m/s: 0.002 m in a step, or in several ones.
TEST(Trips, make_progress_where_they_are_nearer_than_ever) {
  Trip trip = scripted();
  const auto steps_without_progress = [&](std::vector<double> ways) {
    for (const double route_left : ways) go_on(trip, {}, {}, route_left, kStep, true);
    return std::lround(trip.deadlock_time / kStep);
  };
  EXPECT_EQ(steps_without_progress({9.9, 9.8}), 0);
  EXPECT_EQ(steps_without_progress({9.8, 9.7985}), 2);
  EXPECT_EQ(steps_without_progress({9.797}), 2);               // with that before
  EXPECT_EQ(steps_without_progress({10.5, 10.0, 9.8}), 5);     // back, and there again
  EXPECT_EQ(steps_without_progress({9.5, 9.6, 9.5, 9.4}), 7);  // to and fro
}

TEST(Trips, of_a_robot_that_walls_keep_from_its_goal) {
  Scenario scene = alone({robot_at({0, 0}, {20, 0})});
  scene.obstacles = {wall({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, true)};
  const RunMetrics m = run(scene, 100).metrics;
  EXPECT_NEAR(*m.deadlock_time, 10.0, 1e-9);
  EXPECT_EQ(*m.timeout, 1.0);
  EXPECT_FALSE(m.extra_time_mean);
  EXPECT_FALSE(m.efficacy);
  EXPECT_FALSE(m.path_ratio);
  EXPECT_GT(*m.effort, 0.0);  // to the nearest place
}

// Without navigation it drives into a blind alley, 2.5 m in at most 5 s, and trembles there.
TEST(Trips, of_a_robot_in_a_blind_alley) {
  Scenario scene = alone({robot_at({0, 0}, {20, 0})});
  scene.obstacles = {wall({{-3, -0.7}, {3, -0.7}, {3, 0.7}, {-3, 0.7}})};
  scene.navigation = false;
  const RunMetrics m = run(scene, 400).metrics;
  EXPECT_GT(*m.deadlock_time, 35.0);
  EXPECT_LT(*m.deadlock_time, 38.0);
}

// The route around the end of a wall is as long as the route to its corner and on, within the
// radius.
TEST(Trips, go_by_the_shortest_way_around_walls) {
  Scenario scene = alone({robot_at({-4, 0}, {4, 0})});
  scene.obstacles = {wall({{0, -3}, {0, 30}})};
  const Simulation simulation(scene, 1);
  const Simulation::Route route = simulation.route({0});
  EXPECT_GT(route.length, 2.0 * std::sqrt(16.0 + 3.0 * 3.0));
  EXPECT_LT(route.length, 2.0 * std::sqrt(16.0 + 3.6 * 3.6) + 1.0);
  EXPECT_LT(route.next.y, -3.0);
  const RunMetrics m = run(scene, 200).metrics;
  EXPECT_GT(*m.path_ratio, 0.98);
  EXPECT_LT(*m.path_ratio, 1.1);
  EXPECT_LT(*m.extra_time_mean, 5.0);
  EXPECT_GT(*m.extra_time_mean, 0.0);

  scene.navigation = false;
  EXPECT_EQ(Simulation(scene, 1).route({0}).length, 8.0);
}

TEST(Trips, begin_anew_where_the_goal_is_changed) {
  const Scenario scene = alone({robot_at({0, 0}, {50, 0})});
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  for (int k = 0; k < 300; ++k) {
    if (k == 60) simulation.set_goal({0}, {simulation.fleet().position[0].x + 20.0, 0});
    simulation.step();
    metrics.observe(simulation);
  }
  // at 2 m/s from the start, 20 m less a step
  const RunMetrics m = metrics.summary().metrics;
  EXPECT_NEAR(*m.flowtime, 10.0, 2 * kStep + 1e-9);
  EXPECT_NEAR(*m.extra_time_mean, 0.0, kStep + 1e-9);
  EXPECT_NEAR(*m.path_ratio, 1.0, 1e-9);
  EXPECT_EQ(*m.reversals, 0.0);  // speeding up was before
}

TEST(Trips, of_robots_that_come_and_go) {
  const Scenario scene = alone({robot_at({0, 0}, {20, 0}), robot_at({0, 30}, {20, 30})});
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  for (int k = 0; k < 250; ++k) {
    if (k == 30) simulation.remove_robot({0});
    if (k == 50) simulation.add_robot(robot_at({0, 60}, {20, 60}));
    simulation.step();
    metrics.observe(simulation);
  }
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.robots, 3);
  EXPECT_EQ(summary.arrived, 2);
  EXPECT_FALSE(metrics.all_arrived());
  EXPECT_EQ(summary.metrics.trips, 3);
  EXPECT_NEAR(*summary.metrics.success, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(*summary.metrics.extra_time_mean, 0.0, kStep + 1e-9);
}

TEST(Quantile, is_the_least_value_that_more_than_the_share_does_not_exceed) {
  std::vector<double> values{5.0, 1.0, 4.0, 2.0, 3.0};
  EXPECT_EQ(quantile(values, 0.0), 1.0);
  EXPECT_EQ(quantile(values, 0.5), 3.0);
  EXPECT_EQ(quantile(values, 0.75), 4.0);
  EXPECT_EQ(quantile(values, 0.9), 5.0);
  std::vector<double> hundred;
  for (int k = 1; k <= 100; ++k) hundred.push_back(k);
  EXPECT_EQ(quantile(hundred, 0.99), 100.0);
  EXPECT_EQ(quantile(hundred, 0.5), 51.0);
}

TEST(Metrics, step_times_have_a_median_and_a_99th_percentile) {
  Metrics metrics(alone({robot_at({0, 0}, {20, 0})}));
  EXPECT_FALSE(metrics.summary().metrics.step_ms_p50);
  for (int k = 200; k >= 1; --k) metrics.add_step_time(k);
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(*summary.metrics.step_ms_p50, 101.0);
  EXPECT_EQ(*summary.step_milliseconds_median, 101.0);
  EXPECT_EQ(*summary.metrics.step_ms_p99, 199.0);
}

}  // namespace
}  // namespace avo
