// SPDX-License-Identifier: Apache-2.0
// avo explain: the decision that the simulation takes, and all that it rests on.
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/method.h"
#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

const std::string kPaper = "method=avo_paper";

Json explained(const Strings& arguments) {
  Strings all{"explain", "--json"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const ProcessResult result = run_avo(all);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Json::parse(result.out, nullptr, false);
}

avo::Vec2 point(const Json& json) {
  return {json.at(0), json.at(1)};
}

/// The simulation just before the step that begins at `steps` time steps.
avo::Simulation simulated(const avo::Scenario& scenario, int steps) {
  avo::Simulation simulation(scenario, 1);
  for (int i = 0; i < steps; ++i) simulation.step();
  return simulation;
}

TEST(Explain, tells_the_decision_that_the_next_step_takes) {
  const Json json = explained({"circle-10", "--robot", "3", "--time", "7.05"});
  avo::Simulation simulation = simulated(avo_io::load_scenario("circle-10"), 70);
  EXPECT_EQ(json["time"], simulation.time()) << "the last step until then";
  EXPECT_EQ(json["robot"], 3);
  EXPECT_EQ(point(json["position"]), simulation.fleet().position[3]);
  EXPECT_EQ(point(json["velocity"]), simulation.fleet().velocity[3]);
  EXPECT_EQ(point(json["preferred_velocity"]), simulation.perceive({3}).robot.preferred_velocity);
  simulation.step();
  const avo::Plan& plan = simulation.fleet().plan[3];
  EXPECT_EQ(point(json["new_velocity"]), plan.new_velocity);
  EXPECT_EQ(json["status"], avo::to_string(plan.status));
  EXPECT_EQ(json["violation"], plan.violation);
}

TEST(Explain, half_planes_are_those_of_the_sensed_neighbors) {
  const Json json = explained({"circle-10", "--robot", "0", "--time", "6", "--set", kPaper});
  const avo::Simulation simulation = simulated(avo_io::load_scenario("circle-10", {kPaper}), 60);
  const auto perception = simulation.perceive({0});
  avo::PlanWorkspace workspace;
  avo::HalfPlanes half_planes;
  simulation.planner().collect_half_planes(perception.robot, perception.neighbors, workspace,
                                           half_planes);
  ASSERT_GT(half_planes.planes.size(), 0U);
  ASSERT_EQ(json["half_planes"].size(), half_planes.planes.size());
  ASSERT_EQ(json["status"], "optimal");
  const avo::Vec2 chosen = point(json["new_velocity"]);
  for (std::size_t k = 0; k < half_planes.planes.size(); ++k) {
    const Json& plane = json["half_planes"][k];
    const auto index = static_cast<std::size_t>(half_planes.planes[k].neighbor);
    EXPECT_EQ(plane["neighbor"], perception.source[index]);
    EXPECT_EQ(point(plane["normal"]), half_planes.planes[k].plane.normal);
    EXPECT_EQ(plane["offset"], half_planes.planes[k].plane.offset);
    EXPECT_NEAR(norm(point(plane["normal"])), 1.0, 1e-12);
    EXPECT_GE(dot(point(plane["normal"]), chosen), plane["offset"].get<double>() - 1e-9);
  }
  EXPECT_EQ(json["neighbors"].size(), perception.neighbors.size());
  EXPECT_EQ(json["acceleration_disc"]["radius"], 4.0) << "delta max_acceleration";
  EXPECT_EQ(point(json["acceleration_disc"]["center"]), perception.robot.velocity);
  EXPECT_EQ(json["speed_disc"]["radius"], 2.0);
  EXPECT_EQ(json["target_by"], "half_planes");
}

TEST(Explain, names_moving_obstacles) {
  std::vector<std::string> words{"positions-exchange",
                                 "--robot",
                                 "1",
                                 "--set",
                                 kPaper,
                                 "--set",
                                 "moving_obstacles=[{position: [36, 0]}, {position: [7, 0.5], "
                                 "velocity: [1, 0]}]",
                                 "--set",
                                 "sensing_radius=25"};
  Json json = explained(words);
  ASSERT_EQ(json["half_planes"].size(), 2U);
  EXPECT_EQ(json["half_planes"][0]["neighbor"], "moving_obstacles.1");
  EXPECT_EQ(json["half_planes"][1]["neighbor"], 0);
  ASSERT_EQ(json["neighbors"].size(), 2U) << "the other one is too far away";
  EXPECT_EQ(json["neighbors"][0]["neighbor"], "moving_obstacles.1");
  EXPECT_EQ(json["neighbors"][0]["max_acceleration"], 0.0);
  // where the other robot is too far away, there is no neighbor to share half-planes with
  words.back() = "sensing_radius=15";
  json = explained(words);
  EXPECT_EQ(json["target_by"], "union_of_obstacles");
  EXPECT_EQ(json["half_planes"], Json::array());
  ASSERT_EQ(json["neighbors"].size(), 1U);
}

TEST(Explain, tells_methods_that_choose_outside_the_union_of_obstacles) {
  for (const avo::MethodTraits& method : avo::kMethodTraits) {
    if (avo::is_external(method.method)) continue;
    const std::string set = std::string("method=") + avo::to_string(method.method);
    const Json json = explained({"circle-10", "--robot", "0", "--time", "0.1", "--set", set});
    EXPECT_EQ(json["target_by"], method.avoids_union ? "union_of_obstacles" : "half_planes") << set;
  }
}

TEST(Explain, a_robot_alone_avoids_the_union_of_obstacles) {
  const Json json = explained({"moving-obstacle", "--robot", "0", "--time", "5"});
  EXPECT_EQ(json["target_by"], "union_of_obstacles");
  EXPECT_EQ(json["half_planes"], Json::array());
  EXPECT_EQ(json["neighbors"][0]["neighbor"], "moving_obstacles.0");
  avo::Simulation simulation = simulated(avo_io::load_scenario("moving-obstacle"), 50);
  simulation.step();
  EXPECT_EQ(point(json["new_velocity"]), simulation.fleet().plan[0].new_velocity);
  EXPECT_EQ(json["status"], "optimal");
  EXPECT_EQ(json["violation"], 0.0);
}

/// circle-10 by method avo, in the thick of it.
const Strings kAvo{"circle-10", "--set",          "method=avo", "--set", "control_time=2",
                   "--set",     "time_horizon=3", "--time",     "10"};

TEST(Explain, tells_the_certificate_apart_from_the_half_planes) {
  for (const char* kind : {"none", "braking_trajectories"}) {
    Strings arguments = kAvo;
    arguments.insert(arguments.end(),
                     {"--robot", "3", "--set", std::string("certificate=") + kind});
    const Json json = explained(arguments);
    avo::Simulation simulation = simulated(
        avo_io::load_scenario("circle-10", {"method=avo", "control_time=2", "time_horizon=3",
                                            std::string("certificate=") + kind}),
        100);
    const auto seen = simulation.perceive({3});
    avo::PlanWorkspace workspace;
    std::vector<avo::CertificateConstraint> constraints;
    simulation.planner().collect_certificate(seen.robot, seen.neighbors, workspace, constraints);
    EXPECT_EQ(constraints.empty(), std::string(kind) == "none");
    EXPECT_EQ(json["certificate_kind"], kind);
    EXPECT_EQ(json["detour_angle"], seen.detour.angle);
    ASSERT_EQ(json["certificate"].size(), constraints.size());
    for (std::size_t k = 0; k < constraints.size(); ++k) {
      const avo::CertificateConstraint& expected = constraints[k];
      const Json& constraint = json["certificate"][k];
      EXPECT_EQ(constraint["neighbor"], seen.source[static_cast<std::size_t>(expected.neighbor)]);
      EXPECT_EQ(constraint["interval"], expected.interval);
      EXPECT_EQ(point(constraint["normal"]), expected.normal);
      EXPECT_EQ(constraint["offset"], expected.offset);
    }
    simulation.step();
    EXPECT_EQ(point(json["new_velocity"]), simulation.fleet().plan[3].new_velocity)
        << "with the detour that it remembers";
  }
}

TEST(Explain, other_methods_have_no_certificate) {
  const Json json = explained({"circle-10", "--robot", "3", "--time", "8", "--set", kPaper});
  for (const char* key : {"certificate_kind", "certificate", "detour_angle"})
    EXPECT_FALSE(json.contains(key)) << key;
}

TEST(Explain, names_the_first_constraints_of_the_nearest) {
  Strings arguments{"explain"};
  arguments.insert(arguments.end(), kAvo.begin(), kAvo.end());
  arguments.insert(arguments.end(), {"--robot", "3"});
  const ProcessResult result = run_avo(arguments);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.out.find("  certificate         braking_trajectories, "), std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("  constraint          ("), std::string::npos) << result.out;
}

