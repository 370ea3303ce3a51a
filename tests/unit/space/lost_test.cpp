// SPDX-License-Identifier: Apache-2.0
// Robots of space that do not know exactly where they are: they touch no box, go on, and see each
// other as if they knew.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/error.h"
#include "avo/space/check.h"
#include "avo/space/planner.h"
#include "avo/space/simulation.h"
#include "space/boxes.h"
#include "space/senses.h"
#include "unit/space/draws.h"
#include "unit/space/runs.h"

namespace avo::space::tests {
namespace {

constexpr double kEver = Box::kFar;

// A plate below, and a pillar with a rounded edge beside the course.
std::vector<Box> plate_and_pillar() {
  return {{.min = {-kEver, -kEver, -kEver}, .max = {kEver, kEver, 0.0}},
          {.min = {4.0, -0.4, 0.0}, .max = {4.3, 0.4, 1.0}, .heading = 0.3, .radius = 0.1}};
}

double gap_to(const std::vector<Box>& boxes, Vec3 place, double radius) {
  double least = 1e9;
  for (const Box& box : boxes)
    least = std::min(least, nearest(place, place, box).distance - box.radius - radius);
  return least;
}

// One robot on a harness of its own: it takes itself to be elsewhere at each decision.
struct Drifting {
  double error = 0.1, declared = 0.1;  // m
  Vec3 wish = {};
  std::vector<Box> boxes = plate_and_pillar();
  Draws draws{7};

  // m: the function returns the least gap along the path.
  double run(Robot& robot, int steps) {
    PlannerOptions options{.method = Method::avo};
    options.localization_error = declared;
    const Planner planner(options);
    PlanWorkspace workspace;
    double least = gap_to(boxes, robot.position, robot.radius);
    for (int k = 0; k < steps; ++k) {
      const Vec3 off = error * draws.direction();
      std::vector<Box> seen;
      for (const Box& box : boxes) seen.push_back(moved(box, -off));
      robot.preferred_velocity = wish;
      const Plan plan = planner.plan(robot, {}, workspace, nullptr, seen);
      for (int part = 1; part <= 8; ++part) {
        const double t = 0.1 * part / 8.0;
        const Vec3 p = robot.position + t * robot.velocity + (0.5 * t * t) * plan.acceleration;
        least = std::min(least, gap_to(boxes, p, robot.radius));
      }
      robot.position = robot.position + 0.05 * (robot.velocity + plan.next_velocity);
      robot.velocity = plan.next_velocity;
    }
    return least;
  }
};

TEST(LostInSpace, keep_what_is_declared) {
  for (const Vec3 wish : {Vec3{0.3, 0.2, -1.5}, Vec3{1.5, 0.0, -1.5}, Vec3{0.0, 0.0, -2.0}}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      Drifting drifting{.wish = wish};
      drifting.draws = Draws(seed);
      Robot robot{.position = {0.0, 0.0, 3.0}};
      robot.vertical = seed % 2 == 0 ? 0.6 : 1.4;
      EXPECT_GE(drifting.run(robot, 300), 0.0) << seed;
      EXPECT_LT(robot.position.z, 0.5 + 0.25) << "it does come near";
    }
  }
}

TEST(LostInSpace, what_is_not_declared_makes_contact) {
  Drifting drifting{.declared = 0.02, .wish = {0.3, 0.2, -1.5}};
  Robot robot{.position = {0.0, 0.0, 3.0}};
  EXPECT_LT(drifting.run(robot, 300), -0.02);
}

// The robot leaves the box however near the robot is. A direction that leads off the box does so
// wherever the box is.
TEST(LostInSpace, one_beside_a_box_leaves_it) {
  for (const double gap : {1e-6, 0.01, 0.05, 0.11}) {
    Drifting drifting{.wish = {0.2, 0.1, 1.0}};
    Robot robot{.position = {0.0, 0.0, 0.5 + gap}};
    EXPECT_GE(drifting.run(robot, 40), 0.0) << gap;
    EXPECT_GT(robot.position.z, 1.5) << gap;
    Drifting along{.wish = {0.0, 1.5, 0.0}};
    Robot other{.position = {0.0, 0.0, 0.5 + gap}};
    EXPECT_GE(along.run(other, 100), 0.0) << gap;
    EXPECT_GT(other.position.y, 4.0) << gap;
  }
}

// The worst of views: the post looks off to one side by all of the error, and the robot wishes to
// go where it seems to keep its distance and does not.
TEST(LostInSpace, a_view_from_aside_leads_into_no_post) {
  constexpr double kError = 0.1;
  PlannerOptions options{.method = Method::avo};
  options.localization_error = kError;
  const Planner planner(options);
  PlanWorkspace workspace;
  for (const Vec3 axis : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0.6, 0.0, 0.8}}) {
    const std::vector<Box> post{{.min = {}, .max = {}, .radius = 0.05}};
    for (const double gap : {1e-4, 0.02, 0.06}) {
      Robot robot{.position = {0.0, 0.35 + gap, 0.0}, .radius = 0.3};
      double least = gap, moves = 0.0;
      for (int k = 0; k < 400; ++k) {
        const Vec3 out = robot.position / norm(robot.position);
        const Vec3 off = kError * cross(axis, out);
        const Vec3 seen_out = (robot.position + off) / norm(robot.position + off);
        const Vec3 aside = cross(axis, seen_out);
        robot.preferred_velocity = (dot(aside, out) < 0.0 ? 1.0 : -1.0) * aside;
        const std::vector<Box> seen{moved(post[0], -off)};
        const Plan plan = planner.plan(robot, {}, workspace, nullptr, seen);
        moves += 0.05 * norm(robot.velocity + plan.next_velocity);
        robot.position = robot.position + 0.05 * (robot.velocity + plan.next_velocity);
        robot.velocity = plan.next_velocity;
        least = std::min(least, norm(robot.position) - 0.35);
      }
      EXPECT_GE(least, 0.0) << gap;
      EXPECT_GT(moves, 0.1) << gap;
    }
  }
}

