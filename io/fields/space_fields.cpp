// SPDX-License-Identifier: Apache-2.0
// The table of fields of groups and boxes in scenes of space.
#include "io/fields/fields.h"

namespace avo_io {

using avo::kAnyValue;
using avo::kNotNegative;
using avo::kPositive;

template <>
const std::vector<Field<SpaceGroup>>& fields() {
  static const std::vector<Field<SpaceGroup>> table{
      {"count", &SpaceGroup::count, kRequired, kNumber, "", "number of robots"},
      {"sphere", kNested, kOptional, kNoNumber, "", "evenly over a sphere"},
      {"box", kNested, kOptional, kNoNumber, "", "at random in a box"},
      {"grid", kNested, kOptional, kNoNumber, "", "row by row, layer by layer"},
      {"goal", kNested, kRequired, kNoNumber, "",
       "antipodal, permuted, or {offset: {by: [x, y, z]}}"},
      {"jitter", &SpaceGroup::jitter, kOptional, kNotNegative, "m",
       "the largest random offset of starts and goals"},
  };
  return table;
}

template <>
const std::vector<Field<SpherePlacement>>& fields() {
  static const std::vector<Field<SpherePlacement>> table{
      {"center", &SpherePlacement::center, kOptional, kAnyValue, "m", "of the sphere"},
      {"radius", &SpherePlacement::radius, kOptional, kPositive, "m", "of the sphere"},
  };
  return table;
}

template <>
const std::vector<Field<BoxPlacement>>& fields() {
  static const std::vector<Field<BoxPlacement>> table{
      {"min", &BoxPlacement::min, kRequired, kAnyValue, "m", "corner"},
      {"max", &BoxPlacement::max, kRequired, kAnyValue, "m", "corner"},
      {"clearance", &BoxPlacement::clearance, kOptional, kNotNegative, "m",
       "between any two robots, beyond contact"},
  };
  return table;
}

template <>
const std::vector<Field<SpaceGridPlacement>>& fields() {
  static const std::vector<Field<SpaceGridPlacement>> table{
      {"corner", &SpaceGridPlacement::corner, kRequired, kAnyValue, "m", "of the first robot"},
      {"spacing", &SpaceGridPlacement::spacing, kOptional, kPositive, "m", "between neighbors"},
      {"columns", &SpaceGridPlacement::columns, kRequired, kNumber, "", "robots along x"},
      {"rows", &SpaceGridPlacement::rows, kRequired, kNumber, "", "robots along y"},
  };
  return table;
}

template <>
const std::vector<Field<SpaceOffset>>& fields() {
  static const std::vector<Field<SpaceOffset>> table{
      {"by", &SpaceOffset::by, kRequired, kAnyValue, "m", "from the start to the goal"},
  };
  return table;
}

template <>
const std::vector<Field<SpaceBox>>& fields() {
  static const std::vector<Field<SpaceBox>> table{
      {"min", &SpaceBox::min, kRequired, kAnyValue, "m", "corner"},
      {"max", &SpaceBox::max, kRequired, kAnyValue, "m", "corner"},
      {"heading", &SpaceBox::heading, kOptional, avo::kAngle, "rad",
       "counter-clockwise from above, about the middle of the box"},
  };
  return table;
}

}  // namespace avo_io
