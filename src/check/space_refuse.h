// SPDX-License-Identifier: Apache-2.0
// The bodies that the judge of space accepts.
#pragma once
#include <cstddef>
#include <span>

#include "avo/space/check.h"

namespace avo::judge {

/// Throw Error with the number of the body and the rule that its first unsound value breaks.
void require_sound(const space::CheckedRobot& robot, std::size_t number);
void require_sound(const space::CheckedMover& mover, std::size_t number);
void require_sound(const space::Box& box, std::size_t number);
/// The same for states that are not those of so many moving obstacles.
void require_all(std::size_t movers, std::span<const space::CheckedState> states);

}  // namespace avo::judge
