// SPDX-License-Identifier: Apache-2.0
// A decision in words.
#pragma once
#include <string>

#include "avo/explanation.h"
#include "avo/planner.h"

namespace avo::inline guidance {

/// See Explanation::sentence, which need not be set.
std::string sentence_of(const Explanation& explanation, const Planner& planner);

/// Fills in the decision, the state and the sentence, from what the robot sees.
void explain_decision(const Planner& planner, Explanation& explanation);

}  // namespace avo::inline guidance
