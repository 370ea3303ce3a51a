// SPDX-License-Identifier: Apache-2.0
// The discs of footprints: their constraints, and their paths for a candidate.
#include "certificate/discs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "certificate/kernels.h"
#include "robots/model.h"

namespace avo::inline certificate {
BrakingPose braking_pose(const MotionModel& model, Vec2 velocity, double heading,
                         double max_braking, const StepLaw& law) {
  if (is_holonomic(model)) return {};
  const double length = stopping_length(norm(velocity), braking_decrement(max_braking, law), law);
  return turn_while_braking(model, velocity, heading, length);
}

BrakingPose braking_pose(const Robot& robot, const StepLaw& law) {
  return braking_pose(robot.model, robot.velocity, robot.heading, braking_limit(robot), law);
}

namespace {

// Both robots of a pair compute the places of its discs by these expressions.
Vec2 center_of(Vec2 position, double ahead, Vec2 direction) {
  return position + ahead * direction;
}
double radius_of(const Footprint& footprint, double ahead, double spread) {
  return footprint.radius + std::abs(ahead) * spread;
}

}  // namespace

Robot disc_of(const Robot& robot, const BrakingPose& pose, int k) {
  const Footprint footprint = footprint_of(robot.model);
  const double ahead = footprint.ahead(k);
  Robot disc = robot;
  disc.position = center_of(robot.position, ahead, pose.ahead);
  disc.radius = radius_of(footprint, ahead, pose.spread);
  return disc;
}

Neighbor disc_of(const Neighbor& neighbor, int k) {
  Neighbor disc = neighbor;
  if (has_discs(neighbor)) {
    const double ahead = neighbor.footprint.ahead(k);
    disc.position = center_of(neighbor.position, ahead, neighbor.ahead);
    disc.radius = radius_of(neighbor.footprint, ahead, neighbor.spread);
  }
  disc.footprint = {};
  return disc;
}

double rounding_of_discs(const BrakingPair& pair, double lever, double other_lever) {
  const double lengths = lengths_of_rounding(lever) + lengths_of_rounding(other_lever);
  const double share = pair.decides ? std::min(pair.share, 1.0 - pair.share) : 1.0;
  const double intervals =
      pair.decides ? std::max(pair.a.intervals, pair.b.intervals) : pair.a.intervals;
  return scalar::rounding_margin<scalar::Pack<double>>(lengths, intervals, share).value;
}

namespace {

// Nothing is left out for discs: their swing has no such bound.
Deviation any_deviation(const Deviation& of_robot) {
  constexpr double kAny = 1e9;  // m
  Deviation deviation = of_robot;
  deviation.anyhow.start = deviation.most_ahead = deviation.most_aside = kAny;
  return deviation;
}

void begin_disc(double ahead, const Braking& own, const Deviation& deviation,
                DiscConstraints& disc) {
  disc.ahead = ahead;
  TrajectoryConstraints& of_others = disc.trajectories;
  of_others.columns.count = of_others.columns.tested = 0;
  of_others.own_columns.count = of_others.own_columns.filled = 0;
  of_others.stays_at_rest = of_others.has_cones = false;
  of_others.waiting.clear();
  of_others.own = own;
  of_others.deviation = deviation;
}

}  // namespace

void collect_discs(const Robot& robot, const Neighbors& neighbors, const NearPairs& near,
                   std::size_t i, const StepLaw& law, FootprintConstraints& footprint,
                   Invariant& invariant) {
  const Footprint own = footprint_of(robot.model);
  const Braking braking = near.own.braking(i);
  const Deviation deviation = any_deviation(near.own.deviation(i));
  for (int k = 0; k < own.discs; ++k) {
    DiscConstraints& disc = footprint.discs[static_cast<std::size_t>(k)];
    begin_disc(own.ahead(k), braking, deviation, disc);
    collect_one_by_one({robot, disc_of(robot, footprint.pose, k), own.ahead(k)}, neighbors,
                       Selected::all, law, disc.trajectories, invariant);
  }
}

void begin_disc_walls(const Robot& robot, std::span<const Wall> walls, const StepLaw& law,
                      FootprintConstraints& footprint, WallConstraints& all) {
  const Footprint own = footprint_of(robot.model);
  footprint.count = static_cast<std::size_t>(own.discs);
  if (footprint.discs.size() < footprint.count) footprint.discs.resize(footprint.count);
  footprint.pose = braking_pose(robot, law);
  all.clear();
  for (int k = 0; k < own.discs; ++k) {
    WallConstraints& of_walls = footprint.discs[static_cast<std::size_t>(k)].walls;
    const double lever = std::abs(own.ahead(k));
    begin_walls(disc_of(robot, footprint.pose, k), walls, law, of_walls,
                {2.0 * lever, lengths_of_rounding(lever)});
    if (of_walls.broken.any()) all.broken.take(of_walls.broken.index, of_walls.broken.depth);
    all.doubtful = all.doubtful || of_walls.doubtful;
    all.must_brake = all.must_brake || of_walls.must_brake;
  }
}

namespace {

// m: the coefficient of the step itself, for the three points of a disc that turns.
double step_coefficient(const TrajectoryConstraints& constraints, std::size_t k,
                        const CandidatePath& path, const StepLaw& law) {
  const ConstraintColumns& columns = constraints.columns;
  const Vec2 normal{columns.normal[0][k], columns.normal[1][k]};
  const Braking& own = constraints.own;
  const BrakingDistances braking = braking_distances(own.profile, law, 0);
  const std::array<Vec2, 3> from{{{}, braking.middle * own.direction, braking.end * own.direction}};
  const std::array<Vec2, 3> to{path.begin, from[1] + path.swing, path.end};
  const double cone = constraints.has_cones ? columns.cone[k] : 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t point = 0; point < 3; ++point) {
    const double bend = point == 2 ? path.bend : 0.0;
    const double off = cone > 0.0 ? cone * (norm(to[point] - from[point]) + bend) : 0.0;
    least = std::min(least, dot(normal, to[point]) + columns.offset[point][k] - bend - off);
  }
  return least - path.grown_within;
}

// m: the least coefficient of the three points of a later interval.
double later_coefficient(const TrajectoryConstraints& constraints, std::size_t k,
                         const CandidatePath& path, const StepLaw& law) {
  const auto [start, middle, end] = scalar::coefficients<scalar::Pack<double>>(
      constraints.columns, k, constraints.own, path, law, constraints.has_cones);
  return std::min({start.value, middle.value, end.value}) - path.grown;
}

bool keeps_all(const CandidatePath& path, const StepLaw& law, Asked asked_for,
               TrajectoryConstraints& constraints) {
  ConstraintColumns& columns = constraints.columns;
  bool kept = true;
  std::size_t k = 0;
  for (; k < columns.count && (kept || asked_for == Asked::all); ++k) {
    columns.coefficient[k] = std::numeric_limits<double>::infinity();
    if (!(columns.needs[k] < path.moving)) continue;
    columns.coefficient[k] = columns.interval[k] > 0.0
                                 ? later_coefficient(constraints, k, path, law)
                                 : step_coefficient(constraints, k, path, law);
    kept = kept && columns.coefficient[k] >= 0.0;
  }
  columns.tested = k;
  return kept && !(constraints.stays_at_rest && path.moving > 0);
}

// Sets the path of a disc that is anywhere within a spread: `path` has followed the robot alone so
// far (docs/certificate/footprints.md, "Drives").
void turn_disc(const BrakingPose& now, const BrakingPose& within, const BrakingPose& after,
               double ahead, CandidatePath& path) {
  const double lever = std::abs(ahead);
  path.begin = path.swing = ahead * (within.ahead - now.ahead);
  path.end = path.first + path.begin;
  path.grown_within = lever * (within.spread - now.spread);
  path.first = path.first + ahead * (after.ahead - now.ahead);
  path.grown = lever * (after.spread - now.spread);
}

}  // namespace

