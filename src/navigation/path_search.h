// SPDX-License-Identifier: Apache-2.0
// One robot's route to its goal: A* on the corner graph, from the goal towards the robot. Its
// result for a corner equals that of the whole map of the goal, to the last bit.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "navigation/path_map.h"

namespace avo::inline navigation {

/// Memory for a search.
struct PathScratch {
  struct Reached {
    double length = 0.0;  // m
    std::uint32_t next = 0;
    std::uint32_t search = 0;  // number of the search that has reached it
  };
  std::vector<Reached> reached;     // by corner
  std::vector<std::uint32_t> told;  // by corner, number of the search that has stored it
  std::uint32_t search = 0;
  std::vector<std::pair<double, std::uint32_t>> open;
  // from the goal, before the test for walls in between
  std::vector<std::pair<double, std::uint32_t>> in_view;
  std::vector<std::uint32_t> settled;
};

/// A part of a sum of lengths, more than its rounding.
inline constexpr double kRouteRounding = 1e-9;

class PathSearch {
 public:
  /// The goal must be free.
  PathSearch(const CornerGraph& graph, const PathMap& goal, Vec2 from, PathScratch& scratch);

  /// Settles corners in ascending order of the sum of their lengths and their distances to `from`,
  /// (m, corner). It goes up to that limit, m; visit(corner, both) returns the new limit.
  template <typename Visit>
  void settle(double limit, const Visit& visit);
  void settle(double limit) {
    settle(limit, [=](std::uint32_t, double) { return limit; });
  }
  /// Returns whether a corner's length is final.
  [[nodiscard]] bool is_settled(std::uint32_t corner) const;
  [[nodiscard]] double length(std::uint32_t corner) const {
    return scratch_.reached[corner].length;
  }
  [[nodiscard]] std::size_t count() const { return scratch_.settled.size(); }
  /// The map of the route from that target on, which is settled, or the goal.
  [[nodiscard]] PathMap route_from(std::uint32_t target) const;

 private:
  struct Front {
    double sum;  // m, the length and the distance to `from`
    std::uint32_t corner;
  };
  [[nodiscard]] double sum_of(std::uint32_t corner) const {
    return length(corner) + norm(graph_.points[corner] - from_);
  }
  void look_from_goal();
  void reach_from_goal();
  void reach(std::uint32_t corner, double length, std::uint32_t next);
  [[nodiscard]] bool comes_first(std::uint32_t next, std::uint32_t other) const;
  void spread(std::uint32_t corner);
  Front pop();
  void tell_around(PathMap& map) const;

  const CornerGraph& graph_;
  const PathMap& goal_;
  Vec2 from_;
  PathScratch& scratch_;
  double settled_ = 0.0;       // m: the sum of all corners that are not settled is at least this
  double longest_edge_ = 0.0;  // m
};

template <typename Visit>
void PathSearch::settle(double limit, const Visit& visit) {
  reach_from_goal();
  while (!scratch_.open.empty() &&
         scratch_.open.front().first <= limit * (1.0 + kRouteRounding) + kLengthRounding) {
    const Front front = pop();
    if (front.sum <= sum_of(front.corner)) {  // otherwise it has been reached again since
      spread(front.corner);
      limit = visit(front.corner, front.sum);
    }
    reach_from_goal();
  }
  settled_ =
      scratch_.open.empty() ? std::numeric_limits<double>::infinity() : scratch_.open.front().first;
}

}  // namespace avo::inline navigation
