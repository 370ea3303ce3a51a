// SPDX-License-Identifier: Apache-2.0
// Robots that do not know exactly where they are on the map: they touch no wall, go on, and see
// each other as if they knew.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/assumptions.h"
#include "avo/error.h"
#include "robots/model.h"
#include "support/refusal.h"
#include "support/walls.h"
#include "unit/sim/judged.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::gap_to;
using test::Judged;
using test::Random;
using test::refusal;
using test::robot_at;

LocalizationNoise within(double position) {
  return {position, NoiseDistribution::uniform, {}};
}

StaticObstacle line(Vec2 a, Vec2 b, double radius = 0.0) {
  return {{{{a, b}, false}}, radius};
}

// A room with a wall in it that ends in its midst. Everybody is sent to the same place at that end.
Scenario pressed(std::uint64_t seed, double error, bool with_cars) {
  Random random(seed);
  Scenario scene;
  scene.seed = seed;
  scene.sensing.localization = within(error);
  scene.navigation = false;  // straight on, against whatever there is
  scene.obstacles = {line({-6, -5}, {6, -5}), line({6, -5}, {6, 5}, 0.2), line({6, 5}, {-6, 5}),
                     line({-6, 5}, {-6, -5}), line({0, -5}, {0, 0.2})};
  for (int k = 0; k < 12; ++k) {
    const Vec2 place{-4.5 + 3.0 * (k % 4), -3.2 + 3.1 * (k / 4)};
    RobotSetup robot = robot_at(place, k % 2 == 0 ? Vec2{0.0, 0.4} : Vec2{5.9, -4.9});
    robot.radius = random.uniform(0.25, 0.45);
    robot.max_speed = robot.preferred_speed = random.uniform(0.8, 2.0);
    robot.max_acceleration = random.uniform(0.5, 2.0);
    robot.max_braking = robot.max_acceleration * random.uniform(0.5, 1.0);
    if (with_cars && k % 3 == 0) {
      robot.model = k % 2 == 0 ? Car{.body = CarBody{0.2, 0.4}} : Car{.max_curvature = 2.0};
      robot.heading = random.uniform(-3.0, 3.0);
    }
    scene.robots.push_back(robot);
  }
  return scene;
}

TEST(LostRobots, touch_no_wall_and_nobody) {
  std::int64_t steps = 0;
  double nearest = 1.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Scenario scene = pressed(seed, 0.02 * static_cast<double>(1 + seed % 4), seed % 2 == 0);
    if (seed % 3 == 1) {
      scene.clock = Clock::free;
      scene.sensing.delay = 1, scene.sensing.dropped = 0.05;
      scene.robots[2].time_step = scene.robots[7].time_step = 0.04;
    } else if (seed % 3 == 2) {
      scene.sensing.noise = {0.01, 0.02};
    }
    ASSERT_TRUE(broken_assumptions(scene).none()) << seed;
    Judged run(scene, 1);
    for (const double end = 40.0; run.simulation.time() < end;) {
      run.step();
      for (const Vec2 p : run.simulation.fleet().position)
        for (const StaticObstacle& wall : scene.obstacles)
          nearest = std::min(nearest, gap_to(p, walls_of({&wall, 1})[0]));
    }
    const CheckReport report = run.report();
    EXPECT_EQ(report.overlaps.count, 0) << seed;
    EXPECT_EQ(report.static_contacts.count, 0) << seed;
    steps += report.robot_steps;
  }
  EXPECT_GT(steps, 50000);
  EXPECT_LT(nearest, 0.45);  // they do press
}

// One robot on a harness of its own: it takes itself to be elsewhere at each decision.
struct Drift {
  double error = 0.1;     // m
  double declared = 0.1;  // m
  Vec2 wish = {};
  std::vector<Wall> walls = {};
  Random random{7};

  // The result is the least gap of the run, in m. `robot` is then where it comes to.
  double run(Robot& robot, int steps) {
    PlannerOptions options;
    options.localization_error = declared;
    const Planner planner(options);
    PlanWorkspace workspace;
    double least = 1.0;
    for (int k = 0; k < steps; ++k) {
      const Vec2 off = error * test::in_disc(random, 1.0);
      std::vector<Wall> seen;
      for (const Wall& wall : walls) seen.push_back({wall.a - off, wall.b - off, wall.radius});
      robot.preferred_velocity = wish;
      const Plan plan = planner.plan(robot, {}, workspace, nullptr, seen);
      EXPECT_NE(plan.status, PlanStatus::overlapping) << k;
      for (int part = 1; part <= 8; ++part) {
        const double t = 0.1 * part / 8.0;
        const Vec2 p = robot.position + t * robot.velocity + (0.5 * t * t) * plan.acceleration;
        for (const Wall& wall : walls) least = std::min(least, gap_to(p, wall) - robot.radius);
      }
      robot.position = robot.position + 0.05 * (robot.velocity + plan.next_velocity);
      robot.velocity = plan.next_velocity;
    }
    return least;
  }
};

