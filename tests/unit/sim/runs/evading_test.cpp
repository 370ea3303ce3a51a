// SPDX-License-Identifier: Apache-2.0
// What a decision says of the evasive maneuver that it takes; and robots that may not swerve
// (docs/movers.md, "Rule").
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/simulation.h"
#include "support/generators.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::Random;
using test::robot_at;

Neighbor walker(Vec2 position, Vec2 velocity) {
  return {.position = position, .velocity = velocity, .behavior = Behavior::moves_on};
}

Robot resting() {
  Robot robot;
  robot.radius = 0.4;
  return robot;
}

constexpr double kStep = 0.1;  // s

// The robot goes on as the evasion says, and then it brakes. The result is the least distance from
// the walker's disc, in m.
double clearance_on(Robot robot, const Neighbor& other, Vec2 first, const Evasion& way) {
  double least = 1e9, time = 0.0;
  Vec2 next = first;
  for (int k = 0; k < 300; ++k) {
    for (int part = 1; part <= 8; ++part) {
      const double t = kStep * part / 8.0;
      const Vec2 place =
          robot.position + t * robot.velocity + (0.5 * t * t / kStep) * (next - robot.velocity);
      const Vec2 c = other.position + (time + t) * other.velocity;
      least = std::min(least, norm(place - c) - robot.radius - other.radius);
    }
    robot.position = robot.position + 0.5 * kStep * (robot.velocity + next);
    robot.velocity = next, time += kStep;
    const bool brakes = time >= way.duration - 1e-9;
    const Vec2 left = (brakes ? Vec2{} : way.velocity) - robot.velocity;
    // gently, as ways are at first; braking is full
    const double most = (brakes ? 1.0 : 0.6) * kStep;
    next = robot.velocity + std::min(1.0, most / std::max(norm(left), 1e-12)) * left;
  }
  return least;
}

TEST(Evading, says_whom_and_on_which_way) {
  const Planner planner(default_options(Method::avo));
  PlanWorkspace workspace;
  Robot robot;
  robot.velocity = robot.preferred_velocity = {2, 0};
  int evading = 0;
  for (int step = 0; step < 120; ++step) {
    // the other one stands aside
    const std::vector<Neighbor> others{walker({9.0, 9.0}, {}),
                                       walker({2.0, 3.0 - 0.1 * step}, {0, -1})};
    const Plan plan = planner.plan(robot, others, workspace);
    const auto way = planner.evasion(robot, others, workspace);
    ASSERT_EQ(way.has_value(), plan.evading) << step;
    if (way) {
      ++evading;
      EXPECT_EQ(way->neighbor, 1) << step;
      EXPECT_GE(way->duration, 0.0);
      EXPECT_LE(way->duration, 4.0 + 2.0 * kStep);
      EXPECT_LE(norm(way->velocity), 2.0 + 1e-9);
      EXPECT_GE(clearance_on(robot, others[1], plan.next_velocity, *way), 0.0) << step;
    }
    robot.position = robot.position + 0.5 * kStep * (robot.velocity + plan.next_velocity);
    robot.velocity = plan.next_velocity;
  }
  EXPECT_GT(evading, 0);
  EXPECT_LT(evading, 110) << "not any longer when it has made room";
}

TEST(Evading, is_no_word_for_what_is_chosen_anyway) {
  const Planner planner(default_options(Method::avo));
  PlanWorkspace workspace;
  Robot robot;
  robot.preferred_velocity = {1, 0};
  const auto evades = [&](const std::vector<Neighbor>& others) {
    const bool flag = planner.plan(robot, others, workspace).evading;
    EXPECT_EQ(planner.evasion(robot, others, workspace).has_value(), flag);
    return flag;
  };
  EXPECT_FALSE(evades({}));
  EXPECT_FALSE(evades({walker({-50, 9}, {0, 1})}));
  Neighbor peer = walker({-2.5, 0}, {1.5, 0});
  peer.behavior = Behavior::decides;
  EXPECT_FALSE(evades({peer}));
  robot.velocity = robot.preferred_velocity = {2, 0};
  EXPECT_TRUE(evades({walker({2, 3}, {0, -1})}));
}

// The walker that is nearest goes away, and hinders no robot.
TEST(Evading, names_the_one_that_is_in_the_way) {
  const Planner planner(default_options(Method::avo));
  PlanWorkspace workspace;
  Robot robot;
  robot.velocity = robot.preferred_velocity = {2, 0};
  const std::vector<Neighbor> others{walker({-1.2, 0}, {-2, 0}), walker({2, 3}, {0, -1})};
  const auto way = planner.evasion(robot, others, workspace);
  ASSERT_TRUE(way.has_value());
  EXPECT_EQ(way->neighbor, 1);
  const std::vector<Neighbor> turned{others[1], others[0]};
  EXPECT_EQ(planner.evasion(robot, turned, workspace).value().neighbor, 0);
}

// What was said of one decision is not said of the next one.
TEST(Evading, ends) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({0, 9}, {0.5, 9})};
  MovingObstacle mover;
  mover.position = {-8, 0}, mover.velocity = {1.5, 0}, mover.radius = 0.3;
  scene.moving_obstacles = {mover};
  scene.sensing_radius = 11.0;
  Simulation simulation(scene, 1);
  int evading = 0, last = 0;
  for (int step = 0; step < 200; ++step) {
    simulation.step();
    if (simulation.fleet().plan[0].evading) ++evading, last = step;
    EXPECT_FALSE(simulation.fleet().plan[1].evading);
  }
  EXPECT_GT(evading, 0);
  EXPECT_LT(last, 120);
}

