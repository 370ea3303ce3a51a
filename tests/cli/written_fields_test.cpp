// SPDX-License-Identifier: Apache-2.0
// C's header, Python's stub, TypeScript's types and the document of scenes are written by hand.
// They have every field of the table: what is missing is printed as the line that it has to be.
#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

#include "fields/model_fields.h"
#include "fields/robot_fields.h"
#include "fields/scene_fields.h"
#include "run_avo.h"

namespace avo_test {
namespace {

using avo::for_each_member;

/// The names of a value's type.
struct Types {
  std::string_view c;
  std::string_view attribute = {}, argument = {}, script = {};  // of robots
};
template <class Value>
inline constexpr Types kTypes{};
template <>
inline constexpr Types kTypes<double>{"double", "_Number", "_Float", "number"};
template <>
inline constexpr Types kTypes<std::optional<double>>{"double", "_NumberOrNone", "_Float | None",
                                                     "number"};
template <>
inline constexpr Types kTypes<avo::Vec2>{"avo_vec2", "_Point", "_Pair", "[number, number]"};
template <>
inline constexpr Types kTypes<bool>{"bool", "bool", "bool", "boolean"};
template <>
inline constexpr Types kTypes<avo::LayerSet>{"uint32_t", "_Layers", "Sequence[int]", "number[]"};
template <>
inline constexpr Types kTypes<avo::Behavior>{"avo_behavior", "_RobotBehavior", "_RobotBehavior",
                                             R"("decides" | "cooperates" | "moves_on")"};
template <>
inline constexpr Types kTypes<std::optional<avo::Method>>{"int32_t", "_Method | None",
                                                          "_Method | None", "string"};
template <>
inline constexpr Types kTypes<avo::AccelerationSet>{"avo_acceleration_set", "", "",
                                                    R"("incircle" | "exact")"};
template <>
inline constexpr Types kTypes<avo::AfterGoal>{"avo_after_goal", "", "", R"("loiter" | "leave")"};
template <>
inline constexpr Types kTypes<int>{"int32_t"};
template <>
inline constexpr Types kTypes<std::optional<int>>{"int32_t"};
template <>
inline constexpr Types kTypes<std::optional<bool>>{"int32_t"};
template <>
inline constexpr Types kTypes<std::uint64_t>{"uint64_t"};
template <>
inline constexpr Types kTypes<std::string>{"const char*"};
template <>
inline constexpr Types kTypes<avo::Method>{"avo_method"};
template <>
inline constexpr Types kTypes<std::optional<avo::Certificate>>{"avo_certificate"};
template <>
inline constexpr Types kTypes<avo::Motion>{"avo_motion"};
template <>
inline constexpr Types kTypes<avo::RightOfWay>{"avo_right_of_way"};
template <>
inline constexpr Types kTypes<avo::Clock>{"avo_clock"};
template <>
inline constexpr Types kTypes<avo::NoiseDistribution>{"avo_noise_distribution"};
template <>
inline constexpr Types kTypes<std::vector<avo::Vec2>>{"const avo_vec2*"};
template <>
inline constexpr Types kTypes<std::vector<avo::TimedPlace>>{"const avo_timed_place*"};

template <class T, class Value>
constexpr const Types& types_of(Value T::*) {
  return kTypes<Value>;
}

/// The lines of a file, without the spaces in front of them, after the one that begins so and
/// before the next one that begins with `end`.
class Part {
 public:
  Part(std::string path, const std::string& begin, const std::string& end)
      : path_(std::move(path)) {
    bool is_inside = false;
    for (const std::string& line : lines_of(path_)) {
      if (is_inside && line.starts_with(end)) break;
      if (is_inside)
        lines_.push_back(line.substr(std::min(line.size(), line.find_first_not_of(' '))));
      is_inside = is_inside || line.starts_with(begin);
    }
    EXPECT_FALSE(lines_.empty()) << path_ << " has no line " << begin;
  }

  /// Also where it goes on in the next line.
  void expect_text(const std::string& text) const {
    std::string joined;
    for (const std::string& line : lines_) joined.append(line).append(" ");
    EXPECT_NE(joined.find(text), std::string::npos) << path_ << " has no line\n  " << text;
  }
  void expect(const std::string& line) const {
    EXPECT_TRUE(std::any_of(lines_.begin(), lines_.end(),
                            [&](const std::string& own) { return own.starts_with(line); }))
        << path_ << " has no line\n  " << line;
  }

 private:
  static std::vector<std::string> lines_of(const std::string& path) {
    std::vector<std::string> lines{""};
    for (const char letter : read_file(std::string(AVO_SOURCE) + "/" + path))
      if (letter == '\n')
        lines.emplace_back();
      else
        lines.back().push_back(letter);
    return lines;
  }

