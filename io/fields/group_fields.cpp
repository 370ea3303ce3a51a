// SPDX-License-Identifier: Apache-2.0
// The table of fields for groups of robots: their starts and their goals.
#include "io/fields/fields.h"

namespace avo_io {

using avo::kAnyValue;
using avo::kNotNegative;
using avo::kPositive;

template <>
const std::vector<Field<Group>>& fields() {
  static const std::vector<Field<Group>> table{
      {"number", &Group::number, kRequired, kNumber, "", "how many robots"},
      {"placement", kNested, kRequired, kNoNumber, "", "where they start"},
      {"goals", kNested, kRequired, kNoNumber, "", "where they want to come to rest"},
      {"task", kNested, kOptional, kNoNumber, "", "what they do together", "nothing"},
      {"jitter", &Group::jitter, kOptional, kNotNegative, "m",
       "starts and goals are up to so far off by chance, along x and along y"},
  };
  return table;
}

template <>
const std::vector<Field<CirclePlacement>>& fields() {
  static const std::vector<Field<CirclePlacement>> table{
      {"center", &CirclePlacement::center, kOptional, kAnyValue, "m", "of the circle"},
      {"min_radius", &CirclePlacement::min_radius, kOptional, kNotNegative, "m", "of the circle"},
      {"spacing", &CirclePlacement::spacing, kOptional, kPositive, "m",
       "length of the arc from robot to robot, unless min_radius is larger"},
  };
  return table;
}

template <>
const std::vector<Field<GridPlacement>>& fields() {
  static const std::vector<Field<GridPlacement>> table{
      {"corner", &GridPlacement::corner, kOptional, kAnyValue, "m", "of the first robot"},
      {"spacing", &GridPlacement::spacing, kRequired, kPositive, "m",
       "from robot to robot, along x and y"},
      {"columns", &GridPlacement::columns, kRequired, kNumber, "", "how many robots in a row"},
  };
  return table;
}

template <>
const std::vector<Field<LinePlacement>>& fields() {
  static const std::vector<Field<LinePlacement>> table{
      {"from", &LinePlacement::from, kRequired, kAnyValue, "m", "where the first robot starts"},
      {"to", &LinePlacement::to, kRequired, kAnyValue, "m", "where the last robot starts"},
  };
  return table;
}

template <>
const std::vector<Field<RandomPlacement>>& fields() {
  static const std::vector<Field<RandomPlacement>> table{
      {"min", &RandomPlacement::min, kRequired, kAnyValue, "m", "lower left corner"},
      {"max", &RandomPlacement::max, kRequired, kAnyValue, "m", "upper right corner"},
      {"clearance", &RandomPlacement::clearance, kOptional, kNotNegative, "m", "between discs"},
  };
  return table;
}

template <>
const std::vector<Field<RingPlacement>>& fields() {
  static const std::vector<Field<RingPlacement>> table{
      {"center", &RingPlacement::center, kOptional, kAnyValue, "m", "of the circle"},
      {"radius", &RingPlacement::radius, kOptional, kPositive, "m", "of the circle"},
      {"noise", &RingPlacement::noise, kOptional, kNotNegative, "m",
       "up to which a start is off the circle, along x and along y"},
      {"clearance", &RingPlacement::clearance, kOptional, kNotNegative, "m",
       "between discs, at starts and at goals"},
  };
  return table;
}

template <>
const std::vector<Field<AntipodalGoals>>& fields() {
  static const std::vector<Field<AntipodalGoals>> table;
  return table;
}

template <>
const std::vector<Field<OffsetGoals>>& fields() {
  static const std::vector<Field<OffsetGoals>> table{
      {"by", &OffsetGoals::by, kRequired, kAnyValue, "m", "from start to goal"},
  };
  return table;
}

template <>
const std::vector<Field<PermutationGoals>>& fields() {
  static const std::vector<Field<PermutationGoals>> table;
  return table;
}

template <>
const std::vector<Field<RandomGoals>>& fields() {
  static const std::vector<Field<RandomGoals>> table{
      {"min", &RandomGoals::min, kRequired, kAnyValue, "m", "lower left corner"},
      {"max", &RandomGoals::max, kRequired, kAnyValue, "m", "upper right corner"},
      {"clearance", &RandomGoals::clearance, kOptional, kNotNegative, "m",
       "between the discs of robots at their goals"},
  };
  return table;
}

template <>
const std::vector<Field<FormationGoals>>& fields() {
  static const std::vector<Field<FormationGoals>> table{
      {"shape", &FormationGoals::shape, kOptional, kNoNumber, "", "of the slots"},
      {"spacing", &FormationGoals::spacing, kOptional, kPositive, "m", "from slot to slot"},
      {"center", &FormationGoals::center, kRequired, kAnyValue, "m", "mean of the slots"},
      {"heading", &FormationGoals::heading, kOptional, avo::kAngle, "rad",
       "that the formation faces, counter-clockwise from +x"},
  };
  return table;
}

}  // namespace avo_io
