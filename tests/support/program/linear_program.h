// SPDX-License-Identifier: Apache-2.0
// The choice of a new velocity as a program in the plane (paper §IV-D, Eqs. 22, 23).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "avo/geometry.h"

namespace avo::reference {

enum class ProgramState : std::uint8_t {
  optimal,          ///< the point of all constraints nearest the preferred velocity, Eq. (23)
  least_unsafe,     ///< the soft half-planes leave no point: smallest largest soft violation
  hard_infeasible,  ///< the hard half-planes leave no point: smallest largest hard violation
  discs_disjoint,  ///< the discs do not meet: point of the acceleration disc nearest the speed disc
};

struct ProgramResult {
  Vec2 point;
  /// The distance by which the point is outside: of the soft half-planes (least_unsafe), of the
  /// hard ones (hard_infeasible), of the speed disc (discs_disjoint). It is 0 if optimal, else > 0.
  /// Its unit is that of offsets.
  double violation = 0.0;
  ProgramState state = ProgramState::optimal;
};

/// Returns the point of hard ∩ soft ∩ acceleration ∩ speed (all closed) nearest `preferred`, Eq.
/// (23).
///
/// Requires: every number is finite, except that acceleration.radius may be infinite; |normal| = 1;
/// radii >= 0. It never returns NaN. It returns `preferred` itself, bit for bit, if nothing is
/// violated.
///
/// Among equally unsafe points (two parallel half-planes leave a segment of them), it is the one
/// nearest `preferred`. State hard_infeasible ignores the soft half-planes; discs_disjoint ignores
/// all half-planes.
///
/// Bounds, with ulp = 2^-52, c and r of the disc in question, and m = |c| + r of the smaller disc,
/// or of the larger one where the circles cross:
///  (1) |point - c| <= r + 4 ulp (|c| + r) for both discs, hence r (1 + 4 ulp) around the origin;
///      the point is outside the speed disc only, and knowingly, in state discs_disjoint;
///  (2) hard half-planes are violated by 32 ulp m at most, unless state is hard_infeasible, and
///      soft ones by the same if state is optimal; 8 ulp (|c| + r) of the smaller disc count as 0;
///  (3) turning all vectors by 90 degrees turns the point, and multiplying all lengths by 2^k
///      multiplies it, bit for bit.
///
/// The half-plane that is violated most is taken next, the first of equals. That costs O(n^2) at
/// worst for the program, and O(n^3) for the least unsafe point, but few of n are ever taken.
/// `scratch` grows to four times their number; nothing else is allocated.
ProgramResult nearest_point(std::span<const HalfPlane> hard, std::span<const HalfPlane> soft,
                            const Disc& acceleration, const Disc& speed, Vec2 preferred,
                            std::vector<HalfPlane>& scratch);

}  // namespace avo::reference
