// SPDX-License-Identifier: Apache-2.0
#include "navigation/field.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace avo::inline navigation {
namespace {

constexpr double kFarthest = 256.0;     // radii, over which a bend is handed on
constexpr std::int64_t kGoalRings = 2;  // of cells around the goal that may see it

// Spreads from the goal. Each point hands on its aim to those points around it that see the aim,
// and offers itself to the others.
class Wave {
 public:
  Wave(const CornerGraph& graph, PathMap& map)
      : graph_(graph),
        map_(map),
        length_(graph.points.size(), std::numeric_limits<double>::infinity()),
        unseen_(graph.points.size(), PathMap::kNothing) {}

  void spread() {
    const Lattice::LatticeCell goal = graph_.lattice.place_of(map_.goal);
    for (std::int64_t away = 0; away <= kGoalRings; ++away) {
      for_each_point(goal, away, [&](std::uint32_t k) { offer(k, PathMap::kGoal); });
    }
    while (!open_.empty()) {
      const double length = open_.top().first;
      const std::uint32_t point = open_.top().second;
      open_.pop();
      if (length > length_[point]) continue;
      const Lattice::LatticeCell place = graph_.lattice.place_of(graph_.points[point]);
      for (std::int64_t away = 0; away <= 1; ++away) {
        for_each_point(place, away, [&](std::uint32_t k) { hand_on(point, k); });
      }
    }
    std::copy_n(length_.begin(), map_.length.size(), map_.length.begin());
    gather_from_outside();
  }

 private:
  template <typename Visit>
  void for_each_point(Lattice::LatticeCell place, std::int64_t away, const Visit& visit) const {
    graph_.lattice.for_each_around(place, away, [&](std::size_t cell) {
      const auto sample = static_cast<std::uint32_t>(graph_.corners() + cell);
      if (graph_.room[sample] > 0.0) visit(sample);
      for (const std::uint32_t corner : graph_.lattice.corners_in(cell)) visit(corner);
    });
  }

  void gather_from_outside() {
    std::vector<std::uint32_t>& targets = map_.from_outside;
    graph_.lattice.for_each_on_border([&](std::size_t cell) {
      const std::uint32_t next = map_.next[graph_.corners() + cell];
      if (next != PathMap::kNothing) targets.push_back(next);
    });
    std::sort(targets.begin(), targets.end());
    targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
  }

  void hand_on(std::uint32_t from, std::uint32_t to) {
    if (from == to) return;
    const std::uint32_t next = map_.next[from];
    const double piece = norm(point_of(graph_, map_, next) - graph_.points[to]);
    const bool is_near = piece <= kFarthest * graph_.radius;
    if (is_near && offer(to, next) && !graph_.is_corner(from)) return;
    offer(to, from);
  }

  // False where `to` does not see the bend and would use it.
  bool offer(std::uint32_t to, std::uint32_t bend) {
    const bool is_goal = bend == PathMap::kGoal;
    const Vec2 q = is_goal ? map_.goal : graph_.points[bend];
    const double piece = norm(graph_.points[to] - q);
    const double length = (is_goal ? 0.0 : length_[bend]) + piece;
    if (!(length < length_[to])) return true;
    if (unseen_[to] == bend) return false;
    const double room = is_goal ? map_.room : graph_.room[bend];
    const bool is_turn = !is_goal && graph_.is_corner(bend) && graph_.is_corner(to);
    if (is_turn && !graph_.may_bend(to, (graph_.points[to] - q) / piece)) return true;
    if (!map_.is_open(q, graph_.points[to]) ||
        !graph_.grid.is_clear(q, graph_.points[to], std::min(room, graph_.room[to]))) {
      unseen_[to] = bend;
      return false;
    }
    length_[to] = length, map_.next[to] = bend;
    open_.push({length, to});
    return true;
  }

  using Entry = std::pair<double, std::uint32_t>;
  const CornerGraph& graph_;
  PathMap& map_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::vector<double> length_;         // m, by point
  std::vector<std::uint32_t> unseen_;  // by point: the last bend that it was found not to see
};

}  // namespace

void spread_field(const CornerGraph& graph, PathMap& map) {
  Wave(graph, map).spread();
}

}  // namespace avo::inline navigation
