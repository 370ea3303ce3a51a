// SPDX-License-Identifier: Apache-2.0
// Numbers, places and names in sentences, in ASCII.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "avo/explanation.h"

namespace avo::inline guidance {

using Words = std::string;

/// The value with so many digits at most behind the point, and no zeros at the end. Numbers of
/// scenes are below 1e13.
Words number(double value, int digits);
/// E.g. "(4, 3.6)", m.
Words place(Vec2 p);
/// E.g. "robot 7", "moving obstacle 2"; see Perception::source.
Words name_of(std::int64_t source);
/// E.g. "the wall from (0, 0) to (1, 0)".
Words name_of(const Wall& wall);
/// The name of a neighbor or wall that the decision heeds.
Words name_of(const Explanation& e, Cause cause);
/// E.g. "robots 2 and 4" of their names; without repetition, the first few.
Words list_of(const std::vector<Words>& names);
/// E.g. "robots 2 and 4", or "robot 2 and the wall from (0, 0) to (1, 0)"; the first few.
Words list_of(const Explanation& e, const std::vector<Cause>& causes);

}  // namespace avo::inline guidance
