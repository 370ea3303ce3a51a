// SPDX-License-Identifier: Apache-2.0
// What a planner of space takes.
#pragma once
#include <span>

#include "avo/space/planner.h"

namespace avo::space {

/// Throws Error that names the first number out of range.
void check_boxes(std::span<const Box> boxes);

/// Throws Error on options out of range, and on those that space does not have.
void validate_in_space(const PlannerOptions& options);

bool is_valid(const Robot& robot);
/// Returns whether all numbers are in range.
bool are_valid(const Robot& robot, std::span<const Neighbor> neighbors, std::span<const Box> boxes,
               std::span<const Mover> movers = {});

}  // namespace avo::space
