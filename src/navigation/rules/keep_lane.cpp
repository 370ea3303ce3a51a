// SPDX-License-Identifier: Apache-2.0
// Rule 6 of docs/arrival.md, keep to the right-hand lane. In a passage of two lanes a robot heads
// for the place beside the point ahead on its route. That place is in the right-hand lane, or half
// as far from the axis where something is between.
#include "navigation/rules/keep_lane.h"

#include <algorithm>
#include <cmath>

#include "navigation/right_of_way.h"
#include "navigation/route_walk.h"

namespace avo::inline navigation {
namespace {

constexpr double kAhead = 3.0;        // radii, along the route, to where a lane is searched for
constexpr double kReaches = 2.0;      // times its reach, more: its front swings less than it moves
constexpr double kAlong = 0.5;        // cosine: a route that leads more across keeps no lane
constexpr double kSight = 1e-9;       // m: lines of sight do not pass where pieces of walls touch
constexpr double kRoom = 1.0 - 1e-3;  // of the radius, that the segment into a lane needs
constexpr double kLaneRoom = 0.1;     // radii of the passage, between walls and a robot in its lane
// radii of the passage, from the axis, where there is room: robots in both lanes do not touch
constexpr double kLane = 1.3;

// The place that the front of a robot reaches when the robot itself has come to the target.
Vec2 beyond(Vec2 p, Vec2 target, double reach) {
  const double distance = norm(target - p);
  return reach > 0.0 && distance > 0.0 ? target + (reach / distance) * (target - p) : target;
}

}  // namespace

double lane_offset(const Passage& passage) {
  const double free = passage.half_width - (1.0 + kLaneRoom) * passage.radius;
  return std::max(0.5 * passage.half_width, std::min(kLane * passage.radius, free));
}

std::optional<Vec2> lane_ahead(const Passages& passages, const CornerGraph& graph,
                               const PathMap& map, Vec2 p, std::uint32_t target, double reach) {
  std::optional<Vec2> lane;
  const double ahead = kAhead * graph.radius + kReaches * reach;
  walk_route(graph, map, p, target, kLooksAhead * graph.radius, [&](const RoutePiece& piece) {
    if (piece.before + piece.length < ahead) return true;
    const Vec2 direction = (piece.to - piece.from) / piece.length;
    const Vec2 place = piece.from + (ahead - piece.before) * direction;
    const auto number = passages.at(place);
    if (!number || !passages[*number].two_lanes) return false;
    const Passage& passage = passages[*number];
    AxisPoint axis = axis_point(passage, true, place_in(passage, place).along);
    const double cosine = dot(axis.direction, direction);
    // a place behind the wall at a bend may be equally near to the axis
    if (std::abs(cosine) <= kAlong || !graph.grid.is_clear(place, axis.point, kSight)) return false;
    if (cosine < 0.0) axis.direction = -1.0 * axis.direction;
    for (const double part : {1.0, 0.5}) {
      const Vec2 middle = axis.point - part * lane_offset(passage) * perpendicular(axis.direction);
      if (!graph.grid.is_clear(p, beyond(p, middle, reach), kRoom * graph.radius)) continue;
      lane = middle;
      break;
    }
    return false;
  });
  return lane;
}

}  // namespace avo::inline navigation
