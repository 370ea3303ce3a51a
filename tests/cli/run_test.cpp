// SPDX-License-Identifier: Apache-2.0
// avo run: recordings and summaries as promised.
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "avo/version.h"
#include "avo_io/recording.h"
#include "avo_io/scene.h"
#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

const Strings kSummaryKeys{"scene",
                           "robots",
                           "parked",
                           "steps",
                           "arrived",
                           "first_collision_time",
                           "collision_pairs",
                           "one_sided_collisions",
                           "one_sided_collisions_in_motion",
                           "mover_collisions",
                           "mover_collisions_in_motion",
                           "mover_collisions_evadable",
                           "static_collisions",
                           "min_clearance",
                           "min_static_clearance",
                           "first_seen_too_late",
                           "max_acceleration",
                           "acceleration_excess",
                           "max_speed",
                           "mean_arrival",
                           "last_arrival",
                           "infeasible_steps",
                           "decisions",
                           "not_arrived_count",
                           "not_arrived",
                           "unreachable",
                           "step_milliseconds_median",
                           "metrics",
                           "seed",
                           "version"};

Strings keys_of(const Json& json) {
  Strings keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

TEST(Run, records_every_step_of_every_robot_bit_by_bit) {
  const Strings overrides{"duration=5", "groups.0.placement.circle.min_radius=5"};
  const std::string csv = path_of("out.csv");
  const ProcessResult result =
      run_avo({"run", "circle-6", "--record", csv, "--set", overrides[0], "--set", overrides[1]});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Strings lines = lines_of(read_file(csv));
  ASSERT_EQ(lines.size(), 1U + 51U * 6U);
  EXPECT_EQ(lines[0], "time,robot,x,y,vx,vy");
  avo::Simulation simulation(avo_io::load_scenario("circle-6", overrides), 1);
  std::size_t row = 1;
  for (int step = 0; step <= 50; ++step) {
    if (step > 0) simulation.step();
    const avo::FleetView fleet = simulation.fleet();
    for (std::size_t i = 0; i < 6; ++i) {
      double t = 0, x = 0, y = 0, vx = 0, vy = 0;
      int robot = -1;
      ASSERT_EQ(
          std::sscanf(lines[row++].c_str(), "%lf,%d,%lf,%lf,%lf,%lf", &t, &robot, &x, &y, &vx, &vy),
          6);
      EXPECT_EQ(t, simulation.time());
      EXPECT_EQ(robot, static_cast<int>(i));
      EXPECT_EQ((avo::Vec2{x, y}), fleet.position[i]);
      EXPECT_EQ((avo::Vec2{vx, vy}), fleet.velocity[i]);
    }
  }
  EXPECT_EQ(read_file(csv).back(), '\n');
  EXPECT_TRUE(lines[7].starts_with("0.1,0,")) << "the shortest digits: " << lines[7];
}

TEST(Run, is_the_same_for_any_number_of_threads) {
  const auto record = [](const std::string& threads) {
    const std::string csv = path_of("threads.csv");
    EXPECT_EQ(
        run_avo({"run", "circle-300", "--set", "duration=4", "--threads", threads, "--record", csv})
            .exit_code,
        0);
    return read_file(csv);
  };
  const std::string one = record("1");
  EXPECT_GT(one.size(), 10000U);
  EXPECT_EQ(one, record("2"));
  EXPECT_EQ(one, record("3"));
}

TEST(Run, summary_has_all_keys_and_the_numbers_of_the_library) {
  const Strings overrides{"duration=30", "moving_obstacles=[{position: [0, 3], radius: 0.25}]"};
  const std::string path = path_of("out.json");
  const ProcessResult result = run_avo({"run", "positions-exchange", "--summary", path, "--set",
                                        overrides[0], "--set", overrides[1], "--seed", "7"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(read_file(path));
  EXPECT_EQ(keys_of(json), kSummaryKeys);

  const avo::Scenario scenario = avo_io::load_scenario("positions-exchange", overrides);
  avo::Simulation simulation(scenario, 1);
  avo::Metrics metrics(scenario);
  metrics.observe(simulation);
  for (int step = 0; step < 300; ++step) {
    simulation.step();
    metrics.observe(simulation);
  }
  const avo::RunSummary expected = metrics.summary();
  EXPECT_EQ(json["scene"], "positions-exchange");
  EXPECT_EQ(json["robots"], 2);
  EXPECT_EQ(json["steps"], 300);
  EXPECT_EQ(json["arrived"], 2);
  EXPECT_EQ(json["arrived"], expected.arrived);
  EXPECT_TRUE(json["first_collision_time"].is_null());
  EXPECT_EQ(json["collision_pairs"], 0);
  EXPECT_EQ(json["mover_collisions"], 0);
  EXPECT_EQ(json["static_collisions"], 0);
  EXPECT_TRUE(json["min_static_clearance"].is_null());
  EXPECT_EQ(json["min_clearance"], *expected.min_clearance);
  EXPECT_EQ(json["max_acceleration"], expected.max_acceleration);
  EXPECT_EQ(json["max_speed"], expected.max_speed);
  EXPECT_EQ(json["mean_arrival"], *expected.mean_arrival);
  EXPECT_EQ(json["last_arrival"], *expected.last_arrival);
  EXPECT_EQ(json["infeasible_steps"], expected.infeasible_steps);
  EXPECT_EQ(keys_of(json["decisions"]), (Strings{"optimal", "least_unsafe", "refused", "detour",
                                                 "braking", "overlapping", "invalid_input"}));
  EXPECT_EQ(json["decisions"]["optimal"], expected.decisions.optimal);
  EXPECT_EQ(json["decisions"]["least_unsafe"], expected.decisions.least_unsafe);
  EXPECT_EQ(json["not_arrived_count"], 0);
  EXPECT_EQ(json["not_arrived"], Json::array());
  EXPECT_GT(json["step_milliseconds_median"], 0.0);
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["version"], avo::kVersion);
}

TEST(Run, summary_says_null_where_there_is_nothing) {
  const std::string path = path_of("out.json");
  ASSERT_EQ(run_avo({"run", "moving-obstacle", "--summary", path, "--set", "duration=1"}).exit_code,
            0);
  const Json json = Json::parse(read_file(path));
  for (const char* key : {"first_collision_time", "min_clearance", "mean_arrival", "last_arrival"})
    EXPECT_TRUE(json[key].is_null()) << key;
  EXPECT_EQ(json["arrived"], 0);
}

/// An obstacle stands where robot 0 wants to go.
const std::string kNoRoom =
    "version: 1\nduration: 20\nrobots:\n"
    "  - {position: [0, 0], goal: [5, 0]}\n"
    "  - {position: [0, 9], goal: [0, 9]}\n"
    "moving_obstacles:\n  - {position: [5, 0]}\n";

// A goal in a box, and a robot that passes beside it.
constexpr const char* kBox =
    "version: 1\nduration: 8\nobstacles:\n"
    "  - {polygon: [[4, -2], [8, -2], [8, 2], [4, 2]]}\n"
    "robots:\n  - {position: [0, 0], goal: [6, 0]}\n  - {position: [0, 3], goal: [0, 9]}\n";

TEST(Run, tells_whom_walls_keep_from_their_goals) {
  const std::string scene = path_of("box.yaml"), out = path_of("box.json");
  const std::string csv = path_of("box.csv");
  write_file(scene, kBox);
  const ProcessResult result = run_avo({"run", scene, "--summary", out, "--record", csv});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
  EXPECT_NE(result.err.find("leads to the goal of robot 0 (to 2.5 m); a route has"),
            std::string::npos)
      << result.err;
  const Json json = Json::parse(read_file(out));
  EXPECT_EQ(json["unreachable"], Json::array({0}));
  EXPECT_EQ(json["arrived"], 1);
  const Json& robot = json["not_arrived"][0];
  EXPECT_NEAR(robot["distance"].get<double>(), 2.5, 1e-4) << "it has gone to the nearest place";
  EXPECT_NEAR(robot["distance_left"].get<double>(), 2.5, 1e-4);
  EXPECT_EQ(json["static_collisions"], 0);
  EXPECT_GT(json["min_static_clearance"], 0.0);
  const ProcessResult check = run_avo({"check", csv, "--scene", scene, "--json"});
  ASSERT_EQ(check.exit_code, 0) << check.err;
  EXPECT_EQ(Json::parse(check.out)["static_contacts"]["count"], 0);
  const ProcessResult two = run_avo({"run", scene, "--set", "robots.1.goal=[6, 1]"});
  EXPECT_NE(two.err.find("leads to the goals of robots 0 (to 2.5 m), 1 (to 1.5 m);"),
            std::string::npos)
      << two.err;
}

// The same recording beside walls that it was not made among.
TEST(Run, is_judged_by_the_walls_of_the_scene_given) {
  const std::string scene = path_of("crossed.yaml"), csv = path_of("crossed.csv");
  write_file(scene, kBox);
  ASSERT_EQ(run_avo({"run", scene, "--record", csv}).exit_code, 0);
  std::string moved = kBox;
  moved.replace(moved.find("[[4, -2], [8, -2], [8, 2], [4, 2]]"), 34,
                "[[-1, 6], [1, 6], [1, 6.2], [-1, 6.2]]");
  write_file(scene, moved);
  const ProcessResult check = run_avo({"check", csv, "--scene", scene, "--json"});
  EXPECT_EQ(check.exit_code, 1) << check.err;
  const Json contacts = Json::parse(check.out)["static_contacts"];
  EXPECT_EQ(contacts["count"], 1);
  EXPECT_EQ(contacts["first"]["robot"], 1);
}

TEST(Run, refuses_starts_too_near_to_walls_with_the_arithmetic) {
  const std::string scene = path_of("near.yaml");
  std::string near = kBox;
  near.replace(near.find("[0, 0], goal"), 12, "[3.7, 0], goal");
  write_file(scene, near);
  const ProcessResult result = run_avo({"run", scene});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("robot 0 starts too near obstacles.0: found [3.7, 0], 0.3 m from it"),
            std::string::npos)
      << result.err;
}

TEST(Run, tells_who_has_not_arrived_and_who_is_in_the_way) {
  write_file(path_of("no-room.yaml"), kNoRoom);
  const ProcessResult result =
      run_avo({"run", path_of("no-room.yaml"), "--summary", path_of("out.json")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(read_file(path_of("out.json")));
  EXPECT_EQ(json["arrived"], 1);
  EXPECT_EQ(json["not_arrived_count"], 1);
  ASSERT_EQ(json["not_arrived"].size(), 1U);
  const Json& robot = json["not_arrived"][0];
  EXPECT_EQ(keys_of(robot),
            (Strings{"robot", "distance", "speed", "status", "detour_angle", "held_by"}));
  EXPECT_EQ(robot["robot"], 0);
  EXPECT_GE(robot["distance"], 1.0) << "both radii";
  EXPECT_LE(robot["distance"], 1.2) << "it keeps some clearance";
  EXPECT_EQ(robot["held_by"], Json::array({"moving_obstacles.0"}));
  std::int64_t decisions = 0;
  for (const auto& [status, count] : json["decisions"].items())
    decisions += count.get<std::int64_t>();
  EXPECT_EQ(decisions, 2 * 200);
  EXPECT_NE(result.out.find("  decisions          "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("  not arrived        robot 0, 1.1 m to go, "), std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find(", held by obstacle 0\n"), std::string::npos) << result.out;
}

TEST(Run, validate_tells_whom_walls_keep_from_their_goals) {
  write_file(path_of("box.yaml"), kBox);
  const ProcessResult result =
      run_avo({"validate", path_of("box.yaml"), "--set", "robots.1.goal=[3.6, 3]"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(
      lines_of(result.err),
      (Strings{"warning: robot 0: its goal [6, 0] cannot be reached by any route as wide as the "
               "robot: it goes to [3.4999995, 0], 2.5 m from there"}));
  const ProcessResult near =
      run_avo({"validate", path_of("box.yaml"), "--set", "robots.0.goal=[3.6, 1]"});
  EXPECT_EQ(
      lines_of(near.err),
      (Strings{"warning: robot 0: its goal [3.6, 1] is nearer to an obstacle than its radius = "
               "0.5 m: it goes to [3.4999995, 1], 0.1 m from there, where it has arrived"}));
}

// A corridor of one lane: one robot comes through, the other one waits.
constexpr const char* kLane =
    "version: 1\nduration: 12\nobstacles:\n"
    "  - {polygon: [[-5, 0.8], [5, 0.8], [5, 8], [-5, 8]]}\n"
    "  - {polygon: [[-5, -8], [5, -8], [5, -0.8], [-5, -0.8]]}\n"
    "robots:\n"
    "  - {position: [-7, 0], goal: [12, 3], preferred_speed: 0.7}\n"
    "  - {position: [12, 0], goal: [-12, 3]}\n";

TEST(Run, tells_who_waits_at_a_passage_and_for_whom) {
  write_file(path_of("lane.yaml"), kLane);
  const ProcessResult result =
      run_avo({"run", path_of("lane.yaml"), "--summary", path_of("lane.json")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(read_file(path_of("lane.json")));
  ASSERT_EQ(json["not_arrived"].size(), 2U);
  EXPECT_FALSE(json["not_arrived"][0].contains("passage"));
  const Json& robot = json["not_arrived"][1];
  EXPECT_EQ(robot["held_by"], Json::array({0})) << robot;
  EXPECT_NEAR(robot["passage"][0].get<double>(), 0.0, 1e-6);
  EXPECT_NE(result.out.find(", held by 0 at the passage at [0, 0]\n"), std::string::npos)
      << result.out;
  const ProcessResult why =
      run_avo({"explain", path_of("lane.yaml"), "--robot", "1", "--time", "12"});
  EXPECT_NE(why.out.find("at the passage at (0, 0) m for robot 0\n"), std::string::npos) << why.out;
  const ProcessResult same =
      run_avo({"explain", path_of("lane.yaml"), "--robot", "1", "--time", "12", "--json"});
  EXPECT_EQ(Json::parse(same.out)["waits"]["for"], 0) << same.out;
}

TEST(Run, names_those_who_move_and_have_not_arrived) {
  const ProcessResult result = run_avo({"run", "circle-7", "--set", "duration=4"});
  EXPECT_NE(result.out.find("  not arrived        robot 0, "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find(" m to go, moving at 2 m/s; robot 1, "), std::string::npos);
  EXPECT_NE(result.out.find(" m to go, moving at 2 m/s; 2 more\n"), std::string::npos);
}

TEST(Run, nobody_is_missing_where_all_arrive) {
  const ProcessResult result = run_avo({"run", "positions-exchange"});
  EXPECT_EQ(result.out.find("not arrived"), std::string::npos) << result.out;
}

TEST(Run, collisions_are_counted_and_are_no_failure) {
  const std::string path = path_of("out.json");
  const ProcessResult result =
      run_avo({"run", "positions-exchange", "--summary", path, "--set", "duration=1", "--set",
               "method=avo_paper", "--set", "robots.1.position=[-9.5, 0]", "--set",
               "moving_obstacles=[{position: [-10, -0.5], radius: 0.5}]"});
  EXPECT_EQ(result.exit_code, 0);
  const Json json = Json::parse(read_file(path));
  EXPECT_EQ(json["first_collision_time"], 0.0);
  EXPECT_EQ(json["collision_pairs"], 1);
  EXPECT_GE(json["mover_collisions"], 1);
  EXPECT_TRUE(json["mover_collisions_evadable"].is_null())
      << "no certificate, no evasive maneuvers";
  EXPECT_LE(json["min_clearance"], -0.5);
  EXPECT_NE(result.err.find("warning: robot 0 and robot 1 overlap at the start"),
            std::string::npos);
}

TEST(Run, prints_a_summary_to_read) {
  const ProcessResult result = run_avo({"run", "moving-obstacle"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "") << "no bar where there is no terminal, no warning";
  EXPECT_TRUE(result.out.starts_with("moving-obstacle: 1 robots, 300 steps of 0.1 s\n"));
  for (const char* word : {"arrived            1 of 1", "collisions         0 pairs", "largest"})
    EXPECT_NE(result.out.find(word), std::string::npos) << word;

  const Json m = Json::parse(run_avo({"run", "moving-obstacle", "--json"}).out)["metrics"];
  const std::string smoothness = fmt::format(
      "  smoothness         jerk {:.3g} m/s^3, acceleration {:.3g} a_max (rms), {:.3g} % of the "
      "steps turned back\n",
      m["jerk"].get<double>(), m["acceleration_rms"].get<double>(),
      100.0 * m["turned_back"].get<double>());
  EXPECT_NE(result.out.find(smoothness), std::string::npos) << smoothness;
}

TEST(Run, writes_to_the_standard_output_on_demand) {
  const ProcessResult csv =
      run_avo({"run", "moving-obstacle", "--set", "duration=1", "--record", "-"});
  EXPECT_EQ(lines_of(csv.out).size(), 12U);
  EXPECT_TRUE(csv.out.starts_with("time,robot,x,y,vx,vy\n0,0,-10,0,0,0\n"));
  const ProcessResult json =
      run_avo({"run", "moving-obstacle", "--set", "duration=1", "--summary", "-"});
  EXPECT_EQ(keys_of(Json::parse(json.out)), kSummaryKeys);
}

TEST(Run, warns_in_one_line_and_goes_on) {
  const ProcessResult result = run_avo({"run", "moving-obstacle", "--set", "method=avo_paper",
                                        "--set", "control_time=1", "--set", "duration=1"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(lines_of(result.err).size(), 1U);
  EXPECT_TRUE(result.err.starts_with("warning: control_time 1 s is less than half of"));
}

TEST(Run, usage_errors) {
  const auto message = [](Strings arguments) {
    arguments.insert(arguments.begin(), {"run", "circle-2"});
    const ProcessResult result = run_avo(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(lines_of(result.err).size(), 1U);
    return result.err;
  };
  EXPECT_EQ(message({"--figure", "a.gif"}),
            "avo: --figure a.gif: found the extension '.gif', allowed: .svg, .png, .pdf\n");
  EXPECT_EQ(message({"--record", "a", "--summary", "./a"}),
            "avo: --record a and --summary ./a: found to be one file, must differ\n");
  EXPECT_NE(message({"--threads", "-1"}).find("--threads"), std::string::npos);
  EXPECT_NE(message({"--threads", "many"}).find("--threads"), std::string::npos);
  EXPECT_NE(message({"--nonsense"}).find("--nonsense"), std::string::npos);
  EXPECT_NE(message({"--set"}).find("--set"), std::string::npos);
}

}  // namespace
}  // namespace avo_test