bool keep_discs(const Robot& robot, Vec2 next_velocity, const StepLaw& law,
                FootprintConstraints& footprint, Asked asked_for) {
  std::array<MotionStep, Footprint::kMostDiscs> steps;
  advance_discs(robot.model, {planned_braking(robot), robot.max_speed},
                {{}, robot.velocity, robot.heading}, plan_to(robot, next_velocity, law),
                law.time_step, std::span(steps).first(footprint.count));
  const MotionState& next = steps[0].next;
  const auto within =
      turn_within(robot.model, {{}, robot.velocity, robot.heading}, next, law.time_step);
  const BrakingPose after =
      braking_pose(robot.model, next.velocity, next.heading, braking_limit(robot), law);
  bool kept = true;
  for (std::size_t k = 0; k < footprint.count && (kept || asked_for == Asked::all); ++k) {
    DiscConstraints& disc = footprint.discs[k];
    disc.path = path_after(robot, steps[k], law);
    if (within) {
      turn_disc(footprint.pose, *within, after, disc.ahead, disc.path);
    } else {
      const bool backwards = dot(disc.path.direction, after.ahead) < 0.0;
      disc.path.lever = backwards ? -disc.ahead : disc.ahead;
    }
    kept = keeps_all(disc.path, law, asked_for, disc.trajectories) && kept;
    kept = keeps_walls(disc.walls, disc.path, law) && kept;
  }
  return kept;
}

}  // namespace avo::inline certificate
