// SPDX-License-Identifier: Apache-2.0
// A robot that no other robot hinders arrives in bounded time, beside any number of parked robots
// (docs/arrival.md, "What is proved"). The tests search for scenes in which this is wrong.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "avo/simulation.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::Random;

constexpr double kApart = 1000.0;  // m, of robots that move; more than they sense

// m/s², what is used of the limits: a robot reaches its speed in five steps at the earliest.
double used(double limit, const RobotSetup& robot, double time_step) {
  return std::min(limit, robot.max_speed / (5.0 * time_step));
}

double braking_of(const RobotSetup& robot, double time_step) {
  const double limit = robot.max_braking.value_or(robot.max_acceleration);
  return used(std::min(limit, robot.max_acceleration), robot, time_step);
}

// [T_e] s
double response_time(const RobotSetup& robot, double time_step) {
  return std::max(0.1 * robot.max_speed / robot.max_acceleration, 2.0 * time_step);
}

// The straight line of a robot keeps [M] m from a parked robot's disc, beyond the robot's own
// radius.
double margin(const RobotSetup& robot, double parked_radius, double time_step) {
  const double b = braking_of(robot, time_step), s = robot.preferred_speed;
  const double stopping = s * s / (2.0 * b), contact = robot.radius + parked_radius;
  const double turning =
      2.0 * stopping > contact
          ? stopping + contact - 1.5 * std::cbrt(2.0 * stopping * contact * contact)
          : 0.0;
  // by which it may be ahead of its wish while its acceleration changes
  const double ahead = s * response_time(robot, time_step);
  return std::max(turning + s * time_step + b * time_step * time_step / 8.0 + ahead,
                  0.05 + 0.05 * robot.radius);
}

// s, when it rests at its goal.
double latest_rest(const RobotSetup& robot, double time_step) {
  const double s = robot.preferred_speed, way = norm(robot.goal - robot.position);
  const double a = used(robot.max_acceleration, robot, time_step), b = braking_of(robot, time_step);
  const double response = response_time(robot, time_step);
  const double lead = 0.5 * (response + time_step);
  const double gently = 2.0 * response + lead * std::log(1.0 + 3.0 * s / (b * lead));
  return way / s + s / (2.0 * a) + s / (2.0 * b) + 4.0 * time_step + gently;
}

RobotSetup on_its_way(Random& random, Vec2 around, double time_step) {
  RobotSetup robot;
  robot.position = around + random.uniform(0.0, 50.0) * random.direction();
  const double way =
      random.below(4) == 0 ? random.log_uniform(1e-6, 1.0) : random.uniform(0.5, 40.0);
  robot.goal = robot.position + way * random.direction();
  robot.radius = random.uniform(0.2, 1.0);
  // a step may bend the course of a robot by its radius
  const double strongest = std::min(3.0, 3.9 * robot.radius / (time_step * time_step));
  robot.max_acceleration = random.uniform(0.1 * strongest, strongest);
  if (random.below(2) == 0)
    robot.max_braking = std::min(random.log_uniform(0.5, 3.0) * robot.max_acceleration, strongest);
  robot.max_speed = random.uniform(0.5, 3.0);
  robot.preferred_speed = random.uniform(0.3, 1.0) * robot.max_speed;
  return robot;
}

// The parked robot is as near to the straight line as `part` of the margin allows. The parked robot
// is beside the line, or before or behind it.
RobotSetup parked_beside(const RobotSetup& robot, Random& random, double time_step, double part) {
  RobotSetup parked;
  parked.behavior = Behavior::parked;
  parked.radius = random.log_uniform(0.05, 3.0);
  const Vec2 way = robot.goal - robot.position, along = way / norm(way);
  const double at = random.uniform(-0.2, 1.2), quarter = 0.5 * std::numbers::pi;
  const double angle = at < 0.0 || at > 1.0 ? random.uniform(0.0, quarter) : quarter;
  const Vec2 ahead = at < 0.5 ? -1.0 * along : along;
  const Vec2 aside = random.below(2) == 0 ? perpendicular(along) : -1.0 * perpendicular(along);
  const double distance =
      robot.radius + parked.radius + part * margin(robot, parked.radius, time_step) + 1e-9;
  parked.position = robot.position + std::clamp(at, 0.0, 1.0) * way +
                    distance * (std::cos(angle) * ahead + std::sin(angle) * aside);
  parked.goal = parked.position;
  return parked;
}

