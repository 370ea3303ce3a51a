// SPDX-License-Identifier: Apache-2.0
// Moving obstacles of space: touched at rest only, and not at all where there is an evasive
// maneuver.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/assumptions.h"
#include "avo/space/metrics.h"
#include "avo/space/simulation.h"
#include "certificate/predicted.h"
#include "support/refusal.h"
#include "unit/space/draws.h"
#include "unit/space/runs.h"

namespace avo::space::tests {
namespace {

using test::refusal;

Scenario alone(Vec3 position, Vec3 goal) {
  Scenario scene;
  scene.duration = 20.0;
  scene.sensing_radius = 60.0;
  RobotSetup robot;
  robot.position = position, robot.goal = goal;
  robot.radius = 0.4;
  scene.robots = {robot};
  return scene;
}

// A moving obstacle that is at `place` at that time.
MovingObstacle passing(Vec3 place, Vec3 velocity, double time, double radius) {
  MovingObstacle obstacle;
  obstacle.position = place - time * velocity, obstacle.velocity = velocity;
  obstacle.radius = radius;
  return obstacle;
}

void add_passing(Scenario& scene, int count, Draws& draws, double faster) {
  const RobotSetup& robot = scene.robots[0];
  while (scene.moving_obstacles.size() < static_cast<std::size_t>(count)) {
    const Vec3 middle = 0.5 * (robot.position + robot.goal);
    const MovingObstacle obstacle =
        passing(middle + draws.within(1.5), draws.between(0.4, faster) * draws.direction(),
                draws.between(3.0, 14.0), draws.between(0.3, 1.2));
    if (norm(obstacle.position - robot.position) > obstacle.radius + robot.radius + 3.0)
      scene.moving_obstacles.push_back(obstacle);
  }
}

TEST(SpaceMovers, hit_no_robot_that_crosses) {
  for (int k = 0; k < 12; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 10);
    Scenario scene = alone({-8, 0, 0}, {8, 0, 0});
    add_passing(scene, 1 + k % 6, draws, 4.0);
    const RunSummary summary = summary_of(scene, RunUntil::its_end);
    EXPECT_EQ(summary.mover_collisions, 0) << k;
    EXPECT_EQ(summary.arrived, 1) << k;
  }
}

TEST(SpaceMovers, hit_no_robot_at_its_goal) {
  for (int k = 0; k < 12; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 40);
    Scenario scene = alone({}, {});
    add_passing(scene, 1 + k % 4, draws, 3.0);
    EXPECT_EQ(summary_of(scene, RunUntil::its_end).mover_collisions, 0) << k;
  }
}

TEST(SpaceMovers, a_thrown_ball_is_evaded) {
  for (int k = 0; k < 8; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 80);
    Scenario scene = alone({0, 0, 3}, {0, 0, 3});
    scene.duration = 4.0;
    scene.sensing_radius = 400.0;
    MovingObstacle ball;
    const double time = draws.between(1.4, 2.2);
    const Vec3 at_robot = draws.between(4.0, 9.0) * draws.direction();
    ball.acceleration = {0, 0, -9.81};
    ball.velocity = at_robot - time * ball.acceleration;
    ball.position = scene.robots[0].position + draws.within(0.4) - time * at_robot +
                    (0.5 * time * time) * ball.acceleration;
    ball.radius = 0.2;
    scene.moving_obstacles = {ball};
    EXPECT_EQ(summary_of(scene, RunUntil::its_end).mover_collisions, 0) << k;
  }
}

TEST(SpaceMovers, a_robot_evades_within_its_own_limits) {
  for (int k = 0; k < 8; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 120);
    Scenario scene = alone({}, {});
    RobotSetup& robot = scene.robots[0];
    robot.vertical = k % 2 == 0 ? 0.4 : 1.6;
    robot.climb = 0.5, robot.sink = 0.7;
    add_passing(scene, 2, draws, 3.0);
    Simulation simulation(scene);
    Check check(checked_robots(scene), {}, {}, checked_movers(scene));
    const auto observe = [&] {
      const Robot& now = simulation.robots()[0];
      const CheckedState row{0, now.position, now.velocity};
      check.add(simulation.time(), std::span(&row, 1), mover_states(scene, simulation.time()));
    };
    observe();
    while (simulation.time() < 18.0) simulation.step(), observe();
    EXPECT_FALSE(check.report().broken()) << k;
  }
}

