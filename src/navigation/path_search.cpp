// SPDX-License-Identifier: Apache-2.0
#include "navigation/path_search.h"

#include <functional>

namespace avo {

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
  scratch.open.clear();
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
  ++count_;
  const double length = scratch_.length[corner];
  for (const CornerGraph::Edge& edge : graph_.edges_of(corner)) {
    if (goal_.is_open(graph_.points[corner], graph_.points[edge.to]))
      reach(edge.to, length + edge.length, corner);
  }
}

bool PathSearch::is_settled(std::uint32_t corner) const {
  return scratch_.known[corner] == scratch_.search &&
         sum_of(corner) * (1.0 + 0.5 * kWayRounding) < settled_;
}

PathMap PathSearch::way_from(std::uint32_t target) const {
  PathMap map;
  map.goal = goal_.goal, map.room = goal_.room, map.is_free = goal_.is_free;
  map.closed = goal_.closed;
  map.is_whole = false;
  map.from = from_, map.settled = settled_;
  for (std::uint32_t corner = target; corner != PathMap::kGoal; corner = map.next.back()) {
    map.corners.push_back(corner);
    map.length.push_back(scratch_.length[corner]);
    map.next.push_back(scratch_.next[corner]);
    for (const CornerGraph::Edge& edge : graph_.edges_of(corner))
      if (is_settled(edge.to)) map.beside.push_back({edge.to, scratch_.length[edge.to]});
  }
  std::sort(map.beside.begin(), map.beside.end());
  map.beside.erase(std::unique(map.beside.begin(), map.beside.end()), map.beside.end());
  map.top.assign(map.corners.size(), std::numeric_limits<double>::infinity());
  for (std::size_t k = map.corners.size(); k-- > 0;) {
    double turn = 0.0;
    map.top[k] = top_before(graph_, map, graph_.points[map.corners[k]], map.next[k], turn);
  }
  return map;
}

}  // namespace avo
