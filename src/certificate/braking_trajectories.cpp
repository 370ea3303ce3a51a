// SPDX-License-Identifier: Apache-2.0
// S3: the walls of neighbors, and the test of a candidate against them.
#include "certificate/braking_trajectories.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace avo {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Bézier points of a relative path on one interval.
using Bezier = std::array<Vec2, 3>;

// Direction of the point of the triangle's edges nearest to the origin; 0 where that is the origin.
// Whether the origin lies inside is not asked: no sign of rounding noise decides anything, since
// any direction makes a sound wall, and its distance tells what it is worth.
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

// What the sensing errors of one interval demand (docs/certificate.md, "Sensing errors").
struct ErrorMargin {
  double distance = 0.0;  // m, beyond the inflated contact
  double cone = 0.0;      // most that the normal differs from that of the true paths
  double factor = 1.0;    // of what a path deviates, that a wall has to give room for
};

// Of the path of one that is seen moving for `time`, m.
double error_at(const StepLaw& law, double time) {
  return law.sensing_error.position + law.sensing_error.velocity * time;
}

// moved: |x(t) - q_0| on the interval, m; distance: of the wall.
ErrorMargin error_margin(const BrakingPair& pair, const StepLaw& law, double m, double distance,
                         double moved) {
  const auto& [position, velocity] = law.sensing_error;
  if (position == 0.0 && velocity == 0.0) return {};
  const double one_step = velocity * law.time_step;
  const double steps = pair.decides ? std::min(m + 1.0, pair.b.intervals) : m + 1.0;
  const double error = error_at(law, law.time_step * steps);
  if (!(distance > error)) return {error + 2.0 * (moved + one_step), 2.0, 3.0};
  const double cone = std::min(2.0 * std::sqrt(error / (distance + error)),
                               (moved + error) / std::sqrt(distance * (distance - error)));
  return {error + cone * (moved + one_step), cone, 1.0 + cone};
}

// What is seen to accelerate moves on a parabola. Where A's motion is exponential, a path of A's
// kind between the same ends, leaving with the same velocity, is less than a Δt²/8 away from it.
double parabola_error(const Neighbor& neighbor, const StepLaw& law) {
  if (neighbor.max_acceleration > 0.0 || law.lag == 0.5 * law.time_step) return 0.0;
  return 0.125 * law.time_step * law.time_step * norm(neighbor.acceleration);
}

// A's braking path less B's: its braking path, or that with the acceleration that it is seen to
// keep.
Bezier relative_points(const BrakingPair& pair, const Neighbor& neighbor, const StepLaw& law,
                       const TrajectoryWalls& walls, std::size_t m) {
  const BrakingDistances& own = walls.braking;
  const Vec2 d_A = pair.a.direction;
  if (pair.decides) {
    const BrakingDistances& other = walls.neighbor_braking;
    const Vec2 d_B = pair.b.direction;
    return {pair.p + (own.start[m] * d_A - other.start[m] * d_B),
            pair.p + (own.middle[m] * d_A - other.middle[m] * d_B),
            pair.p + (own.end[m] * d_A - other.end[m] * d_B)};
  }
  const double h = law.time_step, t = static_cast<double>(m) * h;
  const Vec2 a = neighbor.acceleration, v = neighbor.velocity + t * a;
  const Vec2 x = t * neighbor.velocity + (0.5 * t * t) * a;
  return {pair.p + (own.start[m] * d_A - x), pair.p + (own.middle[m] * d_A - (x + law.lag * v)),
          pair.p + (own.end[m] * d_A - (x + h * v + (0.5 * h * h) * a))};
}

// Whether A's share of the free gap exceeds all that a candidate of A's can deviate, looked at
// along p only: then the neighbor can refuse nothing, whatever it does itself.
bool refuses_nothing(const BrakingPair& pair, double deviation) {
  const double distance = norm(pair.p);
  if (!(distance > 0.0)) return false;
  const double nearest = distance + (std::min(0.0, pair.a.length * dot(pair.p, pair.a.direction)) -
                                     std::max(0.0, pair.b.length * dot(pair.p, pair.b.direction))) /
                                        distance;
  return pair.share * (nearest - pair.inflated) > deviation;
}

