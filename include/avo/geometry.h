// SPDX-License-Identifier: Apache-2.0
// Discs and half-planes, the only sets that a robot chooses from (paper §II-A).
#pragma once
#include "avo/vec.h"

namespace avo {

/// D(center, radius) of Eq. (1). As an obstacle it is open, as a set of allowed velocities closed.
struct Disc {
  Vec2 center = {};
  double radius = 0.0;
};

/// {u : normal . u >= offset}, |normal| = 1.
struct HalfPlane {
  Vec2 normal = {};
  double offset = 0.0;
};

/// Returns how far u lies outside the half-plane; negative inside. Same unit as the offset.
constexpr double violation(const HalfPlane& plane, Vec2 u) {
  return plane.offset - dot(plane.normal, u);
}

}  // namespace avo