TEST(Explain, orca_has_no_acceleration_disc) {
  const Json json = explained({"circle-10", "--robot", "0", "--set", "method=orca"});
  EXPECT_TRUE(json["acceleration_disc"].is_null());
}

TEST(Explain, tells_whom_the_robot_evades_and_on_which_way) {
  const Strings words{"positions-exchange",
                      "--set",
                      "robots.0={position: [0, 0], velocity: [2, 0], goal: [30, 0]}",
                      "--set",
                      "robots.1={position: [0, 40], goal: [0, 40]}",
                      "--set",
                      "moving_obstacles=[{position: [9, 9], velocity: [1, 1]}, {position: [2, 3], "
                      "velocity: [0, -1]}]",
                      "--robot",
                      "0"};
  const Json json = explained(words);
  ASSERT_TRUE(json["evading"].is_object()) << json;
  EXPECT_EQ(json["evading"]["neighbor"], "moving_obstacles.1");
  EXPECT_GE(json["evading"]["until"], 0.0);
  EXPECT_LE(json["evading"]["until"], 4.2);
  Strings text = words;
  text.insert(text.begin(), "explain");
  const ProcessResult result = run_avo(text);
  EXPECT_NE(result.out.find("  evades              moving obstacle 1: "), std::string::npos)
      << result.out;
  Strings other = words;
  other.back() = "1";
  EXPECT_TRUE(explained(other)["evading"].is_null());
  text.back() = "1";
  EXPECT_EQ(run_avo(text).out.find("evades"), std::string::npos);
}

