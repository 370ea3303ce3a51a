// SPDX-License-Identifier: Apache-2.0
#include "sim/taken_goals.h"

#include <algorithm>

#include "planner/rules/arrival.h"
#include "sim/shared_goals.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// m: where the robot has come to rest because there was no room at its goal.
std::optional<Vec2> resting_place(const Fleet& fleet, std::size_t slot) {
  if (fleet.has_stood[slot] == 0 || fleet.velocity[slot] != Vec2{}) return std::nullopt;
  return fleet.place(slot);
}

// Counts the robot among those that rest on the goals that it leaves no room at, or no more.
void count(World& world, std::size_t slot, Vec2 place, bool rests) {
  TakenGoals& taken = world.taken_goals;
  const Fleet& fleet = world.fleet;
  const double radius = fleet.traits[slot].route_radius;
  taken.goals.list_within(place, radius + taken.largest_radius, taken.found);
  for (const std::uint32_t at : taken.found) {
    const std::uint32_t rank = taken.ranks[static_cast<std::size_t>(taken.goals.index(at))];
    const std::size_t other = fleet.slot_of[rank];
    if (other == slot || !keep_apart(fleet.conduct[slot], fleet.conduct[other])) continue;
    if (!leave_no_room(place, radius, taken.goals.position(at), fleet.traits[other].route_radius))
      continue;
    rests ? ++taken.takers[rank] : --taken.takers[rank];
  }
}

void note(World& world, std::size_t slot) {
  std::optional<Vec2>& before =
      world.taken_goals.resting[static_cast<std::size_t>(world.fleet.rank[slot])];
  const std::optional<Vec2> now = resting_place(world.fleet, slot);
  if (now == before) return;
  if (before) count(world, slot, *before, false);
  if (now) count(world, slot, *now, true);
  before = now;
}

}  // namespace

void find_taken_goals(World& world) {
  TakenGoals& taken = world.taken_goals;
  const Fleet& fleet = world.fleet;
  taken.takers.clear(), taken.resting.clear(), taken.ranks.clear();
  if (world.shares_goal.empty()) return;
  std::vector<Vec2> goals;
  taken.largest_radius = 0.0;
  for (std::uint32_t rank = 0; rank < fleet.size(); ++rank) {
    const std::size_t slot = fleet.slot_of[rank];
    if (world.shares_goal[rank] != Shares::nothing || !rests_at_goal(fleet, slot) ||
        !method_traits(fleet.conduct[slot].method).has_rules)
      continue;
    goals.push_back(world.end_of(slot)), taken.ranks.push_back(rank);
    taken.largest_radius = std::max(taken.largest_radius, fleet.traits[slot].route_radius);
  }
  if (goals.empty()) return;
  taken.goals.build(goals, 2.0 * taken.largest_radius);
  taken.takers.resize(fleet.size()), taken.resting.resize(fleet.size());
  taken.found.reserve(goals.size());
  for (std::size_t slot = 0; slot < fleet.size(); ++slot) note(world, slot);
}

void note_resting(World& world) {
  if (world.taken_goals.takers.empty()) return;
  if (world.fleet.has_clocks) {
    for (const std::uint32_t slot : world.due) note(world, slot);
  } else {
    for (std::size_t slot = 0; slot < world.fleet.size(); ++slot) note(world, slot);
  }
}

}  // namespace avo::inline sim
