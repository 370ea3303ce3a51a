// SPDX-License-Identifier: Apache-2.0
// Scenes of quadrotors on the command line: their limits, the judge, set points, what is refused.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

#include "avo/space/quadrotor.h"
#include "avo/space/simulation.h"
#include "avo_io/space.h"
#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using avo::Vec3;
using avo::space::QuadrotorLimits;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

const std::string kQuadrotors = R"(version: 1
space: 3
duration: 3
groups:
  - count: 4
    sphere: {radius: 4}
    goal: antipodal
    jitter: 0.1
    radius: 0.25
    quadrotor: {mass: 1.2, max_thrust: 26, max_tilt: 0.6, attitude_time: 0.12}
robots:
  - position: [0, -9, 1]
    goal: [2, 9, 1]
    quadrotor: {mass: 0.03, max_thrust: 0.6, max_tilt: 0.5, attitude_time: 0.05, tracking_error: 0.03}
)";

std::string quadrotors_with(const std::string& what, const std::string& instead) {
  std::string text = kQuadrotors;
  return text.replace(text.find(what), what.size(), instead);
}

std::string refused_quadrotors(const std::string& text) {
  write_file(path_of("bad.yaml"), text);
  const ProcessResult result = run_avo({"validate", path_of("bad.yaml")});
  EXPECT_NE(result.exit_code, 0);
  return result.err;
}

TEST(QuadrotorScenes, give_robots_the_limits_of_their_quadrotors) {
  const avo::space::Scenario scene = avo_io::parse_space_scenario(kQuadrotors, "drones.yaml");
  ASSERT_EQ(scene.robots.size(), 5U);
  const QuadrotorLimits limits = limits_of(*scene.robots[2].quadrotor);
  const avo::space::Robot robot = robot_of(scene.robots[2]);
  EXPECT_EQ(robot.max_acceleration, limits.max_acceleration);
  EXPECT_EQ(robot.radius, 0.25 + limits.deviation);
  EXPECT_EQ(robot_of(scene.robots[0]).radius, 0.53);
  EXPECT_EQ(fleet_delay(scene), 0.12);
  write_file(path_of("drones.yaml"), kQuadrotors);
  const avo::space::Scenario changed =
      *avo_io::load_space_scenario(path_of("drones.yaml"), {"robots.3.quadrotor.mass=1.5"});
  EXPECT_EQ(changed.robots[3].quadrotor->mass, 1.5);
  EXPECT_EQ(changed.robots[3].quadrotor->max_thrust, 26.0);
  EXPECT_EQ(changed.robots[2].quadrotor->mass, 1.2);
}

TEST(QuadrotorScenes, are_judged_with_the_deviation_and_the_judge_says_so) {
  const std::string scene = path_of("drones.yaml"), csv = path_of("drones.csv");
  write_file(scene, kQuadrotors);
  ASSERT_EQ(run_avo({"run", scene, "--record", csv}).exit_code, 0);
  const ProcessResult check = run_avo({"check", csv, "--scene", scene});
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_THAT(check.out, HasSubstr("of quadrotors; radii contain deviations of up to 0.0638 m"));
  const Json json = Json::parse(run_avo({"check", csv, "--scene", scene, "--json"}).out);
  EXPECT_NEAR(json["deviation"].get<double>(), 0.0638, 1e-4);
  // the vehicles of these two references may touch
  write_file(scene,
             "version: 1\nspace: 3\nrobots:\n"
             "  - {position: [0, 0, 5], goal: [0, 0, 5], radius: 0.5, quadrotor: {mass: 1, "
             "max_thrust: 20, max_tilt: 0.5, attitude_time: 0.2}}\n"
             "  - {position: [0, 0, 8], goal: [0, 0, 8], radius: 0.5, quadrotor: {mass: 1, "
             "max_thrust: 20, max_tilt: 0.5, attitude_time: 0.2}}\n");
  write_file(csv,
             "time,robot,x,y,z,vx,vy,vz\n0,0,0,0,5,0,0,0\n0,1,0,0,6.1,0,0,0\n"
             "0.1,0,0,0,5,0,0,0\n0.1,1,0,0,6.1,0,0,0\n");
  EXPECT_THAT(run_avo({"check", csv, "--scene", scene}).out, HasSubstr("1 pairs of robots"));
}

