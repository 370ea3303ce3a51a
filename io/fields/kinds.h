// SPDX-License-Identifier: Apache-2.0
// The kinds of placements, of goals and of tasks in scene files.
#pragma once
#include <string_view>

#include "avo/teams.h"
#include "io/scene/scene_parts.h"

namespace avo_io {

/// The name and one line of text for each kind of placement, of goals and of tasks.
struct KindText {
  std::string_view key, doc;
};
template <class T>
constexpr KindText kind_text();
template <>
constexpr KindText kind_text<CirclePlacement>() {
  return {"circle", "evenly on a circle of radius max(min_radius, spacing * number / 2 pi)"};
}
template <>
constexpr KindText kind_text<GridPlacement>() {
  return {"grid", "row by row"};
}
template <>
constexpr KindText kind_text<LinePlacement>() {
  return {"line", "evenly from one point to another, ends included"};
}
template <>
constexpr KindText kind_text<RandomPlacement>() {
  return {"random", "uniform in a rectangle, clear of all robots placed before"};
}
template <>
constexpr KindText kind_text<RingPlacement>() {
  return {"ring", "by chance on a circle, clear of all robots placed before and of their goals"};
}
template <>
constexpr KindText kind_text<AntipodalGoals>() {
  return {"antipodal", "the start mirrored in the center of the placement"};
}
template <>
constexpr KindText kind_text<OffsetGoals>() {
  return {"offset", "the start moved by a vector"};
}
template <>
constexpr KindText kind_text<PermutationGoals>() {
  return {"permutation", "the starts of the group dealt anew: no robot keeps its own"};
}
template <>
constexpr KindText kind_text<RandomGoals>() {
  return {"random", "uniform in a rectangle, clear of the group's other goals"};
}
template <>
constexpr KindText kind_text<FormationGoals>() {
  return {"formation", "slots of a formation, dealt so that straight ways to them do not cross"};
}
template <>
constexpr KindText kind_text<avo::Queue>() {
  return {"queue", "they stand in a row and move up; the first one goes to its goal once served"};
}
template <>
constexpr KindText kind_text<avo::Follow>() {
  return {"follow", "the first one goes to its goal, the others follow it"};
}
template <>
constexpr KindText kind_text<avo::Patrol>() {
  return {"patrol", "each goes from point to point for ever"};
}
template <>
constexpr KindText kind_text<avo::Flow>() {
  return {"flow", "they leave by the nearest exit, and are removed there"};
}

}  // namespace avo_io
