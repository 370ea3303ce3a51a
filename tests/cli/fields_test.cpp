// SPDX-License-Identifier: Apache-2.0
// The table of fields, the core's validation and the JSON Schema say the same.
#include "io/fields/fields.h"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <type_traits>

#include "avo/planner.h"
#include "avo_io/scene.h"
#include "avo_io/space.h"
#include "fields/model_fields.h"
#include "fields/planner_fields.h"
#include "fields/space_fields.h"
#include "io/text/words.h"
#include "support/json.h"
#include "support/refusal.h"

namespace avo_test {
namespace {

using avo::Scenario;
using avo::test::refusal;

Scenario valid_scenario() {
  Scenario scenario;
  scenario.robots.push_back({.position = {0, 0}, .velocity = {}, .goal = {1, 0}});
  scenario.robots[0].model = avo::Car{};
  scenario.moving_obstacles.push_back({.position = {5, 5}, .velocity = {}, .acceleration = {}});
  return scenario;
}

double next(double value, double towards) {
  return std::nextafter(value, towards);
}

/// Puts values at and just beyond the ends of a field's range into `target`, a part of what
/// `check_all` checks.
template <class Check, class T, class Value>
void check_ends(const Check& check_all, T& target, const avo::Field<T>& field, Value T::*member,
                double& number, const std::string& path) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Value before = target.*member;
  const auto refused = [&](double value) {
    number = value;
    const std::string message = refusal(check_all);
    target.*member = before;
    return message.starts_with(path + ": found ");
  };
  const avo::Range& range = field.range;
  EXPECT_TRUE(refused(next(range.max, infinity))) << path;
  EXPECT_TRUE(refused(next(range.min, -infinity))) << path;
  EXPECT_EQ(refused(range.min), range.open_min) << path;
  EXPECT_TRUE(refused(std::nan(""))) << path;
  EXPECT_TRUE(refused(infinity)) << path;
  EXPECT_TRUE(refused(-infinity)) << path;
}

/// Returns how many fields of the target have a range.
template <class Check, class T>
int check_ranges(const Check& check_all, T& target, const std::string& path) {
  int checked = 0;
  for_each_member(avo::kFields<T>, [&](const auto& field, auto member) {
    const std::string name = path + std::string(field.key);
    auto& value = target.*member;
    using Value = std::decay_t<decltype(value)>;
    ++checked;
    if constexpr (std::is_same_v<Value, double>) {
      check_ends(check_all, target, field, member, value, name);
    } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
      value.emplace(field.range.max);
      check_ends(check_all, target, field, member, *value, name);
      value.reset();
    } else if constexpr (std::is_same_v<Value, avo::Vec2> || std::is_same_v<Value, avo::Vec3>) {
      check_ends(check_all, target, field, member, value.x, name + ".0");
      check_ends(check_all, target, field, member, value.y, name + ".1");
      if constexpr (requires { value.z; })
        check_ends(check_all, target, field, member, value.z, name + ".2");
    } else {
      --checked;
    }
  });
  return checked;
}

TEST(Fields, ranges_are_those_of_validate) {
  Scenario scenario = valid_scenario();
  const auto check_all = [&] { validate(scenario); };
  ASSERT_EQ(refusal(scenario), "");
  EXPECT_EQ(check_ranges(check_all, scenario, ""), 11);
  EXPECT_GE(check_ranges(check_all, scenario.robots[0], "robots.0."), 12);
  EXPECT_EQ(check_ranges(check_all, std::get<avo::Car>(scenario.robots[0].model), "robots.0.car."),
            2);
  avo::CarBody& body = std::get<avo::Car>(scenario.robots[0].model).body.emplace();
  EXPECT_EQ(check_ranges(check_all, body, "robots.0.car.body."), 2);
  scenario.robots[0].model = avo::DifferentialDrive{};
  EXPECT_EQ(check_ranges(check_all, std::get<avo::DifferentialDrive>(scenario.robots[0].model),
                         "robots.0.drive."),
            4);
  EXPECT_EQ(check_ranges(check_all, scenario.moving_obstacles[0], "moving_obstacles.0."), 6);
  EXPECT_EQ(check_ranges(check_all, scenario.sensing, "sensing."), 1);
  EXPECT_EQ(check_ranges(check_all, scenario.sensing.noise, "sensing.noise."), 3);
  EXPECT_EQ(check_ranges(check_all, scenario.sensing.localization, "sensing.localization."), 2);
  EXPECT_EQ(check_ranges(check_all, scenario.sensing_error.emplace(), "sensing_error."), 2);
}

