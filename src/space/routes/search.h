// SPDX-License-Identifier: Apache-2.0
// Shortest routes through free cells (docs/space.md, "Routes and passages").
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "space/routes/free_cells.h"

namespace avo::space {

/// A place on a route, and what the route keeps from boxes there, m.
struct SpaceRoutePoint {
  Vec3 place;
  double room = 0.0;
};

/// A route from the place where it was searched, without that place.
struct FoundRoute {
  std::vector<SpaceRoutePoint>
      points;              ///< the last one is the end; empty: there is no route at all
  bool reaches = false;    ///< whether it ends at the goal, and not as near as possible
  bool is_in_box = false;  ///< whether the goal is nearer to a box than the radius
};

/// Memory for searches; allocates only while it grows.
struct RouteScratch {
  struct Reached {
    double length = 0.0;       ///< m, from the start
    std::uint32_t from = 0;    ///< the point before it, which it sees or seems to see
    std::uint32_t search = 0;  ///< number of the search that has reached it
    bool is_settled = false;
  };
  std::vector<Reached> reached;
  std::uint32_t search = 0;
  std::vector<std::pair<double, std::uint32_t>> open;
  std::vector<std::uint32_t> doors;  ///< cells that see the goal
};

/// The route of a robot that is to end at a goal. Where no route leads there, the route ends as
/// near to the goal as the robot gets. It is a function of its arguments alone.
FoundRoute find_route(const FreeCells& cells, const Solids& solids, Vec3 from, Vec3 goal,
                      double radius, RouteScratch& scratch);

/// m: what a place keeps from boxes, at most as much as routes keep.
double room_at(const Solids& solids, Vec3 place, double most);

}  // namespace avo::space