  std::string path_;
  std::vector<std::string> lines_;
};

template <class Table>
void expect_in_c(const Table& table, const std::string& name) {
  const Part part("bindings/c/include/avo_c/avo.h", "typedef struct " + name + " {", "}");
  for_each_member(table, [&](const auto& field, auto member) {
    part.expect(fmt::format("{} {};", types_of(member).c, field.key));
  });
}

TEST(WrittenFields, definitions_of_c_have_them) {
  expect_in_c(avo::kRobotFields, "avo_robot_def");
  expect_in_c(avo::kCarFields, "avo_car");
  expect_in_c(avo::kCarBodyFields, "avo_car_body");
  expect_in_c(avo::kDriveFields, "avo_differential_drive");
  expect_in_c(avo::kAirplaneFields, "avo_airplane");
  expect_in_c(avo::kMoverFields, "avo_moving_obstacle_def");
  expect_in_c(avo::kScenarioFields, "avo_simulation_def");
  expect_in_c(avo::kSensingFields, "avo_sensing_model");
  expect_in_c(avo::kMeasurementNoiseFields, "avo_measurement_noise");
  expect_in_c(avo::kLocalizationNoiseFields, "avo_localization_noise");
  expect_in_c(avo::kExecutionFields, "avo_execution_model");
}

// A member that is not in the list is neither read nor written.
TEST(WrittenFields, c_takes_them_both_ways) {
  const Part robots("bindings/c/robots.cpp", "constexpr auto for_each_member", "}");
  for_each_member(avo::kRobotFields, [&](const auto& field, auto) {
    robots.expect_text(fmt::format("visit(\"{0}\", &Def::{0}, &Setup::{0});", field.key));
  });
  const Part settings("bindings/c/worlds.cpp", "constexpr auto for_each_setting", "}");
  for_each_member(avo::kScenarioFields, [&](const auto& field, auto) {
    const bool is_own =  // a text, or a number of which 0 is a value
        field.key == "name" || field.key == "external_method" || field.key == "response_time" ||
        field.key == "execution_error";
    if (!is_own)
      settings.expect_text(fmt::format("visit(\"{0}\", &Def::{0}, &Scene::{0});", field.key));
  });
  const Part movers("bindings/c/worlds.cpp", "constexpr auto for_each_of_mover", "}");
  for_each_member(avo::kMoverFields, [&](const auto& field, auto) {
    if (field.key != "path" && field.key != "trajectory")
      movers.expect_text(fmt::format("visit(\"{0}\", &Def::{0}, &Mover::{0});", field.key));
  });
}

TEST(WrittenFields, the_stub_of_python_has_them) {
  const std::string path = "bindings/python/avo/_avo.pyi";
  const Part setup(path, "class RobotSetup:", "@final");
  const Part change(path, "    def change_robot(", "    ) -> None");
  for_each_member(avo::kRobotFields, [&](const auto& field, auto member) {
    const Types& types = types_of(member);
    setup.expect(fmt::format("{}: {}", field.key, types.attribute));
    const bool is_none = field.key == "preferred_speed";  // by default max_speed
    setup.expect(fmt::format("{}: {}{}{}", field.key, types.argument, is_none ? " | None" : "",
                             field.need == avo::kRequired ? "," : " = "));
    const bool stays = field.key == "position" || field.key == "velocity" || field.key == "goal" ||
                       field.key == "time_step";
    if (!stays) change.expect(fmt::format("{}: {} = ...,", field.key, types.argument));
  });
}

template <class Table>
void expect_in_class(const Table& table, const std::string& name) {
  const Part part("bindings/python/avo/_avo.pyi", "class " + name + ":", "class ");
  for_each_member(table, [&](const auto& field, auto) {
    part.expect(fmt::format("def {}(self) -> ", field.key));
  });
}

TEST(WrittenFields, classes_of_python_have_them) {
  expect_in_class(avo::kCarFields, "Car");
  expect_in_class(avo::kDriveFields, "DifferentialDrive");
  expect_in_class(avo::kAirplaneFields, "Airplane");
  expect_in_class(avo::kMoverFields, "MovingObstacle");
}

template <class Table>
void expect_in_script(const Table& table, const std::string& name) {
  const Part part("lab/avo/types.ts", "export interface " + name + " {", "}");
  for_each_member(table, [&](const auto& field, auto member) {
    part.expect(fmt::format("{}{}: {};", field.key, field.need == avo::kRequired ? "" : "?",
                            types_of(member).script));
  });
}

TEST(WrittenFields, types_of_typescript_have_them) {
  expect_in_script(avo::kRobotFields, "RobotSetup");
  expect_in_script(avo::kCarFields, "Car");
  expect_in_script(avo::kCarBodyFields, "CarBody");
  expect_in_script(avo::kDriveFields, "DifferentialDrive");
  expect_in_script(avo::kAirplaneFields, "Airplane");
}

/// Whether the first cell of a row of some table names the key, or a block of code has it.
bool is_told(const std::string& document, std::string_view key) {
  std::size_t at = 0;
  while ((at = document.find(key, at)) != std::string::npos) {
    const std::size_t line = document.rfind('\n', at) + 1, cell = document.find(" | ", line);
    const std::string before = document.substr(line, at - line);
    const char after = document[at + key.size()];
    const bool in_row = before.starts_with("| ") && before.ends_with('`') && at < cell;
    if ((in_row && (after == '`' || after == ':')) || (before.empty() && after == ':')) return true;
    at += key.size();
  }
  return false;
}

template <class Table>
void expect_told(const Table& table, const std::string& document) {
  for (const auto& field : table)
    EXPECT_TRUE(is_told(document, field.key))
        << "docs/scenes.md has no row\n  "
        << fmt::format("| `{}` | {}: {} |", field.key, field.unit, field.doc);
}

TEST(WrittenFields, the_document_of_scenes_has_them) {
  const std::string document = read_file(std::string(AVO_SOURCE) + "/docs/scenes.md");
  expect_told(avo::kRobotFields, document);
  expect_told(avo::kCarFields, document);
  expect_told(avo::kDriveFields, document);
  expect_told(avo::kAirplaneFields, document);
  expect_told(avo::kMoverFields, document);
  expect_told(avo::kScenarioFields, document);
  expect_told(avo::kSensingFields, document);
}

}  // namespace
}  // namespace avo_test
