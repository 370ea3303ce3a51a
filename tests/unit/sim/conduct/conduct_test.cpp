// SPDX-License-Identifier: Apache-2.0
// Parked robots, and robots that do not all avoid each other.
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/assumptions.h"
#include "avo/check.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "property/crushes.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::judge_of;
using test::observe;
using test::Random;
using test::refusal;
using test::robot_at;

constexpr LayerSet kNobody{};

RobotSetup parked_at(Vec2 place, double radius = 0.5) {
  RobotSetup setup = robot_at(place, place);
  setup.radius = radius;
  setup.behavior = Behavior::parked;
  return setup;
}

RobotSetup in_layer(RobotSetup setup, std::uint32_t layers, std::uint32_t avoids) {
  setup.layers = {layers}, setup.avoids = {avoids};
  return setup;
}

// The first robots are all sent to one place after the other, as near to the origin as `extent`.
void crush(std::uint64_t robots, int steps, int steps_a_place, double extent, Random& random,
           Simulation& simulation, Check& check) {
  observe(simulation, check);
  for (int step = 0; step < steps; ++step) {
    if (step % steps_a_place == 0) {
      const Vec2 rally = test::in_disc(random, extent);
      for (std::uint64_t k = 0; k < robots; ++k) simulation.set_goal({k}, rally);
    }
    simulation.step();
    observe(simulation, check);
  }
}

// 40 robots about a square in which 12 are parked, with gaps of 1.5 to 2.5 m between these.
Scenario lot(std::uint64_t seed) {
  Random random(seed);
  Scenario scene;
  scene.sensing_radius = 20.0;
  scene.max_neighbors = 10;
  for (int k = 0; k < 40; ++k) {
    const Vec2 place{2.0 * (k % 10) - 9.0, k < 20 ? -8.0 - 2.0 * (k / 10) : 6.0 + 2.0 * (k / 10)};
    RobotSetup robot = robot_at(place + test::in_disc(random, 0.3), {});
    robot.goal = {robot.position.x + random.uniform(-3.0, 3.0), -robot.position.y};
    robot.max_acceleration = random.uniform(0.5, 2.0);
    scene.robots.push_back(robot);
  }
  for (int k = 0; k < 12; ++k)
    scene.robots.push_back(
        parked_at({3.0 * (k % 4) - 4.5, 3.0 * (k / 4) - 3.0}, random.uniform(0.25, 0.75)));
  return scene;
}

TEST(Parked, nobody_touches_one_that_never_moves) {
  const Scenario scene = lot(1);
  Simulation simulation(scene, 1);
  Check check = judge_of(scene);
  Random random(2);
  crush(40, 1500, 50, 4.0, random, simulation, check);
  const FleetView fleet = simulation.fleet();
  for (std::size_t k = 40; k < 52; ++k) {
    EXPECT_EQ(fleet.position[k], scene.robots[k].position);
    EXPECT_EQ(fleet.velocity[k], (Vec2{}));
    EXPECT_TRUE(simulation.is_at_goal({k}));
    EXPECT_TRUE(simulation.perceive({k}).neighbors.empty());
  }
  const CheckReport report = check.report();
  EXPECT_TRUE(report.safe());
  EXPECT_EQ(report.overlaps.count, 0) << report.overlaps.worst;
  EXPECT_LT(*report.least_clearance, 0.02);  // it was tight
}

// To the last bit, ways around them included.
TEST(Parked, others_move_as_beside_discs) {
  const Scenario scene = lot(3);
  Scenario discs = scene;
  discs.robots.resize(40);
  for (std::size_t k = 40; k < 52; ++k)
    discs.obstacles.push_back({{{{scene.robots[k].position}, false}}, scene.robots[k].radius});
  Simulation parked(scene, 2), walls(discs, 1);
  for (int step = 0; step < 300; ++step) {
    parked.step(), walls.step();
    for (std::size_t k = 0; k < 40; ++k) {
      ASSERT_EQ(parked.fleet().position[k], walls.fleet().position[k]) << step;
      ASSERT_EQ(parked.fleet().velocity[k], walls.fleet().velocity[k]) << step;
    }
  }
  EXPECT_EQ(parked.profile().robot_steps, 0);
}

