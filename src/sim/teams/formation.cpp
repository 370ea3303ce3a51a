// SPDX-License-Identifier: Apache-2.0
// Slots of formations.
#include <algorithm>
#include <cmath>
#include <string>

#include "avo/error.h"
#include "avo/simulation.h"
#include "avo/teams.h"
#include "core/elementary.h"
#include "core/ranges.h"

namespace avo {
namespace {

constexpr double kTurn = 6.283185307179586;  // rad

Vec2 wedge_slot(std::size_t k, double spacing) {
  const double side = spacing / std::sqrt(2.0);  // m: the arms are at 45 degrees
  const auto row = static_cast<double>((k + 1) / 2);
  return {-row * side, k % 2 == 1 ? row * side : -row * side};
}

Vec2 block_slot(std::size_t k, std::size_t count, double spacing) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const std::size_t row = k / columns, width = std::min(columns, count - row * columns);
  const double middle = 0.5 * static_cast<double>(width - 1);
  return {-spacing * static_cast<double>(row),
          spacing * (middle - static_cast<double>(k % columns))};
}

Vec2 ring_slot(std::size_t k, std::size_t count, double spacing) {
  if (count < 2) return {};
  const double step = kTurn / static_cast<double>(count);
  const double half_chord = elementary::direction(0.5 * step).y;
  return 0.5 * spacing / half_chord * elementary::direction(step * static_cast<double>(k));
}

Vec2 slot_of(Formation formation, std::size_t k, std::size_t count, double spacing) {
  switch (formation) {
    case Formation::line:
      return {0.0, -spacing * static_cast<double>(k)};
    case Formation::column:
      return {-spacing * static_cast<double>(k), 0.0};
    case Formation::wedge:
      return wedge_slot(k, spacing);
    case Formation::block:
      return block_slot(k, count, spacing);
    case Formation::ring:
      return ring_slot(k, count, spacing);
  }
  return {};
}

}  // namespace

std::vector<Vec2> formation_slots(Formation formation, std::size_t count, double spacing) {
  require("spacing", spacing, kPositive, "m");
  std::vector<Vec2> slots;
  slots.reserve(count);
  Vec2 sum;
  for (std::size_t k = 0; k < count; ++k) {
    slots.push_back(slot_of(formation, k, count, spacing));
    sum = sum + slots.back();
  }
  for (Vec2& slot : slots) slot = slot - sum / static_cast<double>(count);
  return slots;
}

std::vector<Vec2> place_slots(std::span<const Vec2> slots, Vec2 center, double heading) {
  require("center", center, "m");
  require("heading", heading, kAngle, "rad");
  const Vec2 ahead = elementary::direction(heading);
  std::vector<Vec2> placed;
  placed.reserve(slots.size());
  for (const Vec2 slot : slots)
    placed.push_back(center + slot.x * ahead + slot.y * perpendicular(ahead));
  return placed;
}

void form_up(Simulation& simulation, std::span<const RobotId> robots, std::span<const Vec2> slots) {
  std::vector<Vec2> goals;
  for (const RobotId robot : robots) {
    if (!simulation.index_of(robot))
      throw Error("robots: found no robot " + std::to_string(robot.value));
    goals.push_back(simulation.robot(robot).position);
  }
  const std::vector<std::size_t> chosen = assign_slots(goals, slots);
  for (std::size_t k = 0; k < goals.size(); ++k) goals[k] = slots[chosen[k]];
  simulation.set_goals(robots, goals);
}

}  // namespace avo
