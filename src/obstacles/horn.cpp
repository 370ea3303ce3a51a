// SPDX-License-Identifier: Apache-2.0
// Eqs. (15), (16) where the present velocity does not lead into a collision: the obstacle is a
// bent horn whose near side, the one towards w = 0, is concave. Its hull within reach then has as
// near corners the disc of τ and the points Q where the near side crosses the circle |w| = R; the
// half-plane is the least among the tangent of that disc and the chords between those corners.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "obstacles/local_pair.h"

namespace avo {
namespace {

constexpr int kMaxIterations = 64;
constexpr int kMaxPoints = 12;
constexpr double kTimeTolerance = 1e-7;  // relative; every use is of second order in the time

// Where the near side touches the disc of one time: b = (r n - x)/g with n . y = r.
Vec2 near_side(const LocalPair& pair, const ResponseAt& at) {
  const Vec2 x = pair.x(at), y = pair.y(at);
  const double y2 = norm_squared(y);
  const double l = std::sqrt(std::max(0.0, (y2 - pair.r * pair.r)));
  const double k = pair.r / y2, per_gain = 1.0 / at.gain;
  const double c = k * pair.r, s = k * l;
  return {(c * y.x - s * y.y - x.x) * per_gain, (c * y.y + s * y.x - x.y) * per_gain};
}

// |b| falls while this is positive and grows while it is negative (m²). Zero where b is parallel
// to its normal, hence nearest to or farthest from w = 0.
double falling(const LocalPair& pair, const ResponseAt& at) {
  const Vec2 x = pair.x(at);
  return dot(x, pair.y(at)) - pair.r * norm(x);
}

// Zero of f in [low, high], where its signs differ: false position (Illinois), then bisection.
template <typename F>
ResponseAt find_zero(const Horizon& horizon, double low, double high, double f_low, double f_high,
                     F f) {
  const double negligible = 1e-8 * (std::abs(f_low) + std::abs(f_high));
  int kept = 0;
  for (int i = 0; i < kMaxIterations && high - low > kTimeTolerance * high; ++i) {
    double t = (low * f_high - high * f_low) / (f_high - f_low);
    if (!(t > low && t < high) || i > 16) t = 0.5 * (low + high);
    const ResponseAt at = horizon.at(t);
    const double f_t = f(at);
    if (std::abs(f_t) <= negligible) return at;
    if ((f_t < 0.0) == (f_low < 0.0)) {
      low = t, f_low = f_t;
      if (kept == 1) f_high *= 0.5;
      kept = 1;
    } else {
      high = t, f_high = f_t;
      if (kept == 2) f_low *= 0.5;
      kept = 2;
    }
  }
  return horizon.at(0.5 * (low + high));
}

// Where the circle |w| = R cuts the disc of one time.
std::array<Vec2, 2> circle_points(const LocalPair& pair, const ResponseAt& at) {
  const Vec2 x = pair.x(at);
  const double length = norm(x);
  const double gain_R = at.gain * pair.R;
  const double c = std::clamp(
      -((length - pair.r) * (length + pair.r) + gain_R * gain_R) / (2.0 * gain_R * length), -1.0,
      1.0);
  const double s = std::sqrt((1.0 - c) * (1.0 + c));
  const Vec2 u = x / length;
  return {{pair.R * Vec2{c * u.x - s * u.y, c * u.y + s * u.x},
           pair.R * Vec2{c * u.x + s * u.y, c * u.y - s * u.x}}};
}

// The corners of the hull on the near side, in the order of walking along it with the obstacle on
// the right: the crossings of the circle by ascending time.
struct NearSide {
  const LocalPair& pair;
  const Horizon& horizon;
  std::array<Vec2, kMaxPoints> points{};
  int count = 0;

