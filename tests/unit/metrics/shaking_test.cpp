// SPDX-License-Identifier: Apache-2.0
// Metrics of robots that shake, by hand and against the columns of whole runs.
#include <cmath>
#include <gtest/gtest.h>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <ostream>
#include <span>
#include <vector>

#include "metrics/trips.h"
#include "runs.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::robot_at;

constexpr double kOwnStep = 0.125;  // s, so that all numbers by hand are exact

// At that velocity, m/s; 0.3 a_max is 3 m/s^2, and 0.02 m/s is no motion.
Trip under_way(Vec2 velocity) {
  Trip trip;
  trip.preferred_speed = 2.0;
  trip.step = kOwnStep;
  trip.acceleration_limit = 10.0;
  trip.velocity = velocity;
  return trip;
}

struct Turns {
  std::int64_t turned_back = 0, moving_steps = 0;
  friend bool operator==(const Turns&, const Turns&) = default;
};
std::ostream& operator<<(std::ostream& out, const Turns& turns) {
  return out << turns.turned_back << " of " << turns.moving_steps;
}

// Steps with these accelerations, m/s^2.
Turns turns_of(Trip trip, std::initializer_list<Vec2> accelerations) {
  for (const Vec2 a : accelerations)
    go_on(trip, {}, trip.velocity + kOwnStep * a, 10.0, kOwnStep, true);
  return {trip.turned_back, trip.moving_steps};
}

TEST(TurnedBack, counts_all_steps_but_the_first) {
  const Trip trip = under_way({5, 0});
  EXPECT_EQ(turns_of(trip, {{-8, 0}}), (Turns{0, 0}));
  EXPECT_EQ(turns_of(trip, {{8, 0}, {-8, 0}}), (Turns{1, 1}));
  EXPECT_EQ(turns_of(trip, {{8, 0}, {-8, 0}, {-8, 0}, {8, 0}, {8, 0}}), (Turns{2, 4}));
  EXPECT_EQ(turns_of(trip, {{0, 8}, {0, -8}, {0, 8}, {0, -8}}), (Turns{3, 3}));
  EXPECT_EQ(turns_of(trip, {{8, 0}, {0, 0}, {-8, 0}}), (Turns{0, 2})) << "a step between";
}

TEST(TurnedBack, takes_more_than_135_degrees) {
  const Trip trip = under_way({5, 0});
  EXPECT_EQ(turns_of(trip, {{8, 0}, {-8, 8}}), (Turns{0, 1}));
  EXPECT_EQ(turns_of(trip, {{8, 0}, {-8, -8}, {8, 0}}), (Turns{0, 2}));
  EXPECT_EQ(turns_of(trip, {{4, 4}, {-8, 0}, {0, 4}}), (Turns{0, 2}));
  EXPECT_EQ(turns_of(trip, {{8, 0}, {-8, 7.96875}}), (Turns{1, 1}));
  EXPECT_EQ(turns_of(trip, {{8, 0}, {-8, -7.96875}, {8, 0}}), (Turns{2, 2}));
  EXPECT_EQ(turns_of(trip, {{8, 0}, {-8, 8.03125}}), (Turns{0, 1}));
  EXPECT_EQ(turns_of(trip, {{8, 0}, {0, 8}, {8, 8}, {4, 4}}), (Turns{0, 3}));
}

TEST(TurnedBack, takes_accelerations_above_0_3_of_the_limit) {
  const Trip trip = under_way({5, 0});
  EXPECT_EQ(turns_of(trip, {{3, 0}, {-3, 0}, {3, 0}}), (Turns{0, 2}));
  EXPECT_EQ(turns_of(trip, {{3.0078125, 0}, {-3.0078125, 0}}), (Turns{1, 1}));
  EXPECT_EQ(turns_of(trip, {{9, 0}, {-3, 0}, {9, 0}}), (Turns{0, 2})) << "one of the two is weak";
  EXPECT_EQ(turns_of(trip, {{99, 0}, {-99, 0}}), (Turns{1, 1})) << "beyond every limit";
}

TEST(TurnedBack, leaves_out_steps_of_robots_at_rest) {
  EXPECT_EQ(turns_of(under_way({0, 0}), {{0, 0}, {0, 0}, {8, 0}}), (Turns{0, 0}));
  // sets out, stops, and sets out again: at rest before every second step
  EXPECT_EQ(turns_of(under_way({0, 0}), {{8, 0}, {-8, 0}, {8, 0}, {-8, 0}}), (Turns{2, 2}));
  // one hundredth of the preferred speed is none
  EXPECT_EQ(turns_of(under_way({0.02, -1}), {{0, 8}, {0, -8}}), (Turns{0, 0}));
  EXPECT_EQ(turns_of(under_way({0.02001, -1}), {{0, 8}, {0, -8}}), (Turns{1, 1}));
}

