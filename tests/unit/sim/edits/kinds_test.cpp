// SPDX-License-Identifier: Apache-2.0
// Robots of thousands of sizes come, change and go: what is asked of a new one is what all robots
// together ask, although only few of them are looked at.
#include <algorithm>
#include <cstddef>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/assumptions.h"
#include "avo/error.h"
#include "avo/simulation.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::Random;

// All robots that are there, one in each place of a wide grid.
struct Crowd {
  Scenario scene;
  std::vector<RobotId> id;
  std::uint64_t places = 0;

  RobotSetup random_robot(Random& random) {
    RobotSetup robot;
    robot.position = {20.0 * static_cast<double>(places % 40),
                      20.0 * static_cast<double>(places / 40)};
    ++places;
    robot.goal = robot.position;
    resize(random, robot);
    if (random.below(4) == 0) robot.max_acceleration = 1.5;
    if (random.below(8) == 0) robot.priority = 2.0;
    return robot;
  }
  static void resize(Random& random, RobotSetup& robot) {
    robot.max_speed = 0.1 * (5 + random.below(12));
    robot.preferred_speed = random.uniform(0.2, 1.0) * robot.max_speed;
    robot.radius = 0.05 * (4 + random.below(6));
  }
  // Whether the radius of sensing is too short for the robot, which comes as the last one.
  [[nodiscard]] bool refuses(const std::vector<RobotSetup>& others, const RobotSetup& robot) const {
    Scenario all = scene;
    all.robots = others;
    const auto before = sensing_need(all);
    all.robots.push_back(robot);
    const auto need = sensing_need(all);
    return need && need->range > *scene.sensing_radius * (1.0 + 1e-9) &&
           !(before && need->range <= before->range);
  }
};

bool is_refused(const auto& edit) {
  try {
    edit();
    return false;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("has to be seen"), std::string::npos) << error.what();
    return true;
  }
}

TEST(Kinds, few_robots_ask_what_all_ask_of_one_that_comes_or_changes) {
  Random random(5);
  int refused = 0, accepted = 0;
  for (int run = 0; run < 12; ++run) {
    Crowd crowd;
    crowd.scene.sensing_radius = random.uniform(1.5, 3.0);
    crowd.scene.robots = {{.position = {-50.0, 0.0}, .goal = {-50.0, 0.0}, .max_speed = 0.5}};
    crowd.scene.robots[0].preferred_speed = 0.5;
    Simulation simulation(crowd.scene, 1);
    std::vector<RobotSetup>& robots = crowd.scene.robots;
    crowd.id = {{0}};
    for (int k = 0; k < 120; ++k) {
      const auto one = static_cast<std::size_t>(random.below(static_cast<int>(robots.size())));
      const int choice = random.below(4);
      if (choice == 0 && robots.size() > 1) {
        simulation.remove_robot(crowd.id[one]);
        robots.erase(robots.begin() + static_cast<std::ptrdiff_t>(one));
        crowd.id.erase(crowd.id.begin() + static_cast<std::ptrdiff_t>(one));
        continue;
      }
      const bool changes = choice == 1;
      RobotSetup robot = changes ? robots[one] : crowd.random_robot(random);
      std::vector<RobotSetup> others = robots;
      if (changes) {
        Crowd::resize(random, robot);
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(one));
      }
      const bool expected = crowd.refuses(others, robot);
      const bool found = is_refused([&] {
        if (changes)
          simulation.change_robot(crowd.id[one], robot);
        else
          crowd.id.push_back(simulation.add_robot(robot));
      });
      ASSERT_EQ(found, expected) << run << " " << k;
      ++(found ? refused : accepted);
      if (found) continue;
      if (changes)
        robots[one] = robot;
      else
        robots.push_back(robot);
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(accepted, 300);
}

TEST(Kinds, radius_of_sensing_is_that_of_all_robots) {
  Random random(7);
  Crowd crowd;
  crowd.scene.robots = {crowd.random_robot(random)};
  Simulation simulation(crowd.scene, 1);
  for (int k = 0; k < 200; ++k) {
    const RobotSetup robot = crowd.random_robot(random);
    simulation.add_robot(robot);
    crowd.scene.robots.push_back(robot);
    ASSERT_EQ(simulation.sensing_radius(), needed_sensing_radius(crowd.scene)) << k;
  }
}

// A robot that is as fast as another one, and smaller, may still be too small beside walls.
TEST(Kinds, one_that_is_too_small_for_walls_is_refused_among_larger_ones) {
  Scenario scene;
  scene.obstacles = {{.chains = {Chain{{{-90.0, -9.0}, {90.0, -9.0}}, false}}}};
  scene.robots = {{.position = {0.0, 0.0}, .radius = 0.5}, {.position = {9.0, 0.0}, .radius = 0.5}};
  Simulation simulation(scene, 1);
  RobotSetup robot{.position = {20.0, 0.0}, .goal = {20.0, 0.0}, .radius = 0.5};
  simulation.add_robot(robot);
  robot.position.x = robot.goal.x = 30.0, robot.radius = 0.002;
  EXPECT_THROW(simulation.add_robot(robot), Error);
  robot.radius = 0.003;
  EXPECT_NO_THROW(simulation.add_robot(robot));
}

}  // namespace
}  // namespace avo
