// SPDX-License-Identifier: Apache-2.0
// The directions of robots that coincide: each towards a side of its own, which follows from its
// id.
#include "avo/robot.h"
#include "core/elementary.h"

namespace avo {
namespace {

// The sides of successive ids are a golden angle apart: of the first n of them no two are much
// closer than 2π/n.
Vec2 side_of(std::uint64_t id) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio, odd
  constexpr double kTurn = 6.283185307179586;
  return elementary::direction(kTurn * 0x1p-64 * static_cast<double>(id * kGolden));
}

}  // namespace

Vec2 parting_direction(std::uint64_t id, std::uint64_t other) {
  if (id == other) return {};
  const Vec2 apart = side_of(id) - side_of(other);
  const double length = norm(apart);
  if (length > 0.0) return apart / length;
  // the ids are so far apart that rounding hides the difference
  return {id < other ? -1.0 : 1.0, 0.0};
}

}  // namespace avo