TEST(QuadrotorScenes, convert_writes_the_set_points_of_the_filter) {
  const std::string scene = path_of("drones.yaml"), csv = path_of("drones.csv"),
                    points = path_of("points.csv");
  write_file(scene, kQuadrotors);
  ASSERT_EQ(run_avo({"run", scene, "--record", csv}).exit_code, 0);
  const ProcessResult converted =
      run_avo({"convert", csv, points, "--to", "set-points", "--rate", "100", "--scene", scene});
  ASSERT_EQ(converted.exit_code, 0) << converted.err;
  const std::vector<std::string> lines = lines_of(read_file(points));
  ASSERT_EQ(lines.size(), 1U + 301U * 5U);
  EXPECT_EQ(lines[0], "time,robot,x,y,z,vx,vy,vz,ax,ay,az");
  const avo::space::Scenario drones = avo_io::parse_space_scenario(kQuadrotors, scene);
  avo::space::Simulation simulation(drones);
  std::vector<avo::space::Filter> filters;
  for (const auto& robot : drones.robots)
    filters.emplace_back(limits_of(*robot.quadrotor), fleet_delay(drones), drones.time_step);
  for (std::size_t k = 0; k < 30; ++k) {
    const std::vector<avo::space::Robot> before(simulation.robots().begin(),
                                                simulation.robots().end());
    simulation.step();
    for (std::size_t j = 0; j < 5; ++j)
      filters[j].add(before[j].position, before[j].velocity,
                     (simulation.robots()[j].velocity - before[j].velocity) / drones.time_step);
    for (std::size_t row = 1 + 50 * k; row < 1 + 50 * (k + 1); ++row) {
      std::size_t robot = 0;
      double time = 0;
      Vec3 p, v, a;
      ASSERT_EQ(std::sscanf(lines[row].c_str(), "%lf,%zu,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf",
                            &time, &robot, &p.x, &p.y, &p.z, &v.x, &v.y, &v.z, &a.x, &a.y, &a.z),
                11);
      ASSERT_EQ(robot, (row - 1) % 5);
      ASSERT_NEAR(time, 0.01 * static_cast<double>((row - 1) / 5), 1e-9);
      const avo::space::SetPoint point = filters[robot].at(time);
      ASSERT_LT(norm(p - point.position), 1e-9) << lines[row];
      ASSERT_LT(norm(v - point.velocity), 1e-9) << lines[row];
      ASSERT_LT(norm(a - point.acceleration), 1e-6) << lines[row];
    }
  }
}

// Columns of the file by their names in its header.
std::vector<std::map<std::string, double>> rows_of(const std::string& file) {
  const std::vector<std::string> lines = lines_of(read_file(file));
  const auto split = [](const std::string& line) {
    std::vector<std::string> words(1);
    for (const char c : line) c == ',' ? void(words.emplace_back()) : words.back().push_back(c);
    return words;
  };
  const std::vector<std::string> names = split(lines.at(0));
  std::vector<std::map<std::string, double>> rows;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const std::vector<std::string> words = split(lines[k]);
    EXPECT_EQ(words.size(), names.size()) << lines[k];
    rows.emplace_back();
    for (std::size_t j = 0; j < names.size(); ++j) rows.back()[names[j]] = std::stod(words.at(j));
  }
  return rows;
}

