// SPDX-License-Identifier: Apache-2.0
// Trajectories of moving obstacles, methods of robots and people on a circle, as scenes say them.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo_io/errors.h"
#include "avo_io/scene.h"
#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using avo::Scenario;
using avo::TimedPlace;

const std::string kRobot = "version: 1\nrobots: [{position: [0, 0], goal: [9, 0]}]\n";

Scenario scene_in(const std::string& text) {
  return avo_io::parse_scenario(text, path_of("scene.yaml"));
}

std::string refusal_of(const std::string& text) {
  try {
    scene_in(text);
  } catch (const avo::Error& error) {
    const std::string what = error.what();
    return what.substr(what.find("scene.yaml") + 11);
  }
  return "";
}

std::string mover(const std::string& keys) {
  return kRobot + "moving_obstacles:\n  - {" + keys + "}\n";
}

const std::vector<TimedPlace> kPlaces{{0.5, {1, 2}}, {2, {3, 2}}};

TEST(Trajectories, stand_in_scenes_and_in_files_beside_them) {
  const Scenario listed = scene_in(mover("trajectory: [[0.5, 1, 2], [2, 3, 2]], radius: 0.3"));
  EXPECT_EQ(listed.moving_obstacles[0].trajectory, kPlaces);
  EXPECT_EQ(listed.moving_obstacles[0].position, (avo::Vec2{1, 2}));
  for (const char* text :
       {"0.5,1,2\n2,3,2\n", "time,x,y\r\n0.5, 1 ,2\r\n\r\n2,3,2", "5e-1,1,2\n2,3,2"}) {
    write_file(path_of("walk.csv"), text);
    EXPECT_EQ(scene_in(mover("trajectory_file: walk.csv")).moving_obstacles[0].trajectory, kPlaces)
        << text;
  }
}

TEST(Trajectories, that_are_wrong_are_refused_where_they_stand) {
  EXPECT_EQ(refusal_of(mover("radius: 0.3")),
            "4:5: moving_obstacles.0: found no \"position\", must be given: where it starts, or a "
            "trajectory");
  EXPECT_EQ(
      refusal_of(mover("trajectory: []")),
      "4:18: moving_obstacles.0.trajectory: found an empty list, must have at least one place");
  EXPECT_EQ(
      refusal_of(mover("trajectory: [[1, 2]]")),
      "4:19: moving_obstacles.0.trajectory.0: found a list of 2, must be [time, x, y] in s and "
      "m");
  EXPECT_EQ(refusal_of(mover("trajectory: [[1, 2, 3], [1, 2, 3]]")),
            "4:18: moving_obstacles.0.trajectory: found 1 s after 1 s, must be ascending times");
  EXPECT_EQ(
      refusal_of(mover("position: [1, 2], trajectory: [[0, 1, 2]]")),
      "4:16: moving_obstacles.0.position: found a list, must be left out beside a trajectory");
  EXPECT_EQ(
      refusal_of(mover("trajectory: [[0, 1, 2]], trajectory_file: walk.csv")),
      "4:48: moving_obstacles.0.trajectory_file: found one beside a trajectory, must be one of "
      "them");
  const auto in_file = [](const std::string& text) {
    write_file(path_of("walk.csv"), text);
    try {
      scene_in(mover("trajectory_file: walk.csv"));
    } catch (const avo::Error& error) {
      const std::string what = error.what();
      return what.substr(what.find("walk.csv"));
    }
    return std::string();
  };
  EXPECT_EQ(in_file("time,x,y\n1,2\n"), "walk.csv:2:1: found 2 fields, must be 3: time, x, y");
  EXPECT_EQ(in_file("time,x,y\n1,2,a\n"),
            "walk.csv:2:5: found \"a\", must be a number (m) of at most 1e+12");
  EXPECT_EQ(in_file("1,2,3\n0.5,2,3\n"),
            "walk.csv:2:1: found the time 0.5 s behind 1 s, must be later");
  EXPECT_EQ(in_file("time,x,y\n"), "walk.csv:2:1: found no place, must have at least one");
}

TEST(Trajectories, are_kept_by_recordings_and_judged) {
  write_file(path_of("walk.csv"), "0,4,3\n8,4,-3\n");
  write_file(path_of("scene.yaml"), mover("trajectory_file: walk.csv, radius: 0.3"));
  for (const std::string& name : {path_of("run.csv"), path_of("run.h5")}) {
    EXPECT_EQ(run_avo({"run", path_of("scene.yaml"), "--record", name, "-q"}).exit_code, 0);
    const auto checked = name.ends_with(".h5")
                             ? run_avo({"check", name})
                             : run_avo({"check", name, "--scene", path_of("scene.yaml")});
    EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
  }
}

TEST(OwnMethods, stand_at_robots_and_at_groups) {
  const Scenario scene = scene_in(
      "version: 1\nrobots:\n  - {position: [20, 0], goal: [30, 0], method: orca, time_horizon: 5}\n"
      "groups:\n  - {number: 3, method: orca_clamped, placement: {circle: {min_radius: 5}}, goals: "
      "antipodal}\n");
  EXPECT_EQ(scene.robots[0].method, avo::Method::orca);
  EXPECT_EQ(scene.robots[0].time_horizon, 5.0);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_EQ(scene.robots[k].method, avo::Method::orca_clamped);
  EXPECT_EQ(refusal_of("version: 1\nrobots: [{position: [0, 0], goal: [9, 0], method: ocra}]\n"),
            "2:51: robots.0.method: found \"ocra\", did you mean \"orca\"? Must be one of avo, "
            "avo_paper, velocity_obstacle, orca, orca_clamped, reciprocal_velocity_obstacle, "
            "buffered_voronoi, external, external_clamped");
}

TEST(Ring, places_by_chance_on_a_circle_clear_of_starts_and_goals) {
  const auto with = [](const std::string& ring, int number) {
    return fmt::format(
        "version: 1\nseed: 7\nrobots: [{{position: [0, -4], goal: [0, 4], radius: 0.3}}]\ngroups:\n"
        "  - {{number: {}, radius: 0.3, placement: {{ring: {{{}}}}}, goals: antipodal}}\n",
        number, ring);
  };
  const Scenario scene = scene_in(with("radius: 4, noise: 0.5, clearance: 0.2", 9));
  ASSERT_EQ(scene.robots.size(), 10U);
  for (std::size_t i = 1; i < 10; ++i) {
    const avo::RobotSetup& robot = scene.robots[i];
    EXPECT_EQ(robot.goal, (avo::Vec2{} - robot.position));
    EXPECT_GT(norm(robot.position), 3.2);
    EXPECT_LT(norm(robot.position), 4.8);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(norm(robot.position - scene.robots[j].position), 0.8);
      EXPECT_GE(norm(robot.position - scene.robots[j].goal), 0.8);
    }
  }
  EXPECT_EQ(refusal_of(with("radius: 1", 40)),
            "5:5: groups.0.placement: found room for 4 of 40, must have room for all: enlarge the "
            "circle");
}

}  // namespace
}  // namespace avo_test
