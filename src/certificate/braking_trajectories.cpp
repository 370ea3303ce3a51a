// SPDX-License-Identifier: Apache-2.0
// S3: walls of neighbors, and the test of a candidate against them.
#include "certificate/braking_trajectories.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "avo/half_plane.h"

namespace avo {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Bézier points of a relative path on one interval.
using Bezier = std::array<Vec2, 3>;

// The point of a segment nearest to the origin. Odd in (a, b), bit for bit.
Vec2 nearest_on_segment(Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double length_squared = norm_squared(ab);
  if (!(length_squared > 0.0)) return a;
  const double t = std::clamp(-dot(a, ab) / length_squared, 0.0, 1.0);
  return a + t * ab;
}

// Direction of the point of the triangle's boundary nearest to the origin; 0 if that is the origin.
// No sign test decides whether the origin lies inside: the wall's own distance tells (see below).
Vec2 normal_of(const Bezier& q) {
  Vec2 nearest = nearest_on_segment(q[0], q[1]);
  for (const Vec2 other : {nearest_on_segment(q[1], q[2]), nearest_on_segment(q[2], q[0])}) {
    if (norm_squared(other) < norm_squared(nearest)) nearest = other;
  }
  const double length = norm(nearest);
  return length > 0.0 ? nearest / length : Vec2{};
}

double wall_distance(Vec2 normal, const Bezier& q) {
  return std::min({dot(normal, q[0]), dot(normal, q[1]), dot(normal, q[2])});
}

// A robot that brakes, seen from p_A: its direction and how long it moves.
struct Braking {
  double speed = 0.0;
  double decrement = 0.0;  // [u] m/s
  Vec2 direction;
  double intervals = 0.0;  // in which it or any candidate of its own may move
};

Braking braking_of(Vec2 velocity, double max_acceleration, const StepLaw& law) {
  Braking result;
  result.speed = norm(velocity);
  result.decrement = braking_decrement(law, max_acceleration);
  if (result.speed > 0.0) result.direction = velocity / result.speed;
  result.intervals = braking_steps(result.speed + result.decrement, result.decrement) + 1.0;
  return result;
}

// How far any candidate gets from where the robot is.
double reach_of(const Braking& b, const StepLaw& law) {
  const double top = b.speed + b.decrement;
  return law.lag * b.speed + (law.time_step - law.lag) * top +
         stopping_length(top, b.decrement, law);
}

// How far any candidate's path gets from the braking path at the same time: |v_1 - v_1'| <= 2 u,
// and a change of the speed moves the path by no more than the time until rest.
double deviation_of(const Braking& b, const StepLaw& law) {
  return 2.0 * b.decrement * (law.time_step - law.lag + law.time_step * b.intervals);
}

// Inflation of the contact distance that covers all rounding (docs/certificate.md).
double rounding_margin(const Robot& robot, const Neighbor& neighbor, double contact, double reach) {
  return 0x1p-36 * (contact + reach) + 0x1p-44 * (norm(robot.position) + norm(neighbor.position));
}

// One pair, while its walls are made.
struct PairWalls {
  const Robot& robot;
  const Neighbor& neighbor;
  const StepLaw& law;
  const Braking a, b;
  Vec2 p;  // p_A - p_B
  double contact, inflated, share, deviation;
  bool decides;
  int intervals = 0;
};

Bezier relative_points(const PairWalls& pair, const BrakingDistances& own,
                       const BrakingDistances& other, std::size_t m) {
  const Vec2 d_A = pair.a.direction;
  if (pair.decides) {
    const Vec2 d_B = pair.b.direction;
    return {pair.p + (own.start[m] * d_A - other.start[m] * d_B),
            pair.p + (own.middle[m] * d_A - other.middle[m] * d_B),
            pair.p + (own.end[m] * d_A - other.end[m] * d_B)};
  }
  // p_B + t v_B + t²/2 a_B has the Bézier points of this quadratic
  const double t = static_cast<double>(m) * pair.law.time_step, h = pair.law.time_step;
  const Vec2 v = pair.neighbor.velocity, acceleration = pair.neighbor.acceleration;
  const Vec2 x = t * v + (0.5 * t * t) * acceleration, v_t = v + t * acceleration;
  return {pair.p + (own.start[m] * d_A - x),
          pair.p + (own.middle[m] * d_A - (x + pair.law.lag * v_t)),
          pair.p + (own.end[m] * d_A - (x + h * v_t + (0.5 * h * h) * acceleration))};
}

// Whether neither braking nor any candidate can bring the pair into contact, or A's share of the
// slack exceeds all that a candidate of A's can deviate. Only distances along p are looked at.
bool can_refuse_nothing(const PairWalls& pair) {
  const double distance = norm(pair.p);
  const double reach_A = reach_of(pair.a, pair.law);
  if (!pair.decides) {
    const double t = pair.law.time_step * pair.a.intervals;
    const double reach_B =
        t * norm(pair.neighbor.velocity) + 0.5 * t * t * norm(pair.neighbor.acceleration);
    return distance - reach_A - reach_B > pair.inflated;
  }
  if (distance - reach_A - reach_of(pair.b, pair.law) > pair.inflated) return true;
  const double l_A = stopping_length(pair.a.speed, pair.a.decrement, pair.law);
  const double l_B = stopping_length(pair.b.speed, pair.b.decrement, pair.law);
  const double nearest =
      distance +
      (std::min(0.0, l_A * dot(pair.p, pair.a.direction)) -
       std::max(0.0, l_B * dot(pair.p, pair.b.direction))) /
          distance;
  return pair.share * (nearest - pair.inflated) > pair.deviation;
}

void append_walls(const PairWalls& pair, int index, TrajectoryWalls& walls) {
  const auto count = static_cast<std::size_t>(pair.intervals);
  const double far = pair.inflated + pair.deviation / pair.share;
  const double moving = braking_steps(pair.a.speed, pair.a.decrement);
  const BrakingDistances& own = walls.braking;
  const BrakingDistances& other = walls.neighbor_braking;
  const std::size_t first = walls.walls.size();
  double nearest = kInfinity;  // over the intervals of the invariant
  for (std::size_t m = 0; m < count; ++m) {
    const Bezier q = relative_points(pair, own, other, m);
    const double size = norm(q[1] - q[0]) + norm(q[2] - q[1]);
    const double beyond = far + size;
    if (norm_squared(q[0]) > beyond * beyond) continue;
    const Vec2 n = normal_of(q);
    const double distance = wall_distance(n, q);
    const bool counts = pair.decides || (static_cast<double>(m) < moving && pair.a.speed > 0.0);
    if (counts) nearest = std::min(nearest, distance);
    if (distance > far) continue;
    TrajectoryWall wall{index, static_cast<int>(m), !counts, n, {}};
    const std::array<double, 3> along{own.start[m], own.middle[m], own.end[m]};
    for (std::size_t i = 0; i < 3; ++i) {
      wall.offset[i] = pair.share * dot(n, q[i]) - along[i] * dot(n, pair.a.direction);
    }
    walls.walls.push_back(wall);
  }
  walls.slack = std::min(walls.slack, nearest - pair.contact);
  // what braking cannot keep apart is held to what it keeps
  const bool broken = nearest < pair.contact;
  if (broken) walls.broken = index;
  const double held_to = broken ? nearest : pair.inflated;
  for (std::size_t k = first; k < walls.walls.size(); ++k) {
    for (double& offset : walls.walls[k].offset) offset -= pair.share * held_to;
  }
}

}  // namespace

