// SPDX-License-Identifier: Apache-2.0
// The numbers that the judge accepts.
#pragma once
#include <optional>
#include <string>

#include "avo/check.h"

namespace avo::judge {

/// Throw Error with the place and the name of the first value out of range.
void require_sound(const std::string& place, const CheckedRobot& robot);
void require_sound(const std::string& place, const CheckedMover& obstacle);
void require_sound(const std::string& place, const CheckedWall& wall);
void require_sound(const CheckOptions& options);
/// The time must come after the time `before`, if there is one.
void require_time(double time, std::optional<double> before);
/// A row of that robot.
void require_sound(const CheckedRobot& robot, const CheckedState& row);

}  // namespace avo::judge