struct Found {
  int hindered = 0, late = 0;  // robots
};

// Each robot alone, and all of them, each beside 30 parked ones.
Found search(std::uint64_t seed, double part) {
  Random random(seed);
  Scenario scene{.allow_broken_assumptions = true};  // parked ones may overlap
  scene.time_step = random.uniform(0.02, 0.4);
  scene.sensing_radius = 100.0;
  const std::size_t movers = 1 + seed % 3;
  std::vector<Simulation> alone;
  for (std::size_t k = 0; k < movers; ++k) {
    const Vec2 around{kApart * static_cast<double>(k), 0.0};
    scene.robots.push_back(on_its_way(random, around, scene.time_step));
    Scenario one = scene;
    one.robots = {scene.robots[k]};
    alone.emplace_back(one);
  }
  for (std::size_t k = 0; k < movers; ++k) {
    for (int n = 0; n < 30; ++n)
      scene.robots.push_back(parked_beside(scene.robots[k], random, scene.time_step, part));
  }
  Simulation among(scene);
  std::vector<char> hindered(movers), late(movers);
  double last = 0.0;
  for (std::size_t k = 0; k < movers; ++k)
    last = std::max(last, latest_rest(scene.robots[k], scene.time_step));
  while (among.time() < last + 20.0 * scene.time_step) {
    among.step();
    for (std::size_t k = 0; k < movers; ++k) {
      alone[k].step();
      const Vec2 p = among.fleet().position[k], v = among.fleet().velocity[k];
      if (alone[k].fleet().position[0] != p || alone[k].fleet().velocity[0] != v) hindered[k] = 1;
      if (among.time() < latest_rest(scene.robots[k], scene.time_step)) continue;
      if (v != Vec2{} || norm(p - scene.robots[k].goal) > 1e-10) late[k] = 1;
    }
  }
  return {static_cast<int>(std::count(hindered.begin(), hindered.end(), 1)),
          static_cast<int>(std::count(late.begin(), late.end(), 1))};
}

TEST(Unhindered, robots_beside_any_number_of_parked_ones_move_as_if_alone_and_rest_in_time) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Found found = search(seed, 1.0);
    EXPECT_EQ(found.hindered, 0) << "seed " << seed;
    EXPECT_EQ(found.late, 0) << "seed " << seed;
  }
}

// A course through the middle between two parked robots is as long as the straight line, but for
// rounding.
TEST(Unhindered, between_two_as_far_aside_a_robot_heads_for_its_very_goal) {
  int hindered = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    Scenario scene;
    scene.robots = {on_its_way(random, {}, scene.time_step)};
    scene.robots[0].preferred_speed = 0.1;  // for a narrow gap
    Simulation alone(scene);
    const RobotSetup robot = scene.robots[0];
    RobotSetup parked = robot;
    parked.behavior = Behavior::parked, parked.max_braking = {};
    const Vec2 way = robot.goal - robot.position, aside = perpendicular(way / norm(way));
    const Vec2 middle = robot.position + random.uniform(0.2, 0.8) * way;
    for (const double side : {-1.0, 1.0}) {
      parked.radius = random.uniform(0.5, 2.0) * robot.radius;
      const double distance =
          robot.radius + parked.radius + 0.051 + 0.05 * robot.radius + random.uniform(0.0, 1e-9);
      parked.position = parked.goal = middle + side * distance * aside;
      scene.robots.push_back(parked);
    }
    Simulation among(scene);
    bool same = true;
    while (among.time() < latest_rest(robot, scene.time_step)) {
      alone.step(), among.step();
      same = same && alone.fleet().position[0] == among.fleet().position[0];
    }
    hindered += same ? 0 : 1;
  }
  EXPECT_EQ(hindered, 0);
}

// The search has teeth: with less room it finds robots that are turned off their straight lines.
TEST(Unhindered, with_a_fifth_of_the_margin_many_are_not) {
  int hindered = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) hindered += search(seed, 0.2).hindered;
  EXPECT_GE(hindered, 10);
}

}  // namespace
}  // namespace avo
