// SPDX-License-Identifier: Apache-2.0
// The constraints of all kinds of neighbors and of walls behind one set of functions.
#include "certificate/certificate.h"

#include <algorithm>
#include <limits>

#include "robots/footprint.h"
#include "robots/model.h"

namespace avo::inline certificate {

void reserve_constraints(std::size_t neighbors, std::size_t braking_steps,
                         std::size_t most_constraints, CertificateConstraints& constraints) {
  constraints.loiterers.reserve(neighbors);
  constraints.near.reserve(1, neighbors);
  constraints.trajectories.waiting.reserve(neighbors);
  // the constraints of a pair are stored by whole packs
  const std::size_t steps =
      (braking_steps + kConstraintLanes - 1) / kConstraintLanes * kConstraintLanes;
  constraints.trajectories.columns.reserve(std::min(neighbors * steps, most_constraints));
  constraints.trajectories.own_columns.reserve(std::min(braking_steps, most_constraints));
}

void find_near(const RobotColumns& robots, const CertificateLaw& law,
               CertificateConstraints& constraints) {
  if (law.kind == Certificate::none) return;
  find_near(robots, law.step, constraints.near);
}

void collect_constraints(const Robot& robot, std::span<const Neighbor> neighbors,
                         const CertificateLaw& law, CertificateConstraints& constraints,
                         std::span<const Wall> walls) {
  constraints.alone.reserve(1);
  constraints.alone.clear();
  constraints.alone.add(robot, in_columns(neighbors, constraints.seen));
  find_near(constraints.alone, law, constraints);
  begin_walls_of(robot, walls, law, constraints);
  begin_constraints(robot, constraints.alone.neighbors[0], 0, law, constraints);
  collect_waiting(law.step, constraints.trajectories, constraints.invariant);
}

void begin_walls_of(const Robot& robot, std::span<const Wall> walls, const CertificateLaw& law,
                    CertificateConstraints& constraints) {
  constraints.footprint.count = 0;
  if (law.kind == Certificate::none) {
    constraints.walls.clear();
  } else if (has_footprint(robot.model)) {
    begin_disc_walls(robot, walls, law.step, constraints.footprint, constraints.walls);
  } else {
    begin_walls(robot, walls, law.step, constraints.walls);
  }
}

void begin_constraints(const Robot& robot, const Neighbors& neighbors, std::size_t i,
                       const CertificateLaw& law, CertificateConstraints& constraints) {
  constraints.invariant = {std::numeric_limits<double>::infinity()};
  constraints.trajectories.columns.count = constraints.trajectories.columns.tested = 0;
  constraints.trajectories.stays_at_rest = false;
  constraints.trajectories.waiting.clear();
  constraints.loiterers.clear();
  if (law.kind == Certificate::none) return;
  if (constraints.footprint.count > 0)
    collect_discs(robot, neighbors, constraints.near, i, law.step, constraints.footprint,
                  constraints.invariant);
  else
    begin_trajectories(robot, neighbors, constraints.near, i, law.step, constraints.trajectories,
                       constraints.invariant);
  if (neighbors.columns->has_loiterers)
    collect_loiterers(robot, neighbors, law.step, constraints.loiterers, constraints.invariant);
}

namespace {

// Neighbors farther apart than both could reach count on this limit (docs/certificate/wheels.md,
// "Cars").
bool keeps_reach(const Robot& robot, const CandidatePath& path, const StepLaw& law) {
  if (!may_exceed_reach(model_traits(robot.model))) return true;
  constexpr double kRounding = 1.0 + 0x1p-46;
  const double u = braking_decrement(robot.max_acceleration, law), speed = norm(robot.velocity);
  const double expected = law.lag * speed + (law.time_step - law.lag) * (speed + u) +
                          stopping_length(speed + u, decrement_of(robot, law), law);
  return path.length + stopping_length(path.braking, law) <= kRounding * expected;
}

// Returns whether the robot moves on the tested path. A robot that turns in place moves its discs.
bool moves(const CertificateConstraints& constraints) {
  const auto& discs = constraints.footprint.all();
  return constraints.path.moving > 0 ||
         std::any_of(discs.begin(), discs.end(),
                     [](const DiscConstraints& disc) { return disc.path.moving > 0; });
}

}  // namespace

bool admits(const Robot& robot, Vec2 next_velocity, const CertificateLaw& law,
            CertificateConstraints& constraints, Asked asked_for) {
  const bool holonomic = is_holonomic(robot.model);
  if (constraints.demand_nothing() && !may_exceed_reach(model_traits(robot.model))) return true;
  // as long as nothing is broken, braking keeps the invariant, which a test with a margin for
  // rounding would not admit
  if (law.step.has_free_clocks() && next_velocity == backup_velocity(robot, law)) return true;
  constraints.path = follow(robot, next_velocity, law.step);
  constraints.trajectories.columns.tested = 0;
  if (!holonomic && !keeps_reach(robot, constraints.path, law.step)) return false;
  collect_refusing(robot, constraints.path, law.step, constraints.trajectories,
                   constraints.invariant);
  const bool trajectories_kept =
      keeps_trajectories(constraints.path, law.step, constraints.trajectories, asked_for);
  const bool discs_kept =
      constraints.footprint.count == 0 ||
      keep_discs(robot, next_velocity, law.step, constraints.footprint, asked_for);
  if (constraints.invariant.unknown || (constraints.invariant.touched && moves(constraints)))
    return false;
  return trajectories_kept && discs_kept &&
         keeps_loiterers(constraints.loiterers, constraints.path, law.step) &&
         keeps_walls(constraints.walls, constraints.path, law.step);
}

Vec2 backup_velocity(const Robot& robot, const CertificateLaw& law) {
  return braked(robot.velocity, decrement_of(robot, law.step));
}

void list_constraints(const CertificateConstraints& constraints, Vec2 position,
                      std::vector<CertificateConstraint>& list) {
  list.clear();
  for (std::size_t k = 0; k < constraints.trajectories.columns.count; ++k) {
    if (!constraints.trajectories.columns.is_constraint(k)) continue;
    const TrajectoryConstraint constraint = constraint_at(constraints.trajectories.columns, k);
    list.push_back({constraint.neighbor, constraint.interval, constraint.normal, constraint.bound});
  }
  for (const DiscConstraints& disc : constraints.footprint.all()) {
    const ConstraintColumns& columns = disc.trajectories.columns;
    for (std::size_t k = 0; k < columns.count; ++k) {
      if (!columns.is_constraint(k)) continue;
      const TrajectoryConstraint constraint = constraint_at(columns, k);
      list.push_back(
          {constraint.neighbor, constraint.interval, constraint.normal, constraint.bound});
    }
  }
  for (const LoiterLine& line : constraints.loiterers)
    list.push_back({line.neighbor, 0, line.normal, line.offset + dot(line.normal, position)});
}

}  // namespace avo::inline certificate
