// SPDX-License-Identifier: Apache-2.0
// Draws random starts and goals again if no route leads from the start to the goal.
#pragma once
#include <cstdint>
#include <vector>

#include "avo/scenario.h"
#include "io/maps/free_space.h"
#include "io/scene/scene_parts.h"

namespace avo_io {

/// The starts of a group's robots, and the center of reflection of antipodal goals.
struct Starts {
  std::vector<avo::Vec2> points;
  avo::Vec2 center;
};

/// Adds all discs that a start of the group keeps clear of: other groups' robots, and moving
/// obstacles.
void add_others(const Group& group, const avo::Scenario& scenario, FreeSpace& space);

/// Treats a group among walls. A random goal without a route from its start is drawn again, and so
/// is a random start if no goal helps. Permuted goals are exchanged. All other places stay, and so
/// do places that 2000 tries cannot mend. The random numbers have a separate stream.
void draw_reachable(const Group& group, const avo::Scenario& scenario, std::uint64_t stream,
                    Starts& from, std::vector<avo::Vec2>& to);

}  // namespace avo_io
