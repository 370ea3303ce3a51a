// SPDX-License-Identifier: Apache-2.0
// --set key=value: on every key of the scene, checked like the file, blamed like the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo_io/scene.h"
#include "run_avo.h"
#include "support/bad_scenes.h"

namespace avo_test {
namespace {

using avo::Scenario;
using testing::HasSubstr;

Scenario load(const std::string& scene, const std::vector<std::string>& overrides) {
  return avo_io::load_scenario(scene, overrides);
}

std::string refusal(const std::vector<std::string>& overrides,
                    const std::string& scene = "positions-exchange") {
  try {
    load(scene, overrides);
  } catch (const avo_io::OverrideError& error) {
    return error.what();
  }
  return "";
}

TEST(Set, changes_what_the_file_says) {
  const Scenario scenario =
      load("positions-exchange", {"time_step=0.05", "robots.0.radius=0.4", "robots.1.goal=[1, 2]",
                                  "robots.1.goal.1=3", "method=orca", "max_neighbors=3"});
  EXPECT_EQ(scenario.time_step, 0.05);
  EXPECT_EQ(scenario.robots[0].radius, 0.4);
  EXPECT_EQ(scenario.robots[1].radius, 0.5);
  EXPECT_EQ(scenario.robots[1].goal, (avo::Vec2{1, 3}));
  EXPECT_EQ(scenario.method, avo::Method::orca);
  EXPECT_EQ(scenario.max_neighbors, 3);
}

TEST(Set, refuses_what_was_removed_by_name) {
  EXPECT_EQ(refusal({"precision=double"}),
            "--set precision=double: found the removed key \"precision\", must be left out: "
            "everything is computed in double precision");
  EXPECT_EQ(
      refusal({"samples=25"}),
      "--set samples=25: found the removed key \"samples\", must be left out: all half-planes "
      "are exact");
  EXPECT_EQ(
      refusal({"certificate=stopping_capsules"}),
      "--set certificate=stopping_capsules: certificate: found \"stopping_capsules\", must be "
      "braking_trajectories: stopping_capsules was removed");
  EXPECT_EQ(
      refusal({"right_of_way=told"}),
      "--set right_of_way=told: right_of_way: found \"told\", must be seen: told was removed");
}

TEST(Set, changes_how_gently_robots_move) {
  const Scenario scenario = load(
      "circle-2", {"response_time=0", "comfort_acceleration=0.5", "comfort_jerk=2", "margin=0.1"});
  EXPECT_EQ(scenario.response_time, 0.0);
  EXPECT_EQ(scenario.comfort_acceleration, 0.5);
  EXPECT_EQ(scenario.comfort_jerk, 2.0);
  EXPECT_EQ(scenario.margin, 0.1);
  EXPECT_THAT(refusal({"comfort_jerks=1"}), HasSubstr(", did you mean \"comfort_jerk\"? Allowed"));
}

TEST(Set, adds_what_the_file_leaves_out) {
  const Scenario scenario =
      load("positions-exchange", {"arrival_distance=0.125", "robots.0.car.wheelbase=0.75",
                                  "moving_obstacles=[{position: [3, 3], velocity: [1, 0]}]",
                                  "moving_obstacles.0.radius=0.25"});
  EXPECT_EQ(scenario.arrival_distance, 0.125);
  ASSERT_FALSE(is_holonomic(scenario.robots[0].model));
  EXPECT_EQ(std::get<avo::Car>(scenario.robots[0].model).wheelbase, 0.75);
  ASSERT_EQ(scenario.moving_obstacles.size(), 1U);
  EXPECT_EQ(scenario.moving_obstacles[0].radius, 0.25);
}

TEST(Set, reaches_into_groups_and_the_robots_they_make) {
  const Scenario scenario =
      load("circle-10", {"groups.0.radius=0.3", "groups.0.placement.circle.min_radius=30",
                         "robots.7.radius=0.4", "robots.9.max_speed=1"});
  EXPECT_EQ(scenario.robots[0].radius, 0.3);
  EXPECT_EQ(scenario.robots[0].position, (avo::Vec2{30, 0}));
  EXPECT_EQ(scenario.robots[7].radius, 0.4);
  EXPECT_EQ(scenario.robots[9].max_speed, 1.0);
  EXPECT_EQ(scenario.robots[9].preferred_speed, 2.0);
  EXPECT_EQ(load("cars-100", {"robots.3.car.heading=0.5"}).robots[3].heading, 0.5);
}

TEST(Set, the_last_one_counts) {
  EXPECT_EQ(load("circle-10", {"seed=3", "seed=4"}).seed, 4U);
}

TEST(Set, a_longer_way_takes_more_time_where_the_file_leaves_it_open) {
  EXPECT_EQ(load("circle-10", {}).duration, 100.0);
  EXPECT_EQ(load("circle-10", {"groups.0.placement.circle.min_radius=40"}).duration, 140.0);
  EXPECT_EQ(load("circle-10", {"duration=5"}).duration, 5.0);
}

TEST(Set, is_refused_by_name) {
  EXPECT_EQ(refusal({"time_step=-1"}), "--set time_step=-1: time_step: found -1, must be > 0 s");
  EXPECT_EQ(refusal({"time_step=0.1 s"}),
            "--set time_step=0.1 s: time_step: found \"0.1 s\", must be a number (s)");
  EXPECT_EQ(refusal({"time_step="}),
            "--set time_step=: time_step: found nothing, must be a number (s)");
  EXPECT_EQ(refusal({"robots.0.radus=1"}),
            "--set robots.0.radus=1: robots.0: found the unknown key \"radus\", "
            "did you mean \"radius\"? Allowed are " +
                kRobotKeys);
  EXPECT_EQ(refusal({"robots.2.radius=1"}),
            "--set robots.2.radius=1: robots: found the number \"2\", must be 0 to 1");
  EXPECT_EQ(refusal({"robots.-1.radius=1"}),
            "--set robots.-1.radius=1: robots: found the number \"-1\", must be 0 to 1");
  EXPECT_EQ(refusal({"robots.0.goal.2=1"}),
            "--set robots.0.goal.2=1: robots.0.goal: found the number \"2\", must be 0 to 1");
  EXPECT_EQ(refusal({"time_step.x=1"}),
            "--set time_step.x=1: time_step: found 0.1, has no key \"x\"");
  EXPECT_EQ(refusal({"nonsense"}),
            "--set nonsense: found no key=value, must be such as time_step=0.1");
  EXPECT_EQ(refusal({"=1"}), "--set =1: found no key=value, must be such as time_step=0.1");
  EXPECT_EQ(refusal({"name=&a b"}),
            "--set name=&a b: found an anchor, anchors, aliases and merge keys are not allowed");
  EXPECT_EQ(refusal({"robots.0.goal=[1"}),
            "--set robots.0.goal=[1: found a list as a key or one that is not closed, keys must be "
            "words such as time_step");
  EXPECT_EQ(refusal({"control_time=4", "time_step=5", "time_horizon=10"}),
            "--set time_step=5: time_step: found 5, must be <= control_time = 4 s where motion is "
            "held");
  EXPECT_EQ(refusal({"robots.1.position=[-10, 0]"}),
            "--set robots.1.position=[-10, 0]: robots.1.position: found [-10, 0], the position of "
            "robots.0, must differ from it");
}

TEST(Set, is_refused_by_name_in_groups) {
  EXPECT_EQ(refusal({"robots.10.radius=1"}, "circle-10"),
            "--set robots.10.radius=1: found robots.10, must be robots.0 to robots.9");
  EXPECT_EQ(refusal({"robots.3.radius=0"}, "circle-10"),
            "--set robots.3.radius=0: robots.3.radius: found 0, must be > 0 m");
  EXPECT_THAT(refusal({"robots.3.raduis=1"}, "circle-10"), HasSubstr("mean \"radius\"? Allowed"));
  EXPECT_THAT(refusal({"groups.0.numbre=1"}, "circle-10"), HasSubstr("mean \"number\"? Allowed"));
  EXPECT_EQ(refusal({"groups.0.number=1e18"}, "circle-10"),
            "--set groups.0.number=1e18: groups.0.number: found 1e18, must be a whole number");
}

TEST(Set, is_a_usage_error_on_the_command_line) {
  const ProcessResult result = run_avo({"run", "circle-10", "--set", "time_stp=1"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(
      result.err.starts_with("--set time_stp=1: found the unknown key \"time_stp\", did you mean "
                             "\"time_step\"? Allowed are "
                             "version, name, "));
  EXPECT_EQ(lines_of(result.err).size(), 1U);
  EXPECT_EQ(run_avo({"run", "circle-10", "--seed", "x"}).exit_code, 2);
}

TEST(Set, comes_before_or_after_the_scene_and_keeps_brackets) {
  const ProcessResult after = run_avo({"validate", "positions-exchange", "--set", "duration=7",
                                       "--set", "robots.0.position=[-8, 1]"});
  EXPECT_EQ(after.exit_code, 0) << after.err;
  EXPECT_EQ(after.out,
            "positions-exchange: valid: 2 robots, 0 moving obstacles, 70 steps of 0.1 s\n");
  const ProcessResult before = run_avo({"validate", "--set", "duration=7", "positions-exchange"});
  EXPECT_EQ(before.out, after.out);
}

}  // namespace
}  // namespace avo_test
