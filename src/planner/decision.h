// SPDX-License-Identifier: Apache-2.0
// The parts of one decision.
#pragma once
#include <algorithm>
#include <span>

#include "avo/planner.h"
#include "avo/wall.h"
#include "core/neighbor_columns.h"
#include "lp/linear_program.h"
#include "robots/model.h"

namespace avo::inline planner {

/// The number of nearest neighbors that get a half-plane.
inline std::size_t planned_with(const PlannerOptions& options, std::size_t neighbors) {
  if (!options.max_neighbors) return neighbors;
  return std::min(neighbors, static_cast<std::size_t>(*options.max_neighbors));
}

/// Neighbors behind walls count among the nearest: a farther neighbor does not take their place.
inline std::size_t planned_with(const PlannerOptions& options, const Neighbors& neighbors) {
  return planned_with(options, neighbors.size() + neighbors.hidden) - neighbors.hidden;
}

/// Makes the neighbor a robot that moves on. A neighbor that does not move on has no stated
/// acceleration. A neighbor that decides has no stated deviation, and no likely one.
inline void become_mover(Neighbor& neighbor) {
  if (shares(neighbor)) neighbor.acceleration = {}, neighbor.trajectory = nullptr;
  if (!is_predicted(neighbor)) neighbor.max_deviation = neighbor.likely_deviation = 0.0;
  neighbor.behavior = Behavior::moves_on;
}

/// Returns whether a robot has movers alone as neighbors, none of which does a share. It then
/// avoids the union of their obstacles (§III-C) instead of taking its part of half-planes. An
/// external method has avoided them already.
/// Neighbors must come nearest first; without a certificate only the nearest count.
template <typename Neighbors>
bool is_among_movers(const PlannerOptions& options, const Neighbors& neighbors) {
  if (avoids_union(options.method)) return true;
  const MethodTraits& traits = method_traits(options.method);
  if (traits.stays_in_cell || traits.is_external) return false;
  const std::size_t count = options.certificate == Certificate::none
                                ? planned_with(options, neighbors.size())
                                : neighbors.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (shares(neighbors[k])) return false;
  }
  return count > 0;
}

/// The result of the paper's program for a wish.
struct Wished {
  std::span<const HalfPlane> half_planes;
  std::span<const HalfPlane> walls;  ///< the half-planes of walls among them
  Vec2 wish, aim, target;  ///< m/s: the wish, what Eq. (23) was given for it, and what it chose
  /// m/s: the velocity after one step towards the choice; the change of velocity in the last step
  Vec2 next, last_change;
  double violation = 0.0;   ///< m/s
  bool coinciding = false;  ///< nearly coincides with another robot that decides
};

/// m/s: the program's violation, or the excess, which no program sees. CA_A is empty if everything
/// within reach collides with a neighbor or a wall.
inline double with_excess(std::span<const HalfPlane> planes, std::span<const double> excess,
                          Vec2 v_new, double worst) {
  for (std::size_t k = 0; k < excess.size(); ++k) {
    if (excess[k] > 0.0)
      worst = std::max(worst, excess[k] + std::max(0.0, violation(planes[k], v_new)));
  }
  return worst;
}

/// The status of a choice of the program that is kept, without contact.
inline PlanStatus status_of(double violation) {
  return violation > 0.0 ? PlanStatus::least_unsafe : PlanStatus::optimal;
}

// The functions below that make parts of a plan leave next_velocity to the code that moves the
// robot.

// This is inline: passing a vector by value costs more than the division.
inline Plan plan_of(const PlannerOptions& options, Vec2 velocity, Vec2 new_velocity,
                    PlanStatus status, double violation) {
  const double time = adopts_at_once(options.method) ? options.time_step : options.control_time;
  return {.new_velocity = new_velocity,
          .acceleration = (new_velocity - velocity) / time,
          .status = status,
          .violation = violation};
}

inline Approach approach_of(const PlannerOptions& options) {
  const bool at_once = !method_traits(options.method).lags;
  return {at_once, options.time_step, 0.5 * options.arrival_distance};
}

/// Without a certificate: the plan that the robot's own motion can follow.
Plan as_followed(const Planner& planner, const Robot& robot, Plan plan);

/// Full braking, or only invalid_input where the robot's state does not allow it.
Plan brake(const Planner& planner, const Robot& robot, PlanStatus status, double violation);

/// The plan with the velocity that the robot has after it, moved as a simulation moves it.
Plan with_next_velocity(const Planner& planner, const Robot& robot, Plan plan);

/// Planner::plan_among_movers().
template <typename Trace>
Plan decide_among_movers(const Planner& planner, const Robot& robot,
                         std::span<const Neighbor> obstacles, std::span<const Wall> walls,
                         PlanWorkspace::Scratch& scratch, Trace trace);

}  // namespace avo::inline planner
