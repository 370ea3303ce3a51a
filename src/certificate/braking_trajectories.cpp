// SPDX-License-Identifier: Apache-2.0
// Braking trajectories: the walls of neighbors.
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
  if (neighbor.behavior == Behavior::decides || law.lag == 0.5 * law.time_step) return 0.0;
  return 0.125 * law.time_step * law.time_step * norm(neighbor.acceleration);
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

// What errors and movers take off the pair's walls.
void take_off(const PairWalls& of, std::size_t first, const StepLaw& law, TrajectoryWalls& walls) {
  WallColumns& columns = walls.columns;
  const std::array<double, 3> times{0.0, law.lag, law.time_step};
  for (std::size_t k = first; k < columns.count; ++k) {
    if (!columns.is_wall(k)) continue;
    const double m = columns.interval[k];
    const bool holds = m < of.moving;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!holds) columns.offset[i][k] -= error_at(law, m * law.time_step + times[i]);
    }
    if (columns.cone[k] > 0.0) {
      walls.has_cones = true;
      allow_braking(walls.own, law, columns, k);
    }
    if (holds || m > 0.0) continue;
    // Where A starts cannot be inflated: at rest beside what does not decide it could never leave.
    for (std::size_t i = 0; i < 2; ++i) {
      columns.offset[i][k] += of.held - (of.inflated - of.pair.inflated) - of.pair.contact;
      if (!(columns.offset[i][k] >= 0.0)) walls.stays_at_rest = true;
    }
  }
}

void collect_pair(const BrakingPair& pair, const Neighbor& neighbor, int index, const StepLaw& law,
                  TrajectoryWalls& walls, Invariant& invariant) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double inflation = parabola_error(neighbor, law), inflated = pair.inflated + inflation;
  PairWalls of{pair,
               neighbor,
               index,
               static_cast<std::size_t>(std::max(pair.a.intervals, pair.b.intervals)),
               inflated,
               inflated,
               pair.decides
                   ? infinity
                   : braking_steps_at_least(pair.a.profile.speed, pair.a.profile.decrement)};
  const std::size_t first = walls.columns.count;
  walls.columns.reserve(first + of.intervals);
  const double nearest = append_walls(of, law, walls.own_columns, walls.columns);
  of.held = held_distance(pair, nearest, index, invariant) + inflation;
  if (of.held != inflated) {
    walls.columns.count = first;
    append_walls(of, law, walls.own_columns, walls.columns);
  }
  if (!pair.decides && nearest < pair.contact - pair.error) invariant.touched = true;
  if (!pair.decides || law.sensing_error != SensingError{}) take_off(of, first, law, walls);
}

// Where the pair is worth it.
void collect_close(const BrakingPair& pair, const Neighbor& neighbor, std::size_t index,
                   const StepLaw& law, TrajectoryWalls& walls, Invariant& invariant) {
  const double most = std::max(pair.a.intervals, pair.b.intervals);
  if (!(most <= kMostIntervals)) {
    invariant.unknown = true;
    return;
  }
  const auto intervals = static_cast<std::size_t>(most);
  if (intervals > walls.own_columns.count) {
    walls.own_columns.count = intervals;
    walls.own_columns.reserve(intervals);
    fill_own(pair.a, walls.deviation, law, walls.own_columns);
  }
  collect_pair(pair, neighbor, static_cast<int>(index), law, walls, invariant);
}

void collect_near(const NearPair& near, const StepLaw& law, TrajectoryWalls& walls,
                  Invariant& invariant) {
  collect_close(near.with(walls.own), {}, near.neighbor, law, walls, invariant);
}

// How far one candidate's path gets from A's braking path, m, against A's direction and anyhow.
struct CandidateDeviation {
  double ahead, aside;
};

// docs/certificate.md, "What can refuse nothing", of v_1 itself instead of all that A may choose
CandidateDeviation deviation_of(const CandidatePath& path, const Braking& own, const StepLaw& law) {
  constexpr double kRoom = 1.0 + 0x1p-30;
  const double lead = law.time_step - law.lag, rounding = 0x1p-40 * own.reach;
  const double length = stopping_length(path.braking, law);
  const double speed = own.profile.speed, slow = speed - own.profile.decrement;
  if (!(slow >= 0.0)) return {0.0, kRoom * (lead * path.speed + length) + rounding};
  const double along = dot(own.direction, path.direction);
  const double across = std::abs(cross(own.direction, path.direction));
  const double ahead = lead * (along * path.speed - slow) + along * length -
                       stopping_length(slow, own.profile.decrement, law);
  return {kRoom * std::max(ahead, 0.0) + rounding,
          kRoom * across * (lead * path.speed + length) + rounding};
}

}  // namespace

void begin_walls(const Robot& robot, const Neighbors& neighbors, const NearPairs& near,
                 std::size_t i, const StepLaw& law, TrajectoryWalls& walls, Invariant& invariant) {
  walls.columns.count = walls.own_columns.count = walls.own_columns.filled = 0;
  walls.stays_at_rest = walls.has_cones = false;
  walls.waiting.clear();
  const bool has_movers = near.has_movers[i] != 0;
  if (near.of(i).empty() && !has_movers) return;
  walls.own = near.own.braking(i);
  walls.deviation = near.own.deviation(i);
  for (const NearPair& pair : near.of(i)) walls.waiting.push_back(&pair);
  for (std::size_t k = 0; has_movers && k < neighbors.size(); ++k) {
    const Neighbor mover = neighbors[k];
    if (mover.behavior == Behavior::decides) continue;
    const BrakingPair pair = braking_pair(robot, mover, walls.own, law);
    if (cannot_meet(pair, mover, law)) continue;
    if (norm(pair.p) < pair.contact + law.sensing_error.position) invariant.touched = true;
    collect_close(pair, mover, k, law, walls, invariant);
  }
}

void collect_refusing(const Robot& robot, const CandidatePath& path, const StepLaw& law,
                      TrajectoryWalls& walls, Invariant& invariant) {
  if (walls.waiting.empty()) return;
  CandidateDeviation deviation{walls.deviation.most_ahead, walls.deviation.most_aside};
  if (!robot.car) deviation = deviation_of(path, walls.own, law);
  std::size_t left = 0;
  for (const NearPair* pair : walls.waiting) {
    if (pair->gap > pair->against * deviation.ahead + deviation.aside) {
      walls.waiting[left++] = pair;
    } else {
      collect_near(*pair, law, walls, invariant);
    }
  }
  walls.waiting.resize(left);
}

void collect_waiting(const StepLaw& law, TrajectoryWalls& walls, Invariant& invariant) {
  for (const NearPair* pair : walls.waiting) collect_near(*pair, law, walls, invariant);
  walls.waiting.clear();
}

}  // namespace avo
