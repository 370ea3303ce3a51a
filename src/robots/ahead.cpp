// SPDX-License-Identifier: Apache-2.0
#include "robots/ahead.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/elementary.h"

namespace avo::inline robots {
namespace {

struct Known {
  double heading;
  Vec2 direction;
};

constexpr int kPlaceBits = 8;  // the cache has several times as many places as a tile has robots
thread_local std::array<Known, std::size_t{1} << kPlaceBits> known{};

}  // namespace

Vec2 ahead_of(double heading) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;
  const std::uint64_t spread = std::bit_cast<std::uint64_t>(heading) * kGolden;
  Known& here = known[static_cast<std::size_t>(spread >> (64 - kPlaceBits))];
  // unused places have heading 0 and no direction, so heading 0 is never taken from the cache
  if (here.heading != heading || heading == 0.0) here = {heading, elementary::direction(heading)};
  return here.direction;
}

}  // namespace avo::inline robots
