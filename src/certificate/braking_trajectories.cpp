// SPDX-License-Identifier: Apache-2.0
// S3: the walls of neighbors.
#include "certificate/braking_trajectories.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "certificate/kernels.h"

namespace avo {
namespace {

// Of the path of one that is seen moving for `time`, m.
double error_at(const StepLaw& law, double time) {
  return law.sensing_error.position + law.sensing_error.velocity * time;
}

// What is seen to accelerate moves on a parabola. Where A's motion is exponential, a path of A's
// kind between the same ends, leaving with the same velocity, is less than a Δt²/8 away from it.
double parabola_error(const Neighbor& neighbor, const StepLaw& law) {
  if (neighbor.max_acceleration > 0.0 || law.lag == 0.5 * law.time_step) return 0.0;
  return 0.125 * law.time_step * law.time_step * norm(neighbor.acceleration);
}

// Who is no larger, no faster and no less able than A may be need not be looked at beyond a
// distance: the most of a fleet, told by comparisons alone.
struct Peers {
  double distance_squared;  // m²
  double radius, max_acceleration, speed_squared;

  bool are_far(Vec2 p, const Neighbor& neighbor) const {
    return norm_squared(p) > distance_squared && neighbor.max_acceleration == max_acceleration &&
           neighbor.radius <= radius && norm_squared(neighbor.velocity) <= speed_squared;
  }
};

Peers peers_of(const Robot& robot, const Braking& a, const StepLaw& law) {
  constexpr double kRounding = 1.0 + 0x1p-30;
  const double u = a.profile.decrement, h = law.time_step;
  const double speed = kRounding * std::max(robot.max_speed, a.profile.speed);
  const double top = speed + law.sensing_error.velocity + u, steps = top / u;
  // at least what it takes to stop: v²/2a and what is lost by stopping in steps
  const double length = h * (0.5 * top * steps + 0.125 * u) + std::abs(law.lag - 0.5 * h) * top;
  const double reach = law.lag * speed + (h - law.lag) * top + length;
  const double lengths = 2.0 * robot.radius + a.reach + reach, intervals = 3.0 + steps;
  const double error = law.sensing_error.position + law.sensing_error.velocity * h * intervals;
  // of the rounding margin, what does not grow with the distance; the rest is less than kRounding
  const double margin = 0x1p-46 * (norm(robot.position) + lengths) * intervals;
  const double distance = kRounding * (lengths + error + margin);
  const bool is_known = intervals <= kMostIntervals;
  return {is_known ? distance * distance : std::numeric_limits<double>::infinity(), robot.radius,
          robot.max_acceleration, speed * speed};
}

// Where braking is seen to leave less than the margin, A may not lose more of it.
void allow_braking(const Braking& own, const StepLaw& law, WallColumns& walls, std::size_t k) {
  const auto [start, middle, end] =
      braking_distances(own.profile, law, static_cast<int>(walls.interval[k]));
  const double along = dot({walls.normal_x[k], walls.normal_y[k]}, own.direction);
  const std::array<double, 3> distances{start, middle, end};
  for (std::size_t i = 0; i < 3; ++i) {
    walls.offset[i][k] = std::max(walls.offset[i][k], -distances[i] * along);
  }
}

// What is known of a pair's walls once all of them are: the distance that is held.
void hold(const PairWalls& of, double held, std::size_t first, const StepLaw& law,
          TrajectoryWalls& walls) {
  WallColumns& columns = walls.columns;
  const double share = of.pair.share;
  const std::array<double, 3> times{0.0, law.lag, law.time_step};
  for (std::size_t k = first; k < columns.count; ++k) {
    const double m = columns.interval[k];
    const bool holds = m < of.moving;
    columns.bound[k] += share * held;
    for (std::size_t i = 0; i < 3; ++i) {
      columns.offset[i][k] -= share * held;
      if (!holds) columns.offset[i][k] -= error_at(law, m * law.time_step + times[i]);
    }
    if (columns.cone[k] > 0.0) {
      walls.has_cones = true;
      allow_braking(walls.own, law, columns, k);
    }
    if (holds || m > 0.0) continue;
    // Where A starts cannot be inflated: at rest beside what does not decide it could never leave.
    for (std::size_t i = 0; i < 2; ++i) {
      columns.offset[i][k] += held - (of.inflated - of.pair.inflated) - of.pair.contact;
      if (!(columns.offset[i][k] >= 0.0)) walls.stays_at_rest = true;
    }
  }
}

void collect_pair(const BrakingPair& pair, const Neighbor& neighbor, int index, const StepLaw& law,
                  TrajectoryWalls& walls, Invariant& invariant) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double inflation = parabola_error(neighbor, law);
  const PairWalls of{pair,
                     neighbor,
                     index,
                     static_cast<std::size_t>(std::max(pair.a.intervals, pair.b.intervals)),
                     pair.inflated + inflation,
                     pair.decides
                         ? infinity
                         : braking_steps_at_least(pair.a.profile.speed, pair.a.profile.decrement)};
  const std::size_t first = walls.columns.count;
  walls.columns.reserve(first + of.intervals);
  const double nearest = append_walls(of, law, walls.own_columns, walls.columns);
  const double held = held_distance(pair, nearest, index, invariant) + inflation;
  if (!pair.decides && nearest < pair.contact - pair.error) invariant.touched = true;
  hold(of, held, first, law, walls);
}

// Where the pair is worth it.
void collect_close(const BrakingPair& pair, const Neighbor& neighbor, std::size_t index,
                   const Deviation& deviation, const StepLaw& law, TrajectoryWalls& walls,
                   Invariant& invariant) {
  const double most = std::max(pair.a.intervals, pair.b.intervals);
  if (!(most <= kMostIntervals)) {
    invariant.unknown = true;
    return;
  }
  const auto intervals = static_cast<std::size_t>(most);
  if (intervals > walls.own_columns.count) {
    walls.own_columns.count = intervals;
    walls.own_columns.reserve(intervals);
    fill_own(pair.a, deviation, law, walls.own_columns);
  }
  collect_pair(pair, neighbor, static_cast<int>(index), law, walls, invariant);
}

// Those that decide and are not far. Returns whether there are others, that do not decide.
bool gather(const Robot& robot, const Neighbors& neighbors, Whom whom, const Peers& peers,
            NearColumns& near) {
  near.count = 0;
  near.reserve(neighbors.size());
  bool has_movers = false;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const Neighbor neighbor = neighbors[k];
    const bool decides = neighbor.max_acceleration > 0.0;
    has_movers = has_movers || !decides;
    if (!decides || whom == Whom::movers) continue;
    if (!peers.are_far(robot.position - neighbor.position, neighbor)) near.add(k, neighbor);
  }
  return has_movers;
}

