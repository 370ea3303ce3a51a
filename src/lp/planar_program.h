// SPDX-License-Identifier: Apache-2.0
// The 2-D program over two exact discs and half-planes, incremental and deterministic (Eq. 23).
#pragma once
#include <array>
#include <cstddef>
#include <span>

#include "avo/geometry.h"
#include "lp/lens.h"

namespace avo {

/// What holds a solution in place: the index of a half-plane, or one of these.
constexpr int kNoConstraint = -1;
constexpr int kAccelerationDisc = -2;
constexpr int kSpeedDisc = -3;

/// Half-planes relative to Lens::origin. Their normals may have any length: a violation,
/// offset - normal . u, is in the unit of the offset, and one tolerance serves all of them.
using Planes = std::span<const HalfPlane>;

/// The point nearest `preferred`; or, if `direction` is not zero, the one farthest along it, and
/// among equals that nearest `preferred`.
struct Goal {
  Vec2 preferred;
  Vec2 direction;
};

struct PlanarSolution {
  Vec2 point;
  std::array<int, 2> binding{kNoConstraint, kNoConstraint};
};

/// A plane that the best point so far satisfies changes nothing; otherwise the new best point lies
/// on its boundary. Returns the index of the first plane that leaves nothing (`solution` is then
/// that of the planes before it), planes.size() if none does. Lens not empty.
std::size_t solve_planar(const Lens& lens, Planes planes, const Goal& goal,
                         PlanarSolution& solution) noexcept;

}  // namespace avo
