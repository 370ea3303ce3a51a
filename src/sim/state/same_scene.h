// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "sim/state/saved_state.h"

namespace avo::inline sim {

/// Throws Error where the state is of a scene with other settings, another external method or
/// another execution than those of this world.
void require_same_scene(const SavedState& state, const World& world);

}  // namespace avo::inline sim
