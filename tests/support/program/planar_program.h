// SPDX-License-Identifier: Apache-2.0
// The 2-D program over two exact discs and half-planes, incremental and deterministic (Eq. 23).
#pragma once
#include <cstddef>
#include <span>

#include "avo/geometry.h"
#include "support/program/lens.h"

namespace avo::reference {

/// Half-planes relative to Lens::origin. Their normals may have any length where Goal::direction is
/// not zero: a violation, offset - normal . u, is in the unit of the offset, and one tolerance
/// serves all of them.
using Planes = std::span<const HalfPlane>;

/// The point nearest `preferred`; or, if `direction` is not zero, the one farthest along it, and
/// among equals that nearest `preferred`.
struct Goal {
  Vec2 preferred;
  Vec2 direction;
};

struct PlanarSolution {
  Vec2 point;
  bool moved = false;     ///< it is not the preferred one
  std::size_t taken = 0;  ///< so many half-planes are in force
};

/// The best point of the lens. Lens not empty.
PlanarSolution start_planar(const Lens& lens, const Goal& goal) noexcept;

/// The half-plane that `u` violates by most, and by more than `least`, the first of equals;
/// planes.size() if there is none.
std::size_t most_violated(Planes planes, Vec2 u, double least) noexcept;

bool contains(Planes planes, const HalfPlane& plane) noexcept;

/// On entry the solution is the best point of the lens and of taken[0 .. solution.taken). Always
/// the plane violated most is taken next: the best point then lies on its boundary, and only those
/// taken before limit it there. Returns the index of the first plane that leaves nothing
/// (`solution` is then that of the planes taken before), planes.size() if none does. `taken` has
/// room for all.
std::size_t solve_planar(const Lens& lens, Planes planes, const Goal& goal,
                         std::span<HalfPlane> taken, PlanarSolution& solution) noexcept;

}  // namespace avo::reference
