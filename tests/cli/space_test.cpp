// SPDX-License-Identifier: Apache-2.0
// Scenes of space on the command line: run, its outputs, check, and what is refused.
#include "avo_io/space.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>
#include <string>

#include "avo/space/simulation.h"
#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

const std::string kScene = R"(version: 1
space: 3
duration: 30
groups:
  - {count: 12, sphere: {radius: 6}, goal: antipodal, jitter: 0.1, downwash: 0.4}
robots:
  - {position: [0, -9, 1], goal: [2, 9, 1], vertical: 0.5, climb: 1, sink: 0.5}
obstacles:
  - {floor: -8}
  - {ceiling: 8}
  - {box: {min: [9, -1, -1], max: [10, 1, 1], heading: 0.3}}
  - {polyline: [[-9, 3], [-9, 5]], height: [0, 3]}
)";

std::string scene_with(const std::string& what, const std::string& instead) {
  std::string text = kScene;
  const std::size_t at = text.find(what);
  return text.replace(at, what.size(), instead);
}

std::string refused(const std::string& text, const std::string& verb = "run") {
  write_file(path_of("bad.yaml"), text);
  const ProcessResult result = run_avo({verb, path_of("bad.yaml")});
  EXPECT_NE(result.exit_code, 0);
  return result.err;
}

TEST(SpaceScenes, run_records_what_the_library_simulates_and_check_judges_it) {
  const std::string scene = path_of("drones.yaml"), csv = path_of("drones.csv");
  write_file(scene, kScene);
  const ProcessResult run = run_avo({"run", scene, "--until-arrived", "--record", csv, "--summary",
                                     path_of("s.json"), "--figure", path_of("f.svg")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("arrived            13 of 13"));
  avo::space::Simulation simulation(avo_io::parse_space_scenario(kScene, scene));
  const std::vector<std::string> lines = lines_of(read_file(csv));
  ASSERT_GT(lines.size(), 13U * 50U);
  EXPECT_EQ(lines[0], "time,robot,x,y,z,vx,vy,vz");
  for (std::size_t row = 1; row < lines.size(); ++row) {
    const std::size_t robot = (row - 1) % 13;
    if (row > 1 && robot == 0) simulation.step();
    double time = 0, x = 0, y = 0, z = 0;
    ASSERT_EQ(std::sscanf(lines[row].c_str(), "%lf,%*d,%lf,%lf,%lf", &time, &x, &y, &z), 4);
    ASSERT_EQ((avo::Vec3{x, y, z}), simulation.robots()[robot].position) << row;
    ASSERT_EQ(time, simulation.time());
  }
  const Json summary = Json::parse(read_file(path_of("s.json")));
  EXPECT_EQ(summary["arrived"], 13);
  EXPECT_EQ(summary["collision_pairs"], 0);
  EXPECT_GT(summary["metrics"]["jerk"].get<double>(), 0.0);
  EXPECT_THAT(read_file(path_of("f.svg")), HasSubstr("<svg"));
  const ProcessResult check = run_avo({"check", csv, "--scene", scene, "--require-arrival"});
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_THAT(check.out, HasSubstr("safe"));
}

TEST(SpaceScenes, goals_out_of_reach_are_named_in_one_line_each) {
  const std::string scene = path_of("closed.yaml");
  write_file(scene, R"(version: 1
space: 3
duration: 5
robots:
  - {position: [-4, 0, 0], goal: [4, 0, 0]}
  - {position: [-4, 2, 0], goal: [-0.5, 2, 0]}
obstacles:
  - {box: {min: [-0.1, -7, -7], max: [0.1, 7, 7]}}
  - {polyline: [[-6, -6], [6, -6], [6, 6], [-6, 6], [-6, -6]], height: [-6, 6]}
  - {floor: -6}
  - {ceiling: 6}
)");
  const ProcessResult told = run_avo({"validate", scene});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.err, HasSubstr("robot 0: its goal [4, 0, 0] cannot be reached by any route"));
  EXPECT_THAT(told.err, HasSubstr("robot 1: its goal [-0.5, 2, 0] is nearer to an obstacle than"));
  const ProcessResult run = run_avo({"run", scene});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("0 (to 4.6"));
}

