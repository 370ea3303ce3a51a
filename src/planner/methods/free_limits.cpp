// SPDX-License-Identifier: Apache-2.0
// The tests of the limits of Eq. (13), and their drawing on the safe side.
#include "planner/methods/free_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace avo::inline planner {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Roundings that a distance or a boundary point may carry, in ulp of the sum of its terms.
constexpr double kSlackUlps = 64.0;

// The line that parts an overlapping pair: n = p/|p| over the shortest window after which the pair
// can be apart, n . w >= (r - |p| - T n . v)/g(T). No direction if both p and v are 0.
void append_line(const PassiveObstacle& mover, double reach, std::vector<Limit>& limits) {
  const Obstacle& obstacle = mover.obstacle;
  const Pair& pair = obstacle.pair;
  const Vec2 along = pair.position == Vec2{} ? pair.velocity : pair.position;
  const double length = norm(along);  // 0 also where its square underflows
  if (!(length > 0.0)) return;
  const Vec2 n = along / length;
  const double A = pair.radius - dot(n, pair.position);
  const double B = dot(n, pair.velocity);
  const auto falls_short = [&](double T) { return B * T + reach * obstacle.response.gain(T) < A; };
  double window = obstacle.time_horizon;
  if (!falls_short(window)) {
    window = std::nextafter(last_time(window, falls_short), window);
  }
  window = std::clamp(window, std::min(mover.shortest_window, obstacle.time_horizon),
                      obstacle.time_horizon);
  const Vec2 origin = unchanged(obstacle, mover.v_new_B);
  Limit limit;
  limit.kind = Limit::Kind::line;
  const double demand = (A - B * window) / obstacle.response.gain(window);
  limit.slack = kSlackUlps * kEpsilon * (norm(origin) + std::abs(demand));
  limit.line = {n, dot(n, origin) + demand + limit.slack};
  limits.push_back(limit);
}

}  // namespace

double reach_from(Vec2 from, const Disc& acceleration, const Disc& speed) {
  return std::min(norm(acceleration.center - from) + acceleration.radius,
                  norm(speed.center - from) + speed.radius);
}

double clearance(const Limit& limit, Vec2 v_new) {
  switch (limit.kind) {
    case Limit::Kind::obstacle:
      return closest_approach(limit.obstacle, v_new - limit.v_new_B).distance -
             limit.obstacle.pair.radius + 0.5 * limit.slack;
    case Limit::Kind::line:
      return dot(limit.line.normal, v_new) - limit.line.offset + 0.5 * limit.slack;
    case Limit::Kind::disc:
      break;
  }
  return limit.disc.radius - norm(v_new - limit.disc.center) + 0.5 * limit.slack;
}

bool violates(const Limit& limit, Vec2 v_new) {
  if (limit.kind != Limit::Kind::obstacle) return clearance(limit, v_new) < 0.0;
  Obstacle allowed = limit.obstacle;
  allowed.pair.radius -= 0.5 * limit.slack;
  return contains(allowed, v_new - limit.v_new_B);
}

double steepness(const Limit& limit) {
  return limit.kind == Limit::Kind::obstacle
             ? limit.obstacle.response.gain(limit.obstacle.time_horizon)
             : 1.0;
}

double violation(const Limit& limit, Vec2 v_new) {
  switch (limit.kind) {
    case Limit::Kind::obstacle: {
      const ClosestApproach nearest = closest_approach(limit.obstacle, v_new - limit.v_new_B);
      const double depth = limit.true_radius - nearest.distance;
      return depth > 0.0 ? depth / limit.obstacle.response.gain(nearest.time) : 0.0;
    }
    case Limit::Kind::line:
      return std::max(0.0, limit.line.offset - limit.slack - dot(limit.line.normal, v_new));
    case Limit::Kind::disc:
      break;
  }
  return std::max(0.0, norm(v_new - limit.disc.center) - limit.disc.radius - limit.slack);
}

void append_limit(const PassiveObstacle& mover, const Disc& acceleration, const Disc& speed,
                  std::vector<Limit>& limits) {
  const Obstacle& obstacle = mover.obstacle;
  const Pair& pair = obstacle.pair;
  const Vec2 origin = unchanged(obstacle, mover.v_new_B);
  const double reach = reach_from(origin, acceleration, speed);
  const double distance = norm(pair.position);
  if (distance < pair.radius) return append_line(mover, reach, limits);
  const double tau = obstacle.time_horizon;
  const double gain = obstacle.response.gain(tau);
  if (distance - pair.radius > norm(pair.velocity) * tau + reach * gain) return;
  Limit limit;
  limit.kind = Limit::Kind::obstacle;
  limit.obstacle = obstacle;
  limit.v_new_B = mover.v_new_B;
  limit.true_radius = pair.radius;
  limit.slack =
      kSlackUlps * kEpsilon *
      (distance + pair.radius + tau * norm(pair.velocity) + gain * (reach + norm(origin)));
  limit.obstacle.pair.radius = std::min(pair.radius + limit.slack, distance);
  limits.push_back(limit);
}

void append_limit(const HalfPlane& plane, std::vector<Limit>& limits) {
  Limit limit;
  limit.kind = Limit::Kind::line;
  limit.slack = kSlackUlps * kEpsilon * (1.0 + std::abs(plane.offset));
  limit.line = {plane.normal, plane.offset + limit.slack};
  limits.push_back(limit);
}

void append_limit(const Disc& disc, std::vector<Limit>& limits) {
  if (!std::isfinite(disc.radius)) return;
  Limit limit;
  limit.slack = kSlackUlps * kEpsilon * (norm(disc.center) + disc.radius);
  limit.disc = {disc.center, std::max(0.0, disc.radius - limit.slack)};
  limits.push_back(limit);
}

}  // namespace avo::inline planner
