// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "avo/planner.h"

namespace avo_python {

/// Returns this thread's workspace, so that nothing is allocated once it has grown.
avo::PlanWorkspace& workspace();

}  // namespace avo_python
