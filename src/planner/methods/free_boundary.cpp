// SPDX-License-Identifier: Apache-2.0
// Boundaries of Eq. (13) as exact curves: Eq. (29) for the sides of an obstacle.
#include "planner/methods/free_boundary.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace avo::inline planner {
namespace {

constexpr int kSidePoints = 16;
constexpr int kArcPieces = 4;
constexpr int kCircleArcs = 8;  // a power of two, each cut into kArcPieces
constexpr int kSegmentPieces = 8;

Vec2 unit(Vec2 a) {
  return a / norm(a);
}

// Before this time no disc of the obstacle is within reach: |p| - r > |v| t + W g(t).
double first_time(const Obstacle& obstacle, double reach) {
  const Pair& pair = obstacle.pair;
  const double gap = norm(pair.position) - pair.radius;
  const double speed = norm(pair.velocity);
  return last_time(obstacle.time_horizon,
                   [&](double t) { return gap > speed * t + reach * obstacle.response.gain(t); });
}

// Normal of the side at time t, n . (p + s v) = r: where neighboring discs have a common tangent.
Vec2 side_normal(const Obstacle& obstacle, double t, double sign) {
  const double r = obstacle.pair.radius;
  const Vec2 y = obstacle.pair.position + obstacle.response.lag(t) * obstacle.pair.velocity;
  const double y_squared = norm_squared(y);
  const double length = norm(y);
  const double l = std::sqrt(std::max(0.0, (length - r) * (length + r)));
  return unit((r / y_squared) * y + (sign * l / y_squared) * perpendicular(y));
}

struct Window {
  double from, to;
};

// The times that have tangents, |p + s(t) v| >= r: all, or two windows around the times without
// tangents.
std::array<Window, 2> tangent_windows(const Obstacle& obstacle, double first) {
  const Pair& pair = obstacle.pair;
  const double last = obstacle.time_horizon;
  const Window all{first, last}, none{1.0, 0.0};
  const double speed = norm(pair.velocity);
  const double miss = speed > 0.0 ? std::abs(cross(pair.position, pair.velocity)) / speed : 0.0;
  const double closing = -dot(pair.position, pair.velocity);
  if (!(closing > 0.0) || !(miss < pair.radius)) return {all, none};
  const double half = std::sqrt((pair.radius - miss) * (pair.radius + miss)) / speed;
  const double lag_in = closing / (speed * speed) - half;
  const double lag_out = closing / (speed * speed) + half;
  const auto time_of = [&](double lag) {
    return last_time(last, [&](double t) { return obstacle.response.lag(t) < lag; });
  };
  const double lag_end = obstacle.response.lag(last);
  if (lag_end <= lag_in) return {all, none};
  const Window before{first, time_of(lag_in)};
  if (lag_end <= lag_out) return {before, none};
  return {before, Window{std::max(first, time_of(lag_out)), last}};
}

// Collects the points of one curve after the other and the pieces between them.
struct Sampler {
  PassiveWorkspace& to;
  std::size_t first = 0;  // point of the curve

