// SPDX-License-Identifier: Apache-2.0
// Decisions of airplanes, which cannot stop.
#pragma once
#include <cstddef>
#include <span>

#include "certificate/footprints.h"
#include "planner/decision.h"

namespace avo::inline planner {

/// What an airplane flies towards.
struct FlightTarget {
  Vec2 target;  ///< [v'] m/s, that Eq. (23) chose
  double violation = 0.0;
};

/// The controls nearest to the target that keep to all neighbors that decide and to the walls, or
/// the circle that it is on.
Plan fly_towards(const Planner& planner, const Robot& robot, const Neighbors& neighbors,
                 std::span<const Wall> walls, const FlightTarget& flight,
                 FlightConstraints& constraints);

/// It holds its speed and turns right.
Plan loiter_on(const Planner& planner, const Robot& robot, PlanStatus status, double violation);

/// Whether it flies as fast as it may, not slower than it must, turns by kMostTurn at most in a
/// step, and is on its circle; it has no max_braking, because it does not brake.
bool can_fly(const Robot& robot, double time_step);

/// Whether the circle of one that loiters is that of its position and velocity.
bool is_on_circle(const Neighbor& neighbor);

/// Whether the planner's options are such that it, or one beside one that loiters, keeps what
/// docs/certificate/airplanes.md promises.
bool allows_loiterers(const PlannerOptions& options);

/// The robot with the circle that it is on.
Robot with_circle(const Robot& robot);

}  // namespace avo::inline planner
