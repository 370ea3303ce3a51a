// SPDX-License-Identifier: Apache-2.0
// The methods for comparison on the cases that they are known for (docs/baselines.md).
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "avo/metrics.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

// Two robots drive face to face, 20 m apart, to change places.
Scenario head_on(Method method) {
  Scenario scene;
  scene.method = method;
  scene.sensing_radius = 30.0;
  scene.robots = {test::robot_at({-10, 0}, {10, 0}), test::robot_at({10, 0}, {-10, 0})};
  scene.robots[0].velocity = {2, 0}, scene.robots[1].velocity = {-2, 0};
  return scene;
}

// The robots change places with those opposite.
Scenario circle(Method method, int count, double max_acceleration) {
  Scenario scene;
  scene.method = method;
  scene.sensing_radius = 15.0;
  const double radius = 0.36 * count;
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    const Vec2 place = radius * Vec2{std::cos(angle), std::sin(angle)};
    scene.robots.push_back(test::robot_at(place, -place));
    scene.robots.back().max_acceleration = max_acceleration;
    scene.robots.back().preferred_speed = 2.0;
  }
  return scene;
}

struct Outcome {
  RunSummary summary;
  int turns = 0;           // changes of the sign of the first robot's sidewards velocity
  double rightmost = 0.0;  // m, of the first robot, in head_on()
};

Outcome outcome_of(const Scenario& scene, int steps) {
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  Outcome result;
  double last = 0.0;  // m/s
  for (int k = 0; k < steps; ++k) {
    simulation.step();
    metrics.observe(simulation);
    const double sidewards = simulation.fleet().velocity[0].y;
    if (sidewards * last < 0.0) ++result.turns;
    if (std::abs(sidewards) > 1e-3) last = sidewards;
    result.rightmost = std::max(result.rightmost, -simulation.fleet().position[0].y);
  }
  result.summary = metrics.summary();
  return result;
}

// The reason for RVO: each of two robots takes the other one's evasion for its velocity, and goes
// back. Their paper, Figs. 2 and 4.
TEST(BaselineRuns, velocity_obstacles_oscillate_and_reciprocal_ones_do_not) {
  const Outcome vo = outcome_of(head_on(Method::velocity_obstacle), 250);
  const Outcome rvo = outcome_of(head_on(Method::reciprocal_velocity_obstacle), 250);
  EXPECT_GT(vo.turns, 20);
  EXPECT_LE(rvo.turns, 1);  // out, and back to its line
  EXPECT_EQ(rvo.summary.collision_pairs, 0);
  EXPECT_EQ(rvo.summary.arrived, 2);
}

// ORCA changes velocities by 2 m/s at once. A robot that cannot do so has no room left once τ says
// to evade.
TEST(BaselineRuns, clamped_to_its_acceleration_orca_collides) {
  for (const Method method : {Method::orca, Method::orca_clamped}) {
    Scenario scene = head_on(method);
    scene.time_horizon = 0.5;
    for (RobotSetup& robot : scene.robots) robot.max_acceleration = 0.5;
    const Outcome result = outcome_of(scene, 400);
    EXPECT_EQ(result.summary.collision_pairs, method == Method::orca ? 0 : 1) << to_string(method);
    const bool keeps_limit = result.summary.max_acceleration <= 0.5 * (1.0 + 1e-9);
    EXPECT_EQ(keeps_limit, method == Method::orca_clamped) << to_string(method);
  }
}

// Where it stops at once, its planned stops and its cells are those of the paper's robots, which
// adopt velocities.
TEST(BaselineRuns, buffered_voronoi_cells_keep_apart_who_can_stop_within_a_step) {
  const Outcome result = outcome_of(circle(Method::buffered_voronoi, 24, 20.0), 900);
  EXPECT_EQ(result.summary.arrived, 24);
  EXPECT_GT(result.summary.min_clearance, -1e-6);
}

// Cells turn faster than 1 m/s² follows: nothing is promised, and little is missed.
TEST(BaselineRuns, buffered_voronoi_cells_hardly_overlap_with_slow_brakes) {
  const Outcome result = outcome_of(circle(Method::buffered_voronoi, 24, 1.0), 900);
  EXPECT_EQ(result.summary.arrived, 24);
  EXPECT_GT(result.summary.min_clearance, -0.05);
  EXPECT_LE(result.summary.max_acceleration, 1.0 + 1e-9);
}

// Without the rule for the right they would face each other for ever, each at the side of its cell.
TEST(BaselineRuns, buffered_voronoi_cells_pass_on_the_right) {
  const Outcome result = outcome_of(head_on(Method::buffered_voronoi), 600);
  EXPECT_EQ(result.summary.arrived, 2);
  EXPECT_EQ(result.summary.collision_pairs, 0);
  EXPECT_GT(result.rightmost, 0.4);
}

}  // namespace
}  // namespace avo