TEST(Fields, ranges_of_space_are_those_of_validate) {
  avo::space::Scenario scenario;
  scenario.robots.push_back({.goal = {1, 0, 0}});
  scenario.moving_obstacles.push_back({.position = {5, 5, 5}});
  scenario.boxes.push_back({.max = {avo::space::Box::kFar, avo::space::Box::kFar, -9}});
  const auto check_all = [&] { validate(scenario); };
  ASSERT_EQ(refusal(check_all), "");
  EXPECT_EQ(check_ranges(check_all, scenario, ""), 9);
  EXPECT_EQ(check_ranges(check_all, scenario.robots[0], "robots.0."), 13);
  EXPECT_EQ(check_ranges(check_all, scenario.robots[0].quadrotor.emplace(), "robots.0.quadrotor."),
            6);
  EXPECT_EQ(check_ranges(check_all, scenario.moving_obstacles[0], "moving_obstacles.0."), 6);
  EXPECT_EQ(check_ranges(check_all, scenario.boxes[0], "boxes.0."), 2);
  EXPECT_EQ(check_ranges(check_all, scenario.sensing.noise, "sensing.noise."), 3);
  EXPECT_EQ(check_ranges(check_all, scenario.sensing_error.emplace(), "sensing_error."), 2);
  scenario.max_neighbors = 0;
  EXPECT_EQ(refusal(check_all), "max_neighbors: found 0, must be >= 1");
}

TEST(Fields, ranges_of_options_are_those_of_planners) {
  avo::PlannerOptions options;
  const auto make = [&] { avo::Planner{options}; };
  ASSERT_EQ(refusal(make), "");
  EXPECT_EQ(check_ranges(make, options, "PlannerOptions."), 10);
  EXPECT_EQ(check_ranges(make, options.sensing_error, "PlannerOptions.sensing_error."), 2);
  EXPECT_EQ(check_ranges(make, options.sensing_noise, "PlannerOptions.sensing_noise."), 3);
  options.max_neighbors = 0;
  EXPECT_EQ(refusal(make), "PlannerOptions.max_neighbors: found 0, must be >= 1");
}

TEST(Fields, whole_numbers_have_the_ranges_of_validate) {
  Scenario scenario = valid_scenario();
  EXPECT_EQ(refusal(scenario), "");
  scenario.max_neighbors = 0;
  EXPECT_EQ(refusal(scenario), "max_neighbors: found 0, must be >= 1");
  scenario.max_neighbors = 1;
  EXPECT_EQ(refusal(scenario), "");
  scenario.sensing.delay = -1;
  EXPECT_EQ(refusal(scenario), "sensing.delay: found -1, must be >= 0 steps");
  scenario.sensing.delay = 101;
  EXPECT_EQ(refusal(scenario), "sensing.delay: found 101, must be <= 100 steps");
  scenario.sensing.delay = 100;
  EXPECT_EQ(refusal(scenario), "");
}

std::string refusal_of_text(const std::string& yaml) {
  try {
    if (yaml.find("space: 3") != std::string::npos)
      avo_io::parse_space_scenario(yaml, "f");
    else
      avo_io::parse_scenario(yaml, "f");
  } catch (const avo_io::SceneError& error) {
    return error.what();
  }
  return "";
}