TEST(SpaceScenes, check_finds_what_is_wrong) {
  const std::string scene = path_of("two.yaml"), csv = path_of("two.csv");
  write_file(scene,
             "version: 1\nspace: 3\nrobots:\n"
             "  - {position: [0, 0, 5], goal: [0, 0, 5], downwash: 2}\n"
             "  - {position: [-3, 0, 3], goal: [3, 0, 3]}\n");
  const auto judged = [&](const std::string& rows) {
    write_file(csv, "time,robot,x,y,z,vx,vy,vz\n" + rows);
    return run_avo({"check", csv, "--scene", scene, "--json"});
  };
  const std::string below = "0,0,0,0,5,0,0,0\n0,1,-3,0,3,1,0,0\n";
  std::string rows;  // of each step: rows that are farther apart are not judged
  for (int step = 0; step <= 60; ++step) {
    const std::string time = std::to_string(0.1 * step), x = std::to_string(0.1 * step - 3.0);
    rows += time + ",0,0,0,5,0,0,0\n" + time + ",1," + x + ",0,3,1,0,0\n";
  }
  const ProcessResult passes = judged(rows);
  EXPECT_NE(passes.exit_code, 0);
  EXPECT_EQ(Json::parse(passes.out)["overlaps"]["count"], 1) << passes.out;
  const ProcessResult fast = judged(below + "0.1,0,0,0,5,0,0,0\n0.1,1,-2.7,0,3,5,0,0\n");
  EXPECT_GE(Json::parse(fast.out)["accelerations"]["count"], 1) << fast.out;
  const ProcessResult torn = judged(below + "1,0,0,0\n");
  EXPECT_THAT(torn.err, HasSubstr("two.csv:4: found 4 columns, must be 8"));
}

TEST(SpaceScenes, set_changes_robots_of_groups_as_well) {
  const std::string scene = path_of("drones.yaml");
  write_file(scene, kScene);
  const avo::space::Scenario changed =
      *avo_io::load_space_scenario(scene, {"robots.5.radius=0.25", "groups.0.downwash=0"});
  EXPECT_EQ(changed.robots[5].radius, 0.25);
  EXPECT_EQ(changed.robots[6].radius, 0.5);
  EXPECT_EQ(changed.robots[5].downwash, 0.0);
}

TEST(SpaceScenes, walls_of_the_plane_stand_between_heights) {
  const avo::space::Scenario scene = avo_io::parse_space_scenario(kScene, "drones.yaml");
  ASSERT_EQ(scene.boxes.size(), 4U);
  EXPECT_EQ(scene.boxes[3].min.z, 0.0);
  EXPECT_EQ(scene.boxes[3].max.z, 3.0);
  const avo::space::Scenario all =
      avo_io::parse_space_scenario(scene_with(", height: [0, 3]}", "}"), "drones.yaml");
  EXPECT_EQ(all.boxes[3].max.z, avo::space::Box::kFar);
}

TEST(SpaceScenes, bad_scenes_are_refused_by_place_and_allowed_values) {
  EXPECT_THAT(refused(scene_with("[0, -9, 1]", "[0, -9]")),
              HasSubstr("robots.0.position: found a list of 2, must be [x, y, z] in m"));
  EXPECT_THAT(refused(scene_with("space: 3", "space: 4")),
              HasSubstr("bad.yaml:2:8: space: found 4, must be 2 or 3"));
  EXPECT_THAT(refused(scene_with("climb", "clim")), HasSubstr("did you mean \"climb\"?"));
  EXPECT_THAT(
      refused(scene_with("goal: antipodal", "goal: antipode")),
      HasSubstr("groups.0.goal: found \"antipode\", did you mean \"antipodal\"? Must be one of "
                "antipodal, permuted"));
  EXPECT_THAT(refused(scene_with("sphere: {radius: 6}, ", "")),
              HasSubstr("must have one of sphere, box, grid"));
  EXPECT_THAT(refused(scene_with("vertical: 0.5", "vertical: 0")), HasSubstr("must be > 0"));
  EXPECT_THAT(refused(scene_with("floor: -8", "floor: 2")), HasSubstr("robots.0 and obstacles.0"));
  EXPECT_THAT(refused(scene_with("radius: 6", "radius: 0.5")), HasSubstr("less than contact"));
  EXPECT_THAT(refused(scene_with("vertical: 0.5,", "velocity: [19, 0, 0],")),
              HasSubstr("found 19 m/s at the start, must be <= its max_speed, 2 m/s"));
  EXPECT_THAT(refused(scene_with("duration: 30", "duration: 0.01")), HasSubstr("duration"));
  write_file(path_of("bad.yaml"), kScene);
  try {
    avo_io::load_scenario(path_of("bad.yaml"));
    ADD_FAILURE();
  } catch (const avo_io::SceneError& error) {
    EXPECT_THAT(error.what(), HasSubstr("bad.yaml:2:8: space: found 3, must be 2 here"));
  }
}