// All robots are sent to one corner of a room, or to the end of a wall in its midst.
Scenario pressed_room(std::uint64_t seed, double error) {
  Draws draws(seed);
  Scenario scene;
  scene.seed = seed;
  scene.duration = 25.0;
  scene.sensing.localization = {error, NoiseDistribution::uniform, {}};
  scene.navigation = seed % 2 == 0;
  scene.boxes = {{.min = {-kEver, -kEver, -kEver}, .max = {kEver, kEver, -4.0}},
                 {.min = {6.0, -kEver, -kEver}, .max = {kEver, kEver, kEver}},
                 {.min = {-kEver, 5.0, -kEver}, .max = {kEver, kEver, kEver}},
                 {.min = {-0.1, -kEver, -kEver}, .max = {0.1, 0.2, kEver}, .heading = 0.1}};
  for (int k = 0; k < 12; ++k) {
    RobotSetup& robot = scene.robots.emplace_back();
    robot.position = {-5.0 + 3.0 * (k % 4), -3.2 + 3.1 * (k / 4), draws.between(-3.0, 0.0)};
    if (std::abs(robot.position.x) < 1.2) robot.position.x = 1.2;
    robot.goal = k % 2 == 0 ? Vec3{0.0, 0.7, -3.5} : Vec3{5.6, 4.6, -3.6};
    robot.radius = draws.between(0.25, 0.45);
    robot.max_speed = robot.preferred_speed = draws.between(0.8, 2.0);
    robot.max_acceleration = draws.between(0.5, 2.0);
    robot.vertical = draws.between(0.6, 1.4);
  }
  return scene;
}

TEST(LostInSpace, touch_no_box_and_nobody) {
  double nearest_ever = 1.0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Scenario scene = pressed_room(seed, 0.02 * static_cast<double>(1 + seed % 4));
    if (seed % 3 == 1) scene.sensing.delay = 1, scene.sensing.dropped = 0.05;
    if (seed % 3 == 2) scene.sensing.noise = {0.01, 0.02};
    const RunSummary summary = summary_of(scene, RunUntil::its_end);
    EXPECT_EQ(summary.collision_pairs, 0) << seed;
    EXPECT_EQ(summary.static_collisions, 0) << seed;
    nearest_ever = std::min(nearest_ever, summary.min_static_clearance.value_or(1.0));
  }
  EXPECT_LT(nearest_ever, 0.1) << "they do press";
}

