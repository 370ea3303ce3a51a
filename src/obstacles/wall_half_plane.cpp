// SPDX-License-Identifier: Apache-2.0
// Eqs. (15), (16) for a wall. Lemmas 11 to 13 of docs/half_plane.md.
#include "obstacles/wall_half_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "obstacles/constants.h"
#include "obstacles/wall_horn.h"
#include "obstacles/wall_pair.h"

namespace avo::inline obstacles {
namespace {

// A part of τ: the shortest time that rounding can distinguish from 0.
constexpr double kShortest = 4 * std::numeric_limits<double>::epsilon();

// ds/dt
double lag_rate(const ResponseAt& at, double control_time) {
  return at.gain * (1.0 - at.rate) * at.per_rate * at.per_rate / control_time;
}

// The instant of that lag, or τ. The lag is concave and at most t/2: Newton's iteration comes from
// the left.
ResponseAt instant_of_lag(double lag, const Horizon& horizon) {
  const ResponseAt& end = horizon.end();
  if (!(lag < end.lag)) return end;
  ResponseAt at = horizon.at(std::max(2.0 * lag, kShortest * end.time));
  for (int i = 0; i < kMaxIterations; ++i) {
    const double step = (lag - at.lag) / lag_rate(at, horizon.control_time());
    if (!(step > kConvexTolerance * at.time)) return at;
    at = horizon.at(std::min(at.time + step, end.time));
  }
  return at;
}

// A robot that drives at the wall, with the flat side of the wall towards it: Lemma 12.
struct DriveAtWall {
  const WallPair& pair;
  const Horizon& horizon;
  double tolerance;  // m/s
  HalfPlane least{{}, std::numeric_limits<double>::infinity()};

  void offer(Vec2 n, double h) {
    if (h < least.offset - tolerance) least = {n, h};
  }
};

// Braking: the line of the wall's own direction.
void offer_facing(const Facing& wall, DriveAtWall& course) {
  const Vec2 n = wall.normal;
  const double closing = -dot(n, course.pair.velocity), gap = wall.distance - course.pair.radius;
  const ResponseAt& end = course.horizon.end();
  // in contact, the course towards the wall may come from rounding
  const ResponseAt at = closing > 0.0 ? instant_of_lag(gap / closing, course.horizon) : end;
  const bool at_end = at.time >= end.time;
  course.offer(n, at_end ? (at.time * closing - gap) / at.gain : closing * at.per_rate);
}

// The disc of τ about one end.
void offer_tip(Vec2 from_end, Vec2 from_other, DriveAtWall& course) {
  const ResponseAt& end = course.horizon.end();
  const Vec2 v = course.pair.velocity, x = from_end + end.time * v;
  const double r = course.pair.radius, length = norm(x);
  if (!(length > 0.0)) return;
  const Vec2 n = x / length;
  if (dot(n, from_end) >= r && dot(n, from_end + end.lag * v) >= r &&
      dot(n, from_end) <= dot(n, from_other)) {
    course.offer(n, (r - length) / end.gain);
  }
}

// One side of the obstacle of one end, on the left of p (1) or on its right (-1). Where the line of
// the side is nearest to w = 0, σ = -c tan(α + β): sin α = r/|y|, sin β = c/|y|, and c > 0 is the
// miss distance where the side is the far one.
struct WallSide {
  double speed, t_m, c, r;  // m/s; s; m; m

