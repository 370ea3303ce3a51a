// SPDX-License-Identifier: Apache-2.0
// The candidate velocities for the least bad one, where no velocity is free.
#pragma once
#include <algorithm>
#include <array>
#include <span>

#include "lp/lens.h"
#include "planner/methods/free_boundary.h"

namespace avo::inline planner {

inline constexpr int kDescentSteps = 20;
inline constexpr std::array<double, 4> kFanParts{0.25, 0.5, 0.75, 1.0};  // of the smaller disc

struct Candidates {
  std::span<const Limit> limits;
  std::span<const CurvePoint> points;  // of the boundaries
  const Lens& lens;
  Vec2 preferred;
};

/// Offers the preferred velocity, a fan of velocities and the boundary points. Then it descends
/// from `best` by compass steps. The call offer(u) tests the velocity nearest to u in both discs.
/// If this velocity is better, the call takes it as `best`, and it returns whether it did.
template <typename Offer>
void try_candidates(const Candidates& candidates, const Vec2& best, const Offer& offer) {
  const auto& [limits, points, lens, preferred] = candidates;
  offer(preferred);
  const auto [middle, radius] = lens.smaller;
  constexpr double kSlope = 0.41421356237309503;  // tan 22.5°: every second direction between
  constexpr std::array<Vec2, 8> kFan{
      {{1, 0}, {1, kSlope}, {1, 1}, {kSlope, 1}, {0, 1}, {-kSlope, 1}, {-1, 1}, {-1, kSlope}}};
  offer(middle);
  for (const Vec2 direction : kFan) {
    const Vec2 u = (radius / norm(direction)) * direction;
    for (const double part : kFanParts) {
      offer(middle + part * u);
      offer(middle - part * u);
    }
  }
  for (const CurvePoint& point : points) {
    const auto leaves = [&point](const Limit& limit) {
      return limit.kind == Limit::Kind::disc && violates(limit, point.position);
    };
    if (std::none_of(limits.begin(), limits.end(), leaves)) offer(point.position);
  }
  double step = 0.25 * radius;
  for (int k = 0; k < kDescentSteps; ++k) {
    const Vec2 here = best;
    bool improved = false;
    for (const Vec2 direction : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
      improved = offer(here + step * direction) || improved;
    }
    if (!improved) step *= 0.5;
  }
}

}  // namespace avo::inline planner
