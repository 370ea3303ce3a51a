// SPDX-License-Identifier: Apache-2.0
// The 2-D program over two exact discs and half-planes, incremental and deterministic (Eq. 23).
#pragma once
#include <cstddef>
#include <span>

#include "avo/geometry.h"
#include "support/program/lens.h"

namespace avo::reference {

/// Half-planes relative to Lens::origin. Their normals may have any length if Goal::direction is
/// not zero. A violation, offset - normal . u, is in the unit of the offset, and one tolerance
/// serves all of them.
using Planes = std::span<const HalfPlane>;

/// The point nearest `preferred`. If `direction` is not zero, it is the point farthest along it,
/// and among equals the one nearest `preferred`.
struct Goal {
  Vec2 preferred;
  Vec2 direction;
};

struct PlanarSolution {
  Vec2 point;
  bool moved = false;     ///< it differs from the preferred point
  std::size_t taken = 0;  ///< number of half-planes in force
};

/// Returns the best point of the lens. The lens must not be empty.
PlanarSolution start_planar(const Lens& lens, const Goal& goal) noexcept;

/// Returns the half-plane that `u` violates by most, and by more than `least`, the first of equals;
/// planes.size() if there is none.
std::size_t most_violated(Planes planes, Vec2 u, double least) noexcept;

bool contains(Planes planes, const HalfPlane& plane) noexcept;

/// On entry, the solution is the best point of the lens and of taken[0 .. solution.taken). The
/// plane that is violated most is always taken next. The best point then lies on its boundary, and
/// only the planes taken before limit it there. Returns the index of the first plane that leaves no
/// point (`solution` is then that of the planes taken before), or planes.size() if none does.
/// `taken` has room for all.
std::size_t solve_planar(const Lens& lens, Planes planes, const Goal& goal,
                         std::span<HalfPlane> taken, PlanarSolution& solution) noexcept;

}  // namespace avo::reference