void collect_walls(const Robot& robot, std::span<const Neighbor> neighbors, const StepLaw& law,
                   TrajectoryWalls& walls) {
  walls.walls.clear();
  walls.slack = kInfinity;
  walls.broken = -1;
  walls.touched = false;
  const Braking a = braking_of(robot.velocity, robot.max_acceleration, law);
  walls.intervals = static_cast<int>(a.intervals);
  int known = 0;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const Neighbor& neighbor = neighbors[k];
    const bool decides = neighbor.max_acceleration > 0.0;
    const Braking b = decides ? braking_of(neighbor.velocity, neighbor.max_acceleration, law)
                              : Braking{};
    const double contact = robot.radius + neighbor.radius;
    const double inflated =
        contact + rounding_margin(robot, neighbor, contact, reach_of(a, law));
    PairWalls pair{robot,
                   neighbor,
                   law,
                   a,
                   b,
                   robot.position - neighbor.position,
                   contact,
                   inflated,
                   reciprocal_share(robot.max_acceleration, neighbor.max_acceleration),
                   deviation_of(a, law),
                   decides};
    if (!decides && norm_squared(pair.p) < contact * contact) walls.touched = true;
    if (can_refuse_nothing(pair)) continue;
    pair.intervals = static_cast<int>(decides ? std::max(a.intervals, b.intervals) : a.intervals);
    if (pair.intervals > known) {
      walls.braking.brake(a.speed, a.decrement, law, pair.intervals);
      known = pair.intervals;
    }
    if (decides) walls.neighbor_braking.brake(b.speed, b.decrement, law, pair.intervals);
    append_walls(pair, static_cast<int>(k), walls);
    walls.intervals = std::max(walls.intervals, pair.intervals);
  }
}

