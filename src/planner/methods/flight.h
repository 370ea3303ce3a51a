// SPDX-License-Identifier: Apache-2.0
// Decisions of robots that fly, which cannot stop.
#pragma once
#include <array>
#include <cstddef>
#include <span>

#include "certificate/fallback_areas.h"
#include "planner/decision.h"

namespace avo::inline planner {

/// The target of a robot that flies.
struct FlightTarget {
  Vec2 target;  ///< [v'] m/s, that Eq. (23) chose
  double violation = 0.0;
};

/// The controls nearest to the target that keep clear of all neighbors that decide and of the
/// walls. If there are none, it is the circle that the robot is on.
template <typename Trace>
Plan fly_towards(const Planner& planner, const Robot& robot, const Neighbors& neighbors,
                 std::span<const Wall> walls, const FlightTarget& flight,
                 FlightConstraints& constraints, Trace trace);

/// m/s², along the heading and to its left.
struct Controls {
  double ahead, left;
};

/// Controls that a robot may try in place of wanted ones.
struct TriedControls {
  static constexpr int kTurns = 8;  // to each side
  static constexpr int kRates = 3;  // changes of the speed, besides the wanted one
  std::array<Controls, std::size_t{kRates + 1} * (2 * kTurns + 2)> controls;
  std::size_t count = 0;
};
/// The controls nearest to the wanted ones first; of equally near ones right turns come first.
TriedControls controls_near(const Robot& robot, Controls wanted);

/// The robot holds its speed and turns right.
Plan loiter_on(const Planner& planner, const Robot& robot, PlanStatus status, double violation);

/// Returns whether the robot can fly. Its speed must be within its limits, it must turn by at most
/// kMostTurn in a step, and be on its circle. It has no max_braking, because it does not brake.
bool can_fly(const Robot& robot, double time_step);

/// Returns whether the circle of a neighbor that loiters matches its position and velocity.
bool is_on_circle(const Neighbor& neighbor);

/// Returns whether a robot that flies, or a robot beside it, can keep the promise of
/// certificate/fallback_areas.h with the planner's options.
bool allows_loiterers(const PlannerOptions& options);

/// The robot with its present circle.
Robot with_circle(const Robot& robot);

}  // namespace avo::inline planner