BrakingPair kept_pair(const Robot& robot, const Braking& a, const NearColumns& near,
                      std::size_t k) {
  return {robot.position - Vec2{near.x[k], near.y[k]},
          near.contact[k],
          near.inflated[k],
          near.error[k],
          near.share[k],
          true,
          a,
          {{near.speed[k], near.decrement[k], near.full_steps[k]},
           {near.direction_x[k], near.direction_y[k]},
           near.length[k],
           near.reach[k],
           near.intervals[k]}};
}

}  // namespace

void collect_walls(const Robot& robot, const Neighbors& neighbors, Whom whom, const StepLaw& law,
                   TrajectoryWalls& walls, Invariant& invariant) {
  const Braking a = braking_of(robot.velocity, robot.max_acceleration, law);
  walls.columns.count = walls.own_columns.count = 0;
  walls.stays_at_rest = walls.has_cones = false;
  walls.own = a;
  const bool has_movers = gather(robot, neighbors, whom, peers_of(robot, a, law), walls.near);
  if (walls.near.count == 0 && !has_movers) return;
  const Deviation deviation = deviation_of(a, robot.car.has_value(), law);
  judge_pairs(robot, a, deviation, law, walls.near);
  for (std::size_t i = 0; i < walls.near.kept_count; ++i) {
    const std::size_t k = walls.near.kept[i], index = walls.near.index[k];
    collect_close(kept_pair(robot, a, walls.near, k), neighbors[index], index, deviation, law,
                  walls, invariant);
  }
  for (std::size_t k = 0; has_movers && k < neighbors.size(); ++k) {
    const Neighbor mover = neighbors[k];
    if (mover.max_acceleration > 0.0) continue;
    const BrakingPair pair = braking_pair(robot, mover, a, law);
    if (cannot_meet(pair, mover, law)) continue;
    if (norm(pair.p) < pair.contact + law.sensing_error.position) invariant.touched = true;
    collect_close(pair, mover, k, deviation, law, walls, invariant);
  }
}

}  // namespace avo
