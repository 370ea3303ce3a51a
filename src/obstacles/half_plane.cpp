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
#include <limits>

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

// Collision course: p . v < 0 and the miss distance |b| below r. With û = -v/|v| and ê across it,
// x(t) = σ û + b ê, σ = |v| (t_m - t), t_m the time of closest approach.
struct Approach {
  double speed, t_m, b;  // m/s, s, m; b < 0 only in a tie
  Vec2 u, e;             // û, ê

  explicit Approach(const LocalPair& pair)
      : speed(norm(pair.v)),
        t_m(-pair.v.x * pair.d / (speed * speed)),
        b(pair.d * pair.v.y / speed),
        u{-pair.v.x / speed, -pair.v.y / speed},
        e{pair.v.y / speed, -pair.v.x / speed} {}

  // m = |v| (t_m - s): n . y = r reads (σ m + b²)/|x| = r where n = x/|x|
  double m(const ResponseAt& at) const { return speed * (t_m - at.lag); }
};

// The σ at which n . y = r. The left side of (σ m + b²)/|x| increases in σ (in t it would have a
// kink near t_m): Newton's iteration, guarded by bisection.
double solve_approach(const LocalPair& pair, const Approach& approach, const Horizon& horizon,
                      ResponseAt& at) {
  const double tau = horizon.end().time, b2 = approach.b * approach.b;
  double low = std::max(0.0, approach.speed * (approach.t_m - tau));
  double high = approach.speed * approach.t_m;
  at = horizon.at(std::min(approach.t_m, tau));
  // two starts, each near the root where the other is far: the lag of the latest time, and |x|
  // linear in t halfway through the disc of radius r
  const double cosine = std::min(0.95, (pair.r - std::abs(approach.b)) / approach.m(at));
  const double halfway = 0.5 * std::sqrt(pair.r * pair.r - b2) / approach.speed;
  const ResponseAt middle = horizon.at(std::clamp(approach.t_m - halfway, 0.0, tau));
  double sigma = std::max(std::abs(approach.b) * cosine / std::sqrt(1.0 - cosine * cosine),
                          pair.r - approach.speed * (middle.time - middle.lag));
  if (!(sigma > low && sigma < high)) sigma = 0.5 * (low + high);
  for (int i = 0; i < kMaxIterations; ++i) {
    at = horizon.at(std::clamp(approach.t_m - sigma / approach.speed, 0.0, tau));
    const double m = approach.m(at);
    const double x2 = sigma * sigma + b2;
    const double x = std::sqrt(x2);
    const double excess = (sigma * m + b2) / x - pair.r;
    (excess < 0.0 ? low : high) = sigma;
    const double lag_rate =
        at.rate > 0.0 ? at.gain * (1.0 - at.rate) / (horizon.control_time() * at.rate * at.rate)
                      : 0.5;  // at t = 0
    const double slope = (b2 * (m - sigma) / x2 + sigma * lag_rate) / x;
    double next = slope > 0.0 ? sigma - excess / slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - sigma) <= 1e-8 * next) break;  // of second order in what follows
    sigma = next;
  }
  return sigma;
}

LocalPlane convex(const LocalPair& pair, const Horizon& horizon) {
  const Approach approach(pair);
  const ResponseAt latest = horizon.at(std::min(approach.t_m, horizon.end().time));
  // head-on, both sides are equally near, and n is where n . y = r at t_m itself; so it is for a
  // tie that rounding has put on the other side
  const double c = pair.r / approach.m(latest);
  if (approach.b <= 0.0 && approach.t_m <= horizon.end().time && c < 1.0) {
    const double s = std::sqrt(1.0 - c * c);
    const double h = (pair.r - s * approach.b) / latest.gain;
    return {false, c * approach.u + s * approach.e, h};
  }
  ResponseAt at;
  const double sigma = solve_approach(pair, approach, horizon, at);
  const double x = std::sqrt(sigma * sigma + approach.b * approach.b);
  // F(t), stationary here. In contact t, and with it r - |x|, is known to rounding only: there the
  // equal -n . v/g' keeps the demand high, and the least time that rounding can tell, finite.
  constexpr double kRounding = std::numeric_limits<double>::epsilon();
  if (at.time < 4.0 * kRounding * approach.t_m) at = horizon.at(4.0 * kRounding * approach.t_m);
  double h = (pair.r - x) / at.gain;
  if (pair.r - x < 1e-7 * pair.r) h = std::max(h, approach.speed * (sigma / x) / at.rate);
  return {false, (1.0 / x) * (sigma * approach.u + approach.b * approach.e), h};
}

LocalPlane local_half_plane(const LocalPair& pair, const Horizon& horizon) {
  const ResponseAt& end = horizon.end();
  const Vec2 x = pair.x(end), y = pair.y(end);
  if (tip_is_nearest(pair, x, y)) return tip(pair, end, x);
  const bool collision_course =
      pair.v.x < 0.0 && pair.d * std::abs(pair.v.y) < pair.r * norm(pair.v);
  return collision_course ? convex(pair, horizon) : horn_half_plane(pair, horizon);
}

}  // namespace

RelativeHalfPlane half_plane(const Pair& pair, double reach, const Horizon& horizon) noexcept {
  const double d = norm(pair.position);
  if (d < pair.radius || !(d > 0.0)) return separate(pair, reach, horizon);
  // too far to touch before τ whatever both do: |p + t v| > r + R g(t) on the whole window
  const double speed = norm(pair.velocity);
  if (d - pair.radius > speed * horizon.end().time + reach * horizon.end().gain) {
    return {};
  }
  const double side = side_of(pair.position, pair.velocity, d, speed);
  const Vec2 e_1 = pair.position / d;
  const Vec2 e_2 = side * perpendicular(e_1);
  const LocalPair local{
      d,
      {dot(pair.position, pair.velocity) / d, side * cross(pair.position, pair.velocity) / d},
      pair.radius,
      reach};
  const LocalPlane plane = local_half_plane(local, horizon);
  if (plane.free) return {};
  const Vec2 n = plane.n.x * e_1 + plane.n.y * e_2;
  if (plane.h > reach) return {PairState::unavoidable, {n, reach}, plane.h - reach};
  return {PairState::constrained, {n, plane.h}};
}

}  // namespace avo
