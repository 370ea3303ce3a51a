// SPDX-License-Identifier: Apache-2.0
#include "sim/travels.h"

#include <cstddef>

namespace avo::inline sim {

RouteRules route_rules_of(const Scenario& settings) {
  return {.routes = settings.navigation.value_or(true),
          .passages = settings.right_of_way != RightOfWay::none};
}

bool has_routes(const StaticWorld& statics, std::span<const Routes> routes) {
  return statics.has_walls || routes.front().goes_around_movers();
}

std::vector<Travel> plan_travels(std::span<Routes> routes, const Fleet& fleet,
                                 std::span<const std::uint32_t> floor, double arrival_distance,
                                 std::span<const Travel> before) {
  std::vector<Travel> travels;
  travels.reserve(fleet.size());
  for (const std::uint32_t slot : fleet.slot_of) {
    const std::size_t rank = travels.size();
    const Travel* known = before.empty() ? nullptr : &before[rank];
    travels.push_back(
        fleet.is_parked(slot)
            ? Travel{}
            : plan_anew(routes[floor.empty() ? 0 : floor[rank]], fleet.traits[slot].route_radius,
                        fleet.position[slot], fleet.goal[slot],
                        fleet.own_arrival_distance(slot).value_or(arrival_distance), known));
  }
  return travels;
}

}  // namespace avo::inline sim