TEST(Explain, names_those_who_cooperate) {
  const Json json = explained(
      {"circle-10", "--robot", "3", "--time", "6", "--set", "robots.4.behavior=cooperates"});
  int others = 0, cooperating = 0;
  for (const Json& other : json["neighbors"]) {
    const bool decides = other["neighbor"] != 4;
    ++(decides ? others : cooperating);
    EXPECT_EQ(other["behavior"], decides ? "decides" : "cooperates");
    EXPECT_EQ(other["share"], 0.5);
    EXPECT_EQ(other["max_acceleration"], 1.0);
    EXPECT_EQ(other.contains("max_braking"), decides) << "nobody counts on its brakes";
  }
  EXPECT_EQ(cooperating, 1);
  EXPECT_GT(others, 0);
}

TEST(Explain, tells_what_is_proved_of_the_state) {
  const Strings starts{"positions-exchange",
                       "--robot",
                       "0",
                       "--set",
                       kPaper,
                       "--set",
                       "robots.0={position: [-2.5, 0], velocity: [2, 0], goal: [20, 0]}",
                       "--set"};
  const auto meeting = [&](const char* other) {
    Strings words = starts;
    words.push_back(other);
    return words;
  };
  const Strings near = meeting("robots.1={position: [-0.5, 0], velocity: [-2, 0], goal: [-20, 0]}");
  Json json = explained(near);
  EXPECT_EQ(json["state"], "doomed");
  EXPECT_EQ(json["doomed_by"], 1);
  EXPECT_GT(json["contact_within"], 0.0);
  EXPECT_LT(json["contact_within"], 1.0);
  json = explained(meeting("robots.1={position: [9, 0], velocity: [-2, 0], goal: [-20, 0]}"));
  EXPECT_EQ(json["state"], "safe");
  EXPECT_TRUE(json["doomed_by"].is_null());
  EXPECT_TRUE(json["contact_within"].is_null());
  Strings walled = meeting("robots.1={position: [9, 9], goal: [20, 9]}");
  walled.insert(walled.end(), {"--set", "obstacles=[{polyline: [[-1, -8], [-1, 8]]}]"});
  EXPECT_EQ(explained(walled)["doomed_by"], "walls.0");

  Strings touching = near;
  touching.insert(touching.end(), {"--time", "0.4"});
  json = explained(touching);
  EXPECT_EQ(json["status"], "overlapping");
  EXPECT_EQ(json["contact_with"], 1);
  EXPECT_GT(json["contact_depth"], 0.1);
  EXPECT_LT(json["contact_depth"], 1.0);
  json = explained(near);
  EXPECT_TRUE(json["contact_with"].is_null());
  EXPECT_TRUE(json["contact_depth"].is_null());

  Strings words{"explain"};
  words.insert(words.end(), near.begin(), near.end());
  words.insert(words.end(), {"--states", path_of("states.svg"), "--figure", path_of("why.svg")});
  const ProcessResult result = run_avo(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("  state               doomed: contact with robot 1 within "),
            std::string::npos)
      << result.out;
  EXPECT_EQ(files_in(folder()), (Strings{"states.svg", "why.svg"}));
}

