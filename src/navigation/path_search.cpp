// SPDX-License-Identifier: Apache-2.0
#include "navigation/path_search.h"

#include <cstddef>
#include <functional>

namespace avo::inline navigation {
namespace {

constexpr std::ptrdiff_t kMostAround = 512;  // corners near it that a robot remembers

}  // namespace

PathSearch::PathSearch(const CornerGraph& graph, const PathMap& goal, Vec2 from,
                       PathScratch& scratch)
    : graph_(graph), goal_(goal), from_(from), scratch_(scratch) {
  if (scratch.reached.size() < graph.corners())
    scratch.reached.resize(graph.corners()), scratch.told.resize(graph.corners());
  if (++scratch.search == 0) {
    for (PathScratch::Reached& reached : scratch.reached) reached.search = 0;
    std::fill(scratch.told.begin(), scratch.told.end(), 0);
    scratch.search = 1;
  }
  scratch.open.clear(), scratch.in_view.clear(), scratch.settled.clear();
  look_from_goal();
}

// Their visibility is tested when their turn comes: for most of them it never comes.
void PathSearch::look_from_goal() {
  Horizons horizons(goal_.goal, std::min(goal_.room, graph_.radius));
  graph_.view.look(goal_.goal, horizons, [&](std::uint32_t k, Vec2 q) {
    if (!horizons.is_hidden(q))
      scratch_.in_view.push_back({norm(goal_.goal - q) + norm(q - from_), k});
  });
  std::make_heap(scratch_.in_view.begin(), scratch_.in_view.end(), std::greater<>());
}

// Reaches the corners that are due.
void PathSearch::reach_from_goal() {
  auto& in_view = scratch_.in_view;
  while (!in_view.empty() &&
         (scratch_.open.empty() || in_view.front().first <= scratch_.open.front().first)) {
    const std::uint32_t corner = in_view.front().second;
    std::pop_heap(in_view.begin(), in_view.end(), std::greater<>());
    in_view.pop_back();
    const Vec2 q = graph_.points[corner];
    const double room = std::min(goal_.room, graph_.room[corner]);
    if (goal_.is_open(goal_.goal, q) && graph_.grid.is_clear(goal_.goal, q, room))
      reach(corner, norm(goal_.goal - q), PathMap::kGoal);
  }
}

// Between two routes of one length, the next corner decides: the corner nearer to the goal comes
// first, or the one with the lower number. Dijkstra's algorithm has the same order.
bool PathSearch::comes_first(std::uint32_t next, std::uint32_t other) const {
  if (next == PathMap::kGoal || other == PathMap::kGoal) return other != PathMap::kGoal;
  const double length = this->length(next), other_length = this->length(other);
  return length < other_length || (length == other_length && next < other);
}

void PathSearch::reach(std::uint32_t corner, double length, std::uint32_t next) {
  PathScratch::Reached& reached = scratch_.reached[corner];
  if (reached.search == scratch_.search && length >= reached.length) {
    if (length == reached.length && comes_first(next, reached.next)) reached.next = next;
    return;
  }
  reached = {length, next, scratch_.search};
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
  const double length = this->length(corner);
  for (const CornerGraph::Edge& edge : graph_.edges_of(corner)) {
    longest_edge_ = std::max(longest_edge_, edge.length);
    if (goal_.is_open(graph_.points[corner], graph_.points[edge.to]))
      reach(edge.to, length + edge.length, corner);
  }
}

bool PathSearch::is_settled(std::uint32_t corner) const {
  return scratch_.reached[corner].search == scratch_.search &&
         sum_of(corner) * (1.0 + 0.5 * kRouteRounding) < settled_;
}

// Stores the settled corners nearest to `from`, those beside the route, and the routes from there.
void PathSearch::tell_around(PathMap& map) const {
  std::vector<std::pair<double, std::uint32_t>> near;  // m
  for (const std::uint32_t corner : scratch_.settled)
    if (is_settled(corner)) near.push_back({norm(graph_.points[corner] - from_), corner});
  map.reach = std::numeric_limits<double>::infinity();
  if (near.size() > std::size_t{kMostAround}) {
    std::nth_element(near.begin(), near.begin() + kMostAround, near.end());
    map.reach = near[kMostAround].first * (1.0 - kRouteRounding);
    near.resize(kMostAround);
  }
  std::vector<PathMap::Known> around;
  const auto tell = [&](std::uint32_t corner) {
    if (scratch_.told[corner] == scratch_.search) return false;
    scratch_.told[corner] = scratch_.search;
    around.push_back({corner, scratch_.reached[corner].next, length(corner)});
    return true;
  };
  for (const auto& [distance, corner] : near) tell(corner);
  map.beside = map.corners;
  for (const std::uint32_t corner : map.beside) {
    for (const CornerGraph::Edge& edge : graph_.edges_of(corner)) {
      std::uint32_t next = is_settled(edge.to) ? edge.to : PathMap::kGoal;
      while (next != PathMap::kGoal && tell(next)) next = scratch_.reached[next].next;
    }
  }
  std::sort(around.begin(), around.end(),
            [](const auto& a, const auto& b) { return a.corner < b.corner; });
  map.around = std::make_shared<const std::vector<PathMap::Known>>(std::move(around));
}

PathMap PathSearch::route_from(std::uint32_t target) const {
  PathMap map;
  map.goal = goal_.goal, map.room = goal_.room, map.is_free = goal_.is_free;
  map.closed = goal_.closed;
  map.is_whole = false;
  map.from = from_, map.settled = settled_, map.longest_edge = longest_edge_;
  add_route(
      graph_, target,
      [&](std::uint32_t k) {
        return std::optional(PathMap::Known{k, scratch_.reached[k].next, length(k)});
      },
      map);
  tell_around(map);
  return map;
}

}  // namespace avo::inline navigation
