// SPDX-License-Identifier: Apache-2.0
// Eqs. (15), (16) where the present velocity does not lead into a collision: the obstacle is a
// bent horn whose near side, the one towards w = 0, is concave. Its hull within reach then has as
// near corners the disc of τ and the points Q where the near side crosses the circle |w| = R; the
// half-plane is the least among the tangent of that disc and the chords between those corners.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "obstacles/local_pair.h"

namespace avo {
namespace {

constexpr int kMaxIterations = 64;
// |b| turns five times at most (three signs of `tangential`, two cusps): six pieces with a crossing
// each, three ends of the first disc, two corners of the last.
constexpr int kMaxPoints = 12;
constexpr double kTimeTolerance = 1e-7;  // relative; every use is of second order in the time

// The pair with what does not depend on the time. In contact |x|² - r² is as small as t², and the
// near side a difference of such numbers over g ~ t²: so they are kept as sums of small terms.
struct Horn {
  const LocalPair& pair;
  const Horizon& horizon;
  double gap;    // |p|² - r², m²
  double along;  // p . v, m²/s
  double v2;     // |v|²

  Horn(const LocalPair& local, const Horizon& table)
      : pair(local),
        horizon(table),
        gap((local.d - local.r) * (local.d + local.r)),
        along(local.d * local.v.x),
        v2(norm_squared(local.v)) {}

