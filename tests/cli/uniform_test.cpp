// SPDX-License-Identifier: Apache-2.0
// Built-in uniform-N: robots anywhere in a square of one density, for every N.
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <string>

#include "avo_io/scene.h"

namespace avo_test {
namespace {

using avo::Scenario;
using avo::Vec2;

double farthest(const Scenario& scenario, Vec2 avo::RobotSetup::*point) {
  double result = 0.0;
  for (const avo::RobotSetup& robot : scenario.robots)
    result = std::fmax(result, std::fmax(std::fabs((robot.*point).x), std::fabs((robot.*point).y)));
  return result;
}

double nearest_two(const Scenario& scenario, Vec2 avo::RobotSetup::*point) {
  double result = 1e9;
  for (std::size_t i = 0; i < scenario.robots.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      result = std::fmin(result, norm(scenario.robots[i].*point - scenario.robots[j].*point));
  return result;
}

// 10 robots in pi (15 m)^2, in a square around the origin.
TEST(Uniform, has_its_density_and_the_constants_of_its_kind) {
  for (const int n : {2, 1000, 4000}) {
    const Scenario scenario = avo_io::load_scenario("uniform-" + std::to_string(n));
    EXPECT_EQ(scenario.name, "uniform-" + std::to_string(n));
    ASSERT_EQ(scenario.robots.size(), static_cast<std::size_t>(n));
    const double half = 0.5 * std::sqrt(n * std::acos(-1.0) * 225.0 / 10.0);
    for (const auto point : {&avo::RobotSetup::position, &avo::RobotSetup::goal}) {
      EXPECT_LE(farthest(scenario, point), half * (1.0 + 1e-15));
      EXPECT_GT(farthest(scenario, point), (n > 2 ? 0.99 : 0.1) * half);
      EXPECT_GE(nearest_two(scenario, point), 1.0);
    }
    EXPECT_EQ(scenario.method, avo::Method::avo);
    EXPECT_EQ(scenario.sensing_radius, 15.0);
    EXPECT_EQ(scenario.max_neighbors, 10);
    for (const avo::RobotSetup& robot : scenario.robots) {
      EXPECT_EQ(robot.velocity, Vec2{});
      EXPECT_EQ(robot.radius, 0.5);
      EXPECT_EQ(robot.preferred_speed, 1.5);
      EXPECT_EQ(robot.max_speed, 2.0);
      EXPECT_EQ(robot.max_acceleration, 1.0);
    }
  }
}

TEST(Uniform, is_even) {
  const Scenario scenario = avo_io::load_scenario("uniform-10000");
  int starts[4] = {}, goals[4] = {};
  for (const avo::RobotSetup& robot : scenario.robots) {
    ++starts[2 * (robot.position.x > 0.0) + (robot.position.y > 0.0)];
    ++goals[2 * (robot.goal.x > 0.0) + (robot.goal.y > 0.0)];
  }
  for (const int count : starts) EXPECT_NEAR(count, 2500, 250);
  for (const int count : goals) EXPECT_NEAR(count, 2500, 250);
}

TEST(Uniform, is_by_seed_alone) {
  const Scenario one = avo_io::load_scenario("uniform-50");
  const Scenario again = avo_io::load_scenario("uniform-50", {"seed=1"});
  const Scenario other = avo_io::load_scenario("uniform-50", {"seed=2"});
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_EQ(one.robots[i].position, again.robots[i].position);
    EXPECT_EQ(one.robots[i].goal, again.robots[i].goal);
    EXPECT_FALSE(one.robots[i].position == other.robots[i].position);
  }
}

TEST(Uniform, scene_is_the_embedded_file_at_its_number) {
  const Scenario by_name = avo_io::load_scenario("uniform-1000");
  std::string text;
  for (const avo_io::BuiltinScene& scene : avo_io::builtin_scenes())
    if (scene.name == "uniform-N") text = scene.yaml;
  const Scenario by_file = avo_io::parse_scenario(text, "f");
  EXPECT_EQ(by_file.name, by_name.name);
  EXPECT_EQ(by_file.robots[999].position, by_name.robots[999].position);
  EXPECT_EQ(by_file.robots[999].goal, by_name.robots[999].goal);
}

TEST(Uniform, needs_two_robots_to_a_million) {
  for (const char* name :
       {"uniform-0", "uniform-1", "uniform-1000001", "uniform-99999999999999999"})
    EXPECT_THROW(avo_io::load_scenario(name), avo_io::OverrideError) << name;
  for (const char* name : {"uniform-", "uniform-x", "uniform-010", "uniform--5", "uniform-1e3"})
    EXPECT_THROW(avo_io::load_scenario(name), avo_io::FileError) << name;
}

}  // namespace
}  // namespace avo_test
