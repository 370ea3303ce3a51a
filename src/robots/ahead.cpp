// SPDX-License-Identifier: Apache-2.0
#include "robots/ahead.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/elementary.h"
#include "robots/directions.h"

namespace avo::inline robots {
namespace {

struct KnownHeading {
  double heading;
  Vec2 direction;
};

constexpr int kSetBits = 8;  // the cache has several times as many sets as a tile has robots
using Set = std::array<KnownHeading, 2>;
thread_local std::array<Set, std::size_t{1} << kSetBits> known{};

Set& set_of(double heading) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;
  const std::uint64_t spread = std::bit_cast<std::uint64_t>(heading) * kGolden;
  return known[static_cast<std::size_t>(spread >> (64 - kSetBits))];
}

void keep(Set& set, const KnownHeading& newest) {
  set[1] = set[0];
  set[0] = newest;
}

}  // namespace

void look_ahead(const RobotColumns& robots) {
  constexpr std::size_t kAtOnce = 64;
  static_assert(kSpareAngles <= kSpareNeighbors);
  std::array<double, kAtOnce + kSpareAngles> x, y;
  for (std::size_t first = 0; first < robots.count; first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, robots.count - first);
    const double* const headings = &robots.heading[first];
    find_directions(headings, count, x.data(), y.data());
    for (std::size_t k = 0; k < count; ++k) {
      const bool is_known = std::abs(headings[k]) <= kMostAngle;
      if (is_known && robots.model[first + k] != nullptr)
        keep(set_of(headings[k]), {headings[k], {x[k], y[k]}});
    }
  }
}

Vec2 ahead_of(double heading) {
  if (heading == 0.0) return {1.0, heading};  // no set begins with this heading
  Set& set = set_of(heading);
  for (const KnownHeading& each : set)
    if (each.heading == heading) return each.direction;
  keep(set, {heading, elementary::direction(heading)});
  return set[0].direction;
}

}  // namespace avo::inline robots