TEST(QuadrotorScenes, convert_writes_set_points_in_the_frames_of_autopilots) {
  const std::string scene = path_of("drones.yaml"), csv = path_of("drones.csv"),
                    points = path_of("points.csv");
  write_file(scene, kQuadrotors);
  ASSERT_EQ(run_avo({"run", scene, "--record", csv}).exit_code, 0);
  const auto rows_for = [&](const std::vector<std::string>& autopilot) {
    std::vector<std::string> line{"convert", csv, points, "--to", "set-points", "--scene", scene};
    line.insert(line.end(), autopilot.begin(), autopilot.end());
    const ProcessResult converted = run_avo(line);
    EXPECT_EQ(converted.exit_code, 0) << converted.err;
    return rows_of(points);
  };
  const auto any = rows_for({}), px4 = rows_for({"--autopilot", "px4"}),
             crazyflie = rows_for({"--autopilot", "crazyflie"});
  ASSERT_EQ(any.size(), 151U * 5U);
  ASSERT_EQ(px4.size(), any.size());
  ASSERT_EQ(crazyflie.size(), any.size());
  for (std::size_t k = 0; k < any.size(); ++k) {
    SCOPED_TRACE(k);
    const auto from = [&](const char* name) { return static_cast<float>(any[k].at(name)); };
    const auto is = [&](const char* name) { return static_cast<float>(px4[k].at(name)); };
    ASSERT_EQ(px4[k].at("timestamp"), std::round(1e6 * any[k].at("time")));
    ASSERT_EQ(px4[k].at("robot"), any[k].at("robot"));
    ASSERT_EQ(is("position[0]"), from("y"));
    ASSERT_EQ(is("position[1]"), from("x"));
    ASSERT_EQ(is("position[2]"), -from("z"));
    ASSERT_EQ(is("velocity[0]"), from("vy"));
    ASSERT_EQ(is("velocity[2]"), -from("vz"));
    ASSERT_EQ(is("acceleration[1]"), from("ax"));
    ASSERT_EQ(is("acceleration[2]"), -from("az"));
    ASSERT_TRUE(std::isnan(px4[k].at("yaw")) && std::isnan(px4[k].at("jerk[1]")));
    for (const auto& [name, value] : any[k])
      ASSERT_EQ(static_cast<float>(crazyflie[k].at(name)), static_cast<float>(value)) << name;
    ASSERT_EQ(crazyflie[k].at("qw"), 1.0);
    ASSERT_EQ(crazyflie[k].at("yawrate"), 0.0);
  }
}

TEST(QuadrotorScenes, convert_refuses_what_an_autopilot_cannot_take) {
  const std::string scene = path_of("drones.yaml"), csv = path_of("drones.csv"),
                    points = path_of("points.csv");
  write_file(
      scene,
      "version: 1\nspace: 3\nrobots:\n  - {position: [40, 0, 0], goal: [40, 0, 0], quadrotor: "
      "{mass: 1, max_thrust: 20, max_tilt: 0.5, attitude_time: 0.1}}\n");
  write_file(csv, "time,robot,x,y,z,vx,vy,vz\n0,0,40,0,0,0,0,0\n0.1,0,40,0,0,0,0,0\n");
  const auto error = [&](const std::string& autopilot) {
    return run_avo({"convert", csv, points, "--to", "set-points", "--scene", scene, "--autopilot",
                    autopilot})
        .err;
  };
  EXPECT_EQ(error("px4"), "");
  std::filesystem::remove(points);
  EXPECT_THAT(error("crazyflie"),
              HasSubstr("robot 0 at 0 s: position.0: found 40, must be <= 32.767 m"));
  EXPECT_FALSE(std::filesystem::exists(points));
  EXPECT_THAT(
      error("px"),
      HasSubstr("--autopilot: found px, did you mean \"px4\"? Must be one of px4, crazyflie"));
  EXPECT_THAT(run_avo({"convert", csv, points, "--autopilot", "px4"}).err,
              HasSubstr("--autopilot: found without --to set-points"));
}

