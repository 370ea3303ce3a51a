// SPDX-License-Identifier: Apache-2.0
// A robot alone comes to rest on its goal: no overshoot, no jitter, at any δ, within its limits.
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::Random;

struct Settings {
  Method method;
  Motion motion;
  double delta;

  Scenario scene(const RobotSetup& robot) const {
    Scenario result;
    result.method = method;
    result.motion = motion;
    result.control_time = delta;
    result.robots = {robot};
    return result;
  }
};

struct Trip {
  Settings settings;
  RobotSetup robot;
};

struct Arrived {
  double error;         // m, at the end
  double beyond;        // m, how far past the goal along the line, at most
  double restlessness;  // m and m/s, largest change of the state in the last fifth
  double speed;         // m/s, at the end
  double acceleration;  // part of the limit, at most
  double top_speed;     // part of the limit, at most
  double arrival;       // s, first time within half a meter
};

Arrived travel(const Trip& trip, double time) {
  const Scenario scene = trip.settings.scene(trip.robot);
  Simulation simulation(scene, 1);
  const Vec2 goal = trip.robot.goal;
  const Vec2 way = goal - trip.robot.position;
  const Vec2 along = way / norm(way);
  const int steps = static_cast<int>(time / scene.time_step);
  Arrived outcome{0, 0, 0, 0, 0, 0, -1};
  Vec2 p = trip.robot.position, v = trip.robot.velocity;
  for (int k = 0; k < steps; ++k) {
    simulation.step();
    const Vec2 next_p = simulation.fleet().position[0], next_v = simulation.fleet().velocity[0];
    outcome.beyond = std::max(outcome.beyond, dot(along, next_p - goal));
    outcome.acceleration =
        std::max(outcome.acceleration,
                 simulation.fleet().applied_acceleration[0] / trip.robot.max_acceleration);
    const double mean = norm(next_v - v) / scene.time_step / trip.robot.max_acceleration;
    outcome.acceleration = std::max(outcome.acceleration, mean);
    outcome.top_speed = std::max(outcome.top_speed, norm(next_v) / trip.robot.max_speed);
    if (5 * k > 4 * steps) {
      outcome.restlessness = std::max({outcome.restlessness, norm(next_p - p), norm(next_v - v)});
    }
    if (outcome.arrival < 0 && norm(next_p - goal) < 0.5) outcome.arrival = simulation.time();
    p = next_p;
    v = next_v;
  }
  outcome.error = norm(p - goal);
  outcome.speed = norm(v);
  return outcome;
}

void expect_rest_on_the_goal(const Trip& trip, const Arrived& outcome, double most_beyond) {
  EXPECT_LT(outcome.error, 1e-6);
  EXPECT_LT(outcome.speed, 1e-6);
  EXPECT_LT(outcome.restlessness, 1e-12);
  EXPECT_LE(outcome.acceleration, 1.0 + 1e-9);
  EXPECT_LE(outcome.top_speed, 1.0 + 1e-9);
  EXPECT_LT(outcome.beyond, most_beyond);
  if (testing::Test::HasFailure()) {
    ADD_FAILURE() << "method " << static_cast<int>(trip.settings.method) << " delta "
                  << trip.settings.delta << " motion " << static_cast<int>(trip.settings.motion)
                  << " p " << trip.robot.position.x << " " << trip.robot.position.y << " v "
                  << trip.robot.velocity.x << " " << trip.robot.velocity.y << " goal "
                  << trip.robot.goal.x << " " << trip.robot.goal.y << " beyond " << outcome.beyond
                  << " a " << trip.robot.max_acceleration << " preferred "
                  << trip.robot.preferred_speed;
  }
}

void for_all_settings(const std::function<void(const Settings&)>& check) {
  for (const Method method : {Method::avo_paper, Method::avo}) {
    for (const Motion motion : {Motion::held, Motion::exponential}) {
      for (const double delta : {0.1, 0.5, 2.0, 4.0, 8.0}) check({method, motion, delta});
    }
  }
}