double pick(const BrakingDistances& braking, int interval, int point) {
  const auto m = static_cast<std::size_t>(interval);
  return point == 0 ? braking.start[m] : point == 1 ? braking.middle[m] : braking.end[m];
}

// Where braking is seen to leave less than the margin, A may not lose more of it.
void allow_braking(const TrajectoryWalls& walls, TrajectoryWall& wall) {
  for (int i = 0; i < 3; ++i) {
    double& offset = wall.offset[static_cast<std::size_t>(i)];
    offset = std::max(offset,
                      -pick(walls.braking, wall.interval, i) * dot(wall.normal, walls.direction));
  }
}

void append_walls(const BrakingPair& pair, const Neighbor& neighbor, int index, const StepLaw& law,
                  double deviation, TrajectoryWalls& walls, Invariant& invariant) {
  const auto count = static_cast<std::size_t>(std::max(pair.a.intervals, pair.b.intervals));
  const double moving = braking_steps_at_least(pair.a.speed, pair.a.decrement);
  const double inflation = parabola_error(neighbor, law);
  const double inflated = pair.inflated + inflation, room = deviation / pair.share;
  const std::size_t first = walls.walls.size();
  double nearest = kInfinity;  // over the intervals of the invariant
  for (std::size_t m = 0; m < count; ++m) {
    const Bezier q = relative_points(pair, neighbor, law, walls, m);
    const double moved = norm(q[1] - q[0]) + norm(q[2] - q[1]);
    const double steps = static_cast<double>(m);
    const ErrorMargin most = error_margin(pair, law, steps, pair.contact, moved);
    const double beyond = inflated + moved + most.distance + most.factor * room;
    if (norm_squared(q[0]) > beyond * beyond) continue;
    const Vec2 n = normal_of(q);
    const double distance = wall_distance(n, q);
    const bool counts = pair.decides || steps < moving;
    if (counts) nearest = std::min(nearest, distance);
    ErrorMargin margin = error_margin(pair, law, steps, distance, moved);
    if (distance > inflated + margin.distance + margin.factor * room) continue;
    // the invariant says nothing of intervals at rest: all three points stay clear along n there
    if (!counts) margin = {};
    TrajectoryWall wall{index, static_cast<int>(m), !counts, n, {}, margin.cone, 0.0};
    wall.bound = pair.share * (margin.distance - distance);
    const std::array<double, 3> times{0.0, law.lag, law.time_step};
    const std::array<double, 3> along{walls.braking.start[m], walls.braking.middle[m],
                                      walls.braking.end[m]};
    for (std::size_t i = 0; i < 3; ++i) {
      wall.offset[i] =
          pair.share * (dot(n, q[i]) - margin.distance) - along[i] * dot(n, pair.a.direction);
      if (!counts) wall.offset[i] -= error_at(law, steps * law.time_step + times[i]);
    }
    walls.walls.push_back(wall);
  }
  const double held = held_distance(pair, nearest, index, invariant) + inflation;
  if (!pair.decides && nearest < pair.contact - pair.error) invariant.touched = true;
  for (std::size_t k = first; k < walls.walls.size(); ++k) {
    TrajectoryWall& wall = walls.walls[k];
    for (double& offset : wall.offset) offset -= pair.share * held;
    wall.bound += pair.share * held;
    if (wall.cone > 0.0) allow_braking(walls, wall);
    // Where A starts cannot be inflated: at rest beside what does not decide it could never leave.
    if (!wall.only_in_motion || wall.interval > 0) continue;
    for (std::size_t i = 0; i < 2; ++i) wall.offset[i] += held - inflation - pair.contact;
  }
}

}  // namespace

