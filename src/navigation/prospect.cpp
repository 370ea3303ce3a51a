// SPDX-License-Identifier: Apache-2.0
#include "navigation/prospect.h"

#include <limits>

#include "navigation/route_walk.h"
#include "navigation/rules/keep_lane.h"

namespace avo::inline navigation {
namespace {

constexpr double kLeavesLane = 6.0;  // radii before the next passage of one lane

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
                                   double& length) {
  std::optional<Claim> claim;
  walk_on([&](const RoutePiece& piece) {
    const auto crossed = passages.first_crossed(piece.from, piece.to);
    if (!crossed) return true;
    const Vec2 mouth = axis_point(passages[crossed->passage], crossed->forward, 0.0).point;
    claim = Claim{crossed->passage, crossed->forward, false, norm(mouth - p)};
    length = piece.before + crossed->part * piece.length;
    return false;
  });
  return claim;
}

}  // namespace

Prospect look_ahead(const Passages& passages, const CornerGraph& graph, const PathMap& map, Vec2 p,
                    std::uint32_t target, double reach) {
  const double farthest = kLooksAhead * graph.radius;
  Prospect prospect;
  const auto number = passages.at(p);
  if (number && !passages[*number].two_lanes) {
    const Passage& passage = passages[*number];
    // the route leads out of it at any length
    prospect.claim = claim_inside(passage, *number, p, [&](const auto& visit) {
      walk_route(graph, map, p, target, passage.length() + farthest, visit);
    });
    return prospect;
  }
  const auto walk_on = [&](const auto& visit) {
    walk_route(graph, map, p, target, farthest, visit);
  };
  double length = 0.0;
  prospect.claim = claim_outside(passages, p, walk_on, length);
  if (!prospect.claim || length > kLeavesLane * graph.radius)
    prospect.lane = lane_ahead(passages, graph, map, p, target, reach);
  return prospect;
}

std::optional<Passages::Crossing> next_gap(const Passages& passages, const CornerGraph& graph,
                                           const PathMap& map, Vec2 p, std::uint32_t target) {
  std::optional<Passages::Crossing> gap;
  walk_route(graph, map, p, target, kLooksAhead * graph.radius, [&](const RoutePiece& piece) {
    gap = passages.first_narrow(piece.from, piece.to);
    return !gap;
  });
  return gap;
}

bool has_room_for_two(const Passages& passages, const CornerGraph& graph, const PathMap& map,
                      Vec2 p, std::uint32_t target) {
  bool has_room = true;
  walk_route(graph, map, p, target, std::numeric_limits<double>::infinity(),
             [&](const RoutePiece& piece) {
               has_room = !passages.first_crossed(piece.from, piece.to);
               return has_room;
             });
  return has_room;
}

}  // namespace avo::inline navigation