TEST(Goals, from_rest_the_goal_is_reached_without_overshoot) {
  Random random(40);
  for_all_settings([&](const Settings& settings) {
    for (int k = 0; k < 25 && !testing::Test::HasFailure(); ++k) {
      const double distance = random.log_uniform(1e-3, 100.0);
      const Vec2 start = test::in_disc(random, 50.0);
      Trip trip{settings, test::robot_at(start, start + distance * random.direction())};
      if (k % 2 == 1) {
        trip.robot.max_acceleration = random.log_uniform(0.2, 5.0);
        trip.robot.preferred_speed = random.uniform(0.3, 2.0);
      }
      const double time = 40.0 + 3.0 * distance / trip.robot.preferred_speed +
                          10.0 * settings.delta + 4.0 / trip.robot.max_acceleration;
      const Arrived outcome = travel(trip, time);
      expect_rest_on_the_goal(trip, outcome, 1e-9);
    }
  });
}

TEST(Goals, from_any_velocity_the_goal_is_reached) {
  Random random(41);
  for_all_settings([&](const Settings& settings) {
    for (int k = 0; k < 30 && !testing::Test::HasFailure(); ++k) {
      const double distance = random.log_uniform(1e-3, 100.0);
      const Vec2 start = test::in_disc(random, 50.0);
      const Vec2 towards = random.direction();
      Trip trip{settings, test::robot_at(start, start + distance * towards)};
      const double speed = random.uniform(0.0, 2.0);
      switch (k % 4) {
        case 0:
          trip.robot.velocity = -speed * towards;
          break;
        case 1:
          trip.robot.velocity = speed * perpendicular(towards);
          break;
        case 2:
          trip.robot.velocity = speed * towards;
          break;
        default:
          trip.robot.velocity = test::in_disc(random, 2.0);
      }
      if (k % 3 == 0) trip.robot.max_acceleration = random.log_uniform(0.3, 5.0);
      const double time = 100.0 + 3.0 * distance + 30.0 * settings.delta;
      expect_rest_on_the_goal(trip, travel(trip, time), 1e9);
    }
  });
}

TEST(Goals, on_the_goal_at_rest_nothing_moves) {
  for_all_settings([&](const Settings& settings) {
    Simulation simulation(settings.scene(test::robot_at({3, -7}, {3, -7})), 1);
    for (int k = 0; k < 100; ++k) simulation.step();
    const Vec2 goal{3, -7};
    EXPECT_EQ(simulation.fleet().position[0], goal);
    EXPECT_EQ(simulation.fleet().velocity[0], Vec2{});
    EXPECT_EQ(simulation.fleet().plan[0].status, PlanStatus::optimal);
  });
}

// Not by crawling: 20 m at 2 m/s and 1 m/s^2 take 12 s at best; some lags of δ are all that is
// added, and none by avo, which approaches v' as fast as it can.
TEST(Goals, the_way_takes_little_longer_than_it_must) {
  for_all_settings([&](const Settings& settings) {
    const Trip trip{settings, test::robot_at({0, 0}, {20, 0})};
    const Arrived outcome = travel(trip, 120.0);
    EXPECT_GT(outcome.arrival, 10.0);
    const double lags = settings.method == Method::avo ? 0.0 : 1.5 * settings.delta;
    EXPECT_LT(outcome.arrival, 12.5 + lags) << settings.delta;
  });
}

TEST(Goals, rest_is_reached_by_the_methods_without_control_time) {
  for (const Method method : {Method::orca, Method::velocity_obstacle, Method::orca_clamped,
                              Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    Scenario scene;
    scene.method = method;
    scene.robots = {test::robot_at({0, 0}, {7.123, -3.3})};
    Simulation simulation(scene, 1);
    for (int k = 0; k < 200; ++k) simulation.step();
    EXPECT_LT(norm(simulation.fleet().position[0] - scene.robots[0].goal), 1e-12);
    EXPECT_LT(norm(simulation.fleet().velocity[0]), 1e-12);
  }
}

TEST(Goals, a_new_goal_is_taken_up) {
  for_all_settings([&](const Settings& settings) {
    Simulation simulation(settings.scene(test::robot_at({0, 0}, {5, 0})), 1);
    for (int k = 0; k < 40; ++k) simulation.step();
    simulation.set_goal({0}, {-3, 4});
    for (int k = 0; k < 800; ++k) simulation.step();
    EXPECT_LT(norm(simulation.fleet().position[0] - Vec2{-3, 4}), 1e-6);
    EXPECT_TRUE(simulation.all_at_goal());
  });
}

}  // namespace
}  // namespace avo
