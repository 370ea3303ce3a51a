// SPDX-License-Identifier: Apache-2.0
// The choice of a new velocity as a program in the plane (paper §IV-D, Eqs. 22, 23), for one robot.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "lp/program_columns.h"

namespace avo::inline lp {

enum class ProgramState : std::uint8_t {
  optimal,         ///< the point of all constraints nearest the preferred one, Eq. (23)
  least_unsafe,    ///< the half-planes leave nothing: the smallest largest violation
  discs_disjoint,  ///< the discs do not meet: point of the acceleration disc nearest the speed disc
};

struct ProgramResult {
  Vec2 point;
  /// How far the point lies outside: of the half-planes (least_unsafe), of the speed disc
  /// (discs_disjoint). It is 0 if optimal, otherwise > 0. The unit is that of the offsets.
  double violation = 0.0;
  ProgramState state = ProgramState::optimal;
};

/// Scratch memory of one program.
using ProgramRows = std::vector<ProgramRow<1>>;

/// The number of rows that a program of so many half-planes needs.
constexpr std::size_t program_rows(std::size_t planes) {
  return planes + 3 * most_taken(planes);
}

/// The point of all half-planes, the acceleration disc and the speed disc around 0 (all closed)
/// nearest `preferred`, Eq. (23): the scalar instance of program_kernel.h.
///
/// Requires: every number finite, but acceleration.radius may be infinite; |normal| = 1; radii >=
/// 0. Never returns NaN, and returns `preferred` itself, bit for bit, where nothing is violated.
///
/// Among equally unsafe points (two parallel half-planes leave a segment of them) it is the one
/// nearest `preferred`. discs_disjoint disregards the half-planes.
///
/// Bounds, with ulp = 2^-52, and c and r of the disc in question, none of them denormal. m is |c| +
/// r of the smaller disc, or of the larger disc where the circles cross.
///  (1) |point - c| <= r + 4 ulp (|c| + r) for both discs, hence r (1 + 4 ulp) around the origin;
///      the speed disc is left only in state discs_disjoint;
///  (2) half-planes are violated by 32 ulp m at most if state is optimal; 8 ulp (|c| + r) of the
///      smaller disc count as none.
///  (3) turning all vectors by 90 degrees turns the point, and multiplying all lengths by 2^k
///      multiplies it, bit for bit.
///
/// The half-plane violated most is taken next, the first of equals. At worst this is O(n^2) for the
/// program and O(n^3) for the least unsafe point, but few of n are ever taken. `scratch` grows to
/// program_rows(planes.size()); nothing else is allocated.
ProgramResult nearest_point(std::span<const HalfPlane> planes, const Disc& acceleration,
                            double top_speed, Vec2 preferred, ProgramRows& scratch);

}  // namespace avo::inline lp
