// SPDX-License-Identifier: Apache-2.0
// Another way, where the passage that the way leads through is held, or back (docs/arrival.md,
// rules 13 and 14).
#pragma once
#include <cstddef>

#include "sim/travel.h"

namespace avo::inline sim {

struct World;

/// Of a robot that decides, and has `left` m of its way to go: if it has waited for longer than
/// another way takes, it takes that one from the next step on. A passage that is closed to it for
/// this is open again once that makes no difference. time: s, that it counts as waiting; none while
/// nobody is near, unless it goes back.
void go_around_held(const World& world, std::size_t slot, double left, double time, Travel& travel,
                    LegScratch& scratch);

/// Whether it goes back for now, as far as others are near: it has waited for long before a passage
/// of two lanes, there is no other way, and none of one lane on it. From each power of two of that
/// time on it does for half of what it has waited.
bool goes_back(const World& world, std::size_t slot, const Travel& travel);

/// Makes the heading of a robot at p that of one that goes back: away from there, or nowhere while
/// nobody is in its company.
inline void go_back(Vec2 p, bool in_company, Heading& heading) {
  heading.goal = in_company ? p - (heading.goal - p) : p;
  heading.yields = true;
}

}  // namespace avo::inline sim
