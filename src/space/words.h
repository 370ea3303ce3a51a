// SPDX-License-Identifier: Apache-2.0
// A decision in space in words: those of the plane, where they apply.
#pragma once
#include "avo/space/explanation.h"

namespace avo::space {

/// Fills in the decision and the sentence, from what the robot sees.
void explain_decision(const Planner& planner, Explanation& explanation);

}  // namespace avo::space