const std::string kRobots = "robots: [{position: [0, 0], goal: [1, 0]}]\n";

/// One misspelling and one repetition of every key of a map that opens with `before`.
template <class T>
void check_misspellings(const std::vector<avo_io::Field<T>>& table, const std::string& before,
                        const std::string& after) {
  for (const auto& field : table) {
    const std::string key(field.key);
    const std::string wrong = key.substr(0, key.size() - 1) + (key.ends_with('x') ? "y" : "x");
    const std::string unknown = refusal_of_text(before + wrong + ": 1" + after);
    EXPECT_NE(
        unknown.find("found the unknown key \"" + wrong + "\", did you mean \"" + key + "\"?"),
        std::string::npos)
        << unknown;
    const std::string twice = refusal_of_text(before + key + ": 1, " + key + ": 1" + after);
    EXPECT_NE(twice.find("found the key \"" + key + "\" twice"), std::string::npos) << twice;
  }
}

TEST(Fields, every_key_is_guessed_and_refused_twice) {
  check_misspellings(avo_io::fields<Scenario>(), "{", "}");
  check_misspellings(avo_io::fields<avo::RobotSetup>(), "{version: 1, robots: [{", "}]}");
  check_misspellings(avo_io::fields<avo::MovingObstacle>(), "{version: 1, moving_obstacles: [{",
                     "}]}");
  check_misspellings(avo_io::fields<avo::Airplane>(),
                     "{version: 1, robots: [{position: [0, 0], goal: [1, 0], airplane: {", "}}]}");
  check_misspellings(avo_io::fields<avo::Car>(),
                     "{version: 1, robots: [{position: [0, 0], goal: [1, 0], car: {", "}}]}");
  check_misspellings(avo_io::fields<avo::DifferentialDrive>(),
                     "{version: 1, robots: [{position: [0, 0], goal: [1, 0], drive: {", "}}]}");
  check_misspellings(avo_io::fields<avo_io::Group>(), "{version: 1, groups: [{", "}]}");
  check_misspellings(avo_io::fields<avo_io::RobotsFrom>(), "{version: 1, robots_from: {", "}}");
  check_misspellings(avo_io::fields<avo::SensingModel>(), "{version: 1, sensing: {", "}}");
  check_misspellings(avo_io::fields<avo::MeasurementNoise>(), "{version: 1, sensing: {noise: {",
                     "}}}");
  check_misspellings(avo_io::fields<avo::LocalizationNoise>(),
                     "{version: 1, sensing: {localization: {", "}}}");
  check_misspellings(avo_io::fields<avo::SensingError>(), "{version: 1, sensing_error: {", "}}");
  check_misspellings(avo_io::fields<avo::Disc>(), "{version: 1, obstacles: [{disc: {", "}}]}");
  const std::string space = "{version: 1, space: 3, ",
                    robot = "position: [0, 0, 0], goal: [1, 0, 0]";
  check_misspellings(avo_io::fields<avo::space::RobotSetup>(), space + "robots: [{", "}]}");
  check_misspellings(avo_io::fields<avo::space::MovingObstacle>(), space + "moving_obstacles: [{",
                     "}]}");
  check_misspellings(avo_io::fields<avo::space::Quadrotor>(),
                     space + "robots: [{" + robot + ", quadrotor: {", "}}]}");
  check_misspellings(avo_io::fields<avo_io::SpaceGroup>(), space + "groups: [{", "}]}");
}

