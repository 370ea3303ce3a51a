// SPDX-License-Identifier: Apache-2.0
// Paths in pieces that take equal parts of the step: all pieces have the interface of one.
#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>

#include "check/relative_path.h"
#include "check/wall_path.h"

namespace avo::judge {

/// `piece(k)`, k < count, is a RelativePath or a WallPath.
template <typename Piece>
struct Pieces {
  std::size_t count = 1;
  Piece piece;

  double fraction(std::size_t k, double within) const {
    return (static_cast<double>(k) + within) / static_cast<double>(count);
  }
};

template <typename Piece>
Instant nearest_instant(const Pieces<Piece>& path) {
  Instant nearest = nearest_instant(path.piece(0));
  nearest.fraction = path.fraction(0, nearest.fraction);
  for (std::size_t k = 1; k < path.count; ++k) {
    const Instant instant = nearest_instant(path.piece(k));
    if (instant.distance < nearest.distance)
      nearest = {path.fraction(k, instant.fraction), instant.distance};
  }
  return nearest;
}

template <typename Piece>
std::optional<double> first_below(const Pieces<Piece>& path, double limit) {
  for (std::size_t k = 0; k < path.count; ++k)
    if (const auto first = first_below(path.piece(k), limit)) return path.fraction(k, *first);
  return std::nullopt;
}

template <typename Piece>
std::optional<double> last_below(const Pieces<Piece>& path, double limit) {
  for (std::size_t k = path.count; k-- > 0;)
    if (const auto last = last_below(path.piece(k), limit)) return path.fraction(k, *last);
  return std::nullopt;
}

template <typename Piece>
double lower_bound(const Pieces<Piece>& path) {
  double bound = lower_bound(path.piece(0));
  for (std::size_t k = 1; k < path.count; ++k) bound = std::min(bound, lower_bound(path.piece(k)));
  return bound;
}

}  // namespace avo::judge
