// SPDX-License-Identifier: Apache-2.0
// One robot among movers that do not react (paper §III-C).
#pragma once
#include <span>

#include "planner/methods/free_boundary.h"

namespace avo::inline planner {

enum class PassiveState : unsigned char {
  free,            ///< the velocity lies in CA_A of Eq. (13)
  least_unsafe,    ///< CA_A is empty as far as the candidates tell
  discs_disjoint,  ///< no velocity keeps both discs; none is given
};

struct PassiveChoice {
  Vec2 velocity;           ///< [v'_A] m/s
  double violation = 0.0;  ///< m/s: its depth in an obstacle, or the gap of the discs
  PassiveState state = PassiveState::free;
};

/// Eqs. (13), (14): v'_A nearest to `preferred` in both discs and outside the union of
/// AVO ⊕ {v'_B}. acceleration.radius may be infinite, speed.center is 0. Candidates are
/// `preferred`, its projections on the boundaries (the circles too) and the ends of their free
/// parts, each exact to rounding. Properties, each tested under its number:
///  (1) a free velocity lies in both discs, and contains() holds for none of the obstacles;
///  (2) no free velocity is nearer than it, but in gaps thinner than the boundary samples;
///  (3) equally near ones are decided to the right of `preferred`;
///  (4) without a free velocity, the least violation of the candidates, descended from there. The
///       violation is the depth in the disc of the time of closest approach. A pair that overlaps
///       already is to be parted along p in the shortest window within reach. walls: half-planes in
///       v' to keep to as well.
PassiveChoice choose_among_movers(std::span<const PassiveObstacle> obstacles,
                                  const Disc& acceleration, const Disc& speed, Vec2 preferred,
                                  PassiveWorkspace& workspace,
                                  std::span<const HalfPlane> walls = {});

}  // namespace avo::inline planner
