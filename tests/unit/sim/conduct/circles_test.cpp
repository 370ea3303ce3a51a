// SPDX-License-Identifier: Apache-2.0
// Robots on circles: exact ones, on which all would do the same, and strong robots.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>
#include <set>
#include <vector>

#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::robot_at;

// Robots on a circle exchange their places with those opposite.
Scenario circle_of(int count, double radius) {
  Scenario scene;
  scene.sensing_radius = 15.0;
  scene.max_neighbors = 10;
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    const Vec2 place{radius * std::cos(angle), radius * std::sin(angle)};
    scene.robots.push_back(robot_at(place, -place));
  }
  return scene;
}

bool have_arrived(const Scenario& scene, const Simulation& simulation) {
  for (std::size_t k = 0; k < scene.robots.size(); ++k) {
    const Vec2 place = simulation.fleet().position[simulation.index_of(RobotId{k}).value()];
    if (norm(scene.robots[k].goal - place) > scene.arrival_distance) return false;
  }
  return true;
}

// All in one ring at once, they would stand, and turn as a roundabout: 1.05 to 1.5 times the bound.
TEST(Ties, robots_on_an_exact_circle_do_not_wait_for_each_other) {
  for (const int count : {30, 40, 50, 60}) {
    const double radius = std::max(20.0, 2.25 * count / (2.0 * std::numbers::pi));
    const Scenario scene = circle_of(count, radius);
    const RobotSetup& robot = scene.robots[0];
    const double straight = 2.0 * radius / robot.preferred_speed + robot.preferred_speed;  // a is 1
    ASSERT_EQ(robot.max_acceleration, 1.0);
    Simulation simulation(scene, 1);
    while (!have_arrived(scene, simulation) && simulation.time() < 2.0 * straight)
      simulation.step();
    EXPECT_LE(simulation.time(), 1.2 * straight) << count;
  }
}

std::vector<float> usual_after_a_step(const Scenario& scene) {
  Simulation simulation(scene, 1);
  simulation.step();
  std::vector<float> usual;
  for (std::size_t k = 0; k < scene.robots.size(); ++k)
    usual.push_back(simulation.fleet().detour[simulation.index_of(RobotId{k}).value()].congestion);
  return usual;
}

TEST(Ties, no_two_robots_on_an_exact_circle_are_used_to_the_same) {
  const std::vector<float> usual = usual_after_a_step(circle_of(100, 40.0));
  EXPECT_EQ(std::set<float>(usual.begin(), usual.end()).size(), 100U);
  const auto [least, most] = std::minmax_element(usual.begin(), usual.end());
  EXPECT_NEAR(*least, 0.0, 0.002);
  EXPECT_NEAR(*most, 0.03, 0.002);
}

// Where robots do not see the same, ids have no say.
TEST(Ties, a_millimeter_is_enough_to_be_told_apart_without_ids) {
  Scenario scene = circle_of(100, 40.0);
  for (std::size_t k = 0; k < 100; ++k) {
    const double off = 1e-3 * static_cast<double>(37 * k % 100);
    scene.robots[k].position = scene.robots[k].position + Vec2{off, 0.0};
  }
  for (const float usual : usual_after_a_step(scene)) EXPECT_LT(usual, 0.002F);
  scene = circle_of(100, 40.0);
  scene.method = Method::avo_paper;
  for (const float usual : usual_after_a_step(scene)) EXPECT_EQ(usual, 0.0F);
}

// On board, from what a robot perceives.
TEST(Ties, who_perceives_knows_of_them) {
  const Simulation before(circle_of(40, 20.0), 1);
  std::set<float> usual;
  for (std::size_t k = 0; k < 40; ++k) usual.insert(before.perceive({k}).detour.congestion);
  EXPECT_EQ(usual.size(), 40U);
}

double mean_arrival(const Scenario& scene) {
  Simulation simulation(scene, 1);
  std::vector<double> arrival(scene.robots.size(), 0.0);  // s
  while (!have_arrived(scene, simulation) && simulation.time() < 100.0) {
    simulation.step();
    for (std::size_t k = 0; k < arrival.size(); ++k) {
      const Vec2 place = simulation.fleet().position[simulation.index_of(RobotId{k}).value()];
      const bool is_there = norm(scene.robots[k].goal - place) <= scene.arrival_distance;
      if (!is_there || arrival[k] == 0.0) arrival[k] = is_there ? simulation.time() : 0.0;
    }
  }
  EXPECT_TRUE(have_arrived(scene, simulation));
  return std::accumulate(arrival.begin(), arrival.end(), 0.0) / static_cast<double>(arrival.size());
}

// They got used to traffic so soon that they did not keep right any more: 5 and 14 % later.
TEST(StrongRobots, twice_the_acceleration_makes_nobody_later) {
  Scenario scene = circle_of(100, 35.8);
  const auto with = [&](double acceleration) {
    for (RobotSetup& robot : scene.robots) robot.max_acceleration = acceleration;
    return mean_arrival(scene);
  };
  double before = with(2.5);
  for (const double acceleration : {5.0, 10.0, 20.0}) {
    const double now = with(acceleration);
    EXPECT_LE(now, 1.01 * before) << acceleration;
    before = now;
  }
}

}  // namespace
}  // namespace avo