void follow(const Robot& robot, Vec2 next_velocity, const StepLaw& law, int intervals,
            CandidatePath& path) {
  const double decrement = braking_decrement(law, robot.max_acceleration);
  path.speed = norm(next_velocity);
  path.direction = path.speed > 0.0 ? next_velocity / path.speed : Vec2{};
  path.first = law.lag * robot.velocity + (law.time_step - law.lag) * next_velocity;
  const bool stays = path.speed == 0.0 && norm_squared(robot.velocity) == 0.0;
  path.moving = stays ? 0 : 1 + static_cast<int>(path.speed > 0.0 ? braking_steps(path.speed, decrement) : 0.0);
  path.braking.brake(path.speed, decrement, law, std::max(intervals - 1, 0));
}

WorstWall worst_wall(const TrajectoryWalls& walls, const CandidatePath& path) {
  if (walls.touched && path.moving > 0) return {-kInfinity, -1, 0};
  return worst_wall(walls, path, 0, walls.walls.size());
}

WorstWall worst_wall(const TrajectoryWalls& walls, const CandidatePath& path, std::size_t first,
                     std::size_t last) {
  WorstWall worst{kInfinity, -1, 0};
  for (std::size_t k = first; k < last; ++k) {
    const TrajectoryWall& wall = walls.walls[k];
    if (wall.only_in_motion && wall.interval >= path.moving) continue;
    const double base = dot(wall.normal, path.first);
    const auto take = [&](double value, int point) {
      if (value < worst.coefficient) worst = {value, static_cast<int>(k), point};
    };
    if (wall.interval == 0) {
      // the path begins as the braking path does
      take(base + wall.offset[2], 2);
      continue;
    }
    const auto m = static_cast<std::size_t>(wall.interval - 1);
    const double along = dot(wall.normal, path.direction);
    take(base + along * path.braking.start[m] + wall.offset[0], 0);
    take(base + along * path.braking.middle[m] + wall.offset[1], 1);
    take(base + along * path.braking.end[m] + wall.offset[2], 2);
  }
  return worst;
}

HalfPlane tangent(const TrajectoryWall& wall, int point, const CandidatePath& path,
                  const Robot& robot, const StepLaw& law) {
  const double decrement = braking_decrement(law, robot.max_acceleration);
  const double lead = law.time_step - law.lag;
  // X = v_1/|v_1| D(|v_1|) has the derivative D/|v_1| across v_1 and D' along it
  double across = lead, along = lead;
  double value = dot(wall.normal, path.first) + wall.offset[static_cast<std::size_t>(point)];
  if (wall.interval > 0) {
    const auto m = static_cast<std::size_t>(wall.interval - 1);
    const double distance = point == 0   ? path.braking.start[m]
                            : point == 1 ? path.braking.middle[m]
                                         : path.braking.end[m];
    value += dot(wall.normal, path.direction) * distance;
    const double steps = std::min(static_cast<double>(m) + 0.5 * point,
                                  std::floor(path.speed / decrement) + 0.5);
    along += law.time_step * steps;
    across += path.speed > 0.0 ? distance / path.speed : law.lag;
  }
  const double n_along = dot(wall.normal, path.direction);
  const Vec2 gradient =
      across * wall.normal + ((along - across) * n_along) * path.direction;
  const double length = norm(gradient);
  const Vec2 next_velocity = path.speed * path.direction;
  return {gradient / length, (dot(gradient, next_velocity) - value) / length};
}

}  // namespace avo
