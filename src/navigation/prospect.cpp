// SPDX-License-Identifier: Apache-2.0
#include "navigation/prospect.h"

#include <cmath>
#include <limits>

namespace avo::inline navigation {
namespace {

constexpr double kFarthestPassage =
    24.0;                             // radii of the robot: passages farther off do not matter yet
constexpr double kAhead = 3.0;        // radii, along the route, to where a lane is searched for
constexpr double kReaches = 2.0;      // times its reach, more: its front swings less than it moves
constexpr double kLeavesLane = 6.0;   // radii before the next passage of one lane
constexpr double kAlong = 0.5;        // cosine: a route that leads more across keeps no lane
constexpr double kSight = 1e-9;       // m: lines of sight do not pass where pieces of walls touch
constexpr double kRoom = 1.0 - 1e-3;  // of the radius, that the segment into a lane needs

// A straight piece of the route.
struct RoutePiece {
  Vec2 from, to;
  double before = 0.0, length = 0.0;  // m, of the route
  bool is_last = false;
};

// Calls visit(piece) for the route until it returns false, or the route has become longer than
// `farthest` m.
template <typename Visit>
void walk(const CornerGraph& graph, const PathMap& map, Vec2 p, std::uint32_t target,
          double farthest, const Visit& visit) {
  RoutePiece piece{p, p};
  while (target != PathMap::kNothing && piece.before <= farthest) {
    piece.is_last = target == PathMap::kGoal;
    piece.to = piece.is_last ? map.goal : graph.points[target];
    piece.length = norm(piece.to - piece.from);
    if (!visit(piece) || piece.is_last) return;
    piece.before += piece.length, piece.from = piece.to;
    target = map.after(target);
  }
}

// The direction in which the route leaves the passage that it begins in.
template <typename Walk>
std::optional<Claim> claim_inside(const Passage& passage, std::uint32_t number, Vec2 p,
                                  const Walk& walk_on) {
  std::optional<Claim> claim;
  const double along = place_in(passage, p).along;
  walk_on([&](const RoutePiece& piece) {
    const PassagePlace end = place_in(passage, piece.to);
    const bool leaves = !is_inside(passage, end);
    if (leaves || piece.is_last) {
      const double from = leaves ? 0.5 * passage.length() : along;
      claim =
          Claim{.passage = number, .forward = end.along > from, .inside = true, .ends = !leaves};
    }
    return !claim;
  });
  return claim;
}

// The claim of the passage that the route leads through next, and the route length to it.
template <typename Walk>
std::optional<Claim> claim_outside(const Passages& passages, Vec2 p, const Walk& walk_on,
                                   double& way) {
  std::optional<Claim> claim;
  walk_on([&](const RoutePiece& piece) {
    const auto crossed = passages.first_crossed(piece.from, piece.to);
    if (!crossed) return true;
    const Vec2 mouth = axis_point(passages[crossed->passage], crossed->forward, 0.0).point;
    claim = Claim{crossed->passage, crossed->forward, false, norm(mouth - p)};
    way = piece.before + crossed->part * piece.length;
    return false;
  });
  return claim;
}

// The place that the front of a robot reaches when the robot itself has come to the target.
Vec2 beyond(Vec2 p, Vec2 target, double reach) {
  const double distance = norm(target - p);
  return reach > 0.0 && distance > 0.0 ? target + (reach / distance) * (target - p) : target;
}

// The place beside the point ahead on the route, in the right-hand lane, or half as far where
// something is between.
template <typename Walk>
std::optional<Vec2> lane_ahead(const Passages& passages, const CornerGraph& graph, Vec2 p,
                               double reach, const Walk& walk_on) {
  std::optional<Vec2> lane;
  const double ahead = kAhead * graph.radius + kReaches * reach;
  walk_on([&](const RoutePiece& piece) {
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
      const Vec2 target = axis.point - part * lane_offset(passage) * perpendicular(axis.direction);
      if (!graph.grid.is_clear(p, beyond(p, target, reach), kRoom * graph.radius)) continue;
      lane = target;
      break;
    }
    return false;
  });
  return lane;
}

}  // namespace

Prospect look_ahead(const Passages& passages, const CornerGraph& graph, const PathMap& map, Vec2 p,
                    std::uint32_t target, double reach) {
  const double farthest = kFarthestPassage * graph.radius;
  Prospect prospect;
  const auto number = passages.at(p);
  if (number && !passages[*number].two_lanes) {
    const Passage& passage = passages[*number];
    // the route leads out of it at any length
    prospect.claim = claim_inside(passage, *number, p, [&](const auto& visit) {
      walk(graph, map, p, target, passage.length() + farthest, visit);
    });
    return prospect;
  }
  const auto walk_on = [&](const auto& visit) { walk(graph, map, p, target, farthest, visit); };
  double way = 0.0;
  prospect.claim = claim_outside(passages, p, walk_on, way);
  if (!prospect.claim || way > kLeavesLane * graph.radius)
    prospect.lane = lane_ahead(passages, graph, p, reach, walk_on);
  return prospect;
}

std::optional<Passages::Crossing> next_gap(const Passages& passages, const CornerGraph& graph,
                                           const PathMap& map, Vec2 p, std::uint32_t target) {
  std::optional<Passages::Crossing> gap;
  walk(graph, map, p, target, kFarthestPassage * graph.radius, [&](const RoutePiece& piece) {
    gap = passages.first_narrow(piece.from, piece.to);
    return !gap;
  });
  return gap;
}

bool has_room_for_two(const Passages& passages, const CornerGraph& graph, const PathMap& map,
                      Vec2 p, std::uint32_t target) {
  bool has_room = true;
  walk(graph, map, p, target, std::numeric_limits<double>::infinity(),
       [&](const RoutePiece& piece) {
         has_room = !passages.first_crossed(piece.from, piece.to);
         return has_room;
       });
  return has_room;
}

}  // namespace avo::inline navigation
