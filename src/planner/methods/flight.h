// SPDX-License-Identifier: Apache-2.0
// Decisions of airplanes, which cannot stop.
#pragma once
#include <cstddef>
#include <span>

#include "certificate/footprints.h"
#include "planner/decision.h"

namespace avo::inline planner {

/// The target of an airplane.
struct FlightTarget {
  Vec2 target;  ///< [v'] m/s, that Eq. (23) chose
  double violation = 0.0;
};

/// The controls nearest to the target that keep clear of all neighbors that decide and of the
/// walls. If there are none, it is the circle that the airplane is on.
Plan fly_towards(const Planner& planner, const Robot& robot, const Neighbors& neighbors,
                 std::span<const Wall> walls, const FlightTarget& flight,
                 FlightConstraints& constraints);

/// The airplane holds its speed and turns right.
Plan loiter_on(const Planner& planner, const Robot& robot, PlanStatus status, double violation);

/// Returns whether the airplane can fly: its speed is within its limits, it turns by at most
/// kMostTurn in a step, and it is on its circle. It has no max_braking, because it does not brake.
bool can_fly(const Robot& robot, double time_step);

/// Returns whether the circle of a neighbor that loiters matches its position and velocity.
bool is_on_circle(const Neighbor& neighbor);

/// Returns whether an airplane, or a robot beside one, can keep the promise of
/// docs/certificate/airplanes.md with the planner's options.
bool allows_loiterers(const PlannerOptions& options);

/// The robot with its present circle.
Robot with_circle(const Robot& robot);

}  // namespace avo::inline planner
