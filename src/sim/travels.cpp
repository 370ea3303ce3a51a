// SPDX-License-Identifier: Apache-2.0
#include "sim/travels.h"

#include <cstddef>

namespace avo::inline sim {

WayRules way_rules_of(const Scenario& settings) {
  return {.routes = settings.navigation.value_or(true),
          .passages = settings.right_of_way != RightOfWay::none};
}

bool has_ways(const StaticWorld& statics, std::span<const Ways> ways) {
  return statics.has_walls || ways.front().goes_around_movers();
}

std::vector<Travel> plan_travels(std::span<Ways> ways, const Fleet& fleet,
                                 std::span<const std::uint32_t> floor, double arrival_distance,
                                 std::span<const Travel> before) {
  std::vector<Travel> travels;
  travels.reserve(fleet.size());
  for (const std::uint32_t slot : fleet.slot_of) {
    const std::size_t rank = travels.size();
    const Travel* known = before.empty() ? nullptr : &before[rank];
    travels.push_back(
        fleet.conduct[slot].parked
            ? Travel{}
            : plan_anew(ways[floor.empty() ? 0 : floor[rank]], fleet.traits[slot].way_radius,
                        fleet.position[slot], fleet.goal[slot],
                        fleet.own_arrival_distance(slot).value_or(arrival_distance), known));
  }
  return travels;
}

}  // namespace avo::inline sim