  void begin(const Curve& curve) {
    to.curves.push_back(curve);
    first = to.points.size();
  }
  void add(double parameter) {
    to.points.push_back(point_at(to.curves.back(), to.limits, parameter));
    const int last = static_cast<int>(to.points.size()) - 1;
    if (to.points.size() - first < 2) return;
    to.pieces.push_back({static_cast<int>(to.curves.size()) - 1, last - 1, last, 0.0});
  }
  void add_parts(int count) {
    for (int k = 0; k <= count; ++k) add(static_cast<double>(k) / count);
  }
};

void sample_obstacle(int k, const Limit& limit, double reach, Sampler& sampler) {
  const Obstacle& obstacle = limit.obstacle;
  const double last = obstacle.time_horizon;
  // in contact the sides come from infinity at t = 0; nothing changes within 2^-30 of the window
  const double first = std::max(first_time(obstacle, reach), 0x1p-30 * last);
  for (const Window& window : tangent_windows(obstacle, first)) {
    if (!(window.from < window.to)) continue;
    for (const double sign : {-1.0, 1.0}) {
      sampler.begin({Curve::Kind::side, k, sign, {}, {}, {}});
      // even steps of 1/t are about even steps of velocity
      for (int i = 0; i < kSidePoints; ++i) {
        const double part = static_cast<double>(i) / kSidePoints;
        sampler.add(1.0 / ((1.0 - part) / window.from + part / window.to));
      }
      sampler.add(window.to);
    }
  }
  // the exposed arc of the last disc: n . (p + s(τ) v) >= r
  const Vec2 y = obstacle.pair.position + obstacle.response.lag(last) * obstacle.pair.velocity;
  if (!(norm(y) >= obstacle.pair.radius)) return;
  Disc end = disc(obstacle, last);
  end.center = end.center + limit.v_new_B;
  for (const double sign : {-1.0, 1.0}) {
    sampler.begin({Curve::Kind::arc, k, 1.0, end, side_normal(obstacle, last, sign), unit(y)});
    sampler.add_parts(kArcPieces);
  }
}

// A circle as arcs between directions at equal angles, by halving a quarter turn.
void sample_circle(int k, const Disc& disc, Sampler& sampler) {
  const double diagonal = std::sqrt(0.5);
  std::array<Vec2, kCircleArcs> directions{{{1, 0},
                                            {diagonal, diagonal},
                                            {0, 1},
                                            {-diagonal, diagonal},
                                            {-1, 0},
                                            {-diagonal, -diagonal},
                                            {0, -1},
                                            {diagonal, -diagonal}}};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    sampler.begin(
        {Curve::Kind::arc, k, 1.0, disc, directions[i], directions[(i + 1) % directions.size()]});
    sampler.add_parts(kArcPieces);
  }
}

}  // namespace

CurvePoint point_at(const Curve& curve, std::span<const Limit> limits, double parameter) {
  if (curve.kind == Curve::Kind::segment) {
    const Vec2 along = curve.second - curve.first;
    return {parameter, curve.first + parameter * along, unit(perpendicular(along))};
  }
  if (curve.kind == Curve::Kind::arc) {
    const Vec2 n = unit((1.0 - parameter) * curve.first + parameter * curve.second);
    return {parameter, curve.disc.center + curve.disc.radius * n, n};
  }
  // Eq. (29): w = (r n - p - t v)/g
  const Limit& limit = limits[static_cast<std::size_t>(curve.limit)];
  const Obstacle& obstacle = limit.obstacle;
  const Pair& pair = obstacle.pair;
  const double t = parameter;
  const Vec2 n = side_normal(obstacle, t, curve.sign);
  const Vec2 w = (pair.radius * n - pair.position - t * pair.velocity) / obstacle.response.gain(t);
  return {t, unchanged(obstacle, limit.v_new_B) + w, n};
}

void append_boundary(int k, const Disc& acceleration, const Disc& speed,
                     PassiveWorkspace& workspace) {
  Sampler sampler{workspace};
  const Limit& limit = workspace.limits[static_cast<std::size_t>(k)];
  switch (limit.kind) {
    case Limit::Kind::obstacle:
      sample_obstacle(k, limit,
                      reach_from(unchanged(limit.obstacle, limit.v_new_B), acceleration, speed),
                      sampler);
      return;
    case Limit::Kind::disc:
      sample_circle(k, limit.disc, sampler);
      return;
    case Limit::Kind::line:
      break;
  }
  const Disc& inner = acceleration.radius < speed.radius ? acceleration : speed;
  const Vec2 n = limit.line.normal;
  const Vec2 foot = inner.center + (limit.line.offset - dot(n, inner.center)) * n;
  const Vec2 half = inner.radius * perpendicular(n);
  sampler.begin({Curve::Kind::segment, k, 1.0, {}, foot - half, foot + half});
  sampler.add_parts(kSegmentPieces);
}

}  // namespace avo::inline planner