TEST(Fields, every_default_is_that_of_the_struct) {
  const Scenario defaults;
  const Scenario scenario =
      avo_io::parse_scenario("version: 1\nduration: 60\n" + kRobots, "a.yaml");
  EXPECT_EQ(scenario.name, "a");
  EXPECT_EQ(scenario.time_step, defaults.time_step);
  EXPECT_EQ(scenario.control_time, std::nullopt);
  EXPECT_EQ(scenario.response_time, std::nullopt);
  EXPECT_EQ(scenario.comfort_acceleration, std::nullopt);
  EXPECT_EQ(scenario.comfort_jerk, std::nullopt);
  EXPECT_EQ(scenario.margin, 0.0);
  EXPECT_EQ(scenario.never_swerves, false);
  EXPECT_EQ(scenario.time_horizon, std::nullopt);
  EXPECT_EQ(scenario.sensing_radius, std::nullopt);
  EXPECT_EQ(scenario.max_neighbors, std::nullopt);
  EXPECT_EQ(scenario.method, avo::Method::avo);
  EXPECT_EQ(scenario.certificate, std::nullopt);
  EXPECT_EQ(scenario.motion, avo::Motion::held);
  EXPECT_EQ(scenario.arrival_distance, 0.5);
  EXPECT_EQ(scenario.seed, 1U);
  EXPECT_EQ(scenario.robots[0].radius, 0.5);
  EXPECT_EQ(scenario.robots[0].max_speed, 2.0);
  EXPECT_EQ(scenario.robots[0].max_acceleration, 1.0);
  EXPECT_EQ(scenario.robots[0].preferred_speed, 2.0);
  EXPECT_TRUE(is_holonomic(scenario.robots[0].model));
}

TEST(Fields, every_value_of_the_contract_arrives) {
  const Scenario scenario = avo_io::parse_scenario(R"yaml(version: 1
name: two robots
time_step: 0.2
duration: 61
control_time: 3        # delta
time_horizon: 9        # tau
sensing_radius: 14
max_neighbors: 8
method: orca
motion: exponential
arrival_distance: 0.25
seed: 18446744073709551615
robots:
  - {position: [-10, 1], velocity: [0.5, 0.25], goal: [10, 2], radius: 0.4, max_speed: 3, max_acceleration: 0.75, preferred_speed: 1.5, priority: 4, arrival_distance: 0.125, layers: [1, 31], avoids: [0, 2]}
  - {position: [+1.0e+1, -.5], goal: [-10, 0], max_speed: 1.25, car: {wheelbase: 0.7, heading: 3.}}
moving_obstacles:
  - {position: [0, 5], velocity: [0, -0.5], acceleration: [0.125, 0], radius: 0.6}
)yaml",
                                                   "f.yaml");
  EXPECT_EQ(scenario.name, "two robots");
  EXPECT_EQ(scenario.time_step, 0.2);
  EXPECT_EQ(scenario.duration, 61.0);
  EXPECT_EQ(scenario.control_time, 3.0);
  EXPECT_EQ(scenario.time_horizon, 9.0);
  EXPECT_EQ(scenario.sensing_radius, 14.0);
  EXPECT_EQ(scenario.max_neighbors, 8);
  EXPECT_EQ(scenario.method, avo::Method::orca);
  EXPECT_EQ(scenario.motion, avo::Motion::exponential);
  EXPECT_EQ(scenario.arrival_distance, 0.25);
  EXPECT_EQ(scenario.seed, 18446744073709551615U);
  ASSERT_EQ(scenario.robots.size(), 2U);
  const avo::RobotSetup& first = scenario.robots[0];
  EXPECT_EQ(first.position, (avo::Vec2{-10, 1}));
  EXPECT_EQ(first.velocity, (avo::Vec2{0.5, 0.25}));
  EXPECT_EQ(first.goal, (avo::Vec2{10, 2}));
  EXPECT_EQ(first.radius, 0.4);
  EXPECT_EQ(first.max_speed, 3.0);
  EXPECT_EQ(first.max_acceleration, 0.75);
  EXPECT_EQ(first.preferred_speed, 1.5);
  EXPECT_EQ(first.priority, 4.0);
  EXPECT_EQ(first.arrival_distance, 0.125);
  EXPECT_EQ(first.layers.bits, 0x80000002U);
  EXPECT_EQ(first.avoids.bits, 5U);
  const avo::RobotSetup& second = scenario.robots[1];
  EXPECT_EQ(second.position, (avo::Vec2{10, -0.5}));
  EXPECT_EQ(second.priority, 1.0);
  EXPECT_EQ(second.layers.bits, 1U);
  EXPECT_EQ(second.avoids.bits, 0xffffffffU);
  EXPECT_FALSE(is_parked(second));
  EXPECT_EQ(second.preferred_speed, 1.25) << "max_speed where it is left out";
  ASSERT_FALSE(is_holonomic(second.model));
  EXPECT_EQ(std::get<avo::Car>(second.model).wheelbase, 0.7);
  EXPECT_EQ(second.heading, 3.0);
  ASSERT_EQ(scenario.moving_obstacles.size(), 1U);
  EXPECT_EQ(scenario.moving_obstacles[0].velocity, (avo::Vec2{0, -0.5}));
  EXPECT_EQ(scenario.moving_obstacles[0].acceleration, (avo::Vec2{0.125, 0}));
  EXPECT_EQ(scenario.moving_obstacles[0].radius, 0.6);
}

