// SPDX-License-Identifier: Apache-2.0
// The command that takes off as much speed as one step can.
#pragma once
#include "avo/planner.h"

namespace avo {

/// v' that comes to rest within the step if the limits allow, and otherwise brakes straight along
/// -v; |v' - v| <= δ a_max always, |v'| <= v_max unless that is farther than δ a_max away.
/// rate: the part of v' - v that one step turns into velocity.
Vec2 braking_velocity(const Robot& robot, double control_time, double rate) noexcept;

}  // namespace avo