TEST(LostRobots, keep_what_is_declared) {
  for (const Vec2 wish : {Vec2{0.3, -1.5}, Vec2{1.5, -1.5}, Vec2{0.0, -2.0}}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Drift drift{.wish = wish, .walls = {{{-50, 0}, {50, 0}, 0.0}, {{4, 0}, {4, 0.3}, 0.1}}};
      drift.random = Random(seed);
      Robot robot{.position = {0.0, 3.0}};
      EXPECT_GE(drift.run(robot, 300), 0.0);
      EXPECT_LT(robot.position.y, 0.5 + 0.25) << "it does come near";
    }
  }
}

TEST(LostRobots, what_is_not_declared_makes_contact) {
  Drift drift{.declared = 0.02, .wish = {0.3, -1.5}, .walls = {{{-50, 0}, {50, 0}, 0.0}}};
  Robot robot{.position = {0.0, 3.0}};
  PlannerOptions options;
  const Planner planner(options);
  double least = 1.0;
  PlanWorkspace workspace;
  for (int k = 0; k < 300; ++k) {
    const Vec2 off = 0.1 * test::in_disc(drift.random, 1.0);
    const std::vector<Wall> seen{{Vec2{-50, 0} - off, Vec2{50, 0} - off, 0.0}};
    robot.preferred_velocity = drift.wish;
    const Plan plan = planner.plan(robot, {}, workspace, nullptr, seen);
    robot.position = robot.position + 0.05 * (robot.velocity + plan.next_velocity);
    robot.velocity = plan.next_velocity;
    least = std::min(least, gap_to(robot.position, drift.walls[0]) - robot.radius);
  }
  EXPECT_LT(least, -0.02);
}

// However near the robot is, a direction away from the wall is one wherever the wall is.
TEST(LostRobots, one_beside_a_wall_leaves_it) {
  for (const double gap : {1e-6, 0.01, 0.05, 0.11}) {
    for (const double side : {-1.0, 1.0}) {
      Drift drift{.wish = {0.2, side * 1.0}, .walls = {{{-3, 0}, {50, 0}, 0.0}}};
      Robot robot{.position = {0.0, side * (0.5 + gap)}};
      EXPECT_GE(drift.run(robot, 40), 0.0);
      EXPECT_GT(std::abs(robot.position.y), 1.5) << gap;
    }
    Drift along{.wish = {1.5, 0.0}, .walls = {{{-3, 0}, {50, 0}, 0.0}}};
    Robot robot{.position = {0.0, 0.5 + gap}};
    EXPECT_GE(along.run(robot, 100), 0.0);
    EXPECT_GT(robot.position.x, 6.0) << gap;
  }
}

// The worst of views: the pillar looks off to one side by all of the error, and the robot wishes to
// go where it seems to keep its distance and does not.
TEST(LostRobots, a_view_from_aside_leads_into_no_pillar) {
  constexpr double kError = 0.1;
  PlannerOptions options;
  options.localization_error = kError;
  const Planner planner(options);
  PlanWorkspace workspace;
  for (const double gap : {1e-4, 0.02, 0.06}) {
    Robot robot{.position = {0.35 + gap, 0.0}, .radius = 0.3};
    double least = gap, moved = 0.0;
    for (int k = 0; k < 400; ++k) {
      const Vec2 out = robot.position / norm(robot.position);
      const Vec2 off = kError * perpendicular(out);
      const Vec2 seen_out = (robot.position + off) / norm(robot.position + off);
      const Vec2 aside = perpendicular(seen_out);
      robot.preferred_velocity = (dot(aside, out) < 0.0 ? 1.0 : -1.0) * aside;
      const std::vector<Wall> seen{{-off, -off, 0.05}};
      const Plan plan = planner.plan(robot, {}, workspace, nullptr, seen);
      moved += 0.05 * norm(robot.velocity + plan.next_velocity);
      robot.position = robot.position + 0.05 * (robot.velocity + plan.next_velocity);
      robot.velocity = plan.next_velocity;
      least = std::min(least, norm(robot.position) - 0.35);
    }
    EXPECT_GE(least, 0.0) << gap;
    EXPECT_GT(moved, 0.1) << gap;
  }
}