void collect_walls(const Robot& robot, std::span<const Neighbor> neighbors, Whom whom,
                   const StepLaw& law, TrajectoryWalls& walls, Invariant& invariant) {
  walls.walls.clear();
  const Braking a = braking_of(robot.velocity, robot.max_acceleration, law);
  const double deviation = deviation_after(a, a.intervals, law);
  const bool exact = law.sensing_error == SensingError{};
  walls.direction = a.direction;
  int known = 0;  // intervals of A's braking
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const Neighbor& neighbor = neighbors[k];
    if (whom == Whom::movers && neighbor.max_acceleration > 0.0) continue;
    const BrakingPair pair = braking_pair(robot, neighbor, a, law);
    if (cannot_meet(pair, neighbor, law)) continue;
    if (!pair.decides && norm(pair.p) < pair.contact + law.sensing_error.position) {
      invariant.touched = true;
    }
    if (pair.decides && exact && refuses_nothing(pair, deviation)) continue;
    const double most = std::max(pair.a.intervals, pair.b.intervals);
    if (!(most <= kMostIntervals)) {
      invariant.unknown = true;
      continue;
    }
    const int intervals = static_cast<int>(most);
    if (intervals > known) {
      walls.braking.brake(a.speed, a.decrement, law, intervals);
      known = intervals;
    }
    if (pair.decides) {
      walls.neighbor_braking.brake(pair.b.speed, pair.b.decrement, law, intervals);
    }
    append_walls(pair, neighbor, static_cast<int>(k), law, deviation, walls, invariant);
  }
  walls.intervals = std::max(known - 1, 0);
}

namespace {

// From the point of A's braking path to that of the path.
Vec2 deviation_of(const TrajectoryWalls& walls, const TrajectoryWall& wall, int point,
                  const CandidatePath& path) {
  const Vec2 x = pick(walls.braking, wall.interval, point) * walls.direction;
  if (wall.interval == 0) return path.first - x;
  return path.first + pick(path.braking, wall.interval - 1, point) * path.direction - x;
}

}  // namespace

WorstWall worst_wall(const TrajectoryWalls& walls, const CandidatePath& path) {
  return worst_wall(walls, path, 0, walls.walls.size());
}

WorstWall worst_wall(const TrajectoryWalls& walls, const CandidatePath& path, std::size_t first,
                     std::size_t last) {
  WorstWall worst{kInfinity, nullptr, 0, {}};
  for (std::size_t k = first; k < last; ++k) {
    const TrajectoryWall& wall = walls.walls[k];
    if (wall.only_in_motion && wall.interval >= path.moving) continue;
    const auto take = [&](double value, int point) {
      Vec2 lean;
      if (wall.cone > 0.0) {
        const Vec2 deviation = deviation_of(walls, wall, point, path);
        const double length = norm(deviation);
        value -= wall.cone * length;
        if (length > 0.0) lean = (wall.cone / length) * deviation;
      }
      if (std::isnan(value)) value = -kInfinity;  // nothing that is not known is admitted
      if (value < worst.coefficient) worst = {value, &wall, point, lean};
    };
    const double base = dot(wall.normal, path.first);
    if (wall.interval == 0) {
      // y_0 and y_1 are those of the braking path, which keeps the wall unless A is at rest
      take(base - path.bend + wall.offset[2], 2);
      if (wall.only_in_motion) take(wall.offset[0], 0), take(wall.offset[1], 1);
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

HalfPlane tangent(const WorstWall& worst, const CandidatePath& path, const Robot& robot,
                  const StepLaw& law) {
  const TrajectoryWall& wall = *worst.wall;
  // the point is (Δt - s) v_1 + (v_1/|v_1|) D(|v_1|) and a constant; the second term grows with v_1
  // by D/|v_1| across it and by D', the time for which braking moves it, along it
  double across = law.time_step - law.lag, along = across;
  if (wall.interval > 0) {
    const auto m = static_cast<std::size_t>(wall.interval - 1);
    const double distance = worst.point == 0   ? path.braking.start[m]
                            : worst.point == 1 ? path.braking.middle[m]
                                               : path.braking.end[m];
    const double decrement = braking_decrement(robot.max_acceleration, law);
    // of the step that ends at rest, the lag only
    const double to_point = worst.point == 0 ? 0.0 : worst.point == 1 ? law.lag : law.time_step;
    const double to_rest = law.time_step * std::floor(path.speed / decrement) + law.lag;
    across += path.speed > 0.0 ? distance / path.speed : law.lag;
    along += std::min(law.time_step * static_cast<double>(m) + to_point, to_rest);
  }
  const Vec2 normal = wall.normal - worst.lean;
  const double n_along = dot(normal, path.direction);
  const Vec2 gradient = across * normal + ((along - across) * n_along) * path.direction;
  const double length = norm(gradient);
  if (!(length > 0.0)) return {wall.normal, dot(wall.normal, path.next_velocity)};
  return {gradient / length, (dot(gradient, path.next_velocity) - worst.coefficient) / length};
}

}  // namespace avo
