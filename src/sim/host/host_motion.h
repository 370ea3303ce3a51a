// SPDX-License-Identifier: Apache-2.0
// Robots that move as the host tells them, and do not decide.
#pragma once

namespace avo::inline sim {

struct World;

/// Moves the robots that the host moves over one step, each alone.
void move_as_told(World& world);

/// Lets robots decide again that have come to rest since the host gave them back, where others have
/// room for that. Returns whether there are any.
bool decide_again(World& world);

}  // namespace avo::inline sim