TEST(LostRobots, see_each_other_as_if_they_knew_where_they_are) {
  Scenario scene = pressed(4, 0.05, false);
  Simulation simulation(scene, 1);
  const std::vector<Wall> walls = walls_of(scene.obstacles);
  double most = 0.0;
  for (int step = 0; step < 40; ++step, simulation.step()) {
    const FleetView fleet = simulation.fleet();
    Vec2 before;
    for (std::size_t i = 0; i < 12; ++i) {
      const Simulation::Perception seen = simulation.perceive({i});
      EXPECT_EQ(seen.robot.position, fleet.position[i]);
      for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
        const auto other = static_cast<std::size_t>(seen.source[k]);
        EXPECT_EQ(seen.neighbors[k].position, fleet.position[other]);
        EXPECT_EQ(seen.neighbors[k].velocity, fleet.velocity[other]);
      }
      if (seen.walls.empty()) continue;
      const auto shift = [&](const Wall& wall) {  // of those that are as long, the nearest one
        Vec2 least{1e9, 1e9};
        for (const Wall& own : walls)
          if (norm(wall.a - own.a) < norm(least)) least = wall.a - own.a;
        return least;
      };
      const Vec2 off = shift(seen.walls[0]);
      for (const Wall& wall : seen.walls) EXPECT_LT(norm(shift(wall) - off), 1e-12);
      EXPECT_LE(std::max(std::abs(off.x), std::abs(off.y)), 0.05 + 1e-12);
      EXPECT_NE(off, before);
      most = std::max(most, std::abs(off.x));
      before = off;
    }
  }
  EXPECT_GT(most, 0.045);
  EXPECT_NEAR(simulation.planner().options().localization_error, std::sqrt(2.0) * 0.05, 1e-9);
}

TEST(LostRobots, decisions_are_made_of_what_perceive_tells) {
  for (const bool navigation : {true, false}) {
    Scenario scene = pressed(2, 0.05, true);
    scene.navigation = navigation;
    scene.right_of_way = RightOfWay::none;
    Simulation simulation(scene, 1);
    for (int step = 0; step < 60; ++step) {
      std::vector<Plan> expected;
      PlanWorkspace workspace;
      for (std::size_t i = 0; i < 12; ++i) {
        Simulation::Perception seen = simulation.perceive({i});
        const Plan planned = simulation.planner().plan(seen.robot, seen.neighbors, workspace,
                                                       &seen.detour, seen.walls);
        expected.push_back(seen.stop.value_or(planned));  // some share a goal
      }
      simulation.step();
      for (std::size_t i = 0; i < 12; ++i)
        ASSERT_EQ(simulation.fleet().plan[i].new_velocity, expected[i].new_velocity)
            << navigation << ", robot " << i << ", step " << step;
    }
  }
}

TEST(LostRobots, are_lost_by_the_seed_alone) {
  const Scenario scene = pressed(1, 0.05, true);
  Simulation one(scene, 1);
  for (int k = 0; k < 30; ++k) one.step();
  const std::vector<std::byte> saved = one.save();
  Simulation again(saved, 2), other(scene, 1);
  for (int k = 0; k < 60; ++k) {
    ASSERT_EQ(one.state_hash(), again.state_hash()) << k;
    one.step(), again.step();
  }
  Scenario exact = scene;
  exact.sensing.localization = {};
  EXPECT_THROW(Simulation(exact, 1).restore(saved), Error);
}

TEST(LostRobots, come_to_their_goals_all_the_same) {
  Scenario scene;
  scene.sensing.localization = {0.02, NoiseDistribution::gaussian, {}};
  scene.obstacles = {line({0, -8}, {0, -1.0}), line({0, 1.0}, {0, 8})};
  for (int k = 0; k < 6; ++k) {
    const double y = -4.0 + 1.6 * k;
    scene.robots.push_back(robot_at({k % 2 == 0 ? -5.0 : 5.0, y}, {k % 2 == 0 ? 5.0 : -5.0, y}));
    scene.robots.back().radius = 0.4;
  }
  Judged run(scene, 1);
  run.run(60.0);
  EXPECT_TRUE(run.simulation.all_at_goal());
  EXPECT_TRUE(run.report().safe());
}

TEST(LostRobots, errors_out_of_range_are_refused) {
  Scenario scene = pressed(1, 0.05, false);
  EXPECT_EQ(refusal(scene), "");
  scene.sensing.localization.position = -0.1;
  EXPECT_EQ(refusal(scene), "sensing.localization.position: found -0.1, must be >= 0 m");
  scene.sensing.localization = {0.1, NoiseDistribution::uniform, 2.0};
  EXPECT_EQ(refusal(scene),
            "sensing.localization.truncated: found 2, must be left out with "
            "distribution uniform, which stays within what is given");
  PlannerOptions options;
  options.localization_error = -1.0;
  EXPECT_THROW(Planner{options}, Error);
}

}  // namespace
}  // namespace avo
