// SPDX-License-Identifier: Apache-2.0
// Whether a decision is possible, or a robot can only brake.
#pragma once
#include <span>

#include "avo/planner.h"
#include "avo/wall.h"
#include "core/neighbor_columns.h"

namespace avo::inline planner {

/// Returns whether every number is finite and in range.
bool is_valid(const Robot& robot);
bool is_valid(const Neighbor& neighbor);
bool is_valid(const Wall& wall);
bool all_valid(const Robot& robot, std::span<const Neighbor> neighbors);
bool all_valid(const Robot& robot, const Neighbors& neighbors);

/// Returns whether a car moves along its valid heading, as in a simulation. Others predict that it
/// brakes along its velocity, and it brakes along its heading.
bool follows_heading(const Robot& robot);

/// A car holds its acceleration and brakes fully: it cannot do what the others expect under every
/// option. The same holds for a robot that flies, and for a robot that decides beside it.
bool can_follow(const Robot& robot, const Neighbors& neighbors, const PlannerOptions& options);
bool can_follow(const Robot& robot, std::span<const Neighbor> neighbors,
                const PlannerOptions& options);

/// Returns whether plan() decides with all of these, and does not say invalid_input.
bool can_decide(const Robot& robot, std::span<const Neighbor> neighbors,
                std::span<const Wall> walls, const PlannerOptions& options);

/// Returns whether enough is known of the robot to slow down. Its place does not matter for that.
bool can_brake(const Robot& robot);
/// Returns whether its heading and its model are valid.
bool can_drive(const Robot& robot);
bool has_known_place(const Robot& robot);

}  // namespace avo::inline planner
