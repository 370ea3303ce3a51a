// SPDX-License-Identifier: Apache-2.0
#include "navigation/path_search.h"

#include <cstddef>
#include <functional>

namespace avo {
namespace {

constexpr std::ptrdiff_t kMostAround = 512;  // corners that a robot remembers

}  // namespace

PathSearch::PathSearch(const CornerGraph& graph, const PathMap& goal, Vec2 from,
                       PathScratch& scratch)
    : graph_(graph), goal_(goal), from_(from), scratch_(scratch) {
  const std::size_t corners = graph.corners();
  if (scratch.known.size() < corners) {
    scratch.length.resize(corners), scratch.next.resize(corners);
    scratch.known.assign(corners, 0);
    scratch.search = 0;
  }
  if (++scratch.search == 0) {
    std::fill(scratch.known.begin(), scratch.known.end(), 0);
    scratch.search = 1;
  }
  scratch.open.clear(), scratch.settled.clear();
  for_each_in_sight(graph, goal.goal, goal.room, [&](std::uint32_t corner) {
    if (goal.is_open(goal.goal, graph.points[corner]))
      reach(corner, norm(goal.goal - graph.points[corner]), PathMap::kGoal);
  });
}

// Of two ways of one length, the one whose next corner is nearer to the goal, or has the lower
// number: so Dijkstra's algorithm finds them.
bool PathSearch::comes_first(std::uint32_t next, std::uint32_t other) const {
  if (other == PathMap::kGoal) return false;
  const double length = scratch_.length[next], other_length = scratch_.length[other];
  return length < other_length || (length == other_length && next < other);
}

void PathSearch::reach(std::uint32_t corner, double length, std::uint32_t next) {
  const bool is_known = scratch_.known[corner] == scratch_.search;
  if (is_known && length >= scratch_.length[corner]) {
    if (length == scratch_.length[corner] && comes_first(next, scratch_.next[corner]))
      scratch_.next[corner] = next;
    return;
  }
  scratch_.known[corner] = scratch_.search;
  scratch_.length[corner] = length, scratch_.next[corner] = next;
  scratch_.open.push_back({sum_of(corner), corner});
  std::push_heap(scratch_.open.begin(), scratch_.open.end(), std::greater<>());
}

PathSearch::Front PathSearch::pop() {
  std::pop_heap(scratch_.open.begin(), scratch_.open.end(), std::greater<>());
  const auto [sum, corner] = scratch_.open.back();
  scratch_.open.pop_back();
  return {sum, corner};
}

void PathSearch::spread(std::uint32_t corner) {
  scratch_.settled.push_back(corner);
  const double length = scratch_.length[corner];
  for (const CornerGraph::Edge& edge : graph_.edges_of(corner)) {
    longest_edge_ = std::max(longest_edge_, edge.length);
    if (goal_.is_open(graph_.points[corner], graph_.points[edge.to]))
      reach(edge.to, length + edge.length, corner);
  }
}

bool PathSearch::is_settled(std::uint32_t corner) const {
  return scratch_.known[corner] == scratch_.search &&
         sum_of(corner) * (1.0 + 0.5 * kWayRounding) < settled_;
}

// Of those that are settled, the nearest ones to `from`.
void PathSearch::tell_around(PathMap& map) const {
  std::vector<std::pair<double, std::uint32_t>> near;  // m
  for (const std::uint32_t corner : scratch_.settled)
    if (is_settled(corner)) near.push_back({norm(graph_.points[corner] - from_), corner});
  map.reach = std::numeric_limits<double>::infinity();
  if (near.size() > std::size_t{kMostAround}) {
    std::nth_element(near.begin(), near.begin() + kMostAround, near.end());
    map.reach = near[kMostAround].first * (1.0 - kWayRounding);
    near.resize(kMostAround);
  }
  std::vector<PathMap::Known> around;
  around.reserve(near.size());
  for (const auto& [distance, corner] : near)
    around.push_back({corner, scratch_.next[corner], scratch_.length[corner]});
  const auto is_less = [](const auto& a, const auto& b) { return a.corner < b.corner; };
  const auto is_same = [](const auto& a, const auto& b) { return a.corner == b.corner; };
  std::sort(around.begin(), around.end(), is_less);
  around.erase(std::unique(around.begin(), around.end(), is_same), around.end());
  map.around = std::make_shared<const std::vector<PathMap::Known>>(std::move(around));
}

PathMap PathSearch::way_from(std::uint32_t target) const {
  PathMap map;
  map.goal = goal_.goal, map.room = goal_.room, map.is_free = goal_.is_free;
  map.closed = goal_.closed;
  map.is_whole = false;
  map.from = from_, map.settled = settled_, map.longest_edge = longest_edge_;
  tell_around(map);
  add_way(
      graph_, target,
      [&](std::uint32_t k) {
        return std::optional(PathMap::Known{k, scratch_.next[k], scratch_.length[k]});
      },
      map);
  return map;
}

}  // namespace avo
