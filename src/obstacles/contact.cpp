// SPDX-License-Identifier: Apache-2.0
// The wall that takes an overlapping pair apart.
#include "obstacles/contact.h"

#include <algorithm>
#include <cmath>

namespace avo {
namespace {

// First T in [Δt, τ] with reach g(T) + B T >= A, or τ: the left side minus A is convex in T, so
// Newton's iteration from the right end falls monotonically onto the one crossing.
ResponseAt shortest_window(double A, double B, double reach, const Horizon& horizon) {
  const auto slack = [&](const ResponseAt& at) { return reach * at.gain + B * at.time - A; };
  if (slack(horizon.step()) >= 0.0) return horizon.step();
  ResponseAt at = horizon.end();
  for (int i = 0; i < 60; ++i) {
    const double excess = slack(at);
    if (!(excess > 0.0)) break;
    const double next = at.time - excess / (reach * at.rate + B);
    if (!(next < at.time) || !(next > horizon.step().time)) break;
    at = horizon.at(next);
  }
  return at;
}

}  // namespace

RelativeHalfPlane separate(const Pair& pair, double reach, const Horizon& horizon) noexcept {
  const Vec2 along = pair.position == Vec2{} ? pair.velocity : pair.position;
  const double length = norm(along);
  if (!(length > 0.0)) return {PairState::coincident, {}};
  const Vec2 n = along / length;
  const double A = pair.radius - dot(n, pair.position);
  const double B = dot(n, pair.velocity);
  const ResponseAt window = shortest_window(A, B, reach, horizon);
  const double h = (A - B * window.time) / window.gain;
  return {PairState::overlapping, {n, std::min(h, reach)}, std::max(0.0, h - reach)};
}

}  // namespace avo
