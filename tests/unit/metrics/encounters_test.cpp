// SPDX-License-Identifier: Apache-2.0
// Lists that are made for several steps tell which robots meet in a step. The figures are those of
// looking at all pairs anew, and most robots are never looked at.
#include "metrics/encounters.h"

#include <functional>
#include <gtest/gtest.h>
#include <vector>

#include "avo/simulation.h"
#include "unit/metrics/runs.h"

namespace avo {
namespace {

using test::Random;
using test::robot_at;

// Discs that drift through each other in a square, and what observes them.
struct Drifting {
  std::vector<RobotSetup> setups;
  std::vector<Vec2> position, velocity;
  std::vector<Body> bodies;
  std::vector<Sweep> sweeps;
  int looked_at = 0;  // bodies

  Drifting(int count, double side) {
    Random random(7);
    for (int k = 0; k < count; ++k) {
      position.push_back({random.uniform(0.0, side), random.uniform(0.0, side)});
      velocity.push_back(test::in_disc(random, 2.0));
      setups.push_back(robot_at(position.back(), {}));
      setups.back().radius = random.uniform(0.1, 0.4);
    }
  }

  void observe(Encounters& encounters, std::uint64_t roster, double begin) {
    constexpr double kStep = 0.1;  // s
    bodies.clear(), sweeps.clear();
    for (std::size_t k = 0; k < setups.size(); ++k) {
      Body& body = bodies.emplace_back();
      body.name = k, body.radius = setups[k].radius, body.setup = &setups[k];
      body.position = position[k], body.velocity = velocity[k];
      const Vec2 next = position[k] + kStep * velocity[k];
      body.path = hermite_path(position[k], velocity[k], next, velocity[k], kStep);
      sweeps.push_back({body.path, body.radius, false});
    }
    const auto body = [this](std::size_t k) {
      ++looked_at;
      return bodies[k];
    };
    encounters.observe(sweeps, body, roster, {}, {begin, kStep, true, {}});
    for (std::size_t k = 0; k < setups.size(); ++k) position[k] = bodies[k].path.control[3];
  }
};

void expect_same(const Encounters& a, const Encounters& b) {
  EXPECT_EQ(a.collided, b.collided);
  EXPECT_EQ(a.min_clearance, b.min_clearance);
  EXPECT_EQ(a.first_collision_time, b.first_collision_time);
  EXPECT_EQ(a.overlap_depth, b.overlap_depth);
  EXPECT_EQ(a.collision_robot_steps, b.collision_robot_steps);
  EXPECT_EQ(a.overlapping, b.overlapping);
}

// With another roster at every step, no robot is listed for longer than one step.
TEST(Encounters, are_the_same_whether_robots_are_listed_for_several_steps) {
  for (const double side : {60.0, 20.0, 6.0}) {
    Drifting kept(150, side), anew(150, side);
    Encounters of_lists, of_all;
    for (int k = 0; k < 80; ++k) {
      kept.observe(of_lists, 1, 0.1 * k);
      anew.observe(of_all, static_cast<std::uint64_t>(k) + 1, 0.1 * k);
      ASSERT_NO_FATAL_FAILURE(expect_same(of_lists, of_all)) << k;
    }
    EXPECT_GT(of_lists.collided.size(), 5u) << side;
  }
}

// A robot that is put far away passes every other robot in that step.
TEST(Encounters, are_the_same_where_somebody_is_put_elsewhere) {
  Drifting kept(150, 30.0), anew(150, 30.0);
  Encounters of_lists, of_all;
  for (int k = 0; k < 60; ++k) {
    if (k % 7 == 3)
      kept.velocity[5] = anew.velocity[5] = {k % 2 == 0 ? 300.0 : -300.0, 0.0};
    else
      kept.velocity[5] = anew.velocity[5] = {0.1, 0.0};
    kept.observe(of_lists, 1, 0.1 * k);
    anew.observe(of_all, static_cast<std::uint64_t>(k) + 1, 0.1 * k);
    ASSERT_NO_FATAL_FAILURE(expect_same(of_lists, of_all)) << k;
  }
}

TEST(Encounters, look_at_few_of_those_who_are_far_apart) {
  constexpr int kSteps = 100, kRobots = 400;
  Drifting sparse(kRobots, 400.0);
  Encounters encounters;
  sparse.observe(encounters, 1, 0.0);
  sparse.looked_at = 0;
  for (int k = 1; k < kSteps; ++k) sparse.observe(encounters, 1, 0.1 * k);
  EXPECT_LT(sparse.looked_at, kSteps * kRobots / 50);
  EXPECT_GT(sparse.looked_at, 0);
}

// After a rollback an id may be that of another robot.
TEST(Encounters, setups_are_those_of_the_robots_that_are_there) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({50, 0}, {50, 0})};
  Simulation simulation(scene, 1);
  const std::vector<std::byte> before = simulation.save();
  const auto with_third = [&](double radius) {
    simulation.restore(before);
    RobotSetup setup = robot_at({50, 20}, {50, 20});
    setup.radius = radius;
    EXPECT_EQ(simulation.add_robot(setup).value, 2u);
    return simulation.save();
  };
  const std::vector<std::byte> large = with_third(3.5);
  static_cast<void>(with_third(0.5));
  Metrics metrics(scene);
  metrics.observe(simulation);
  simulation.step();
  metrics.observe(simulation);
  EXPECT_DOUBLE_EQ(*metrics.summary().min_clearance, 19.0);
  simulation.restore(large);
  simulation.step();
  metrics.observe(simulation);
  EXPECT_DOUBLE_EQ(*metrics.summary().min_clearance, 16.0);
}

}  // namespace
}  // namespace avo
