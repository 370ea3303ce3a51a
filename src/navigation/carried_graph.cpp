// SPDX-License-Identifier: Apache-2.0
// The part of a corner graph that an edit of few walls keeps.
#include "navigation/carried_graph.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/plane.h"
#include "navigation/path_search.h"

namespace avo::inline navigation {
namespace {

bool are_equal(const Corner& one, const Corner& other) {
  return one.point == other.point && one.room == other.room && one.outward == other.outward &&
         one.most_lean == other.most_lean;
}

// Matches corners that were searched for anew and have not changed. Corners in another order are
// not matched: the order decides among routes of one length.
void match_found_anew(const Corners& before, const Corners& now,
                      std::vector<std::uint32_t>& number) {
  std::vector<std::uint32_t> old_of(now.all.size(), kNoCorner);
  std::map<std::pair<double, double>, std::uint32_t> anew;  // by place, their old number
  for (std::uint32_t k = 0; k < number.size(); ++k) {
    if (number[k] != kNoCorner)
      old_of[number[k]] = k;
    else
      anew.insert({{before.all[k].point.x, before.all[k].point.y}, k});
  }
  std::vector<std::uint32_t> before_old(now.all.size());  // the old number of the next one kept
  std::uint32_t next = kNoCorner;
  for (std::size_t k = now.all.size(); k-- > 0;) {
    before_old[k] = next;
    if (old_of[k] != kNoCorner) next = old_of[k];
  }
  std::uint32_t least = 0;
  for (std::uint32_t k = 0; k < now.all.size(); ++k) {
    if (old_of[k] == kNoCorner) {
      const auto found = anew.find({now.all[k].point.x, now.all[k].point.y});
      if (found == anew.end() || found->second < least || found->second >= before_old[k] ||
          !are_equal(before.all[found->second], now.all[k]))
        continue;
      old_of[k] = found->second, number[found->second] = k;
    }
    least = old_of[k] + 1;
  }
}

// Zones around the changed walls and the changed corners.
std::vector<Zone> zones_of(const WallChanges& changes, double radius, const Corners& before,
                           const Corners& now, const std::vector<std::uint32_t>& number) {
  std::vector<Zone> zones = changes.around(radius + 2.0 * kSpareRoom);
  const auto include = [&](Vec2 p) {
    const auto nearest =
        std::min_element(zones.begin(), zones.end(), [&](const auto& a, const auto& b) {
          return norm(p - a.center) - a.reach < norm(p - b.center) - b.reach;
        });
    nearest->reach = std::max(nearest->reach, norm(p - nearest->center) * (1.0 + kLengthRounding));
  };
  std::vector<char> is_known(now.all.size(), 0);
  for (std::size_t k = 0; k < number.size() && !zones.empty(); ++k) {
    if (number[k] == kNoCorner)
      include(before.all[k].point);
    else
      is_known[number[k]] = 1;
  }
  for (std::size_t k = 0; k < is_known.size() && !zones.empty(); ++k)
    if (is_known[k] == 0) include(now.all[k].point);
  return zones;
}

// The edges that a corner had before, without the sectors in which it sees changes.
std::optional<CornerGraph::SomeEdges> edges_left(const CornerGraph& before,
                                                 const CarriedGraph& carried, std::size_t old) {
  const CornerGraph::Edges* known = before.edges.known(old);
  const CornerGraph::SomeEdges* some = before.some_edges.known(old);
  if (known == nullptr && some == nullptr) return std::nullopt;
  CornerGraph::SomeEdges left;
  if (known == nullptr) known = &some->edges, left.open = some->open;
  for (const Zone& zone : carried.changed) {
    if (reaches(known->reach, before.points[old], zone.center, zone.reach))
      left.open |= sectors_of(before.points[old], zone.center, zone.reach);
  }
  left.edges.reach = known->reach;
  for (const CornerGraph::Edge& edge : known->all) {
    const Vec2 line = before.points[edge.to] - before.points[old];
    if (left.open[Horizons::sector_of(line)]) continue;
    if (carried.number[edge.to] == kNoCorner) return std::nullopt;
    left.edges.all.push_back({carried.number[edge.to], edge.length});
  }
  return left;
}

void carry_edges(const CornerGraph& before, const CarriedGraph& carried, CornerGraph& graph) {
  if (graph.all_within != before.all_within || before.edges.size() == 0) return;
  for (std::size_t old = 0; old < before.corners(); ++old) {
    const std::uint32_t now = carried.number[old];
    if (now == kNoCorner) continue;
    std::optional<CornerGraph::SomeEdges> left = edges_left(before, carried, old);
    if (!left || left->open.all()) continue;
    if (left->open.none())
      graph.edges.put(now, std::make_unique<CornerGraph::Edges>(std::move(left->edges)));
    else
      graph.some_edges.put(now, std::make_unique<CornerGraph::SomeEdges>(std::move(*left)));
  }
}

}  // namespace

CornerGraph corner_graph(std::span<const Wall> walls, double radius, const CornerGraph& before,
                         std::optional<CarriedGraph>& carried, Joining joining) {
  carried.reset();
  const WallChanges changes(before.grid.walls(), walls);
  if (!changes.are_few() || before.radius != radius || !before.lattice.empty())
    return corner_graph(walls, radius, joining);
  ClearanceGrid grid = corner_grid(walls, radius);
  if (grid.reach() != before.grid.reach()) return corner_graph(walls, radius, joining);
  carried.emplace();
  Corners found = corners(grid, radius, before.found, changes, carried->number);
  match_found_anew(before.found, found, carried->number);
  carried->changed = zones_of(changes, radius, before.found, found, carried->number);
  CornerGraph graph = graph_among(walls, radius, std::move(grid), std::move(found), joining);
  carry_edges(before, *carried, graph);
  if (graph.all_within != before.all_within) carried.reset();
  return graph;
}

std::vector<Zone> zones_for(const CarriedGraph& carried, const CornerGraph& graph,
                            const PathMap& map, double length) {
  constexpr double kSectorWidth = 0.03;  // rad, more than the width of a sector
  std::vector<Zone> changed = carried.changed;
  if (!(graph.all_within < kInfinity)) return changed;
  const bool has_long_edges = map.is_whole || map.longest_edge > graph.all_within;
  const double longest = has_long_edges ? std::max(length, map.settled) : graph.all_within;
  for (Zone& zone : changed) zone.reach += kSectorWidth * longest;
  return changed;
}

// All routes that are shorter than the shortest one into a change are the same, and so are the
// entries of corners on them.
PathMap carried_map(const PathMap& map, std::uint32_t target, const CornerGraph& before,
                    const CarriedGraph& carried, std::span<const Zone> changed) {
  const auto now = [&](std::uint32_t corner) {
    return corner < PathMap::kNothing ? carried.number[corner] : corner;
  };
  PathMap left;
  left.goal = map.goal, left.room = map.room, left.is_free = map.is_free;
  left.is_whole = false;
  left.from = map.from, left.reach = map.reach, left.longest_edge = map.longest_edge;
  left.closed = map.closed;
  left.settled = std::min(
      map.settled, least_route_into(changed, map.from, map.goal) * (1.0 - 2.0 * kRouteRounding));
  for (std::size_t k = map.place_of(target); k < map.corners.size(); ++k) {
    left.corners.push_back(now(map.corners[k])), left.next.push_back(now(map.next[k]));
    left.length.push_back(map.length[k]), left.top.push_back(map.top[k]);
  }
  const auto is_left = [&](std::uint32_t corner, double length) {
    return length + norm(before.points[corner] - map.from) < left.settled;
  };
  for (const std::uint32_t corner : map.beside)
    if (is_left(corner, norm(before.points[corner] - map.goal))) left.beside.push_back(now(corner));
  if (!map.around) return left;
  std::vector<PathMap::Known> around;
  for (const PathMap::Known& known : *map.around) {
    if (is_left(known.corner, known.length))
      around.push_back({now(known.corner), now(known.next), known.length});
  }
  left.around = std::make_shared<const std::vector<PathMap::Known>>(std::move(around));
  return left;
}

}  // namespace avo::inline navigation
