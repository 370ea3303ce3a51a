// SPDX-License-Identifier: Apache-2.0
// Whom each of many robots may have to brake for: by far bounds the most of a fleet is told by
// little arithmetic, what is left is judged in full lanes, whosever it is.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/robot.h"
#include "certificate/braking_path.h"
#include "certificate/pair.h"
#include "core/neighbor_columns.h"

namespace avo {

/// Whose walls are wanted.
enum class Whom : unsigned char { everyone, movers };

/// Who is no faster than A may be and just as able need not be looked at beyond a distance, the sum
/// of this, its radius and its reach.
struct FarBound {
  double distance;              ///< m
  std::array<double, 3> reach;  ///< of one's speed, a polynomial: m, s, s²/m
  double max_acceleration, speed_squared;
};
FarBound far_bound_of(const Robot& robot, const StepLaw& law);

/// Pairs that are not far, until there are enough of them to fill lanes.
struct NearQueue {
  static constexpr std::size_t kSize = 64, kSpare = 16;
  using Column = std::array<double, kSize + kSpare>;
  std::size_t count = 0;
  Column robot{}, neighbor{};  // indices
  Column x{}, y{}, v_x{}, v_y{}, radius{}, max_acceleration{}, is_car{};  // of A; is_car: 1 or 0
  Column other_x{}, other_y{}, other_v_x{}, other_v_y{}, other_radius{}, other_max_acceleration{};
};

/// A pair that can refuse a candidate of A's; what is A's alone is left out.
struct NearPair {
  std::uint32_t robot, neighbor;  ///< of the robots, and of this one's neighbors
  BrakingPair pair;
};

/// Scratch memory and result of find_near(); allocates only while it grows.
struct NearPairs {
  NearQueue queue;
  std::vector<NearPair> kept;           ///< robot by robot, by ascending neighbor
  std::vector<std::size_t> end;         ///< behind those of robot i
  std::vector<std::uint8_t> has_movers;  ///< whether robot i has neighbors that do not decide

  std::span<const NearPair> of(std::size_t i) const {
    const std::size_t first = i == 0 ? 0 : end[i - 1];
    return std::span(kept).subspan(first, end[i] - first);
  }
  void reserve(std::size_t robots, std::size_t pairs) {
    kept.reserve(pairs);
    end.reserve(robots);
    has_movers.reserve(robots);
  }
};

/// Of each robot's neighbors that decide, if everyone's walls are wanted, those that may meet it
/// and can refuse a candidate.
void find_near(std::span<const Sensing> robots, Whom whom, const StepLaw& law, NearPairs& near);

}  // namespace avo
