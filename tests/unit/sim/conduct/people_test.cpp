// SPDX-License-Identifier: Apache-2.0
// Moving obstacles that follow a path, robots that brake less than they accelerate, and what scenes
// may say of both.
#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "avo/assumptions.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::Random;
using test::refusal;
using test::robot_at;

MovingObstacle walker(std::vector<Vec2> path) {
  return {.position = {},
          .radius = 0.3,
          .max_deviation = 2.0,
          .max_speed = 1.5,
          .path = std::move(path)};
}

TEST(Paths, are_followed_from_point_to_point_within_the_limits) {
  for (const double time_step : {0.02, 0.1, 0.5}) {
    Random random(3);
    MovingObstacle person = walker({});
    for (int k = 0; k < 5; ++k) person.path.push_back(test::in_disc(random, 8.0));
    PathWalk walk{person.position, {0.0, -1.5}};  // not where it goes
    std::vector<int> reached(person.path.size());
    for (int step = 0; step * time_step < 400.0; ++step) {
      const PathWalk next = next_on_path(person, walk, time_step);
      EXPECT_LE(norm(next.velocity - walk.velocity), 2.0 * time_step * (1.0 + 1e-12));
      EXPECT_LE(norm(next.velocity), 1.5 * (1.0 + 1e-12));
      const Vec2 mean = 0.5 * (walk.velocity + next.velocity);
      EXPECT_LE(norm(next.position - walk.position - time_step * mean), 1e-12);
      if (next.next_point != walk.next_point) {
        EXPECT_EQ(next.next_point, (walk.next_point + 1) % person.path.size());
        EXPECT_LE(norm(walk.position - person.path[walk.next_point]), person.radius);
        ++reached[walk.next_point];
      }
      walk = next;
    }
    EXPECT_GE(*std::min_element(reached.begin(), reached.end()), 5) << time_step;
  }
}

TEST(Paths, of_one_point_end_there) {
  const MovingObstacle person = walker({{3.0, 4.0}});
  PathWalk walk{};
  for (int step = 0; step < 200; ++step) walk = next_on_path(person, walk, 0.1);
  EXPECT_LE(norm(walk.position - Vec2{3.0, 4.0}), 1e-6);
  EXPECT_LE(norm(walk.velocity), 1e-6);
}

// People walk to and fro through robots on errands.
Scenario busy_hall() {
  Random random(8);
  Scenario scene;
  scene.sensing_radius = 14.0;
  for (int k = 0; k < 20; ++k) {
    const Vec2 place{2.0 * (k % 5) - 4.0, 2.0 * (k / 5) - 3.0};
    RobotSetup robot = robot_at(place, -1.0 * place + test::in_disc(random, 0.3));
    robot.radius = 0.4;
    robot.max_speed = robot.preferred_speed = 1.2;
    scene.robots.push_back(robot);
  }
  for (const double side : {-1.0, 1.0}) {
    MovingObstacle person = walker({{2.0 * side, 9.0}, {-side, -9.0}});
    person.position = {8.0 * side, 9.0};
    scene.moving_obstacles.push_back(person);
  }
  return scene;
}

RunSummary walk_through(const Scenario& scene) {
  EXPECT_TRUE(broken_assumptions(scene).none());
  Simulation simulation(scene, 1), other(scene, 2);
  Metrics metrics(scene);
  metrics.observe(simulation);
  for (int step = 0; step < 900; ++step) {
    simulation.step(), other.step();
    metrics.observe(simulation);
    EXPECT_EQ(simulation.state_hash(), other.state_hash());
  }
  return metrics.summary();
}

TEST(People, walk_into_robots_at_rest_only) {
  Scenario scene = busy_hall();
  for (RobotSetup& robot : scene.robots) robot.model = DifferentialDrive{};  // these stay
  const RunSummary summary = walk_through(scene);
  EXPECT_GT(summary.mover_collisions, 0);
  EXPECT_EQ(summary.mover_collisions_in_motion, 0);
  EXPECT_EQ(summary.collision_pairs, 0);
}

TEST(People, walk_into_hardly_anybody_who_can_leave_their_way) {
  Scenario scene = busy_hall();
  scene.sensing.noise.position = 1e-6;  // so no robot knows their paths
  const RunSummary summary = walk_through(scene);
  EXPECT_LE(summary.mover_collisions, 1);  // where robots stand close together
  EXPECT_EQ(summary.mover_collisions_in_motion, 0);
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_EQ(summary.arrived, 20);
}