TEST(Parked, comes_and_goes_like_an_obstacle) {
  Scenario scene;
  scene.robots = {robot_at({-6, 0}, {6, 0})};
  scene.robots[0].velocity = {2, 0};
  Simulation simulation(scene, 1);
  const std::string near = refusal([&] { simulation.add_robot(parked_at({-3.5, 0})); });
  EXPECT_TRUE(near.starts_with("robot 1: found robot 0 at [-6, 0], which is 2.5 m from it, 0.5"))
      << near;
  EXPECT_EQ(simulation.fleet().id.size(), 1u);
  const RobotId added = simulation.add_robot(parked_at({0, 0}));
  EXPECT_EQ(added.value, 1u);
  EXPECT_EQ(refusal([&] {
              simulation.set_goal(added, {1, 1});
            }),
            "robot 1: found a goal for it, must be one that is not parked");
  Simulation restored(simulation.save(), 1), rolled_back(scene, 1);
  rolled_back.restore(simulation.save());
  simulation.set_goal({0}, {0.2, 0.0});
  EXPECT_EQ(simulation.unreachable(), std::vector<RobotId>{{0}});
  simulation.set_goal({0}, {6, 0});
  EXPECT_TRUE(simulation.unreachable().empty());
  for (int k = 0; k < 100; ++k) {
    simulation.step(), restored.step(), rolled_back.step();
    ASSERT_EQ(restored.state_hash(), simulation.state_hash()) << k;
    ASSERT_EQ(rolled_back.state_hash(), simulation.state_hash()) << k;
  }
  EXPECT_TRUE(simulation.all_at_goal());
  simulation.remove_robot(added);
  simulation.set_goal({0}, {-6, 0});
  double farthest = 0.0;  // m, off the straight line
  for (int k = 0; k < 100; ++k) {
    simulation.step();
    farthest = std::max(farthest, std::abs(simulation.fleet().position[0].y));
  }
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_LT(farthest, 0.1);
}

TEST(Parked, elsewhere_than_at_its_goal_or_in_motion_is_refused) {
  const auto refused = [](RobotSetup setup) {
    Scenario scene;
    scene.robots = {setup};
    return refusal([&] { validate(scene); });
  };
  RobotSetup setup = parked_at({1, 2});
  EXPECT_EQ(refused(setup), "");
  setup.goal = {1.5, 2};
  EXPECT_EQ(refused(setup),
            "robots.0.goal: found [1.5, 2], must be [1, 2], its position: it is parked");
  setup = parked_at({1, 2});
  setup.velocity = {0, 0.1};
  EXPECT_EQ(refused(setup), "robots.0.velocity: found [0, 0.1], must be [0, 0]: it is parked");
  EXPECT_EQ(refused(in_layer(parked_at({1, 2}), 6, 0xffffffff)),
            "robots.0.layers: found [1, 2], must be left out: it is parked");
}

TEST(Parked, has_arrived_and_counts_for_no_mean) {
  Scenario scene;
  scene.robots = {robot_at({-3, 0}, {3, 4}), parked_at({0, -5}), parked_at({0.5, -5})};
  scene.allow_broken_assumptions = true;
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  for (int k = 0; k < 100; ++k) simulation.step(), metrics.observe(simulation);
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.robots, 3);
  EXPECT_EQ(summary.parked, 2);
  EXPECT_EQ(summary.arrived, 3);
  EXPECT_EQ(summary.mean_arrival, summary.last_arrival);
  EXPECT_EQ(summary.decisions.optimal, 100);
  EXPECT_EQ(summary.collision_pairs, 0);  // of the two that stand in each other
  EXPECT_GT(*summary.min_clearance, 3.0);
}

TEST(Parked, comes_first_where_a_later_robot_starts_in_it) {
  Scenario scene;
  scene.robots = {parked_at({0, 0}), robot_at({0.5, 0}, {9, 0})};
  const BrokenAssumptions broken = broken_assumptions(scene);
  ASSERT_EQ(broken.starts.size(), 1U);
  EXPECT_EQ(broken.starts[0].robot, RobotId{0});
  EXPECT_EQ(broken.starts[0].other, BodyId{RobotId{1}});
}

// Two crowds at the same places, in layers of their own.
TEST(Layers, who_is_not_avoided_changes_no_bit) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    const Scenario one = test::dense_avo_scene(60, motion, Certificate::braking_trajectories, 5);
    Scenario other = test::dense_avo_scene(50, motion, Certificate::braking_trajectories, 6);
    Scenario both = one;
    for (RobotSetup& robot : both.robots) robot = in_layer(robot, 1, 1);
    for (const RobotSetup& robot : other.robots) both.robots.push_back(in_layer(robot, 2, 2));
    Simulation of_both(both, 2), of_one(one, 1), of_other(other, 1);
    for (int step = 0; step < 100; ++step) {
      of_both.step(), of_one.step(), of_other.step();
      for (std::size_t k = 0; k < 110; ++k) {
        const Vec2 alone = k < 60 ? of_one.fleet().position[k] : of_other.fleet().position[k - 60];
        ASSERT_EQ(of_both.fleet().position[k], alone) << step << " " << k;
      }
    }
  }
}

