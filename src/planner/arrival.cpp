// SPDX-License-Identifier: Apache-2.0
// Keep right in traffic, back out of a jam.
#include "planner/arrival.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace avo {
namespace {

double env(const char* name, double fallback) {
  const char* text = std::getenv(name);
  return text ? std::atof(text) : fallback;
}

}  // namespace

Vec2 turned_right(Vec2 a, double angle) {
  // t = tan(angle / 2) by a continued fraction; the turn is a rotation whatever t is
  const double x = 0.5 * angle, x2 = x * x;
  const double t = x / (1.0 - x2 / (3.0 - x2 / (5.0 - x2 / (7.0 - x2 / 9.0))));
  const double c = (1.0 - t * t) / (1.0 + t * t), s = 2.0 * t / (1.0 + t * t);
  return {c * a.x + s * a.y, c * a.y - s * a.x};
}

Vec2 keep_right(const Robot& robot, std::span<const Neighbor> neighbors) {
  static const double range = env("KR_RANGE", 8.0), count = env("KR_COUNT", 3.0),
                      most = env("KR_ANGLE", 30.0) * 3.14159265358979 / 180;
  const double speed = norm(robot.preferred_velocity);
  if (!(speed > 0.0)) return robot.preferred_velocity;
  const Vec2 way = robot.preferred_velocity / speed;
  double congestion = 0.0;
  for (const Neighbor& neighbor : neighbors) {
    const Vec2 towards = neighbor.position - robot.position;
    const double distance = norm(towards);
    if (distance >= range) continue;
    if (dot(towards, way) <= 0.0) continue;
    const bool closing = dot(towards, neighbor.velocity - robot.velocity) < 0.0;
    const bool slow = norm_squared(neighbor.velocity) < 0.01;
    if (!closing && !slow) continue;
    congestion += (1.0 - distance / range) / count;
    if (congestion >= 1.0) break;
  }
  return turned_right(robot.preferred_velocity, most * std::min(congestion, 1.0));
}

bool is_blocked(Vec2 next_velocity, Vec2 unhindered_next_velocity, Vec2 preferred) {
  return dot(next_velocity, preferred) < 0.5 * dot(unhindered_next_velocity, preferred);
}

}  // namespace avo
