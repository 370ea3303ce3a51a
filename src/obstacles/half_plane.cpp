// SPDX-License-Identifier: Apache-2.0
// The paper's half-plane H, Eqs. (15), (16), in closed form (§IV-B): the unit normal n of least
// support of hull(D(0, R) ∩ AVO), with that support as offset.
//
// In w = v' - v the obstacle is the family of discs {w : |x(t) + g(t) w| < r}, x(t) = p + t v, with
// centers -x/g and radii r/g. Their envelope has at time t the two normals n with n . y = r, where
// y(t) = p + s(t) v and s = t - g/g' is the lag. Three cases:
//   tip     the disc of τ alone is nearest: n = x(τ)/|x(τ)|
//   convex  on collision course the obstacle is convex: n = x(t)/|x(t)| where n . y = r
//   horn    otherwise its near side is concave, and the hull closes it by a chord (horn.cpp)
#include "avo/half_plane.h"

#include <algorithm>
#include <cmath>

#include "obstacles/contact.h"
#include "obstacles/local_pair.h"

namespace avo {
namespace {

constexpr int kMaxIterations = 64;  // bisection alone would end by then

// Is the wall n = x(τ)/|x(τ)| nowhere higher than at τ? A test without search (A <= 0, B s >= A).
bool tip_is_nearest(const LocalPair& pair, Vec2 x, Vec2 y) {
  const double reach = pair.r * norm(x);
  return reach > 0.0 && pair.d * x.x >= reach && dot(x, y) >= reach;
}

LocalPlane tip(const LocalPair& pair, const ResponseAt& end, Vec2 x) {
  const double length = norm(x);
  const double h = (pair.r - length) / end.gain;
  return {h <= -pair.R, x / length, h};
}

// Collision course: p . v < 0 and the miss distance b below r. With û = -v/|v| and ê across it,
// x(t) = σ û + b ê, σ = |v| (t_m - t), t_m the time of closest approach. The condition n . y = r
// reads G(σ) = (σ m + b²)/|x| - r = 0 with m = |v| (t_m - s), and G increases in σ; in t it would
// have a kink near t_m.
LocalPlane convex(const LocalPair& pair, const Horizon& horizon) {
  const double speed = norm(pair.v);
  const double t_m = -pair.v.x * pair.d / (speed * speed);
  const double b = pair.d * pair.v.y / speed;
  const Vec2 u = {-pair.v.x / speed, -pair.v.y / speed};
  const Vec2 e = {pair.v.y / speed, -pair.v.x / speed};
  const double delta = horizon.control_time();

  double low = std::max(0.0, speed * (t_m - horizon.end().time));
  double high = speed * t_m;
  ResponseAt at = horizon.at(std::min(t_m, horizon.end().time));
  // as if the lag kept its value of the latest time: then σ m = |x| r - b² directly
  const double m_end = speed * (t_m - at.lag);
  const double cosine = std::min(0.95, (pair.r - b) / m_end);
  double sigma = std::clamp(b * cosine / std::sqrt(1.0 - cosine * cosine), low, high);
  if (!(sigma >= low)) sigma = low;
  for (int i = 0; i < kMaxIterations; ++i) {
    at = horizon.at(std::clamp(t_m - sigma / speed, 0.0, horizon.end().time));
    const double m = speed * (t_m - at.lag);
    const double x2 = sigma * sigma + b * b;
    const double x = std::sqrt(x2);
    if (!(x > 0.0)) break;
    const double G = (sigma * m + b * b) / x - pair.r;
    (G < 0.0 ? low : high) = sigma;
    const double lag_rate = at.gain * (1.0 - at.rate) / (delta * at.rate * at.rate);
    const double slope = (b * b * (m - sigma) / x2 + sigma * lag_rate) / x;
    double next = sigma - G / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - sigma) <= 1e-9 * next || next == sigma) break;
    sigma = next;
  }
  const double x = std::sqrt(sigma * sigma + b * b);
  Vec2 n;
  if (x > 1e-150) {
    n = {(sigma * u.x + b * e.x) / x, (sigma * u.y + b * e.y) / x};
  } else {
    // head-on: both sides are equally near; the left of p is taken, where n . y = r
    const double c = std::min(1.0, pair.r / (speed * (t_m - at.lag)));
    const double s = std::sqrt(1.0 - c * c);
    n = {c * u.x + s * e.x, c * u.y + s * e.y};
  }
  const double h = (pair.r - x) / at.gain;
  return {h <= -pair.R, n, h};
}

LocalPlane local_half_plane(const LocalPair& pair, const Horizon& horizon) {
  const ResponseAt& end = horizon.end();
  const Vec2 x = pair.x(end), y = pair.y(end);
  if (tip_is_nearest(pair, x, y)) return tip(pair, end, x);
  const bool collision_course = pair.v.x < 0.0 && pair.d * pair.v.y < pair.r * norm(pair.v);
  return collision_course ? convex(pair, horizon) : horn_half_plane(pair, horizon);
}

}  // namespace

RelativeHalfPlane half_plane(const Pair& pair, double reach, const Horizon& horizon) noexcept {
  const double d = norm(pair.position);
  if (d < pair.radius || !(d > 0.0)) return separate(pair, reach, horizon);
  // too far to touch before τ whatever both do: |p + t v| > r + R g(t) on the whole window
  if (d - pair.radius > norm(pair.velocity) * horizon.end().time + reach * horizon.end().gain) {
    return {};
  }
  const Vec2 e_1 = pair.position / d;
  const double across = cross(pair.position, pair.velocity);
  const Vec2 e_2 = across < 0.0 ? -perpendicular(e_1) : perpendicular(e_1);
  const LocalPair local{d, {dot(pair.position, pair.velocity) / d, std::abs(across) / d},
                        pair.radius, reach};
  const LocalPlane plane = local_half_plane(local, horizon);
  if (plane.free) return {};
  return {PairState::constrained, {plane.n.x * e_1 + plane.n.y * e_2, plane.h}};
}

}  // namespace avo
