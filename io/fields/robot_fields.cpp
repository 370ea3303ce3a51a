// SPDX-License-Identifier: Apache-2.0
// The fields of robots and scenes for other programs, of robots for groups, and of footprints.
#include "avo_io/fields.h"
#include "fields/planner_fields.h"
#include "io/fields/fields.h"

namespace avo_io {

using avo::kAnyValue;
using avo::kNotNegative;
using avo::kPositive;
using avo::RobotSetup;

namespace {

template <class Listed>
std::vector<Listed> listed() {
  std::vector<Listed> all;
  avo::for_each_member(avo::kFields<typename Listed::Struct>, [&](const auto& field, auto member) {
    all.push_back(
        {field.key, member, field.need == kRequired, field.unit, field.doc, field.default_text});
  });
  return all;
}

}  // namespace

std::vector<RobotField> robot_fields() {
  return listed<RobotField>();
}
std::vector<PlannerField> planner_fields() {
  return listed<PlannerField>();
}
std::vector<SceneField> scene_fields() {
  return listed<SceneField>();
}
std::vector<SpaceRobotField> space_robot_fields() {
  return listed<SpaceRobotField>();
}
std::vector<SpaceSceneField> space_scene_fields() {
  return listed<SpaceSceneField>();
}

const std::vector<Field<RobotSetup>>& group_robot_fields() {
  static const std::vector<Field<RobotSetup>> table = [] {
    std::vector<Field<RobotSetup>> result = fields<RobotSetup>();
    std::erase_if(result, [](const auto& f) { return f.key == "position" || f.key == "goal"; });
    return result;
  }();
  return table;
}

template <>
const std::vector<Field<FootprintShape>>& fields() {
  static const std::vector<Field<FootprintShape>> table{
      {"length", &FootprintShape::length, kOptional, kPositive, "m",
       "of a rectangle, along the heading", "a polygon"},
      {"width", &FootprintShape::width, kOptional, kPositive, "m", "of the rectangle", "a polygon"},
      {"offset", &FootprintShape::offset, kOptional, kAnyValue, "m",
       "of the rectangle's center, ahead of the position"},
      {"polygon", &FootprintShape::polygon, kOptional, kAnyValue, "m",
       "corners, from the position: x along the heading, y to its left", "a rectangle"},
      {"excess", &FootprintShape::excess, kOptional, kNotNegative, "m",
       "by which discs may exceed its sides; as few discs as that allows cover it",
       "a quarter of its width"},
  };
  return table;
}

}  // namespace avo_io