  void add(Vec2 point) {
    if (count < kMaxPoints) points[static_cast<std::size_t>(count++)] = point;
  }
};

// One end of a piece of the near side; at t = 0 |b| is infinite and falls.
struct End {
  ResponseAt at;
  double length = std::numeric_limits<double>::infinity();  // |b|, m/s
  double falling = 1.0;
};

End end_at(const LocalPair& pair, const ResponseAt& at) {
  return {at, norm(near_side(pair, at)), falling(pair, at)};
}

// The crossing of a piece on which |b| is monotone, if there is one.
void cross(NearSide& side, const End& from, const End& to) {
  const LocalPair& pair = side.pair;
  if ((from.length > pair.R) == (to.length > pair.R)) return;
  // |b|^{-1/2} is nearly linear in t; its limit keeps false position in balance
  const auto f = [&](double length) { return std::sqrt(std::min(pair.R / length, 9.0)) - 1.0; };
  const ResponseAt at =
      find_zero(side.horizon, from.at.time, to.at.time, f(from.length), f(to.length),
                [&](const ResponseAt& each) { return f(norm(near_side(pair, each))); });
  const Vec2 b = near_side(pair, at);
  const auto ends = circle_points(pair, at);
  side.add(norm_squared(ends[0] - b) <= norm_squared(ends[1] - b) ? ends[0] : ends[1]);
}

// The next time of the search for turning points, as wide as the passage itself. Receding, |b| is
// at least (d - r)/g and so exceeds R while R t²/(2 δ) < d - r.
double next_time(const LocalPair& pair, double control_time, double t_m, double speed, double t) {
  if (t_m > 0.0) {
    const double least = 0.125 * pair.d * pair.v.y / (speed * speed);
    return t < t_m ? t_m : t + std::max(0.5 * (t - t_m), least);
  }
  if (t > 0.0) return 1.5 * t;
  return std::max(std::sqrt(2.0 * control_time * (pair.d - pair.r) / pair.R),
                  1e-3 * pair.r / speed);
}

// All crossings of the near side. |b| falls up to the closest approach t_m; it can cross R outwards
// only while R g' < |v|, and from then on it falls wherever it exceeds R. So only times between
// those two are searched for turning points.
void find_crossings(NearSide& side) {
  const LocalPair& pair = side.pair;
  const ResponseAt& last = side.horizon.end();
  const double speed = norm(pair.v);
  const double t_m = speed > 0.0 ? -pair.v.x * pair.d / (speed * speed) : 0.0;
  const double delta = side.horizon.control_time();
  End from{};
  while (from.at.time < last.time) {
    const bool settled = pair.R * from.at.rate >= speed;
    const double t = settled ? last.time : next_time(pair, delta, t_m, speed, from.at.time);
    const End to = end_at(pair, t > from.at.time && t < last.time ? side.horizon.at(t) : last);
    if (settled || (from.falling < 0.0) == (to.falling < 0.0)) {
      cross(side, from, to);
    } else {
      const auto f = [&](const ResponseAt& at) { return falling(pair, at); };
      const End turn = end_at(
          pair, find_zero(side.horizon, from.at.time, to.at.time, from.falling, to.falling, f));
      cross(side, from, turn);
      cross(side, turn, to);
    }
    from = to;
  }
}

// Normal of the chord from a to b, and of the tangent from a to a disc: on the left, walking on.
Vec2 chord_normal(Vec2 a, Vec2 b) {
  const Vec2 m = b - a;
  return perpendicular(m) / norm(m);
}

Vec2 tangent_normal(Vec2 a, const Disc& disc) {
  const Vec2 m = disc.center - a;
  const double m2 = norm_squared(m);
  const double l = std::sqrt(std::max(0.0, m2 - disc.radius * disc.radius));
  return {(-disc.radius * m.x - l * m.y) / m2, (-disc.radius * m.y + l * m.x) / m2};
}

// Support of the corners. The points of the disc outside the reach do not count: where its
// extreme point is one of them, its corners on the circle take its place.
double support(const NearSide& side, const Disc& disc, bool disc_in_reach, Vec2 n) {
  double h = -std::numeric_limits<double>::infinity();
  if (disc_in_reach && norm(disc.center + disc.radius * n) <= side.pair.R) {
    h = dot(n, disc.center) + disc.radius;
  }
  for (int k = 0; k < side.count; ++k) {
    h = std::max(h, dot(n, side.points[static_cast<std::size_t>(k)]));
  }
  return h;
}

}  // namespace

LocalPlane horn_half_plane(const LocalPair& pair, const Horizon& horizon) {
  const ResponseAt& end = horizon.end();
  const Vec2 x = pair.x(end);
  const Disc disc{-x / end.gain, pair.r / end.gain};
  const bool disc_in_reach = norm(x) - pair.r < pair.R * end.gain;

  NearSide side{pair, horizon};
  find_crossings(side);
  if (!disc_in_reach && side.count == 0) return {true, {}, 0.0};
  const int crossings = side.count;
  if (disc_in_reach && norm(disc.center) + disc.radius > pair.R) {
    for (const Vec2 corner : circle_points(pair, end)) side.add(corner);
  }

  LocalPlane best{false, {}, std::numeric_limits<double>::infinity()};
  const auto offer = [&](Vec2 n) {
    const double h = support(side, disc, disc_in_reach, n);
    if (h < best.h) best = {false, n, h};
  };
  if (disc_in_reach) offer(x / norm(x));
  for (int k = 0; k < crossings; ++k) {
    const Vec2 q = side.points[static_cast<std::size_t>(k)];
    if (disc_in_reach && norm(q - disc.center) > disc.radius) offer(tangent_normal(q, disc));
    for (int j = k + 1; j < side.count; ++j) {
      const Vec2 b = side.points[static_cast<std::size_t>(j)];
      if (!(q == b)) offer(chord_normal(q, b));
    }
  }
  return best;
}

}  // namespace avo
