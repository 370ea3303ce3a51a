// SPDX-License-Identifier: Apache-2.0
// Whether there is anything to decide, or a robot can only brake.
#pragma once
#include <span>

#include "avo/planner.h"
#include "avo/wall.h"
#include "core/neighbor_columns.h"

namespace avo::inline planner {

/// Whether every number is finite and in range.
bool is_valid(const Robot& robot);
bool is_valid(const Neighbor& neighbor);
bool is_valid(const Wall& wall);
bool all_valid(const Robot& robot, std::span<const Neighbor> neighbors);
bool all_valid(const Robot& robot, const Neighbors& neighbors);

/// Whether a car moves along its valid heading, as those of a simulation do: others predict that it
/// brakes along its velocity, and it brakes along its heading.
bool follows_heading(const Robot& robot);

/// A car holds its acceleration and brakes at full: it cannot do what the others expect of it under
/// every option. Nor can an airplane, and one that decides beside an airplane.
bool can_follow(const Robot& robot, const Neighbors& neighbors, const PlannerOptions& options);
bool can_follow(const Robot& robot, std::span<const Neighbor> neighbors,
                const PlannerOptions& options);

/// Whether plan() decides by all of that, and does not say invalid_input.
bool can_decide(const Robot& robot, std::span<const Neighbor> neighbors,
                std::span<const Wall> walls, const PlannerOptions& options);

/// Whether enough is known of it to slow down. Where it is does not matter for that.
bool can_brake(const Robot& robot);
/// Whether its heading and its model are valid.
bool can_drive(const Robot& robot);
bool has_known_place(const Robot& robot);

}  // namespace avo::inline planner
