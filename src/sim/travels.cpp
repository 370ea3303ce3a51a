// SPDX-License-Identifier: Apache-2.0
#include "sim/travels.h"

namespace avo::inline sim {

WayRules way_rules_of(const Scenario& settings) {
  return {.routes = settings.navigation.value_or(true),
          .passages = settings.right_of_way != RightOfWay::none};
}

void plan_travels(Ways& ways, const Fleet& fleet, double arrival_distance, const Ways* before) {
  if (ways.empty()) return;
  ways.travels.reserve(fleet.size());
  const bool is_known = before != nullptr && !before->empty();
  for (const std::uint32_t slot : fleet.slot_of) {
    const Travel* known = is_known ? &before->travels[ways.travels.size()] : nullptr;
    ways.travels.push_back(
        fleet.conduct[slot].parked
            ? Travel{}
            : plan_anew(ways, fleet.traits[slot].way_radius, fleet.position[slot], fleet.goal[slot],
                        fleet.own_arrival_distance(slot).value_or(arrival_distance), known));
  }
}

}  // namespace avo::inline sim
