// SPDX-License-Identifier: Apache-2.0
// What a planner can be asked to do.
#pragma once
#include "avo/planner.h"

namespace avo {

/// Throws Error naming the first option out of range.
void validate(const PlannerOptions& options);

}  // namespace avo