TEST(SpaceMovers, beside_boxes_a_robot_evades_without_touching_them) {
  for (int k = 0; k < 8; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 160);
    Scenario scene = alone({0, 0, 1.0}, {0, 0, 1.0});
    scene.boxes = {{{-Box::kFar, -Box::kFar, -Box::kFar}, {Box::kFar, Box::kFar, 0.0}, 0.0, 0.0},
                   {{1.5, -4, 0}, {2.0, 4, 6}, 0.3, 0.0}};
    add_passing(scene, 2, draws, 2.5);
    const RunSummary summary = summary_of(scene, RunUntil::its_end);
    EXPECT_EQ(summary.static_collisions, 0) << k;
    EXPECT_EQ(summary.mover_collisions_in_motion, 0) << k;
  }
}

// There are fleets among moving obstacles. Robots in motion touch no body, and robots never touch
// each other.
TEST(SpaceMovers, touch_robots_of_a_fleet_at_rest_only) {
  for (int k = 0; k < 3; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 200);
    Scenario scene;
    scene.duration = 15.0;
    for (int i = 0; i < 16; ++i) {
      RobotSetup robot;
      robot.position = {3.0 * (i % 4) - 4.5, 3.0 * (i / 4) - 4.5, 0.0};
      robot.goal = {-robot.position.y, robot.position.x, 2.0};
      scene.robots.push_back(robot);
    }
    for (int i = 0; i < 5; ++i) {
      const Vec3 direction = draws.direction();
      scene.moving_obstacles.push_back(passing(draws.within(3.0),
                                               draws.between(0.5, 3.0) * direction,
                                               draws.between(9.0, 11.0), draws.between(0.3, 1.5)));
    }
    const RunSummary summary = summary_of(scene, RunUntil::its_end);
    EXPECT_EQ(summary.collision_pairs, 0) << k;
    EXPECT_EQ(summary.mover_collisions_in_motion, 0) << k;
  }
}

// A moving obstacle knows each decision and accelerates towards the robot within what is declared.
TEST(SpaceMovers, that_deviate_touch_a_robot_at_rest_only) {
  for (int k = 0; k < 12; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 300);
    PlannerOptions options{.method = Method::avo};
    const Planner planner(options);
    PlanWorkspace workspace;
    Detour detour;
    Robot robot;
    robot.max_speed = draws.between(0.5, 2.0);
    Mover mover;
    mover.max_deviation = draws.between(0.3, 3.0), mover.max_speed = draws.between(0.5, 3.0);
    mover.position = 12.0 * draws.direction();
    mover.radius = draws.between(0.2, 1.0);
    Check check({{.radius = robot.radius, .max_speed = robot.max_speed}}, {}, {},
                {CheckedMover{.radius = mover.radius}});
    const double h = options.time_step;
    for (int step = 0; step < 200; ++step) {
      const CheckedState row{0, robot.position, robot.velocity},
          other{0, mover.position, mover.velocity};
      check.add(step * h, std::span(&row, 1), std::span(&other, 1));
      robot.preferred_velocity = robot.max_speed * draws.direction();
      const Plan plan = planner.plan(robot, {}, workspace, &detour, {}, std::span(&mover, 1));
      const Vec3 ahead = robot.position + (2.0 * h) * plan.next_velocity - mover.position;
      const double distance = norm(ahead);
      Vec3 wanted = mover.velocity;
      if (distance > 0.0)
        wanted = mover.velocity + ((1.0 - 1e-9) * mover.max_deviation * h / distance) * ahead;
      const double speed = norm(wanted);
      if (speed > mover.max_speed) wanted = ((1.0 - 1e-9) * mover.max_speed / speed) * wanted;
      mover.position = mover.position + (0.5 * h) * (mover.velocity + wanted);
      mover.velocity = wanted;
      robot.position = robot.position + (0.5 * h) * (robot.velocity + plan.next_velocity);
      robot.velocity = plan.next_velocity;
    }
    EXPECT_EQ(check.report().mover_contacts_moving.count, 0) << k;
    EXPECT_EQ(check.report().accelerations.count, 0) << k;
  }
}

TEST(SpaceMovers, are_sensed_with_noise_and_late) {
  for (int k = 0; k < 6; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 400);
    Scenario scene = alone({-8, 0, 0}, {8, 0, 0});
    scene.sensing.noise = {.position = 0.02, .velocity = 0.03};
    scene.sensing.delay = 1;
    scene.sensing.dropped = 0.1;
    add_passing(scene, 3, draws, 2.0);
    EXPECT_EQ(summary_of(scene, RunUntil::its_end).mover_collisions_in_motion, 0) << k;
  }
}