TEST(Explain, draws_velocity_space) {
  for (const char* name : {"a.svg", "a.png", "a.pdf"}) {
    const ProcessResult result =
        run_avo({"explain", "circle-10", "--robot", "0", "--time", "6", "--figure", path_of(name)});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_GT(read_file(path_of(name)).size(), 1000U);
  }
  EXPECT_EQ(files_in(folder()), (Strings{"a.pdf", "a.png", "a.svg"}));
}

// Robot 3 of the office goes through a door.
TEST(Explain, lists_half_planes_of_walls_and_what_the_certificate_keeps) {
  for (const char* method : {"method=avo", "method=avo_paper", "method=orca"}) {
    const bool is_avo = std::string(method) == "method=avo";
    const Json json = explained({"office", "--robot", "3", "--time", "8", "--set", method});
    const avo::Simulation simulation = simulated(avo_io::load_scenario("office", {method}), 80);
    const auto seen = simulation.perceive({3});
    ASSERT_EQ(json["walls"].size(), seen.walls.size());
    ASSERT_GT(seen.walls.size(), 1U);
    EXPECT_EQ(point(json["walls"][1]["a"]), seen.walls[1].a);
    EXPECT_EQ(point(json["walls"][1]["b"]), seen.walls[1].b);
    EXPECT_EQ(json["walls"][1]["radius"], seen.walls[1].radius);
    for (std::size_t k = 0; k < seen.walls.size(); ++k)
      EXPECT_EQ(json["walls"][k]["obstacle"], seen.wall_source[k]);

    avo::WallPlanes planes;
    simulation.planner().collect_half_planes(seen.robot, seen.walls, planes);
    EXPECT_EQ(planes.speeds.empty(), !is_avo);
    ASSERT_GT(planes.obstacles.size(), 1U);
    ASSERT_EQ(json["wall_half_planes"].size(), planes.speeds.size() + planes.obstacles.size());
    for (std::size_t k = 0; k < json["wall_half_planes"].size(); ++k) {
      const Json& plane = json["wall_half_planes"][k];
      const bool is_speed = k < planes.speeds.size();
      const avo::WallPlane& expected =
          is_speed ? planes.speeds[k] : planes.obstacles[k - planes.speeds.size()];
      EXPECT_EQ(plane["kind"], is_speed ? "speed" : "obstacle");
      EXPECT_EQ(plane["wall"], expected.wall);
      EXPECT_EQ(point(plane["normal"]), expected.plane.normal);
      EXPECT_EQ(plane["offset"], expected.plane.offset);
    }
    ASSERT_EQ(json.contains("wall_certificate"), is_avo);
    if (!is_avo) continue;
    ASSERT_GT(json["wall_certificate"].size(), 0U);
    for (const Json& constraint : json["wall_certificate"]) {
      EXPECT_EQ(constraint["held"], 0.5) << "the robot's radius, and walls have none";
      EXPECT_GT(constraint["distance"].get<double>(), 0.5);
      EXPECT_NEAR(norm(point(constraint["normal"])), 1.0, 1e-12);
    }
  }
}

TEST(Explain, names_walls) {
  const ProcessResult result = run_avo({"explain", "office", "--robot", "3", "--time", "8"});
  for (const char* words : {"  speed before wall   (", "  wall's obstacle     (",
                            "  wall constraint     0.5 m from the wall from ("})
    EXPECT_NE(result.out.find(words), std::string::npos) << words << result.out;
}

TEST(Explain, speaks_without_json) {
  const ProcessResult result =
      run_avo({"explain", "circle-10", "--robot", "3", "--time", "6", "--set", kPaper});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.out.starts_with("circle-10, robot 3 at 6 s\n")) << result.out;
  for (const char* word : {"half-plane", "preferred velocity", "new velocity", "status"})
    EXPECT_NE(result.out.find(word), std::string::npos) << word;
}