TEST(QuadrotorScenes, convert_refuses_what_gives_no_set_points) {
  const std::string scene = path_of("drones.yaml"), csv = path_of("drones.csv"),
                    points = path_of("points.csv");
  write_file(scene, kQuadrotors);
  const auto error = [&](const std::string& rows) {
    write_file(csv, "time,robot,x,y,z,vx,vy,vz\n" + rows);
    const ProcessResult result =
        run_avo({"convert", csv, points, "--to", "set-points", "--scene", scene});
    EXPECT_NE(result.exit_code, 0);
    return result.err;
  };
  EXPECT_THAT(error("0,0,0,0,0,0,0,0\n"),
              HasSubstr("found 1 robots, must be 5, those of the scene"));
  EXPECT_THAT(error("0.1,0,0,0,0,0,0,0\n"), HasSubstr("found the time 0.1 s, must be 0 s"));
  write_file(scene,
             "version: 1\nspace: 3\nrobots:\n  - {position: [0, 0, 0], goal: [1, 0, 0], quadrotor: "
             "{mass: 1, max_thrust: 20, max_tilt: 0.5, attitude_time: 0.1}}\n");
  EXPECT_THAT(error("0,0,0,0,0,0,0,0\n0.1,0,1,0,0,0,0,0\n"),
              HasSubstr("found robot 0 1 m off its velocities"));
  EXPECT_THAT(error("0,0,0,0,0,0,0,0\n"), HasSubstr("must be two at least"));
  write_file(scene, "version: 1\nspace: 3\nrobots:\n  - {position: [0, 0, 0], goal: [1, 0, 0]}\n");
  EXPECT_THAT(error("0,0,0,0,0,0,0,0\n"), HasSubstr("robots.0: found no quadrotor, must have one"));
  write_file(scene, "version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n");
  EXPECT_THAT(error(""), HasSubstr("must be given with --to set-points"));
  EXPECT_THAT(run_avo({"convert", csv, points, "--rate", "9"}).err,
              HasSubstr("--rate: found without --to set-points"));
}

TEST(QuadrotorScenes, bad_quadrotors_are_refused_by_place_and_allowed_values) {
  EXPECT_THAT(refused_quadrotors(quadrotors_with("mass: 1.2, ", "")),
              HasSubstr("groups.0.quadrotor: found no \"mass\""));
  EXPECT_THAT(refused_quadrotors(quadrotors_with("max_tilt: 0.6", "max_tilt: 1.6")),
              HasSubstr("groups.0.quadrotor.max_tilt: found 1.6, must be <= 1.5 rad"));
  EXPECT_THAT(refused_quadrotors(quadrotors_with("max_thrust: 26", "max_trust: 26")),
              HasSubstr("did you mean \"max_thrust\"?"));
  EXPECT_THAT(refused_quadrotors(quadrotors_with("max_thrust: 26", "max_thrust: 11")),
              HasSubstr("quadrotor.max_thrust: found 11, must be > 11.7679"));
  EXPECT_THAT(refused_quadrotors(quadrotors_with("    radius: 0.25", "    max_acceleration: 2")),
              HasSubstr("groups.0.max_acceleration: found 2, must be left out: the quadrotor"));
  EXPECT_THAT(refused_quadrotors(quadrotors_with("    radius: 0.25", "    vertical: 1.5")),
              HasSubstr("vertical: found 1.5, must be <= 1 of a quadrotor"));
  EXPECT_THAT(refused_quadrotors(quadrotors_with("    radius: 0.25", "    max_braking: 9")),
              HasSubstr("max_braking: found 9, must be <= 4.42"));
  EXPECT_THAT(
      refused_quadrotors(quadrotors_with("duration: 3", "duration: 3\nmotion: exponential")),
      HasSubstr("motion: found exponential, must be held"));
  write_file(path_of("drones.yaml"), kQuadrotors);
  EXPECT_THAT(
      run_avo({"validate", path_of("drones.yaml"), "--set", "robots.3.max_acceleration=1"}).err,
      HasSubstr("robots.3.max_acceleration: found 1, must be left out"));
}

}  // namespace
}  // namespace avo_test
