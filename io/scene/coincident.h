// SPDX-License-Identifier: Apache-2.0
// Robots at one point cannot tell in which direction to part.
#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "avo/scenario.h"

namespace avo_io {

/// Two robots at one point of which at least one avoids the other, the earlier one first: the first
/// such pair by place.
std::optional<std::pair<std::size_t, std::size_t>> find_coincident(
    const std::vector<avo::RobotSetup>& robots);

}  // namespace avo_io