TEST(Fields, of_robots_beside_movers_and_of_those_who_cooperate) {
  const Scenario scenario = avo_io::parse_scenario(
      "version: 1\nnever_swerves: true\nrobots:\n"
      "  - {position: [0, 0], goal: [9, 0], behavior: cooperates}\n"
      "  - {position: [0, 9], goal: [9, 9], behavior: decides}\n"
      "groups:\n  - {number: 2, behavior: cooperates, placement: {grid: {corner: [0, 20], spacing: "
      "3, columns: 2}}, goals: "
      "{offset: {by: [9, 0]}}}\n",
      "f");
  EXPECT_TRUE(scenario.never_swerves);
  EXPECT_TRUE(planner_options(scenario).never_swerves);
  EXPECT_EQ(scenario.robots[0].behavior, avo::Behavior::cooperates);
  EXPECT_EQ(scenario.robots[1].behavior, avo::Behavior::decides);
  EXPECT_EQ(scenario.robots[3].behavior, avo::Behavior::cooperates);
}

TEST(Fields, parked_is_short_for_a_behavior) {
  const std::string text =
      "version: 1\nrobots:\n"
      "  - {position: [0, 0], goal: [0, 0], parked: true}\n"
      "  - {position: [0, 9], goal: [0, 9], behavior: parked}\n"
      "  - {position: [0, 18], goal: [0, 18], behavior: parked, parked: true}\n"
      "  - {position: [0, 27], goal: [0, 27], behavior: moves_on, parked: false}\n"
      "groups:\n  - {number: 2, parked: true, placement: {line: {from: [9, 0], to: [9, 9]}}, "
      "goals: "
      "{offset: {by: [0, 0]}}}\n";
  const auto behaviors = [&](const std::vector<std::string>& overrides) {
    std::string words;
    for (const avo::RobotSetup& robot : avo_io::parse_scenario(text, "f", overrides).robots)
      words += std::string(to_string(robot.behavior)) + " ";
    return words;
  };
  EXPECT_EQ(behaviors({}), "parked parked parked moves_on parked parked ");
  EXPECT_EQ(behaviors({"robots.0.parked=false", "robots.4.parked=false"}),
            "decides parked parked moves_on decides parked ");
  EXPECT_EQ(behaviors({"robots.5.behavior=cooperates", "groups.0.parked=false"}),
            "parked parked parked moves_on decides cooperates ");
}

