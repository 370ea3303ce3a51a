// SPDX-License-Identifier: Apache-2.0
// A decision in space, in words: those of the plane where they apply.
#pragma once
#include <string>

#include "avo_io/space_decision.h"

namespace avo_io {

/// See SpaceDecision::sentence, which need not be set.
std::string sentence_of(const SpaceDecision& decision);
/// Returns the name of a neighbor or a box, e.g. "robot 7" or "obstacle 2".
std::string name_of(const SpaceDecision& decision, SpaceCause cause);

}  // namespace avo_io