// By clocks of their own a robot is seen within its steps, too.
TEST(TurnedBack, counts_a_robots_own_steps) {
  Trip trip = under_way({5, 0});
  trip.step = 2.0 * kOwnStep;
  const auto part = [&](Vec2 a, bool decided) {
    go_on(trip, {}, trip.velocity + kOwnStep * a, 10.0, kOwnStep, decided);
    return Turns{trip.turned_back, trip.moving_steps};
  };
  part({8, 0}, true);
  EXPECT_EQ(part({8, 0}, false), (Turns{0, 0}));
  EXPECT_EQ(part({-8, 0}, true), (Turns{1, 1}));
  EXPECT_EQ(part({-8, 0}, false), (Turns{1, 1}));
  EXPECT_EQ(part({-8, 0}, true), (Turns{1, 2}));
  EXPECT_EQ(part({8, 0}, false), (Turns{1, 2}));
}

TEST(TurnedBack, of_robots_that_stay_at_rest_is_unset) {
  RobotSetup idle = robot_at({0, 0}, {30, 0});
  idle.preferred_speed = 0.0;
  const RunMetrics m = run(alone({idle}), 20).metrics;
  EXPECT_FALSE(m.turned_back);
  EXPECT_EQ(*m.acceleration_rms, 0.0);
  EXPECT_FALSE(run(alone({robot_at({0, 0}, {0.4, 0})}), 20).metrics.acceleration_rms)
      << "there from the start on";
}

// From rest over 20 m at 2 m/s: 2 s and 1 s of 11 s at the limit of 1 m/s^2.
TEST(AccelerationRms, of_a_robot_alone) {
  RobotSetup robot = robot_at({0, 0}, {20, 0});
  const RunMetrics m = run(alone({robot}), 150).metrics;
  EXPECT_NEAR(*m.acceleration_rms, std::sqrt(3.0 / 11.0), 0.01);
  EXPECT_EQ(*m.turned_back, 0.0);
  robot.max_acceleration = 4.0;
  const RunMetrics strong = run(alone({robot}), 150).metrics;
  EXPECT_NEAR(*strong.acceleration_rms, std::sqrt(*strong.effort / *strong.flowtime) / 4.0, 1e-12);
}

// The crowd has robots of all models. Some holonomic robots brake three times as hard as they speed
// up.
Scenario shaking_crowd(std::uint64_t seed) {
  Scenario scene = test::dense_scene(40, Motion::held, seed);
  scene.method = Method::avo;
  scene.moving_obstacles.clear();
  for (std::size_t k = 0; k < scene.robots.size(); ++k) {
    RobotSetup& robot = scene.robots[k];
    robot.position = 2.0 * robot.position;
    robot.goal = 2.0 * robot.goal;
    if (k % 5 == 1) robot.max_braking = 3.0 * robot.max_acceleration;
    if (k % 5 == 2) {
      robot.model = Airplane{0.5, 2.0 * robot.max_acceleration};
      robot.velocity = robot.max_speed / norm(robot.velocity) * robot.velocity;
      robot.heading = std::atan2(robot.velocity.y, robot.velocity.x);
    }
    if (k % 5 == 3) {
      robot.model = DifferentialDrive{.wheel_speed = 2.0, .wheel_acceleration = 4.0};
      robot.velocity = {};
    }
  }
  return scene;
}

// Half of them decide every 0.07 s, the others every 0.1 s, at instants of their own.
Scenario crowd_by_clocks(std::uint64_t seed) {
  Scenario scene = test::dense_scene(24, Motion::held, seed);
  scene.method = Method::avo;
  scene.clock = Clock::free;
  scene.moving_obstacles.clear();
  for (std::size_t k = 0; k < scene.robots.size(); ++k) {
    scene.robots[k].model = Holonomic{};
    if (k % 2 == 1) scene.robots[k].time_step = 0.07;
  }
  return scene;
}

// Everything again from the columns of a run.
struct Shaken {
  double turned_back = 0.0, moving = 0.0, squared = 0.0, time = 0.0;
  double hardest = 0.0;  // m/s^2 beyond max_acceleration
};