TEST(SpaceMovers, on_a_trajectory_are_where_it_has_them) {
  MovingObstacle obstacle;
  obstacle.trajectory = {{1.0, {0, 0, 1}}, {3.0, {4, 0, 1}}, {4.0, {4, 2, 1}}};
  EXPECT_EQ(state_at(obstacle, 0.5).position, (Vec3{0, 0, 1}));
  EXPECT_EQ(state_at(obstacle, 0.5).velocity, Vec3{});
  EXPECT_EQ(state_at(obstacle, 2.0).position, (Vec3{2, 0, 1}));
  EXPECT_EQ(state_at(obstacle, 3.0).velocity, (Vec3{0, 2, 0}));
  EXPECT_EQ(state_at(obstacle, 9.0).position, (Vec3{4, 2, 1}));
  EXPECT_EQ(state_at(obstacle, 9.0).velocity, Vec3{});
}

// What proves that a step keeps off is never more than what dense samples find, and misses little.
TEST(SpaceMovers, proofs_of_distance_agree_with_dense_samples) {
  Draws draws(500);
  int proved = 0, missed = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 middle = 0.2 * draws.direction();
    const HullOf<3> hull{middle + draws.within(2.0), middle + draws.within(2.0),
                         middle + draws.within(2.0)};
    double nearest = 1e9;
    for (int i = 0; i <= 40; ++i) {
      for (int j = 0; j <= 40 - i; ++j) {
        const double a = i / 40.0, b = j / 40.0;
        nearest =
            std::min(nearest, norm(a * hull.start + b * hull.middle + (1.0 - a - b) * hull.end));
      }
    }
    if (keeps_off(hull, nearest * 1.001)) ADD_FAILURE() << k << ' ' << nearest;
    if (nearest < 0.1) continue;
    ++proved;
    if (!keeps_off(hull, 0.9 * nearest - 0.01)) ++missed;
  }
  EXPECT_GT(proved, 1000);
  EXPECT_EQ(missed, 0);
}

TEST(SpaceMovers, rest_is_clear_of_accelerating_ones_where_dense_samples_say_so) {
  Draws draws(600);
  int clear = 0, touched = 0;
  for (int k = 0; k < 3000; ++k) {
    PredictedOf<3> other;
    other.position = draws.within(6.0), other.velocity = draws.within(3.0);
    if (k % 3 != 0) other.acceleration = draws.within(2.0);
    other.contact = draws.between(0.2, 1.0);
    const Vec3 place = draws.within(2.0);
    double nearest = 1e9;
    for (int i = 0; i < 4000; ++i)
      nearest = std::min(nearest, norm(place - other.place_at(1.0 + 0.01 * i)));
    const bool is_clear = rests_clear(other, place, 1.0);
    if (is_clear) ++clear;
    if (nearest < other.contact) ++touched;
    if (is_clear) {
      EXPECT_GE(nearest, other.contact * 0.999) << k;
    } else {
      EXPECT_LE(nearest, other.contact * 1.01 + 1e-3) << k;
    }
  }
  EXPECT_GT(clear, 500);
  EXPECT_GT(touched, 30);
}

TEST(SpaceMovers, the_judge_tells_contacts_at_rest_from_those_in_motion) {
  const auto judged = [](Vec3 velocity) {
    Check check({{}}, {}, {}, {CheckedMover{.radius = 0.5}});
    const CheckedState start{0, {}, velocity}, end{0, velocity, velocity};
    const CheckedState from{0, {-3, 0, 0.6}, {6, 0, 0}}, to{0, {3, 0, 0.6}, {6, 0, 0}};
    check.add(0.0, std::span(&start, 1), std::span(&from, 1));
    check.add(1.0, std::span(&end, 1), std::span(&to, 1));
    return check.report();
  };
  EXPECT_EQ(judged({}).mover_contacts_at_rest, 1);
  EXPECT_EQ(judged({}).mover_contacts_moving.count, 0);
  EXPECT_NEAR(judged({}).mover_hits[0].depth, 0.4, 1e-8);
  EXPECT_EQ(judged({0, 0.1, 0}).mover_contacts_moving.count, 1);
  EXPECT_EQ(judged({0, 0, -1}).mover_contacts_at_rest, 0);
}

// A robot in motion along x, and a moving obstacle before it.
Scenario facing(double speed, double x, double speed_of_mover) {
  Scenario scene = alone({}, {9, 0, 0});
  scene.robots[0].radius = 0.5;
  scene.robots[0].velocity = {speed, 0, 0};
  scene.moving_obstacles.resize(1);
  scene.moving_obstacles[0].position = {x, 0, 0};
  scene.moving_obstacles[0].velocity = {speed_of_mover, 0, 0};
  scene.moving_obstacles[0].radius = 0.5;
  return scene;
}

