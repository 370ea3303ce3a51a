// SPDX-License-Identifier: Apache-2.0
// What a graph among other walls tells of the edges of a new one: an edge stays unless an added
// wall is in its way, and none comes unless a removed one was.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "navigation/corner_graph.h"

namespace avo {

class KnownEdges {
 public:
  /// Of a graph that has its points and no edges yet. Both graphs have to stay while it is used.
  KnownEdges(const CornerGraph& graph, const CornerGraph* before);

  /// Ascending, greater than i: all points that may be joined to it. Then are_joined(i, k) may be
  /// asked for, until the next call.
  [[nodiscard]] std::span<const std::uint32_t> candidates(std::uint32_t i);
  /// Nothing where it is not known.
  [[nodiscard]] std::optional<bool> are_joined(std::uint32_t i, std::uint32_t k) const;

 private:
  void match_points();
  [[nodiscard]] bool may_have_opened(Vec2 p, Vec2 q) const;

  struct Disc {
    Vec2 center;   // m
    double reach;  // m
  };
  const CornerGraph& graph_;
  const CornerGraph* before_;
  std::span<const Wall> added_, removed_;
  std::vector<Disc> opened_;  // around removed walls: nothing has changed for ways outside of them
  std::vector<std::uint32_t> old_of_;     // the same point, in the same order; or kNone
  std::vector<std::uint32_t> joined_to_;  // by old point: the last i + 1 that it was joined to
  std::vector<std::uint32_t> candidates_;
};

}  // namespace avo