TEST(Explain, tells_the_response_time_that_takes_effect) {
  const auto told = [](const char* setting) {
    return explained({"circle-10", "--robot", "3", "--time", "6", "--set", setting});
  };
  EXPECT_NEAR(told("seed=1")["response_time"].get<double>(), 0.2, 1e-12);
  EXPECT_NEAR(told("response_time=0.25")["response_time"].get<double>(), 0.5, 1e-12);
  EXPECT_EQ(told("response_time=0")["response_time"], 0.0);
  EXPECT_FALSE(told("method=orca").contains("response_time"));
  EXPECT_EQ(explained({"moving-obstacle", "--robot", "0", "--time", "5"})["response_time"], 0.0)
      << "among movers alone";
  const auto line = [](const char* setting) {
    return run_avo({"explain", "circle-10", "--robot", "3", "--set", setting}).out;
  };
  EXPECT_NE(line("seed=1").find("  response time       0.2 s\n"), std::string::npos);
  EXPECT_NE(line("response_time=0").find("  response time       0: at once\n"), std::string::npos);
}

TEST(Explain, tells_ages_and_what_noise_may_hide) {
  const Strings circle{"circle-10", "--robot", "3", "--time", "7"};
  Strings sensed = circle;
  for (const char* setting : {"sensing.dropped=0.6", "sensing.noise.position=0.05",
                              "sensing.noise.velocity=0.1", "seed=4"})
    sensed.insert(sensed.end(), {"--set", setting});
  const Json json = explained(sensed);
  double sum = 0.0;
  int carried = 0;
  for (const Json& other : json["neighbors"]) {
    sum += other["risk"].get<double>();
    carried += other.contains("age") ? 1 : 0;
    EXPECT_GE(other.value("age", 1), 1);
  }
  EXPECT_GT(sum, 0.0);
  EXPECT_DOUBLE_EQ(json["risk"].get<double>(), std::min(1.0, sum));
  EXPECT_GT(carried, 0);
  Strings words{"explain"};
  words.insert(words.end(), sensed.begin(), sensed.end());
  const std::string said = run_avo(words).out;
  EXPECT_NE(said.find("  carried on          robot "), std::string::npos) << said;
  EXPECT_NE(said.find(" that noise hides a broken half-plane\n"), std::string::npos) << said;
  EXPECT_FALSE(explained(circle).contains("risk"));  // nothing is hidden
}

TEST(Explain, tells_priorities_and_who_decides) {
  const Strings scene{
      "circle-10",          "--robot", "3", "--time", "7", "--set", "robots.3.priority=3", "--set",
      "robots.4.avoids=[9]"};
  const Json json = explained(scene);
  EXPECT_EQ(json["priority"], 3.0);
  int movers = 0;
  for (const Json& other : json["neighbors"]) {
    const bool decides = other["neighbor"] != 4;
    EXPECT_EQ(other["behavior"], decides ? "decides" : "moves_on");
    EXPECT_EQ(other["share"], decides ? 0.25 : 1.0);
    movers += decides ? 0 : 1;
  }
  EXPECT_EQ(movers, 1);
  EXPECT_GT(json["neighbors"].size(), 5U);
}

TEST(Explain, usage_errors) {
  const auto message = [](Strings arguments) {
    arguments.insert(arguments.begin(), {"explain", "circle-10"});
    const ProcessResult result = run_avo(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  EXPECT_EQ(message({"--robot", "10"}), "avo: --robot: found 10, must be 0 to 9\n");
  EXPECT_EQ(message({"--robot", "-1"}), "avo: --robot: found -1, must be 0 to 9\n");
  EXPECT_EQ(message({"--robot", "0", "--time", "-1"}),
            "avo: --time: found -1, must be finite and >= 0 s\n");
  EXPECT_EQ(message({"--robot", "0", "--time", "nan"}),
            "avo: --time: found nan, must be finite and >= 0 s\n");
  EXPECT_EQ(message({"--robot", "0", "--time", "101"}),
            "avo: --time: found 101 s, must be <= duration = 100 s\n");
  EXPECT_NE(message({}).find("--robot"), std::string::npos);
  for (const char* figure : {"--figure", "--states"}) {
    EXPECT_NE(message({"--robot", "0", "--json", figure, "a.svg"}).find(figure), std::string::npos);
    EXPECT_NE(message({"--robot", "0", figure, "a.txt"}).find(figure), std::string::npos);
  }
  EXPECT_NE(message({"--robot", "0", "--figure", "a.svg", "--states", "./a.svg"}).find("one file"),
            std::string::npos);
}

}  // namespace
}  // namespace avo_test