TEST(SpaceMovers, before_which_no_robot_can_brake_are_refused) {
  const std::string words =
      "robot 0 and moving obstacle 0 start too fast for their distance: found 1 m of overlap when "
      "robot 0 brakes at once, must be none; slow down, or move apart";
  for (const double speed_of_mover : {0.0, -9.0}) {
    Scenario scene = facing(2.0, 2.0, speed_of_mover);
    EXPECT_EQ(refusal([&] { validate(scene); }), words) << speed_of_mover;
    EXPECT_EQ(refusal([&] { Simulation simulation(scene); }), words) << speed_of_mover;
    scene.certificate = Certificate::none;
    validate(scene);
  }
  validate(facing(2.0, 3.0, 0.0));  // it touches where the robot stops, up to rounding
  validate(facing(0.0, 1.1, -9.0));
  EXPECT_NE(refusal([&] { validate(facing(2.0, 2.99, 0.0)); }), "");
}

// In a plane of space the same starts are refused as in the plane. Those that are not lead to no
// contact in motion.
TEST(SpaceMovers, are_refused_at_the_start_as_in_the_plane) {
  int refused = 0, kept = 0;
  for (int k = 0; k < 400; ++k) {
    Draws draws(static_cast<std::uint64_t>(k) + 500);
    Scenario scene = facing(draws.between(0.0, 2.0), draws.between(1.05, 4.0), 0.0);
    MovingObstacle& obstacle = scene.moving_obstacles[0];
    obstacle.position.y = draws.between(-1.5, 1.5);
    obstacle.velocity = {draws.between(-3.0, 2.0), draws.between(-1.0, 1.0), 0.0};
    if (k % 3 == 0) obstacle.acceleration = {draws.between(-2.0, 2.0), 0.0, 0.0};
    if (k % 3 == 1) obstacle.max_deviation = 0.5;
    scene.duration = 4.0;
    avo::Scenario plane;
    plane.robots.resize(1);
    plane.robots[0].radius = 0.5;
    plane.robots[0].velocity.x = scene.robots[0].velocity.x;
    plane.moving_obstacles.resize(1);
    avo::MovingObstacle& same = plane.moving_obstacles[0];
    same.position = {obstacle.position.x, obstacle.position.y};
    same.velocity = {obstacle.velocity.x, obstacle.velocity.y};
    same.acceleration = {obstacle.acceleration.x, obstacle.acceleration.y};
    same.max_deviation = obstacle.max_deviation;
    same.radius = obstacle.radius;
    const std::string words = refusal([&] { validate(scene); });
    const bool is_refused_in_plane = broken_assumptions(plane).start_count > 0;
    EXPECT_EQ(!words.empty(), is_refused_in_plane) << k << ": " << words;
    ++(words.empty() ? kept : refused);
    if (!words.empty()) continue;
    EXPECT_EQ(summary_of(scene, RunUntil::its_end).mover_collisions_in_motion, 0) << k;
  }
  EXPECT_GT(refused, 50);
  EXPECT_GT(kept, 50);
}

TEST(SpaceMovers, out_of_range_are_refused) {
  Scenario scene = alone({}, {});
  MovingObstacle obstacle;
  obstacle.position = {0.25, 0, 0};
  scene.moving_obstacles = {obstacle};
  EXPECT_EQ(refusal([&] { validate(scene); }),
            "robot 0 and moving obstacle 0 overlap at the start: found 0.25 m between the centers, "
            "must be >= 0.4 + 0.5 = 0.9 m; move them apart");
  scene.moving_obstacles[0].position = {5, 0, 0};
  scene.moving_obstacles[0].max_speed = 2.0;
  EXPECT_EQ(refusal([&] { validate(scene); }),
            "moving_obstacles.0.max_speed: found 2, must be left out without max_deviation: it "
            "keeps its acceleration");
  scene.moving_obstacles[0].max_speed.reset();
  scene.moving_obstacles[0].trajectory = {{1.0, {5, 0, 0}}, {1.0, {6, 0, 0}}};
  EXPECT_EQ(refusal([&] { validate(scene); }),
            "moving_obstacles.0.trajectory: found 1 s after 1 s, must be ascending times");
  scene.moving_obstacles[0].trajectory.clear();
  scene.sensing_radius = 2.0;
  EXPECT_NE(
      refusal([&] { validate(scene); }).find("in which a robot can stop before moving obstacles"),
      std::string::npos);
}

}  // namespace
}  // namespace avo::space::tests