struct SeenRobot {
  Vec2 begin = {};           // m/s, when its own step began
  double begin_time = 0.0;   // s
  std::optional<Vec2> mean;  // m/s^2, of its own step before
  bool is_there = false;
};

double limit_of(const RobotSetup& robot) {
  const Airplane* airplane = std::get_if<Airplane>(&robot.model);
  return std::hypot(robot.max_acceleration, airplane ? airplane->lateral_acceleration : 0.0);
}

double degrees_between(Vec2 a, Vec2 b) {
  return std::atan2(std::abs(cross(a, b)), dot(a, b)) * 180.0 / std::numbers::pi;
}

Shaken shaken_in(const Scenario& scene, int steps) {
  Simulation simulation(scene, 1);
  std::vector<SeenRobot> seen(scene.robots.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i] = {scene.robots[i].velocity, 0.0, {}, simulation.is_at_goal({i})};
  Shaken all;
  for (int k = 0; k < steps; ++k) {
    const std::span<const Vec2> velocities = simulation.fleet().velocity;
    const std::vector<Vec2> before(velocities.begin(), velocities.end());
    const double now = simulation.time();
    simulation.step();
    const double duration = simulation.time() - now;
    const FleetView fleet = simulation.fleet();
    for (std::size_t i = 0; i < seen.size(); ++i) {
      SeenRobot& robot = seen[i];
      if (robot.is_there) continue;
      const Vec2 a = (fleet.velocity[i] - before[i]) / duration;
      const double a_max = limit_of(scene.robots[i]);
      all.hardest = std::max(all.hardest, norm(a) - a_max);
      all.squared += norm_squared(a) / (a_max * a_max) * duration;
      all.time += duration;
      if (simulation.decided({i})) {
        if (now > robot.begin_time)
          robot.mean = (before[i] - robot.begin) / (now - robot.begin_time);
        robot.begin = before[i], robot.begin_time = now;
        if (robot.mean && norm(before[i]) > 0.01 * scene.robots[i].preferred_speed) {
          all.moving += 1.0;
          const bool both = norm(a) > 0.3 * a_max && norm(*robot.mean) > 0.3 * a_max;
          if (both && degrees_between(a, *robot.mean) > 135.0) all.turned_back += 1.0;
        }
      }
      robot.is_there = simulation.is_at_goal({i});
    }
  }
  return all;
}

TEST(Shaking, of_a_crowd_is_that_of_its_columns) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Scenario scene = shaking_crowd(seed);
    const Shaken expected = shaken_in(scene, 200);
    const RunMetrics m = run(scene, 200).metrics;
    EXPECT_GT(expected.turned_back, 0.0);
    EXPECT_GT(expected.hardest, 0.1);
    EXPECT_EQ(*m.turned_back, expected.turned_back / expected.moving);
    EXPECT_NEAR(*m.acceleration_rms, std::sqrt(expected.squared / expected.time), 1e-12);
  }
}

TEST(Shaking, by_clocks_of_their_own_is_that_of_own_steps) {
  for (const std::uint64_t seed : {4, 5}) {
    const Scenario scene = crowd_by_clocks(seed);
    const Shaken expected = shaken_in(scene, 500);
    const RunMetrics m = run(scene, 500).metrics;
    EXPECT_GT(expected.turned_back, 0.0);
    EXPECT_EQ(*m.turned_back, expected.turned_back / expected.moving);
    EXPECT_NEAR(*m.acceleration_rms, std::sqrt(expected.squared / expected.time), 1e-12);
  }
}

// A simulation that goes on from saved bytes is the one that was observed before.
TEST(Shaking, goes_on_where_a_saved_run_does) {
  std::vector<Scenario> scenes{shaking_crowd(6), crowd_by_clocks(6)};
  for (const std::size_t gentle : {0U, 1U}) {  // and the same at once, which turns back
    scenes.push_back(scenes[gentle]);
    scenes.back().response_time = 0.0;
  }
  for (const Scenario& scene : scenes) {
    Simulation simulation(scene, 1);
    Metrics metrics(scene);
    metrics.observe(simulation);
    for (int k = 0; k < 61; ++k) simulation.step(), metrics.observe(simulation);
    Simulation again(simulation.save(), 2);
    for (int k = 61; k < 200; ++k) again.step(), metrics.observe(again);
    if (scene.response_time == 0.0) {
      EXPECT_GT(*metrics.summary().metrics.turned_back, 0.0);
    }
    EXPECT_EQ(metrics.summary().metrics, run(scene, 200).metrics);
  }
}

}  // namespace
}  // namespace avo