TEST(Fields, how_gently_robots_move_is_of_method_avo_alone) {
  const std::string keys =
      "response_time: 0.2\ncomfort_acceleration: 0.6\ncomfort_jerk: 1.5\nmargin: 0.1\n";
  const Scenario scenario = avo_io::parse_scenario("version: 1\n" + keys + kRobots, "f");
  EXPECT_EQ(scenario.response_time, 0.2);
  EXPECT_EQ(scenario.comfort_acceleration, 0.6);
  EXPECT_EQ(scenario.comfort_jerk, 1.5);
  const avo::PlannerOptions options = planner_options(scenario);
  EXPECT_EQ(options.response_time, 0.2);
  EXPECT_EQ(options.comfort_acceleration, 0.6);
  EXPECT_EQ(options.comfort_jerk, 1.5);
  EXPECT_EQ(options.margin, 0.1);
  const std::string start = "version: 1\n" + kRobots;
  EXPECT_EQ(refusal_of_text(start + "response_time: -0.1\n"),
            "f:3:16: response_time: found -0.1, must be >= 0");
  EXPECT_EQ(refusal_of_text(start + "comfort_acceleration: 0\n"),
            "f:3:23: comfort_acceleration: found 0, must be > 0 m/s^2");
  EXPECT_EQ(refusal_of_text(start + "comfort_jerk: 0\n"),
            "f:3:15: comfort_jerk: found 0, must be > 0 m/s^3");
  EXPECT_EQ(refusal_of_text(start + "margin: -0.1\n"), "f:3:9: margin: found -0.1, must be >= 0 m");
  const std::string orca = "version: 1\nmethod: orca\n" + kRobots;
  EXPECT_EQ(refusal_of_text(orca + "response_time: 0.1\n"),
            "f:4:16: response_time: found 0.1, must be 0 with method orca");
  EXPECT_EQ(refusal_of_text(orca + "response_time: 0\n"), "");
  EXPECT_EQ(refusal_of_text(orca + "comfort_acceleration: 0.5\n"),
            "f:4:23: comfort_acceleration: found 0.5, must be none with method orca");
  EXPECT_EQ(refusal_of_text(orca + "comfort_jerk: 2\n"),
            "f:4:15: comfort_jerk: found 2, must be none with method orca");
  EXPECT_EQ(refusal_of_text(orca + "margin: 0.1\n"),
            "f:4:9: margin: found 0.1, must be 0 m with method orca");
}

TEST(Fields, a_drive_has_limits_of_its_wheels_where_none_are_given) {
  const Scenario scenario = avo_io::parse_scenario(R"yaml(version: 1
robots:
  - {position: [0, 6], goal: [9, 6], model: differential_drive, heading: 0.5, drive: {track: 0.4, offset: 0.2, wheel_speed: 1.25, wheel_acceleration: 2}, radius: 0.3}
  - {position: [0, 9], goal: [9, 6], drive: {}, max_speed: 0.5, max_acceleration: 0.25}
)yaml",
                                                   "f.yaml");
  const avo::RobotSetup& robot = scenario.robots[0];
  const avo::DifferentialDrive expected{0.4, 0.2, 1.25, 2.0};
  EXPECT_EQ(robot.model, avo::MotionModel(expected));
  EXPECT_EQ(robot.heading, 0.5);
  EXPECT_EQ(robot.radius, 0.3);
  EXPECT_EQ(disc_radius(robot), 0.5);
  EXPECT_EQ(robot.max_speed, 1.25);
  EXPECT_EQ(robot.preferred_speed, 1.25);
  EXPECT_EQ(robot.max_acceleration, 0.5 * most_acceleration(expected));
  EXPECT_EQ(scenario.robots[1].model, avo::MotionModel(avo::DifferentialDrive{}));
  EXPECT_EQ(scenario.robots[1].max_speed, 0.5);
  EXPECT_EQ(scenario.robots[1].preferred_speed, 0.5);
  EXPECT_EQ(scenario.robots[1].max_acceleration, 0.25);
}

