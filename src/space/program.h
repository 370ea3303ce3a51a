// SPDX-License-Identifier: Apache-2.0
// Eq. (23) in space: the point in two balls and some half-spaces that is nearest to a wish. Where
// there is none, it is the least unsafe point (docs/space.md, "Programs").
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "avo/vec3.h"
#include "space/half_space.h"

namespace avo::space {

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
