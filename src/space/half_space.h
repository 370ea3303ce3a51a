// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "avo/vec3.h"

namespace avo::space {

/// normal . w >= offset; the normal is a unit vector. m/s where w is a velocity.
struct HalfSpace {
  Vec3 normal;
  double offset = 0.0;
};

inline double violation(const HalfSpace& half_space, Vec3 point) {
  return half_space.offset - dot(half_space.normal, point);
}

/// Half-spaces in columns. Allocates only while it grows.
struct HalfSpaceColumns {
  using Column = std::vector<double>;
  /// The columns have room for so many extra entries, which are read but do not count.
  static constexpr std::size_t kSpare = 8;

  std::size_t count = 0;
  std::array<Column, 3> normal;
  Column offset;
  Column number;     ///< of two that are violated equally, the one with the lower number is chosen
  Column violation;  ///< by the last point; scratch memory

  void reserve(std::size_t half_spaces);
  /// Requires room for one more.
  void add(const HalfSpace& half_space, double its_number);
  [[nodiscard]] HalfSpace at(std::size_t k) const {
    return {{normal[0][k], normal[1][k], normal[2][k]}, offset[k]};
  }
};

}  // namespace avo::space