TEST(Fields, a_small_drive_plans_for_a_point_near_its_axle) {
  const Scenario scenario = avo_io::parse_scenario(R"yaml(version: 1
robots:
  - {position: [0, 0], goal: [9, 0], radius: 0.1, model: differential_drive}
  - {position: [0, 1], goal: [9, 1], radius: 0.1, drive: {track: 0.16, wheel_speed: 0.5}}
  - {position: [0, 2], goal: [9, 2], radius: 0.2, drive: {track: 0.16}}
  - {position: [0, 3], goal: [9, 3], radius: 0.1, drive: {track: 0.16, offset: 0.2}}
groups:
  - number: 1
    radius: 0.1
    drive: {}
    placement: {line: {from: [0, 4], to: [0, 5]}}
    goals: {offset: {by: [9, 0]}}
)yaml",
                                                   "f.yaml");
  const auto offset_of = [&](std::size_t k) {
    return std::get<avo::DifferentialDrive>(scenario.robots[k].model).offset;
  };
  EXPECT_EQ(offset_of(0), 0.05);
  EXPECT_EQ(offset_of(1), 0.05);
  EXPECT_EQ(offset_of(2), 0.08);
  EXPECT_EQ(offset_of(3), 0.2);  // where the scene says so
  EXPECT_EQ(offset_of(4), 0.05);
  EXPECT_EQ(disc_radius(scenario.robots[0]), 0.1 + 0.05);
  const avo::RobotSetup& own = scenario.robots[1];
  EXPECT_EQ(own.max_acceleration,
            0.5 * most_acceleration(std::get<avo::DifferentialDrive>(own.model)));
  EXPECT_EQ((avo::DifferentialDrive{.track = 0.16}.offset), 0.08);
  EXPECT_EQ(avo::DifferentialDrive{}.offset, 0.2);
}

TEST(Fields, sensing_says_how_lost_robots_are) {
  const Scenario scenario = avo_io::parse_scenario(
      "version: 1\nsensing: {localization: {position: 0.03, distribution: uniform}}\n"
      "robots: [{position: [0, 0], goal: [9, 0]}]\n",
      "f");
  EXPECT_EQ(scenario.sensing.localization.position, 0.03);
  EXPECT_EQ(scenario.sensing.localization.distribution, avo::NoiseDistribution::uniform);
  EXPECT_EQ(scenario.sensing.noise, avo::MeasurementNoise{});
}

TEST(Fields, doubles_arrive_bit_by_bit_and_without_minus_zero) {
  for (const char* text : {"0.1", "1.7976931348623157e+1", "4.9406564584124654e-324", "123456789.1",
                           "0.30000000000000004", "2.2250738585072011e-308"}) {
    const Scenario scenario = avo_io::parse_scenario(
        fmt::format("version: 1\nduration: 60\nrobots: [{{position: [{}, -0], goal: [1, 0]}}]\n",
                    text),
        "f");
    EXPECT_EQ(fmt::format("{:.17g}", scenario.robots[0].position.x),
              fmt::format("{:.17g}", std::strtod(text, nullptr)));
    EXPECT_FALSE(std::signbit(scenario.robots[0].position.y));
  }
}

TEST(Fields, quotes_make_a_text_of_anything) {
  for (const std::string name : {"null", "~", "1", ".nan", "true"})
    EXPECT_EQ(avo_io::parse_scenario("version: 1\nname: \"" + name + "\"\n" + kRobots, "f").name,
              name);
}

TEST(Fields, the_first_of_equally_near_words_is_meant) {
  EXPECT_EQ(avo_io::nearest("mix", {"min", "max"}), "min");
  EXPECT_EQ(avo_io::nearest("mix", {"max", "min"}), "max");
  EXPECT_EQ(avo_io::nearest("completely", {"min", "max"}), std::nullopt);
}

