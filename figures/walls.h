// SPDX-License-Identifier: Apache-2.0
// Static obstacles in a figure of the workspace.
#pragma once
#include <optional>
#include <span>

#include "avo/wall.h"
#include "figures/canvas.h"

namespace avo::figures {

/// What all walls cover; none where there are none.
std::optional<Box> covered(std::span<const StaticObstacle> obstacles);

/// Walls as thick as they are, and visible in any case; solids and what lies beyond bounds filled.
void draw_walls(Canvas& canvas, std::span<const StaticObstacle> obstacles);

}  // namespace avo::figures