// Through a corridor for one, from both ends.
TEST(Layers, nobody_waits_at_a_passage_for_those_whom_it_does_not_avoid) {
  Scenario one;
  for (const double y : {-0.8, 0.8})
    one.obstacles.push_back({.chains = {{.points = {{-4, y}, {4, y}}}}});
  for (const double y : {-0.8, 0.8})
    for (const double x : {-4.0, 4.0})
      one.obstacles.push_back({.chains = {{.points = {{x, y}, {x, 10.0 * y}}}}});
  Scenario other = one, both = one;
  one.robots = {in_layer(robot_at({-9, 0}, {9, 0}), 1, 1)};
  other.robots = {in_layer(robot_at({8, 0}, {-8, 0}), 2, 2)};
  both.robots = {one.robots[0], other.robots[0]};
  Simulation of_both(both, 1), of_one(one, 1), of_other(other, 1);
  for (int step = 0; step < 150; ++step) {
    of_both.step(), of_one.step(), of_other.step();
    ASSERT_EQ(of_both.fleet().position[0], of_one.fleet().position[0]) << step;
    ASSERT_EQ(of_both.fleet().position[1], of_other.fleet().position[0]) << step;
  }
  EXPECT_TRUE(of_both.all_at_goal());
}

// Two floors.
TEST(Layers, those_who_avoid_nobody_there_may_be_in_one_place) {
  Scenario scene;
  for (int k = 0; k < 6; ++k) {
    const Vec2 place{-6.0, 3.0 * (k / 2)};
    scene.robots.push_back(in_layer(robot_at(place, -1.0 * place), 1U << k % 2, 1U << k % 2));
  }
  EXPECT_TRUE(broken_assumptions(scene).none());
  EXPECT_TRUE(advice(scene).empty());
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  Check check = judge_of(scene);
  metrics.observe(simulation), observe(simulation, check);
  for (int k = 0; k < 120; ++k)
    simulation.step(), metrics.observe(simulation), observe(simulation, check);
  EXPECT_EQ(metrics.summary().arrived, 6);
  EXPECT_EQ(metrics.summary().collision_pairs, 0);
  EXPECT_TRUE(check.report().safe());
}

TEST(Layers, nobody_is_held_by_those_whom_it_does_not_avoid) {
  Scenario scene;
  scene.robots = {in_layer(robot_at({0, 0}, {9, 0}), 1, 1),
                  in_layer(robot_at({0, 0}, {9, 0}), 2, 2),
                  in_layer(robot_at({1, 0}, {9, 0}), 1, 1)};
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  ASSERT_EQ(metrics.summary().not_arrived.size(), 3u);
  EXPECT_EQ(metrics.summary().not_arrived[0].held_by, std::vector<std::int64_t>{2});
  EXPECT_EQ(metrics.summary().not_arrived[1].held_by, std::vector<std::int64_t>{});
}

TEST(Layers, to_the_one_that_avoids_a_car_it_accelerates_as_its_set_allows) {
  Scenario scene;
  scene.robots = {in_layer(robot_at({0, 0}, {9, 0}), 1, 3),
                  in_layer(robot_at({5, 0}, {-9, 0}), 2, 2)};
  scene.robots[1].model = Car{.acceleration_set = AccelerationSet::exact};
  const Neighbor seen = Simulation(scene, 1).perceive({0}).neighbors.at(0);
  EXPECT_EQ(seen.behavior, Behavior::moves_on);
  EXPECT_DOUBLE_EQ(seen.max_deviation, std::sqrt(2.0));
  scene.robots[1].model = Car{.body = CarBody{0.4, 0.6}};
  EXPECT_EQ(refusal(scene),
            "robots.0.avoids: found robot 1, which does not avoid it, must be both or neither: its "
            "body is not over its axle");
  scene.robots[1].avoids.bits = 3;
  EXPECT_EQ(refusal(scene), "");
  scene.robots[0].layers = {};  // no robot avoids it
  EXPECT_NE(refusal(scene), "");
  scene.robots[1].model = Holonomic{};
  Simulation simulation(scene, 1);
  RobotSetup late = robot_at({5, 5}, {5, 5});
  late.model = Car{.body = CarBody{0.4, 0.6}};
  EXPECT_THROW(simulation.add_robot(late), Error);
}

