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
constexpr double kTimeTolerance = 1e-9;  // relative; every use is of second order in the time

// Where the near side touches the disc of one time: b = (r n - x)/g with n . y = r.
Vec2 near_side(const LocalPair& pair, const ResponseAt& at) {
  const Vec2 x = pair.x(at), y = pair.y(at);
  const double y2 = norm_squared(y);
  const double l = std::sqrt(std::max(0.0, (y2 - pair.r * pair.r)));
  const double c = pair.r * pair.r / y2, s = pair.r * l / y2;
  return {(c * y.x - s * y.y - x.x) / at.gain, (c * y.y + s * y.x - x.y) / at.gain};
}

// |b| falls while this is positive and grows while it is negative (m²). Zero where b is parallel
// to its normal, hence nearest to or farthest from w = 0.
double falling(const LocalPair& pair, const ResponseAt& at) {
  const Vec2 x = pair.x(at);
  return dot(x, pair.y(at)) - pair.r * norm(x);
}

// Zero of f in [low, high], where its signs differ: false position, Illinois variant.
template <typename F>
ResponseAt find_zero(const Horizon& horizon, double low, double high, double f_low, double f_high,
                     F f) {
  int kept = 0;
  for (int i = 0; i < kMaxIterations && high - low > kTimeTolerance * high; ++i) {
    double t = (low * f_high - high * f_low) / (f_high - f_low);
    if (!(t > low && t < high) || i > 20) t = 0.5 * (low + high);
    const ResponseAt at = horizon.at(t);
    const double f_t = f(at);
    if (f_t == 0.0) return at;
    if ((f_t < 0.0) == (f_low < 0.0)) {
      const double step = t - low;
      low = t, f_low = f_t;
      if (kept == 1) f_high *= 0.5;
      kept = 1;
      if (step < kTimeTolerance * high && kept == 1 && i > 0) return at;
    } else {
      const double step = high - t;
      high = t, f_high = f_t;
      if (kept == 2) f_low *= 0.5;
      kept = 2;
      if (step < kTimeTolerance * high && i > 0) return at;
    }
  }
  return horizon.at(0.5 * (low + high));
}

// Where the circle |w| = R cuts the disc of one time.
std::array<Vec2, 2> circle_points(const LocalPair& pair, const ResponseAt& at) {
  const Vec2 x = pair.x(at);
  const double length = norm(x);
  const double gR = at.gain * pair.R;
  const double c = std::clamp(
      -((length - pair.r) * (length + pair.r) + gR * gR) / (2.0 * gR * length), -1.0, 1.0);
  const double s = std::sqrt((1.0 - c) * (1.0 + c));
  const Vec2 u = x / length;
  return {{pair.R * Vec2{c * u.x - s * u.y, c * u.y + s * u.x},
           pair.R * Vec2{c * u.x + s * u.y, c * u.y - s * u.x}}};
}

// The corners of the hull on the near side, in the order of walking along it with the obstacle on
// the right: crossings of the circle by ascending time, then the disc of τ.
struct NearSide {
  const LocalPair& pair;
  const Horizon& horizon;
  std::array<Vec2, kMaxPoints> points{};
  int count = 0;
  double least = std::numeric_limits<double>::infinity();  // |b| at its turning times

  void add(Vec2 point) {
    if (count < kMaxPoints) points[static_cast<std::size_t>(count++)] = point;
  }

  // |b| is monotone between the two times; b = nullptr stands for t = 0, where |b| is infinite.
  void cross(const ResponseAt& from, double b_from, const ResponseAt& to, double b_to) {
    if ((b_from > pair.R) == (b_to > pair.R)) return;
    // |b|^{-1/2} is nearly linear in t
    const double target = 1.0 / std::sqrt(pair.R);
    const auto f = [&](const ResponseAt& at) {
      return 1.0 / std::sqrt(norm(near_side(pair, at))) - target;
    };
    const double f_from = std::isinf(b_from) ? -target : 1.0 / std::sqrt(b_from) - target;
    const ResponseAt at =
        find_zero(horizon, from.time, to.time, f_from, 1.0 / std::sqrt(b_to) - target, f);
    const Vec2 b = near_side(pair, at);
    const auto ends = circle_points(pair, at);
    add(norm_squared(ends[0] - b) <= norm_squared(ends[1] - b) ? ends[0] : ends[1]);
  }
};

// All crossings of the near side. |b| falls up to the closest approach t_m; it can cross R outwards
// only while R g' < |v|, and from then on it falls wherever it exceeds R. So only times between
// those two need a search for turning points, on a grid that is geometric as the passage itself.
void find_crossings(NearSide& side) {
  const LocalPair& pair = side.pair;
  const Horizon& horizon = side.horizon;
  const double speed = norm(pair.v);
  const double t_m = speed > 0.0 ? -pair.v.x * pair.d / (speed * speed) : 0.0;
  const ResponseAt end = horizon.end();

  ResponseAt from{};
  double b_from = std::numeric_limits<double>::infinity();
  double f_from = 1.0;
  ResponseAt to = t_m > 0.0 && t_m < end.time ? horizon.at(t_m) : from;
  double stride = 0.125 * std::max(pair.d * pair.v.y / speed, pair.r) / speed;
  while (from.time < end.time) {
    if (!(to.time > 0.0 && to.time == t_m)) {
      const bool settled = pair.R * from.rate >= speed;
      const double next = from.time + stride;
      to = settled || !(next < end.time) || !(next > from.time) ? end : horizon.at(next);
      stride *= 1.5;
    }
    const double b_to = norm(near_side(pair, to));
    const double f_to = falling(pair, to);
    if ((f_from < 0.0) != (f_to < 0.0) && from.time > 0.0) {
      const auto f = [&](const ResponseAt& at) { return falling(pair, at); };
      const ResponseAt turn = find_zero(horizon, from.time, to.time, f_from, f_to, f);
      const double b_turn = norm(near_side(pair, turn));
      side.least = std::min(side.least, b_turn);
      side.cross(from, b_from, turn, b_turn);
      side.cross(turn, b_turn, to, b_to);
    } else {
      side.cross(from, b_from, to, b_to);
    }
    side.least = std::min(side.least, b_to);
    from = to, b_from = b_to, f_from = f_to;
    to = {};
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
