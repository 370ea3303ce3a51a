// SPDX-License-Identifier: Apache-2.0
// Random starts and goals between which no way leads are drawn again.
#pragma once
#include <cstdint>
#include <vector>

#include "avo/scenario.h"
#include "io/maps/free_space.h"
#include "io/scene/scene_parts.h"

namespace avo_io {

/// Where a group's robots start, and the point that antipodal goals mirror in.
struct Starts {
  std::vector<avo::Vec2> points;
  avo::Vec2 center;
};

/// Adds all that a start of the group keeps clear of: other groups' robots, and moving obstacles.
void add_others(const Group& group, const avo::Scenario& scenario, FreeSpace& space);

/// Of a group among walls: a random goal that no way leads to from its start is drawn again, and a
/// random start where no goal helps. Permuted goals are exchanged. All else stays as it is, and so
/// does what 2000 tries do not mend. The numbers are of a stream of their own.
void draw_reachable(const Group& group, const avo::Scenario& scenario, std::uint64_t stream,
                    Starts& from, std::vector<avo::Vec2>& to);

}  // namespace avo_io