TEST(WayOut, there_is_one_or_not) {
  const Planner planner(default_options(Method::avo));
  PlanWorkspace workspace;
  const Robot robot = resting();
  const auto has = [&](const std::vector<Neighbor>& others, const std::vector<Wall>& walls = {}) {
    return planner.has_evasive_maneuver(robot, others, workspace, walls);
  };
  EXPECT_TRUE(has({}));
  EXPECT_TRUE(has({walker({-8, 0}, {1, 0})}));
  EXPECT_FALSE(has({walker({-1.5, 0}, {4, 0})})) << "0.2 s before contact";
  // Between two walls there is no room aside, and the walker comes faster than the robot can run.
  const std::vector<Wall> walls{{{-40, 0.6}, {40, 0.6}, 0.0}, {{-40, -0.6}, {40, -0.6}, 0.0}};
  EXPECT_FALSE(has({walker({-12, 0}, {3, 0})}, walls));
  EXPECT_TRUE(has({walker({-12, 0}, {3, 0})}));
  // A robot that decides hinders no other one here.
  Neighbor peer = walker({0.75, 0}, {});
  peer.behavior = Behavior::decides;
  EXPECT_TRUE(has({walker({-8, 0}, {1, 0}), peer}));
  Robot car = robot;
  car.model = Car{0.7};
  EXPECT_TRUE(planner.has_evasive_maneuver(car, std::vector{walker({-8, 0}, {1, 0})}, workspace));
  Robot airplane = robot;
  airplane.model = Airplane{}, airplane.velocity = {1.0, 0.0};
  EXPECT_TRUE(planner.has_evasive_maneuver(airplane, {}, workspace)) << "its circle";
  PlannerOptions bare = default_options(Method::avo);
  bare.certificate = Certificate::none;
  EXPECT_FALSE(Planner(bare).has_evasive_maneuver(robot, {}, workspace));
  Robot broken = robot;
  broken.radius = -1.0;
  EXPECT_FALSE(planner.has_evasive_maneuver(broken, {}, workspace));
}

// The course that leaves the strip of a wide moving obstacle takes more than 2 T = 2.2 s.
TEST(WayOut, is_long_enough_for_wide_movers) {
  const Planner planner(default_options(Method::avo));
  PlanWorkspace workspace;
  Robot robot = resting();
  robot.radius = 0.36, robot.max_speed = 1.3, robot.max_acceleration = 2.0;
  Neighbor truck = walker({-20, 0}, {1, 0});
  truck.radius = 3.0;
  EXPECT_TRUE(planner.has_evasive_maneuver(robot, std::vector{truck}, workspace));
}

// A mover that comes into sight late. Judged by where both are, as braking would go on from there.
struct Meeting {
  bool hit = false, unable_to_stop = false;
};
Meeting meet(Random random, bool never_swerves) {
  Scenario scene;
  scene.never_swerves = never_swerves;
  scene.robots = {robot_at({0, 0}, {20, 0})};
  scene.robots[0].radius = 0.4;
  scene.robots[0].velocity = {random.uniform(0.0, 2.0), 0};
  const double speed = random.uniform(2.0, 5.0), time = random.uniform(0.7, 3.0);
  const Vec2 along = random.direction();
  const Vec2 meets =
      time * scene.robots[0].velocity + random.uniform(-0.8, 0.8) * Vec2{-along.y, along.x};
  MovingObstacle mover;
  mover.radius = 0.6, mover.velocity = speed * along, mover.position = meets - time * speed * along;
  scene.moving_obstacles = {mover};
  scene.sensing_radius = 60.0;
  scene.allow_broken_assumptions = true;
  Simulation simulation(scene, 1);
  PlanWorkspace workspace;
  Meeting met;
  const auto state = [&] {
    const auto seen = simulation.perceive({0});
    return simulation.planner().state(seen.robot, seen.neighbors, workspace).state;
  };
  if (state() != SafetyState::safe && state() != SafetyState::doomed) return met;
  for (int step = 0; step < 60; ++step) {
    simulation.step();
    const Vec2 c = mover.position + simulation.time() * mover.velocity;
    met.hit = met.hit || norm(simulation.fleet().position[0] - c) < 1.0 - 1e-9;
    if (!met.hit && simulation.fleet().velocity[0] != Vec2{} && state() == SafetyState::unknown)
      met.unable_to_stop = true;
  }
  return met;
}

TEST(Swerving, is_left_out_where_the_option_says_so) {
  int swerves = 0, hits = 0, strict_hits = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Meeting usual = meet(Random(seed), false), strict = meet(Random(seed), true);
    swerves += usual.unable_to_stop ? 1 : 0;
    hits += usual.hit ? 1 : 0, strict_hits += strict.hit ? 1 : 0;
    EXPECT_FALSE(strict.unable_to_stop) << seed;
  }
  EXPECT_GT(swerves, 0);
  EXPECT_GT(strict_hits, hits);
}

TEST(Swerving, is_left_out_by_method_avo_alone) {
  PlannerOptions options = default_options(Method::orca);
  options.never_swerves = true;
  EXPECT_EQ(test::refusal([&] { Planner{options}; }),
            "PlannerOptions.never_swerves: found true, must be false with method orca");
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {5, 0})};
  scene.never_swerves = true;
  EXPECT_TRUE(planner_options(scene).never_swerves);
  EXPECT_TRUE(Simulation(scene, 1).planner().options().never_swerves);
  const Simulation saved(Simulation(scene, 1).save(), 1);
  EXPECT_TRUE(saved.planner().options().never_swerves);
}

}  // namespace
}  // namespace avo
