// SPDX-License-Identifier: Apache-2.0
// The canonical order of neighbors, nearest first, for any order of the input.
#pragma once
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "planner/decision.h"
#include "planner/scratch.h"

namespace avo::inline planner {

inline double distance_squared(const Robot& robot, const Neighbor& neighbor) {
  return norm_squared(neighbor.position - robot.position);
}

// Writes the canonical order of neighbors into scratch.order; ties keep the input order.
inline void rank(const Robot& robot, std::span<const Neighbor> neighbors,
                 PlanWorkspace::Scratch& scratch) {
  scratch.order.resize(neighbors.size());
  std::iota(scratch.order.begin(), scratch.order.end(), 0U);
  const auto key = [&](std::uint32_t k) {
    return std::pair(distance_squared(robot, neighbors[k]), k);
  };
  std::sort(scratch.order.begin(), scratch.order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
}

// The neighbors in their canonical order; they are sorted into scratch memory only if necessary.
inline std::span<const Neighbor> nearest_first(const Robot& robot,
                                               std::span<const Neighbor> neighbors,
                                               PlanWorkspace::Scratch& scratch) {
  const auto nearer = [&](const Neighbor& a, const Neighbor& b) {
    return distance_squared(robot, a) < distance_squared(robot, b);
  };
  if (std::is_sorted(neighbors.begin(), neighbors.end(), nearer)) return neighbors;
  rank(robot, neighbors, scratch);
  scratch.ordered.clear();
  for (const std::uint32_t k : scratch.order) scratch.ordered.push_back(neighbors[k]);
  return scratch.ordered;
}

}  // namespace avo::inline planner