TEST(LostInSpace, see_each_other_as_if_they_knew_where_they_are) {
  const Scenario scene = pressed_room(4, 0.05);
  Simulation simulation(scene);
  double most = 0.0;
  for (int step = 0; step < 30; ++step, simulation.step()) {
    Vec3 before;
    for (std::size_t k = 0; k < simulation.size(); ++k) {
      const Simulation::Perception seen = simulation.perceive({k});
      EXPECT_EQ(seen.robot.position, simulation.robots()[k].position);
      for (std::size_t n = 0; n < seen.neighbors.size(); ++n) {
        const auto other = static_cast<std::size_t>(seen.neighbor_ids[n].value);
        EXPECT_EQ(seen.neighbors[n].position, simulation.robots()[other].position);
      }
      for (std::size_t b = 0; b < seen.boxes.size(); ++b) {
        if (seen.box_ids[b].value != 0) continue;
        const double off = seen.boxes[b].max.z + 4.0;  // m, of the floor
        EXPECT_LE(std::abs(off), 0.05 + 1e-12);
        EXPECT_NE(off, before.z);
        before.z = off, most = std::max(most, std::abs(off));
      }
    }
  }
  EXPECT_GT(most, 0.045);
  EXPECT_NEAR(planner_options(scene).localization_error, std::sqrt(3.0) * 0.05, 1e-9);
}

TEST(LostInSpace, decisions_are_made_of_what_perceive_tells) {
  for (const std::uint64_t seed : {2U, 3U}) {
    const Scenario scene = pressed_room(seed, 0.05);
    const Planner planner(planner_options(scene));
    Simulation simulation(scene);
    PlanWorkspace workspace;
    for (int step = 0; step < 80; ++step) {
      std::vector<Vec3> expected;
      for (std::size_t k = 0; k < simulation.size(); ++k) {
        Simulation::Perception seen = simulation.perceive({k});
        expected.push_back(
            planner.plan(seen.robot, seen.neighbors, workspace, &seen.detour, seen.boxes)
                .next_velocity);
      }
      simulation.step();
      for (std::size_t k = 0; k < simulation.size(); ++k)
        ASSERT_EQ(simulation.robots()[k].velocity, expected[k]) << k << ", step " << step;
    }
  }
}

TEST(LostInSpace, are_lost_by_the_seed_alone) {
  Scenario scene = pressed_room(1, 0.05);
  Simulation one(scene, 1), two(scene, 2);
  ++scene.seed;
  Simulation other(scene, 1);
  for (int k = 0; k < 60; ++k) {
    one.step(), two.step(), other.step();
    ASSERT_EQ(one.state_hash(), two.state_hash()) << k;
  }
  EXPECT_NE(one.state_hash(), other.state_hash());
}

TEST(LostInSpace, come_to_their_goals_all_the_same) {
  Scenario scene;
  scene.duration = 60.0;
  scene.sensing.localization = {0.02, NoiseDistribution::gaussian, {}};
  scene.boxes = {{.min = {0, 1.2, -kEver}, .max = {0.2, kEver, kEver}},
                 {.min = {0, -kEver, -kEver}, .max = {0.2, -1.2, kEver}},
                 {.min = {0, -1.2, 1.2}, .max = {0.2, 1.2, kEver}},
                 {.min = {0, -1.2, -kEver}, .max = {0.2, 1.2, -1.2}}};
  for (int k = 0; k < 6; ++k) {
    RobotSetup& robot = scene.robots.emplace_back();
    const double side = k % 2 == 0 ? 1.0 : -1.0;
    robot.position = {-5.0 * side, -4.0 + 1.6 * k, 1.0}, robot.goal = {5.0 * side, 0.8 * k, 0.0};
    robot.radius = 0.4;
  }
  const RunSummary summary = summary_of(scene, RunUntil::all_arrive);
  EXPECT_EQ(summary.arrived, 6);
  EXPECT_EQ(summary.collision_pairs + summary.static_collisions, 0);
}

}  // namespace
}  // namespace avo::space::tests
