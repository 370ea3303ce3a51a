// SPDX-License-Identifier: Apache-2.0
// Pairs of robots in which only one avoids the other.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "avo/scenario.h"

namespace avo::inline sim {

struct OneSided {
  std::size_t avoiding, avoided;  // robots
  std::string_view reason;        // the reason why nothing could be promised
};

/// The first pair without a possible promise. A robot that avoids B without being avoided by B
/// takes B for a mover with its acceleration. This does not describe the swing of a disc ahead of
/// its axle. A robot that flies cannot stop for movers.
std::optional<OneSided> find_impossible(std::span<const RobotSetup> robots);

}  // namespace avo::inline sim
