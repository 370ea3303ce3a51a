// SPDX-License-Identifier: Apache-2.0
// A decision in words.
#pragma once
#include <string>

#include "avo/explanation.h"
#include "avo/planner.h"

namespace avo::inline sim {

/// See Explanation::sentence, which need not be set.
std::string sentence_of(const Explanation& explanation, const Planner& planner);

}  // namespace avo::inline sim
