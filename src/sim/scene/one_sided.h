// SPDX-License-Identifier: Apache-2.0
// Pairs of robots of which one only avoids the other.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "avo/scenario.h"

namespace avo::inline sim {

struct OneSided {
  std::size_t avoiding, avoided;  // robots
  std::string_view reason;        // why nothing could be promised
};

/// Whoever avoids B and is not avoided by it takes it for a mover of its acceleration, which does
/// not tell how a disc ahead of its axle swings; and an airplane cannot stop for movers. The first
/// such pair.
std::optional<OneSided> find_impossible(std::span<const RobotSetup> robots);

}  // namespace avo::inline sim