TEST(People, tell_which_point_they_go_for) {
  Simulation simulation(busy_hall(), 1);
  std::vector<PathWalk> walks;
  for (const MovingObstacle& person : simulation.moving_obstacles().setup)
    walks.push_back({person.position, person.velocity});
  for (int step = 0; step < 300; ++step) {
    simulation.step();
    const MovingObstacleView people = simulation.moving_obstacles();
    ASSERT_EQ(people.next_point.size(), 2u);
    for (std::size_t k = 0; k < walks.size(); ++k) {
      walks[k] = next_on_path(people.setup[k], walks[k], 0.1);
      ASSERT_EQ(people.next_point[k], walks[k].next_point) << step;
    }
  }
  EXPECT_EQ(walks[0].next_point, 1u);
}

TEST(Braking, towards_a_goal_begins_as_early_as_the_limit_asks_for) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {20, 0})};
  scene.robots[0].max_braking = 0.4;
  Simulation simulation(scene, 1);
  double hardest = 0.0, fastest = 0.0, speed = 0.0;
  for (int step = 0; step < 400; ++step) {
    simulation.step();
    const double next = norm(simulation.fleet().velocity[0]);
    hardest = std::max(hardest, (speed - next) / scene.time_step);
    fastest = std::max(fastest, (next - speed) / scene.time_step);
    speed = next;
  }
  EXPECT_TRUE(simulation.all_at_goal());
  EXPECT_LE(hardest, 0.4 * (1.0 + 1e-9));
  EXPECT_GT(hardest, 0.39);
  EXPECT_GT(fastest, 0.99);
}

// What is always allowed, and what others count on.
TEST(Braking, without_a_decision_is_neither_less_nor_more_than_the_limit) {
  const Planner planner(PlannerOptions{});
  PlanWorkspace workspace;
  Robot robot{.velocity = {1.0, 0.0}, .max_braking = 0.4};
  robot.preferred_velocity.x = std::numeric_limits<double>::quiet_NaN();
  const Plan plan = planner.plan(robot, {}, workspace);
  EXPECT_EQ(plan.status, PlanStatus::invalid_input);
  EXPECT_NEAR(plan.next_velocity.x, 0.96, 1e-12);
}

std::string refusal_of(const std::function<void(Scenario&)>& change) {
  Scenario scene = busy_hall();
  change(scene);
  return refusal(scene);
}

TEST(People, what_cannot_be_meant_is_refused_in_a_line) {
  EXPECT_EQ(refusal_of([](Scenario&) {}), "");
  EXPECT_EQ(refusal_of([](Scenario& s) { s.moving_obstacles[1].max_deviation = -1.0; }),
            "moving_obstacles.1.max_deviation: found -1, must be >= 0 m/s^2");
  EXPECT_EQ(refusal_of([](Scenario& s) { s.moving_obstacles[1].max_deviation = 0.0; }),
            "moving_obstacles.1.max_speed: found 1.5, must be left out without max_deviation: it "
            "keeps its acceleration");
  EXPECT_EQ(refusal_of([](Scenario& s) { s.moving_obstacles[1].max_speed.reset(); }),
            "moving_obstacles.1.path: found one, must be left out without max_speed and "
            "max_deviation, within which it is followed");
  EXPECT_EQ(refusal_of([](Scenario& s) {
              s.moving_obstacles[0].acceleration = {0.1, 0.0};
            }),
            "moving_obstacles.0.acceleration: found [0.1, 0], must be [0, 0] with max_speed, which "
            "it would exceed");
  EXPECT_EQ(
      refusal_of([](Scenario& s) {
        s.moving_obstacles[0].velocity = {1.6, 0.0};
      }),
      "moving_obstacles.0.velocity: found [1.6, 0], must be at most max_speed = 1.5 m/s long");
  EXPECT_EQ(refusal_of([](Scenario& s) { s.sensing.delay = 1; }),
            "moving_obstacles.0.path: found one, must be left out where sensing has delay, dropped "
            "or occlusion");
  EXPECT_EQ(refusal_of([](Scenario& s) { s.robots[2].max_braking = 0.0; }),
            "robots.2.max_braking: found 0, must be > 0 m/s^2");
}

}  // namespace
}  // namespace avo
