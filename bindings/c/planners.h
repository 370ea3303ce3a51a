// SPDX-License-Identifier: Apache-2.0
// The planners behind their ids.
#pragma once
#include "avo/planner.h"
#include "handles.h"

namespace avo_c {

inline AVO_C_CONSTINIT Handles<avo_planner_id, avo::Planner> planners("planner");

}  // namespace avo_c
