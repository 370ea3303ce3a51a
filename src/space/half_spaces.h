// SPDX-License-Identifier: Apache-2.0
// The soft half-spaces of a robot's neighbors, Eqs. (15) to (20) in space.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "avo/horizon.h"
#include "avo/vec3.h"
#include "obstacles/half_planes.h"
#include "space/look.h"
#include "space/program.h"

namespace avo::space {

/// The limits of v' in the robot's own space, about its velocity and about 0, m/s.
struct OwnLimits {
  Vec3 velocity;  ///< in space
  double vertical = 1.0;
  double change = 0.0, speed = 0.0;
};

/// Scratch memory; allocates only while it grows.
struct HalfSpaces {
  HalfSpaceColumns columns;  ///< in v', m/s, in the robot's own space
  // pairs in their own planes: the axes, see PairFrame
  std::array<std::vector<double>, 3> along, across;
  PairColumns plane_pairs;
  PlaneColumns planes;
  HalfPlaneWorkspace workspace;
};

/// Appends the half-spaces of the pairs that can cut into what the robot may choose. The others
/// change no bit of a program.
void append_half_spaces(const SpacePairs& pairs, const OwnLimits& own, const Horizon& horizon,
                        HalfSpaces& half_spaces);

}  // namespace avo::space
