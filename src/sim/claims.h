// SPDX-License-Identifier: Apache-2.0
// The claims of passages of a whole fleet.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/executor.h"
#include "guidance/claims.h"
#include "guidance/follower.h"

namespace avo::inline sim {

struct World;

/// Collects the claims of each floor's passages as others see them: robots of all floors may claim
/// them.
void collect_claims(const World& world, Executor& executor, std::vector<Claims>& claims);

/// The robot as others see it, without a claim.
Claimant claimant_of(const World& world, std::size_t slot);

/// The robot on its route, with that error of its own place and with its nearest other, m.
Follower follower_of(const World& world, std::size_t slot, Vec2 lost, double nearest);

/// The robot for which this robot waits at a passage, if it waits.
std::optional<Simulation::Wait> wait_of(const World& world, std::span<const Claims> claims,
                                        std::size_t slot);

}  // namespace avo::inline sim