TEST(SpaceScenes, obstacles_are_named_by_their_numbers_in_the_file) {
  const std::string text =
      "version: 1\nspace: 3\nrobots:\n  - {position: [0, 0, 0.5], goal: [5, 0, 1]}\nobstacles:\n"
      "  - {polygon: [[20, 0], [22, 0], [22, 2]]}\n  - {floor: 0}\n";
  EXPECT_THAT(refused(text), HasSubstr("robots.0 and obstacles.1: braking at the start leaves"));
}

TEST(SpaceScenes, recordings_with_missing_rows_are_not_called_safe) {
  const std::string scene = path_of("one.yaml"), csv = path_of("one.csv");
  write_file(scene, "version: 1\nspace: 3\nrobots:\n  - {position: [0, 0, 0], goal: [9, 0, 0]}\n");
  write_file(csv, "time,robot,x,y,z,vx,vy,vz\n0,0,0,0,0,0,0,0\n9,0,9,0,0,0,0,0\n");
  EXPECT_EQ(run_avo({"check", csv, "--scene", scene}).exit_code, 7);
}

TEST(SpaceScenes, sweeps_have_the_results_of_single_runs) {
  write_file(path_of("drones.yaml"), kScene);
  write_file(path_of("sweep.yaml"),
             "version: 1\nscenes: [drones.yaml]\nmethods: [avo]\nuntil_arrived: true\n"
             "parameters: {groups.0.radius: [0.3, 0.5]}\nseeds: {count: 2}\n");
  const std::string table = path_of("table.csv");
  const ProcessResult sweep = run_avo({"sweep", path_of("sweep.yaml"), "--out", table});
  ASSERT_EQ(sweep.exit_code, 0) << sweep.err;
  const std::vector<std::string> lines = lines_of(read_file(table));
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_THAT(lines[4], HasSubstr(",3,drones.yaml,avo,0.5,2,0x"));
  ASSERT_EQ(run_avo({"run", path_of("drones.yaml"), "--until-arrived", "--set",
                     "groups.0.radius=0.5", "--set", "seed=2", "--summary", path_of("s.json")})
                .exit_code,
            0);
  const Json run = Json::parse(read_file(path_of("s.json")));
  const auto value_of = [&](const std::string& column) {
    const auto fields = [](const std::string& line) {
      std::vector<std::string> all;
      std::stringstream stream(line);
      for (std::string field; std::getline(stream, field, ',');) all.push_back(field);
      return all;
    };
    const std::vector<std::string> names = fields(lines[0]);
    const auto at = std::find(names.begin(), names.end(), column) - names.begin();
    return fields(lines[4])[static_cast<std::size_t>(at)];
  };
  EXPECT_EQ(value_of("arrived"), "13");
  EXPECT_EQ(std::stod(value_of("last_arrival")), run["last_arrival"].get<double>());
  EXPECT_EQ(std::stod(value_of("arrival_100")), run["last_arrival"].get<double>());
  EXPECT_EQ(std::stod(value_of("jerk")), run["metrics"]["jerk"].get<double>());
  const ProcessResult compared = run_avo({"compare", table, "--arrival", path_of("a.svg")});
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
  write_file(path_of("sweep.yaml"), "version: 1\nscenes: [drones.yaml]\nmethods: [orca]\n");
  EXPECT_THAT(run_avo({"sweep", path_of("sweep.yaml"), "--out", table}).err,
              HasSubstr("drones.yaml orca: "));
}