// What the next step decides is what plan() makes of a mover, and the mover decides as if alone.
TEST(Layers, to_the_one_that_avoids_the_other_is_a_mover) {
  Scenario scene;
  scene.sensing_radius = 12.0;
  scene.robots = {robot_at({-6, 0}, {6, 0}), in_layer(robot_at({6, 0.1}, {-6, 0.1}), 2, 2),
                  robot_at({0, -6}, {0, 6})};
  Scenario alone = scene;
  alone.robots = {scene.robots[1]};
  Simulation simulation(scene, 1), mover(alone, 1);
  int as_mover = 0;
  for (int step = 0; step < 120; ++step) {
    const Simulation::Perception seen = simulation.perceive({0});
    PlanWorkspace workspace;
    Detour detour = seen.detour;
    const Plan plan =
        simulation.planner().plan(seen.robot, seen.neighbors, workspace, &detour, seen.walls);
    simulation.step(), mover.step();
    ASSERT_EQ(simulation.fleet().plan[0].next_velocity, plan.next_velocity) << step;
    ASSERT_EQ(simulation.fleet().position[1], mover.fleet().position[0]) << step;
    const Simulation::Perception next = simulation.perceive({0});
    for (std::size_t k = 0; k < next.neighbors.size(); ++k) {
      if (next.source[k] != 1) continue;
      EXPECT_EQ(next.neighbors[k].behavior, Behavior::moves_on);
      EXPECT_EQ(next.neighbors[k].max_deviation, scene.robots[1].max_acceleration);
      EXPECT_EQ(next.neighbors[k].max_speed, scene.robots[1].max_speed);
      ++as_mover;
    }
  }
  EXPECT_GT(as_mover, 80);
  EXPECT_TRUE(simulation.all_at_goal());
}

// Trucks that avoid no robot cross a crowd and brake behind it. No robot is touched in motion.
TEST(Layers, movers_touch_robots_at_rest_only_whatever_they_do) {
  Random random(11);
  Scenario scene;
  scene.sensing_radius = 20.0;
  scene.max_neighbors = 10;
  for (int k = 0; k < 60; ++k) {
    const Vec2 place{2.0 * (k % 10) - 9.0, 2.0 * (k / 10) - 5.0};
    RobotSetup robot = robot_at(place + test::in_disc(random, 0.3), test::in_disc(random, 8.0));
    robot.max_acceleration = random.uniform(0.5, 2.0);
    scene.robots.push_back(robot);
  }
  for (int k = 0; k < 6; ++k) {
    RobotSetup truck = robot_at({-20.0 - 8.0 * k, 3.0 * (k % 3) - 3.0}, {});
    truck.goal = truck.position + Vec2{40.0 + 8.0 * k, 0.0};
    truck.radius = 0.8;
    truck.max_speed = truck.preferred_speed = 1.0;
    truck.velocity = {1.0, 0.0};
    scene.robots.push_back(in_layer(truck, 2, kNobody.bits));
  }
  EXPECT_TRUE(broken_assumptions(scene).none());
  Simulation simulation(scene, 1);
  Check check = judge_of(scene);
  crush(60, 800, 60, 5.0, random, simulation, check);
  const CheckReport report = check.report();
  EXPECT_EQ(report.overlaps.count, 0) << report.overlaps.worst;
  EXPECT_EQ(report.one_sided_contacts_moving.count, 0) << report.one_sided_contacts_moving.worst;
  EXPECT_GT(report.one_sided_contacts_at_rest, 0);
}

TEST(Layers, contacts_of_those_who_avoid_nobody_do_not_count) {
  Scenario scene;
  scene.robots = {in_layer(robot_at({-3, 0}, {3, 0}), 2, 2),
                  in_layer(robot_at({3, 0}, {-3, 0}), 4, 4)};
  EXPECT_FALSE(sensing_need(scene));
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  for (int k = 0; k < 80; ++k) simulation.step(), metrics.observe(simulation);
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_EQ(summary.one_sided_collisions, 0);
  EXPECT_EQ(summary.arrived, 2);
  EXPECT_EQ(summary.last_arrival, summary.mean_arrival);
  EXPECT_FALSE(summary.min_clearance);
}

}  // namespace
}  // namespace avo
