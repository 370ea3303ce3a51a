// SPDX-License-Identifier: Apache-2.0
// C's header, and most of Python's stubs, TypeScript's types and the documents, are written by hand.
// They have every field of the table: what is missing is printed as the line that it has to be.
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "field_types.h"
#include "fields/model_fields.h"
#include "fields/planner_fields.h"
#include "fields/robot_fields.h"
#include "fields/scene_fields.h"
#include "fields/space_fields.h"
#include "run_avo.h"

namespace avo_test {
namespace {

using avo::for_each_member;

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

/// Whether the definition of C has the key: a simulation of space runs without end, and it has
/// neither what is random nor moving obstacles.
template <class T>
bool has_c(std::string_view key) {
  constexpr std::array<std::string_view, 4> kNotInSpace{"name", "duration", "seed",
                                                        "never_swerves"};
  return !std::is_same_v<T, avo::space::Scenario> ||
         std::find(kNotInSpace.begin(), kNotInSpace.end(), key) == kNotInSpace.end();
}

template <class T>
void expect_in_c(const std::string& name, const std::string& header = "avo.h") {
  const Part part("bindings/c/include/avo_c/" + header, "typedef struct " + name + " {", "}");
  for_each_member(avo::kFields<T>, [&](const auto& field, auto member) {
    if (has_c<T>(field.key)) part.expect(fmt::format("{} {};", types_of(member).c, field.key));
  });
}

TEST(WrittenFields, definitions_of_c_have_them) {
  expect_in_c<avo::RobotSetup>("avo_robot_def");
  expect_in_c<avo::Car>("avo_car");
  expect_in_c<avo::CarBody>("avo_car_body");
  expect_in_c<avo::DifferentialDrive>("avo_differential_drive");
  expect_in_c<avo::Airplane>("avo_airplane");
  expect_in_c<avo::MovingObstacle>("avo_moving_obstacle_def");
  expect_in_c<avo::Scenario>("avo_simulation_def");
  expect_in_c<avo::SensingModel>("avo_sensing_model");
  expect_in_c<avo::MeasurementNoise>("avo_measurement_noise");
  expect_in_c<avo::LocalizationNoise>("avo_localization_noise");
  expect_in_c<avo::ExecutionModel>("avo_execution_model");
  expect_in_c<avo::PlannerOptions>("avo_planner_def");
  expect_in_c<avo::SensingNoise>("avo_sensing_noise");
  expect_in_c<avo::space::RobotSetup>("avo_space_robot_def", "space.h");
  expect_in_c<avo::space::Quadrotor>("avo_quadrotor", "space.h");
  expect_in_c<avo::space::Box>("avo_space_box", "space.h");
  expect_in_c<avo::space::Scenario>("avo_space_simulation_def", "space.h");
}

/// A file of bindings/c that takes the fields of T by a list of that name, but for `others`.
template <class T>
void expect_taken(const std::string& file, const std::string& list, const std::string& own,
                  const std::vector<std::string_view>& others = {}) {
  const Part part("bindings/c/" + file, "constexpr auto " + list + " =", "}");
  for_each_member(avo::kFields<T>, [&](const auto& field, auto) {
    const bool is_other = std::find(others.begin(), others.end(), field.key) != others.end();
    if (!is_other && has_c<T>(field.key))
      part.expect_text(fmt::format("visit(\"{0}\", &Def::{0}, &{1}::{0}", field.key, own));
  });
}

// A member that is not in the list is neither read nor written.
TEST(WrittenFields, c_takes_them_both_ways) {
  expect_taken<avo::Scenario>("worlds.cpp", "for_each_setting", "Scene",
                              {"name", "external_method"});
  expect_taken<avo::MovingObstacle>("worlds.cpp", "for_each_of_mover", "Mover",
                                    {"path", "trajectory"});
  expect_taken<avo::PlannerOptions>("planner.cpp", "for_each_option", "Options");
  expect_taken<avo::space::RobotSetup>("space_scenes.cpp", "for_each_of_space_robot", "Setup");
  expect_taken<avo::space::Quadrotor>("space_scenes.cpp", "for_each_of_quadrotor", "Quadrotor");
  expect_taken<avo::space::Scenario>("space_scenes.cpp", "for_each_space_setting", "Scene");
}

template <class T>
void expect_in_class(const std::string& name, const std::string& stub = "_avo.pyi") {
  const Part part("bindings/python/avo/" + stub, "class " + name + ":", "class ");
  for_each_member(avo::kFields<T>, [&](const auto& field, auto) {
    part.expect(fmt::format("def {}(self) -> ", field.key));
  });
}

TEST(WrittenFields, classes_of_python_have_them) {
  expect_in_class<avo::Car>("Car");
  expect_in_class<avo::DifferentialDrive>("DifferentialDrive");
  expect_in_class<avo::Airplane>("Airplane");
  expect_in_class<avo::MovingObstacle>("MovingObstacle");
  expect_in_class<avo::PlannerOptions>("Planner");
  expect_in_class<avo::Scenario>("Scenario");
  expect_in_class<avo::space::RobotSetup>("RobotSetup", "space.pyi");
  expect_in_class<avo::space::Quadrotor>("Quadrotor", "space.pyi");
  expect_in_class<avo::space::Scenario>("Scenario", "space.pyi");
}

template <class T>
void expect_in_script(const std::string& name) {
  const Part part("lab/avo/types.ts", "export interface " + name + " {", "}");
  for_each_member(avo::kFields<T>, [&](const auto& field, auto member) {
    part.expect(fmt::format("{}{}: {};", field.key, field.need == avo::kRequired ? "" : "?",
                            types_of(member).script));
  });
}

TEST(WrittenFields, types_of_typescript_have_them) {
  expect_in_script<avo::Car>("Car");
  expect_in_script<avo::CarBody>("CarBody");
  expect_in_script<avo::DifferentialDrive>("DifferentialDrive");
  expect_in_script<avo::Airplane>("Airplane");
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

std::string document(const std::string& name) {
  return read_file(std::string(AVO_SOURCE) + "/docs/" + name);
}

template <class T>
void expect_told(const std::string& document, const char* name) {
  for (const auto& field : avo::kFields<T>)
    EXPECT_TRUE(is_told(document, field.key))
        << "docs/" << name << " has no row\n  "
        << fmt::format("| `{}` | {}: {} |", field.key, field.unit, field.doc);
}

TEST(WrittenFields, the_document_of_scenes_has_them) {
  const std::string scenes = document("scenes.md");
  expect_told<avo::Car>(scenes, "scenes.md");
  expect_told<avo::DifferentialDrive>(scenes, "scenes.md");
  expect_told<avo::Airplane>(scenes, "scenes.md");
  expect_told<avo::MovingObstacle>(scenes, "scenes.md");
  expect_told<avo::Scenario>(scenes, "scenes.md");
  expect_told<avo::SensingModel>(scenes, "scenes.md");
}

// What space shares with the plane has its row in scenes.md.
TEST(WrittenFields, the_document_of_space_has_the_others) {
  const std::string space = document("space.md"), either = space + document("scenes.md");
  expect_told<avo::space::RobotSetup>(either, "space.md");
  expect_told<avo::space::Quadrotor>(space, "space.md");
  expect_told<avo::space::MovingObstacle>(either, "space.md");
  expect_told<avo::space::Scenario>(either, "space.md");
  for (const auto& field : avo::kFields<avo::space::Scenario>)
    EXPECT_NE(space.find(fmt::format("`{}`", field.key)), std::string::npos)
        << "docs/space.md does not name the key `" << field.key << "` of scenes";
}

}  // namespace
}  // namespace avo_test