Json explained(const std::string& scene, const std::vector<std::string>& more) {
  write_file(path_of("scene.yaml"), scene);
  std::vector<std::string> words{"explain", path_of("scene.yaml"), "--json"};
  words.insert(words.end(), more.begin(), more.end());
  const ProcessResult result = run_avo(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Json::parse(result.out, nullptr, false);
}

avo::Vec3 point(const Json& json) {
  return {json.at(0), json.at(1), json.at(2)};
}

TEST(SpaceScenes, explain_tells_the_decision_that_the_next_step_takes) {
  const Json json = explained(kScene, {"--robot", "3", "--time", "2.05"});
  avo::space::Simulation simulation(avo_io::parse_space_scenario(kScene, "drones.yaml"), 1);
  for (int k = 0; k < 20; ++k) simulation.step();
  EXPECT_EQ(json["time"], simulation.time()) << "the last step until then";
  EXPECT_EQ(point(json["position"]), simulation.robots()[3].position);
  EXPECT_EQ(point(json["goal"]), simulation.goal({3}));
  simulation.step();
  const avo::space::Plan& plan = simulation.plans()[3];
  EXPECT_EQ(point(json["new_velocity"]), plan.new_velocity);
  EXPECT_EQ(point(json["next_velocity"]), plan.next_velocity);
  EXPECT_EQ(json["status"], avo::to_string(plan.status));
  EXPECT_EQ(json["violation"], plan.violation);
  EXPECT_EQ(json["neighbors"].size(), 12U);
}

// Two drones that meet: the change of velocity is along the normal of the half-space.
TEST(SpaceScenes, explained_half_spaces_are_those_that_bind) {
  const std::string scene =
      "version: 1\nspace: 3\nresponse_time: 0\nrobots:\n"
      "  - {position: [0, 0, 0], velocity: [1.5, 0, 0], goal: [20, 0, 0], preferred_speed: 1.5}\n"
      "  - {position: [7, 0.3, 0.4], velocity: [-1.5, 0, 0], goal: [-20, 0.3, 0.4]}\n";
  const Json json = explained(scene, {"--robot", "0"});
  ASSERT_EQ(json["half_spaces"].size(), 1U);
  const Json& plane = json["half_spaces"][0];
  const avo::Vec3 normal = point(plane["normal"]);
  EXPECT_NEAR(norm(normal), 1.0, 1e-12);
  ASSERT_EQ(json["status"], "optimal");
  const avo::Vec3 change = point(json["next_velocity"]) - point(json["velocity"]);
  EXPECT_NEAR(dot(normal, change), norm(change), 1e-9);
  EXPECT_LT(dot(normal, point(json["preferred_velocity"])), plane["offset"].get<double>() - 1e-3);
  EXPECT_EQ(json["trace"]["binding"], Json::array({1}));
  EXPECT_THAT(json["sentence"], HasSubstr("the half-space of robot 1 binds"));
}

TEST(SpaceScenes, explain_names_the_obstacle_for_which_a_robot_brakes) {
  const std::string scene =
      "version: 1\nspace: 3\nduration: 20\nnavigation: false\nrobots:\n"
      "  - {position: [0, 0, 5], goal: [0, 0, -5]}\n"
      "obstacles:\n  - {ceiling: 30}\n  - {floor: 0}\n";
  const Json json = explained(scene, {"--robot", "0", "--time", "2.8"});
  const std::string text = json.dump();
  EXPECT_THAT(text, HasSubstr("obstacles.1"));
  EXPECT_EQ(json["state"], "safe");
  write_file(path_of("scene.yaml"), scene);
  const ProcessResult read = run_avo({"explain", path_of("scene.yaml"), "--robot", "0"});
  EXPECT_THAT(read.out, HasSubstr("in words            Robot 0 starts: "));
  const ProcessResult missing = run_avo({"explain", path_of("scene.yaml"), "--robot", "1"});
  EXPECT_THAT(missing.err, HasSubstr("--robot: found 1, must be 0 to 0"));
  const ProcessResult figure =
      run_avo({"explain", path_of("scene.yaml"), "--robot", "0", "--figure", path_of("f.svg")});
  EXPECT_THAT(figure.err, HasSubstr("--figure, --states: found one of them with a scene of space"));
}

TEST(SpaceScenes, bench_measures_their_steps) {
  write_file(path_of("drones.yaml"), kScene);
  const ProcessResult bench =
      run_avo({"bench", path_of("drones.yaml"), "--steps", "5", "--threads", "1", "--json"});
  ASSERT_EQ(bench.exit_code, 0) << bench.err;
  const Json json = Json::parse(bench.out);
  EXPECT_EQ(json["robots"], 13);
  EXPECT_EQ(json["threads"], 1);
  EXPECT_EQ(json["method"], "avo");
  EXPECT_EQ(json["certificate"], "braking_trajectories");
  EXPECT_GT(json["step_milliseconds_median"].get<double>(), 0.0);
  EXPECT_EQ(json["pairs_per_robot"], nullptr);
  EXPECT_GE(json["infeasible_share"].get<double>(), 0.0);
}

TEST(SpaceScenes, a_scene_that_says_two_dimensions_is_one_of_the_plane) {
  write_file(path_of("plane.yaml"),
             "version: 1\nspace: 2\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n");
  EXPECT_EQ(run_avo({"validate", path_of("plane.yaml")}).exit_code, 0);
  write_file(path_of("drones.yaml"), kScene);
  EXPECT_THAT(run_avo({"validate", path_of("drones.yaml")}).out, HasSubstr("13 robots in space"));
}

}  // namespace
}  // namespace avo_test
