// SPDX-License-Identifier: Apache-2.0
// Pairs for the measurements of half-planes.
#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

#include "avo/half_plane.h"

namespace avo {

inline double uniform(std::uint64_t& state, double a, double b) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return a + (b - a) * (static_cast<double>(state >> 11) * 0x1p-53);
}

// Returns a pair at a distance from `near` to `far`, both robots with speeds up to 2 m/s.
inline Pair random_pair(std::uint64_t& state, double near, double far) {
  const auto direction = [&] {
    const double angle = uniform(state, 0.0, 2.0 * std::numbers::pi);
    return Vec2{std::cos(angle), std::sin(angle)};
  };
  const Vec2 p = uniform(state, near, far) * direction();
  const Vec2 v_A = uniform(state, 0.0, 2.0) * direction();
  return {p, v_A - uniform(state, 0.0, 2.0) * direction(), 1.0};
}

// The cases of the closed form. tip: the disc of τ decides; convex: the robots approach each other
// and would collide; horn: neither.
enum class Kind { mixed, tip, convex, horn };

inline Kind kind_of(const Pair& pair, const Horizon& horizon) {
  const Vec2 tip = pair.position + horizon.end().time * pair.velocity;
  const Vec2 n = tip / norm(tip);
  const Vec2 tangent = pair.position + horizon.end().lag * pair.velocity;
  if (dot(n, pair.position) >= pair.radius && dot(n, tangent) >= pair.radius) return Kind::tip;
  const double miss = std::abs(cross(pair.position, pair.velocity)) / norm(pair.velocity);
  const bool closing = dot(pair.position, pair.velocity) < 0.0;
  return closing && miss < pair.radius ? Kind::convex : Kind::horn;
}

}  // namespace avo