  // m: how far the robot has moved with v beyond the place where the line of the side would be
  // nearest; and its rate, m/s
  [[nodiscard]] std::pair<double, double> ahead(const ResponseAt& at, double lag_rate) const {
    const double m = speed * (t_m - at.lag), l2 = m * m + c * c - r * r;
    const double l = std::sqrt(std::max(0.0, l2));
    const double cosine = l * m - r * c, sine = r * m + l * c;
    const double turn = c * (m * m + c * c) * lag_rate * sine / (l * cosine * cosine);
    return {speed * (at.time - t_m) - c * sine / cosine, speed * (1.0 - turn)};
  }
  // The lag up to which the side is convex and may turn towards w = 0.
  [[nodiscard]] double last_lag() const {
    const double m = c > 0.0 ? r : std::sqrt(std::max(0.0, (r - c) * (r + c)));
    return t_m - m / speed;
  }
};

// The first instant at which the line of the side is nearest to w = 0: Newton's iteration, guarded
// by bisection where there is surely one. On the far side there may be two or none: a step that
// takes the rate for |v| never passes the first.
std::optional<ResponseAt> turning_instant(const WallSide& side, const Horizon& horizon) {
  const double last_lag = side.last_lag(), control_time = horizon.control_time();
  if (!(last_lag > 0.0)) return {};
  const auto ahead = [&](const ResponseAt& at) {
    return side.ahead(at, lag_rate(at, control_time));
  };
  const ResponseAt last = instant_of_lag(last_lag, horizon);
  const bool is_far = side.c > 0.0;
  bool bracketed = ahead(last).first >= 0.0 && !(is_far && last.lag >= last_lag);
  if (!bracketed && !is_far) return {};
  double low = 0.0, high = last.time;
  // any instant of the side gives a sound line, so that the last one will do
  ResponseAt at = horizon.at(kShortest * high);
  for (int i = 0; i < kMaxIterations; ++i) {
    const auto [left, rate] = ahead(at);
    (left < 0.0 ? low : high) = at.time;
    bracketed = bracketed || !(left < 0.0);
    double next = at.time - left / (rate > 0.0 ? rate : side.speed);
    if (std::abs(next - at.time) <= kConvexTolerance * at.time) break;
    if (!(next > low && next < high))
      next = bracketed ? 0.5 * (low + high) : at.time - left / side.speed;
    if (!(next < high)) return {};
    at = horizon.at(next);
  }
  return at;
}

void offer_side(Vec2 from_end, Vec2 from_other, double sign, DriveAtWall& course) {
  const Vec2 v = course.pair.velocity;
  const double speed = norm(v), r = course.pair.radius;
  const double c = -sign * cross(from_end, v) / speed;
  // the robot passes it, unless the other end is in its path
  if (c < -(1.0 + kContact) * r) return;
  const auto at =
      turning_instant({speed, -dot(from_end, v) / (speed * speed), c, r}, course.horizon);
  if (!at) return;
  const Vec2 y = from_end + at->lag * v;
  const double y2 = norm_squared(y), l = std::sqrt(std::max(0.0, y2 - r * r));
  const Vec2 n = (1.0 / y2) * (r * y + (sign * l) * perpendicular(y));
  if (!(dot(n, from_end) <= dot(n, from_other))) return;
  course.offer(n, -dot(n, v) * at->per_rate);  // F where n . y = r
}

RelativeHalfPlane collision_course(const WallPair& pair, const Facing& wall, double reach,
                                   const Horizon& horizon) {
  DriveAtWall course{pair, horizon, kEqualSupports * reach};
  offer_facing(wall, course);
  for (const double sign : {1.0, -1.0}) {  // the left ones first
    offer_side(pair.from_a, pair.from_b, sign, course);
    offer_side(pair.from_b, pair.from_a, sign, course);
  }
  offer_tip(pair.from_a, pair.from_b, course);
  offer_tip(pair.from_b, pair.from_a, course);
  const auto [n, h] = course.least;
  if (h <= -reach) return {};
  if (h > reach) return {PairState::unavoidable, {n, reach}, h - reach};
  return {PairState::constrained, {n, h}};
}

}  // namespace

RelativeHalfPlane wall_half_plane(const WallPair& pair, double reach, const Horizon& horizon) {
  const Vec2 away = away_from_wall(pair, {}), v = pair.velocity;
  const double d = norm(away), r = pair.radius;
  if (!(norm(pair.from_a - pair.from_b) > 0.0))
    return half_plane({pair.from_a, v, r}, reach, horizon);
  if (d < r) return half_plane(pair_in_contact(pair, away), reach, horizon);
  const ResponseAt& end = horizon.end();
  if (d - r - reach * end.gain > norm(v) * end.time) return {};
  const Vec2 pass = nearest_pass(pair);
  const double miss = norm(pass);
  if (!(miss < r)) return wall_horn(pair, pass / miss, reach, horizon);
  const Facing wall = facing(pair);
  // the other end is hidden behind this one
  if (wall.distance < r && (away == pair.from_a || away == pair.from_b))
    return half_plane({away, v, r}, reach, horizon);
  return collision_course(pair, wall, reach, horizon);
}

}  // namespace avo::inline obstacles