  double beyond(double t) const { return gap + t * (2.0 * along + t * v2); }  // |p + t v|² - r²
};

// The near side at one time: the point b = (r n - x)/g, n . y = r, at which it touches the disc.
// With x = y + (t - s) v and t - s = g/g', b has the components -n . v/g' along n and `tangential`
// across it. It moves across n only, by -cusp/(g l) with l² = |y|² - r²: so |b| turns where
// `tangential` or `cusp` changes its sign, and falls at first, when both are positive.
struct Touch {
  ResponseAt at;
  Vec2 b;             // m/s
  double length;      // |b|, m/s
  double l;           // m
  double tangential;  // m/s
  double cusp;        // l² g'/g - r s' n . v, m²/s
};

Touch touch_at(const Horn& horn, const ResponseAt& at) {
  const double r = horn.pair.r;
  const Vec2 y = horn.pair.y(at), v = horn.pair.v;
  const double l2 = std::max(0.0, horn.beyond(at.lag)), l = std::sqrt(l2);
  const double per_y2 = 1.0 / norm_squared(y), per_rate = 1.0 / at.rate, per_gain = 1.0 / at.gain;
  const Vec2 n = {(r * y.x - l * y.y) * per_y2, (r * y.y + l * y.x) * per_y2};
  const double n_v = dot(n, v);
  const double normal = -n_v * per_rate;
  const double tangential = l * per_gain - dot(perpendicular(n), v) * per_rate;
  const double lag_rate =
      at.gain * (1.0 - at.rate) * per_rate * per_rate / horn.horizon.control_time();
  return {at,
          normal * n + tangential * perpendicular(n),
          std::sqrt(normal * normal + tangential * tangential),
          l,
          tangential,
          l2 * at.rate * per_gain - r * lag_rate * n_v};
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

// Where the circle |w| = R cuts the disc of one time, the end on the near side first.
std::array<Vec2, 2> circle_points(const Horn& horn, const ResponseAt& at) {
  const Vec2 x = horn.pair.x(at);
  const double R = horn.pair.R, length = norm(x), gain_R = at.gain * R;
  const double c =
      std::clamp(-(horn.beyond(at.time) + gain_R * gain_R) / (2.0 * gain_R * length), -1.0, 1.0);
  const double s = std::sqrt((1.0 - c) * (1.0 + c));
  const Vec2 u = x / length;
  return {{R * Vec2{c * u.x - s * u.y, c * u.y + s * u.x},
           R * Vec2{c * u.x + s * u.y, c * u.y - s * u.x}}};
}

// The corners of the hull on the near side, in the order of walking along it with the obstacle on
// the right: the crossings of the circle by ascending time.
struct Corners {
  std::array<Vec2, kMaxPoints> points{};
  int count = 0;

  void add(Vec2 point) {
    if (count < kMaxPoints) points[static_cast<std::size_t>(count++)] = point;
  }
};

// The only time between two at which |b| = R: Newton's iteration for |b|^{-1/2}, which is nearly
// linear in t, then bisection.
Touch crossing(const Horn& horn, const Touch& from, const Touch& to) {
  const double R = horn.pair.R;
  // the limit keeps the first step, one of false position, in balance
  const auto f = [&](double length) { return std::sqrt(std::min(R / length, 9.0)) - 1.0; };
  double low = from.at.time, high = to.at.time;
  const double f_low = f(from.length), f_high = f(to.length);
  double t = (low * f_high - high * f_low) / (f_high - f_low);
  for (int i = 0;; ++i) {
    if (!(t > low && t < high) || i > 16) t = 0.5 * (low + high);
    const Touch touch = touch_at(horn, horn.horizon.at(t));
    ((touch.length > R) == (from.length > R) ? low : high) = t;
    const double fall = touch.tangential * touch.cusp / (touch.at.gain * touch.l * touch.length);
    const double next = t + 2.0 * (std::sqrt(touch.length / R) - 1.0) * touch.length / fall;
    // far from the root steps are short as well, where |b| is, or l
    const bool close =
        std::abs(touch.length - R) <= 0.5 * R && std::abs(next - t) <= kTimeTolerance * t;
    if (close || high - low <= kTimeTolerance * high || i == kMaxIterations) return touch;
    t = next;
  }
}

// The crossing of a piece that has one at most, if there is one.
void cross(const Horn& horn, const Touch& from, const Touch& to, Corners& corners) {
  const double R = horn.pair.R;
  if ((from.length > R) == (to.length > R)) return;
  const Touch touch = crossing(horn, from, to);
  const auto ends = circle_points(horn, touch.at);
  const bool on_near_end = norm_squared(ends[0] - touch.b) <= norm_squared(ends[1] - touch.b);
  // In contact, the first disc's edge can be the near side, up to where the others take over.
  if (!on_near_end && corners.count == 0) corners.add(ends[0]);
  corners.add(on_near_end ? ends[0] : ends[1]);
}

// The crossings of a piece on which |b| may turn once by either sign.
void cross_turning(const Horn& horn, const Touch& from, const Touch& to, Corners& corners) {
  const bool falls = (from.tangential < 0.0) == (from.cusp < 0.0);
  const bool falls_later = (to.tangential < 0.0) == (to.cusp < 0.0);
  const bool outside = from.length > horn.pair.R, outside_later = to.length > horn.pair.R;
  // it turns once, and not through R and back: down from outside, or up from inside
  if (falls != falls_later && (outside != outside_later || outside != falls)) {
    return cross(horn, from, to, corners);
  }
  const auto turn = [&](double Touch::*sign) {
    if ((from.*sign < 0.0) == (to.*sign < 0.0)) return from;
    return touch_at(horn,
                    find_zero(horn.horizon, from.at.time, to.at.time, from.*sign, to.*sign,
                              [&](const ResponseAt& at) { return touch_at(horn, at).*sign; }));
  };
  Touch first = turn(&Touch::tangential), second = turn(&Touch::cusp);
  if (second.at.time < first.at.time) std::swap(first, second);
  cross(horn, from, first, corners);
  cross(horn, first, second, corners);
  cross(horn, second, to, corners);
}

// Earlier than this a pair in contact cannot be told from one that touches at rest: its discs have
// tended to a half-plane, to first order in t.
double contact_time(const Horn& horn, double speed) {
  return 1e-7 * std::min(horn.pair.r / speed, horn.horizon.control_time());
}

// The time from which on the near side matters: never nearer than `closest`, all is out of reach
// while R t²/(2 δ) < closest - r.
double first_time(const Horn& horn, double t_m, double speed) {
  const LocalPair& pair = horn.pair;
  const double closest = t_m > 0.0 ? pair.d * pair.v.y / speed : pair.d;
  const double out_of_reach =
      std::sqrt(std::max(0.0, 2.0 * horn.horizon.control_time() * (closest - pair.r) / pair.R));
  return std::max(out_of_reach, (t_m > 0.0 ? 0.5 : 1.0) * contact_time(horn, speed));
}

// The time whose lag is t_m, where y comes nearest: the near side of a close pass has two cusps
// around it at most if s' g/g' > b √(b² - r²)/(1.3 r |v|), b the miss distance (horn_kernel.h).
// s' g/g' is below 0.271 δ always.
double cusp_time(const Horn& horn, double t_m, double speed) {
  const double b = horn.pair.d * horn.pair.v.y / speed, r = horn.pair.r;
  const ResponseAt& last = horn.horizon.end();
  const double l2 = std::max(0.0, (b - r) * (b + r)), most = 0.353 * horn.horizon.control_time();
  if (!(t_m > 0.0) || last.lag <= t_m || b * std::sqrt(l2) >= most * r * speed) return 0.0;
  return find_zero(horn.horizon, t_m, last.time, horn.horizon.at(t_m).lag - t_m, last.lag - t_m,
                   [&](const ResponseAt& at) { return at.lag - t_m; })
      .time;
}

// The next time of the search for turning points, as wide as the passage itself.
double next_time(const LocalPair& pair, double t_m, double t_cusp, double speed, double t) {
  if (t < t_m) return t_m;
  if (t_m <= 0.0) return 1.5 * t;
  const double least = std::min(0.125 * pair.d * pair.v.y / (speed * speed), 0.25 * t_m);
  const double next = t + std::max(0.5 * (t - t_m), least);
  return t < t_cusp && t_cusp < next ? t_cusp : next;
}

// Is |b| below R from here on? |b| <= |x|/g, and |x|/g <= R stays so once |v| <= R g'.
bool stays_in_reach(const Horn& horn, const Touch& touch) {
  const double R = horn.pair.R;
  return touch.length <= R && horn.v2 <= R * R * touch.at.rate * touch.at.rate &&
         norm_squared(horn.pair.x(touch.at)) <= R * R * touch.at.gain * touch.at.gain;
}

// All crossings of the near side. |b| falls up to the closest approach t_m. Past the cusps it can
// cross R outwards only while R g' < |v|, and then falls wherever it exceeds R. So only times
// between those two are searched for turning points.
void find_crossings(const Horn& horn, Corners& corners) {
  const LocalPair& pair = horn.pair;
  const ResponseAt& last = horn.horizon.end();
  const double speed = std::sqrt(horn.v2);
  double t_m = speed > 0.0 ? -horn.along / horn.v2 : 0.0;
  if (t_m < contact_time(horn, speed)) t_m = 0.0;
  const double first = first_time(horn, t_m, speed);
  Touch from = touch_at(horn, first < last.time ? horn.horizon.at(first) : last);
  if (pair.R * from.at.gain * (2.0 * pair.r) > horn.beyond(from.at.time)) {
    // in contact from the start: the first disc's edge is a half-plane's
    for (const Vec2 end : circle_points(horn, from.at)) corners.add(end);
  }
  double t_cusp = -1.0;
  while (from.at.time < last.time && !stays_in_reach(horn, from)) {
    if (t_cusp < 0.0 && from.at.time >= t_m) t_cusp = cusp_time(horn, t_m, speed);
    const bool settled = pair.R * from.at.rate >= speed && t_cusp >= 0.0 &&
                         from.at.time >= t_cusp && from.cusp >= 0.0;
    const double t = settled ? last.time : next_time(pair, t_m, t_cusp, speed, from.at.time);
    const Touch to = touch_at(horn, t > from.at.time && t < last.time ? horn.horizon.at(t) : last);
    settled ? cross(horn, from, to, corners) : cross_turning(horn, from, to, corners);
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
double support(const Corners& corners, const Disc& disc, bool disc_in_reach, double R, Vec2 n) {
  double h = -std::numeric_limits<double>::infinity();
  if (disc_in_reach && norm(disc.center + disc.radius * n) <= R) {
    h = dot(n, disc.center) + disc.radius;
  }
  for (int k = 0; k < corners.count; ++k) {
    h = std::max(h, dot(n, corners.points[static_cast<std::size_t>(k)]));
  }
  return h;
}

}  // namespace

LocalPlane horn_half_plane(const LocalPair& pair, const Horizon& horizon) {
  const Horn horn(pair, horizon);
  const ResponseAt& end = horizon.end();
  const Vec2 x = pair.x(end);
  const Disc disc{-x / end.gain, pair.r / end.gain};
  const bool disc_in_reach = norm(x) - pair.r < pair.R * end.gain;

  Corners corners;
  find_crossings(horn, corners);
  if (!disc_in_reach && corners.count == 0) return {true, {}, 0.0};
  const int crossings = corners.count;
  if (disc_in_reach && norm(disc.center) + disc.radius > pair.R) {
    for (const Vec2 corner : circle_points(horn, end)) corners.add(corner);
  }

  LocalPlane best{false, {}, std::numeric_limits<double>::infinity()};
  const auto offer = [&](Vec2 n) {
    const double h = support(corners, disc, disc_in_reach, pair.R, n);
    if (h < best.h) best = {false, n, h};
  };
  if (disc_in_reach) offer(x / norm(x));
  for (int k = 0; k < crossings; ++k) {
    const Vec2 q = corners.points[static_cast<std::size_t>(k)];
    if (disc_in_reach && norm(q - disc.center) > disc.radius) offer(tangent_normal(q, disc));
    for (int j = k + 1; j < corners.count; ++j) {
      const Vec2 b = corners.points[static_cast<std::size_t>(j)];
      if (!(q == b)) offer(chord_normal(q, b));
    }
  }
  return best;
}

}  // namespace avo
