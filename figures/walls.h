// SPDX-License-Identifier: Apache-2.0
// Static obstacles in a figure of the workspace.
#pragma once
#include <optional>
#include <span>

#include "avo/wall.h"
#include "figures/canvas.h"

namespace avo::figures {

/// Returns the box that all walls cover; none if there are none.
std::optional<Box> covered(std::span<const StaticObstacle> obstacles);

/// Draws walls with their true thickness, but always visible. Solids and the space outside bounds
/// are filled.
void draw_walls(Canvas& canvas, std::span<const StaticObstacle> obstacles);

}  // namespace avo::figures
