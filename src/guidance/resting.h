// SPDX-License-Identifier: Apache-2.0
// Movers at rest, around which routes lead (docs/navigation.md, "Movers at rest").
#pragma once
#include <optional>

#include "avo/vec.h"
#include "avo/wall.h"

namespace avo::inline guidance {

/// The disc of a mover at rest, or a disc that contains a slow one; none for one in motion.
/// is_exact: at rest it is the mover's own disc.
std::optional<Wall> resting_disc(Vec2 position, Vec2 velocity, double radius, bool is_exact);

}  // namespace avo::inline guidance
