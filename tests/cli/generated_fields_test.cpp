// SPDX-License-Identifier: Apache-2.0
// The lines of files that follow from the tables of a robot's fields and of its models. Each block
// stands between two comments. scripts/fields writes the blocks, by this test.
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "avo/robot.h"
#include "field_types.h"
#include "fields/model_fields.h"
#include "fields/robot_fields.h"
#include "run_avo.h"

namespace avo_test {
namespace {

using avo::for_each_member;
using avo::RobotField;
using avo::RobotSetup;
using Lines = std::vector<std::string>;

constexpr const char* kWrites = "AVO_WRITE_FIELDS";  // set by scripts/fields

/// visit(field, default value) for each field that has a member.
template <class T, class Visit>
void for_each_of(const Visit& visit) {
  const T usual;
  for_each_member(avo::kFields<T>,
                  [&](const auto& field, auto member) { visit(field, usual.*member); });
}
template <class Visit>
void for_each_of_robot(const Visit& visit) {
  for_each_of<RobotSetup>(visit);
}

template <class Value>
const Types& type_of(const Value&) {
  return kTypes<Value>;
}

Lines members_of_c() {
  Lines lines;
  for_each_of_robot([&](const RobotField& field, const auto&) {
    lines.push_back(fmt::format("visit(\"{0}\", &Def::{0}, &Setup::{0});", field.key));
  });
  return lines;
}

Lines attributes_of_python() {
  Lines lines;
  for_each_of_robot([&](const RobotField& field, const auto& usual) {
    lines.push_back(fmt::format("{}: {}", field.key, type_of(usual).attribute));
  });
  return lines;
}

std::string in_python(double number) {
  const std::string text = fmt::format("{}", number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}
std::string in_python(avo::Vec2 v) {
  return fmt::format("({}, {})", in_python(v.x), in_python(v.y));
}
std::string in_python(avo::LayerSet) {
  return "...";
}
template <class Word>
requires std::is_enum_v<Word> std::string in_python(Word word) {
  return fmt::format("\"{}\"", to_string(word));
}
template <class Value>
std::string in_python(const std::optional<Value>& value) {
  return value ? in_python(*value) : "None";
}

Lines arguments_of_python() {
  Lines lines;
  for_each_of_robot([&](const RobotField& field, const auto& usual) {
    const std::string_view type = type_of(usual).argument;
    if (field.need == avo::kRequired)
      lines.push_back(fmt::format("{}: {},", field.key, type));
    else if (field.key == "preferred_speed")  // by default max_speed
      lines.push_back(fmt::format("{}: {} | None = None,", field.key, type));
    else
      lines.push_back(fmt::format("{}: {} = {},", field.key, type, in_python(usual)));
  });
  return lines;
}

// What change_robot() takes: no state, and nothing that only a new robot may have.
Lines changes_of_python() {
  Lines lines;
  for_each_of_robot([&](const RobotField& field, const auto& usual) {
    const bool stays = field.key == "position" || field.key == "velocity" || field.key == "goal" ||
                       field.key == "time_step";
    if (!stays) lines.push_back(fmt::format("{}: {} = ...,", field.key, type_of(usual).argument));
  });
  return lines;
}

template <class T>
Lines members_of_script() {
  Lines lines;
  for_each_of<T>([&](const auto& field, const auto& usual) {
    lines.push_back(fmt::format("{}{}: {};{}{}", field.key, field.need == avo::kRequired ? "" : "?",
                                type_of(usual).script, field.unit.empty() ? "" : " // ",
                                field.unit));
  });
  return lines;
}

std::string in_words(double number) {
  return fmt::format("{}", number);
}
std::string in_words(avo::Vec2 v) {
  return fmt::format("[{}, {}]", v.x, v.y);
}
std::string in_words(avo::LayerSet set) {
  std::string list;
  for (int layer = 0; layer < 32; ++layer)
    if ((set.bits >> layer & 1U) != 0) list += fmt::format("{}{}", list.empty() ? "" : ", ", layer);
  return "[" + list + "]";
}
template <class Word>
requires std::is_enum_v<Word> std::string in_words(Word word) {
  return fmt::format("`{}`", to_string(word));
}
template <class Value>
std::string in_words(const std::optional<Value>& value) {
  return value ? in_words(*value) : "none";
}

std::string default_of(const RobotField& field) {
  if (field.need == avo::kRequired) return "required";
  if (!field.default_text.empty()) return std::string(field.default_text);
  const RobotSetup usual;
  return std::visit(
      [&](const auto member) -> std::string {
        if constexpr (std::is_same_v<decltype(member), const std::monostate>)
          return "none";
        else
          return in_words(usual.*member);
      },
      field.member);
}

// "m, > 0, "; nothing where every value is allowed.
std::string allowed(const RobotField& field) {
  const auto& [least, most, is_open] = field.range;
  std::string text(field.unit);
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (least < most && most < avo::kLargest && least >= 0.0)
    add(fmt::format("{} to {}", least, most));
  else if (most == avo::kLargest && least >= 0.0)
    add(fmt::format("{} {}", is_open ? ">" : ">=", least));
  return text.empty() ? text : text + ", ";
}

Lines rows_of_document() {
  Lines lines{"", "| key of a robot | default | |", "|---|---|---|"};
  for (const RobotField& field : avo::kFields<RobotSetup>)
    lines.push_back(fmt::format("| `{}` | {} | {}{} |", field.key, default_of(field),
                                allowed(field), field.doc));
  lines.emplace_back();
  return lines;
}

/// A block of a file, between a line with `scripts/fields: NAME` and one with `scripts/fields end`.
struct Block {
  std::string file, name;
  Lines lines;
};

std::vector<Block> blocks() {
  const std::string stub = "bindings/python/avo/_avo.pyi", script = "lab/avo/types.ts";
  return {{"bindings/c/robots.cpp", "members of RobotSetup", members_of_c()},
          {stub, "attributes of RobotSetup", attributes_of_python()},
          {stub, "arguments of RobotSetup", arguments_of_python()},
          {stub, "changes of RobotSetup", changes_of_python()},
          {script, "members of RobotSetup", members_of_script<RobotSetup>()},
          {script, "members of Car", members_of_script<avo::Car>()},
          {script, "members of its body", members_of_script<avo::CarBody>()},
          {script, "members of DifferentialDrive", members_of_script<avo::DifferentialDrive>()},
          {script, "members of Airplane", members_of_script<avo::Airplane>()},
          {"docs/scenes.md", "keys of robots", rows_of_document()}};
}

/// The file with the block's lines, as far indented as the comment before them.
std::string with_block(const std::string& text, const Block& block) {
  std::string result;
  bool is_inside = false;
  int found = 0;
  for (const std::string& line : lines_of(text)) {
    const bool begins = line.find("scripts/fields: " + block.name) != std::string::npos;
    if (is_inside && line.find("scripts/fields end") != std::string::npos) is_inside = false;
    if (!is_inside) result += line + "\n";
    if (!begins) continue;
    ++found, is_inside = true;
    const std::string indent = line.substr(0, line.find_first_not_of(' '));
    for (const std::string& own : block.lines) result.append(indent).append(own).append("\n");
  }
  EXPECT_EQ(found, 1) << block.file << " has not one block \"scripts/fields: " << block.name << '"';
  EXPECT_FALSE(is_inside) << block.file << ": the block " << block.name << " has no end";
  return result;
}

TEST(GeneratedFields, files_follow_from_the_table) {
  for (const Block& block : blocks()) {
    const std::string path = std::string(AVO_SOURCE) + "/" + block.file;
    const std::string text = read_file(path), present = with_block(text, block);
    if (std::getenv(kWrites) != nullptr && !HasFailure() && present != text)
      write_file(path, present);
    else
      EXPECT_TRUE(text == present)
          << block.file << ": \"" << block.name
          << "\" do not follow from src/fields, run scripts/fields. They have to be\n"
          << fmt::format("{}", fmt::join(block.lines, "\n"));
  }
}

}  // namespace
}  // namespace avo_test
