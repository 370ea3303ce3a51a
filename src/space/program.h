// SPDX-License-Identifier: Apache-2.0
// Eq. (23) in space: of the points in two balls and some half-spaces the one nearest to a wish, and
// where there is none, the least unsafe one (docs/space.md, "Programs").
#pragma once
#include <array>
#include <cstddef>
#include <span>
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

struct Ball {
  Vec3 center;
  double radius = 0.0;  ///< >= 0
};

enum class SpaceProgramState : unsigned char {
  optimal,         ///< the point keeps all half-spaces
  least_unsafe,    ///< no point keeps all: the largest violation is as small as it can be
  balls_disjoint,  ///< no point is in both balls
};

struct SpaceProgramResult {
  Vec3 point;
  double violation = 0.0;  ///< the largest of any half-space; 0 if optimal
  SpaceProgramState state = SpaceProgramState::optimal;
};

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

/// Scratch memory of the program in K dimensions and of those below; allocates only while it grows.
template <std::size_t K>
struct ProgramLevel {
  struct Plane {
    std::array<double, K> normal;
    double offset;
  };
  std::vector<Plane> planes, taken;
  ProgramLevel<K - 1> below;
};
template <>
struct ProgramLevel<1> {
  struct Plane {
    std::array<double, 1> normal;
    double offset;
  };
  std::vector<Plane> planes, taken;
};
template <>
struct ProgramLevel<3> {
  struct Plane {
    std::array<double, 3> normal;
    double offset;
  };
  HalfSpaceColumns planes;
  std::vector<Plane> taken;
  ProgramLevel<2> below;
};
struct SpaceProgramWorkspace {
  ProgramLevel<3> level;
  std::vector<ProgramLevel<3>::Plane> unsafe;  ///< those that bound the violation
  HalfSpaceColumns columns;                    ///< of half-spaces that are given one by one
};

/// The order of the half-spaces changes no bit, as long as their numbers differ. It sets their
/// violations.
SpaceProgramResult nearest_point(HalfSpaceColumns& half_spaces, const std::array<Ball, 2>& balls,
                                 Vec3 wish, SpaceProgramWorkspace& workspace);
/// The same for half-spaces with the numbers 0, 1, 2, ...
SpaceProgramResult nearest_point(std::span<const HalfSpace> half_spaces,
                                 const std::array<Ball, 2>& balls, Vec3 wish,
                                 SpaceProgramWorkspace& workspace);

}  // namespace avo::space