TEST(Fields, comments_bom_crlf_and_markers_do_no_harm) {
  const Scenario plain = avo_io::parse_scenario("version: 1\n" + kRobots, "f");
  for (const std::string& text :
       {"\xEF\xBB\xBFversion: 1\r\n# comment\r\n" + kRobots,
        "---\nversion: 1\n" + kRobots + "...\n", "%YAML 1.2\n---\nversion: 1\n" + kRobots,
        "version: 1\n" + kRobots + "\n\n  \n"}) {
    EXPECT_EQ(avo_io::parse_scenario(text, "f").robots[0].goal, plain.robots[0].goal) << text;
  }
}

TEST(Fields, schema_has_every_field_with_range_and_default) {
  const auto all = nlohmann::ordered_json::parse(avo_io::scenario_schema());
  EXPECT_EQ(all["$schema"], "https://json-schema.org/draft/2020-12/schema");
  const auto& schema = all["else"];
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_EQ(schema["properties"].size(), avo_io::fields<Scenario>().size());
  EXPECT_EQ(schema["properties"]["control_time"]["exclusiveMinimum"], 0.0);
  EXPECT_FALSE(schema["properties"]["control_time"].contains("default")) << "that of the method";
  EXPECT_FALSE(schema["properties"]["sensing_radius"].contains("default")) << "that of the robots";
  EXPECT_FALSE(schema["properties"].contains("precision")) << "it was removed";
  EXPECT_EQ(schema["properties"]["version"]["const"], 1);
  EXPECT_FALSE(schema["properties"]["duration"].contains("default"));
  EXPECT_EQ(schema["required"], nlohmann::ordered_json({"version"}));
  const auto& robot = all["$defs"]["robot"];
  EXPECT_EQ(robot["required"], nlohmann::ordered_json({"position", "goal"}));
  EXPECT_EQ(robot["additionalProperties"], false);
  for (const auto& field : avo_io::fields<avo::RobotSetup>()) {
    const auto& property = robot["properties"][std::string(field.key)];
    EXPECT_NE(property["description"].get<std::string>().find(field.doc), std::string::npos);
  }
  EXPECT_EQ(robot["properties"]["goal"]["minItems"], 2);
  EXPECT_EQ(all["$defs"]["group"]["properties"]["goals"]["oneOf"][0]["enum"],
            nlohmann::ordered_json({"antipodal", "permutation"}));
}

template <class T>
void expect_in_schema(const nlohmann::ordered_json& part) {
  EXPECT_EQ(part["additionalProperties"], false);
  for (const auto& field : avo_io::fields<T>())
    EXPECT_TRUE(part["properties"].contains(std::string(field.key))) << field.key;
}

TEST(Fields, the_schema_has_the_fields_of_space) {
  const auto all = nlohmann::ordered_json::parse(avo_io::scenario_schema());
  EXPECT_EQ(all["if"]["properties"]["space"]["const"], 3);
  EXPECT_EQ(all["then"]["$ref"], "#/$defs/space");
  const auto& parts = all["$defs"];
  expect_in_schema<avo::space::Scenario>(parts["space"]);
  expect_in_schema<avo::space::RobotSetup>(parts["space_robot"]);
  expect_in_schema<avo::space::Quadrotor>(parts["space_robot"]["properties"]["quadrotor"]);
  expect_in_schema<avo::space::MovingObstacle>(parts["space_moving_obstacle"]);
  expect_in_schema<avo_io::SpaceGroup>(parts["space_group"]);
  for (const auto& [key, value] : parts["space_robot"]["properties"].items())
    EXPECT_EQ(parts["space_group"]["properties"].contains(key), key != "position") << key;
  EXPECT_EQ(parts["space_robot"]["properties"]["goal"]["minItems"], 3);
  EXPECT_EQ(parts["space_obstacle"]["oneOf"].size(), 3 + parts["obstacle"]["oneOf"].size());
  for (const auto& form : parts["space_obstacle"]["oneOf"])
    EXPECT_EQ(form["properties"].contains("height"), form["required"][0] != "floor" &&
                                                         form["required"][0] != "ceiling" &&
                                                         form["required"][0] != "box");
}

}  // namespace
}  // namespace avo_test
