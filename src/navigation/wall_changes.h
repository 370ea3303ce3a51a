// SPDX-License-Identifier: Apache-2.0
// The changes of a list of walls by an edit, and where they matter.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/wall.h"

namespace avo::inline navigation {

struct Zone {
  Vec2 center;   // m
  double reach;  // m
};

/// Returns whether p is within one of them, or within the margin of one, m.
bool is_in_one(std::span<const Zone> zones, Vec2 p, double margin);
/// Returns whether a route from p to q of that length, m, may enter one of them.
bool may_meet(std::span<const Zone> zones, Vec2 p, Vec2 q, double length);
/// m: no shorter route from p to q enters one of them.
double least_route_into(std::span<const Zone> zones, Vec2 p, Vec2 q);

/// Two lists that differ between a common beginning and a common end.
struct WallChanges {
  std::span<const Wall> before, now;
  std::size_t same_first = 0, same_last = 0;

  WallChanges(std::span<const Wall> before, std::span<const Wall> now);
  [[nodiscard]] std::span<const Wall> removed() const {
    return before.subspan(same_first, before.size() - same_first - same_last);
  }
  [[nodiscard]] std::span<const Wall> added() const {
    return now.subspan(same_first, now.size() - same_first - same_last);
  }
  /// Returns whether the changes are few enough to be worth tracking.
  [[nodiscard]] bool are_few() const;
  /// The number that a present wall had before.
  [[nodiscard]] std::optional<std::size_t> number_before(std::size_t wall) const;
  /// Zones around all pieces of walls that are new or gone, with that reach, m.
  [[nodiscard]] std::vector<Zone> around(double reach) const;
};

}  // namespace avo::inline navigation
