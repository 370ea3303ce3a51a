// SPDX-License-Identifier: Apache-2.0
// What an edit of few walls leaves of a corner graph.
#include "navigation/carried_graph.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/plane.h"

namespace avo {
namespace {

bool are_equal(const Corner& one, const Corner& other) {
  return one.point == other.point && one.room == other.room && one.outward == other.outward &&
         one.most_lean == other.most_lean;
}

// Corners that were looked for anew, and are as before. None that comes in another order: of ways
// of one length the order decides.
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

// Around the walls that have changed and the corners that have.
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

// Those that what has changed has no say in.
void carry_edges(const CornerGraph& before, const CarriedGraph& carried, CornerGraph& graph) {
  if (graph.all_within != before.all_within || before.edges.size() == 0) return;
  for (std::size_t old = 0; old < before.corners(); ++old) {
    const CornerGraph::Edges* known = before.edges.known(old);
    const std::uint32_t now = carried.number[old];
    if (known == nullptr || now == kNoCorner) continue;
    const bool is_seen =
        std::any_of(carried.changed.begin(), carried.changed.end(), [&](const Zone& zone) {
          return reaches(known->reach, before.points[old], zone.center, zone.reach);
        });
    if (is_seen) continue;
    auto edges = std::make_unique<CornerGraph::Edges>(*known);
    bool are_there = true;
    for (CornerGraph::Edge& edge : edges->all) {
      edge.to = carried.number[edge.to];
      are_there = are_there && edge.to != kNoCorner;
    }
    if (are_there) graph.edges.put(now, std::move(edges));
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
  constexpr double kSectorWidth = 0.03;  // rad, more than a sector has
  std::vector<Zone> changed = carried.changed;
  if (!(graph.all_within < kInfinity)) return changed;
  const bool has_long_edges = map.is_whole || map.longest_edge > graph.all_within;
  const double longest = has_long_edges ? std::max(length, map.settled) : graph.all_within;
  for (Zone& zone : changed) zone.reach += kSectorWidth * longest;
  return changed;
}

PathMap renumbered(PathMap map, const std::vector<std::uint32_t>& number) {
  const auto renumber = [&](std::uint32_t& corner) {
    if (corner < PathMap::kNothing) corner = number[corner];
  };
  for (std::uint32_t& corner : map.corners) renumber(corner);
  for (std::uint32_t& corner : map.next) renumber(corner);
  if (map.around) {
    std::vector<PathMap::Known> around = *map.around;
    for (PathMap::Known& known : around) renumber(known.corner), renumber(known.next);
    map.around = std::make_shared<const std::vector<PathMap::Known>>(std::move(around));
  }
  return map;
}

}  // namespace avo
