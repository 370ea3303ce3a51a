// SPDX-License-Identifier: Apache-2.0
// The routes of a whole fleet.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "avo/scenario.h"
#include "guidance/routes.h"
#include "sim/columns/fleet.h"
#include "sim/columns/static_world.h"

namespace avo::inline sim {

RouteRules route_rules_of(const Scenario& settings);

/// Returns whether robots have routes, on whatever floor: there are walls, or movers at rest.
bool has_routes(const StaticWorld& statics, std::span<const Routes> routes);

/// The routes of all robots, by rank; a floor must have routes. floor: of each robot, by rank;
/// empty where there is one. before: their routes among other walls, or none, see plan_anew().
/// arrival_distance: m, of robots that have none of their own.
std::vector<Travel> plan_travels(std::span<Routes> routes, const Fleet& fleet,
                                 std::span<const std::uint32_t> floor, double arrival_distance,
                                 std::span<const Travel> before = {});

}  // namespace avo::inline sim
