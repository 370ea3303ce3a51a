// SPDX-License-Identifier: Apache-2.0
// Who goes through which passage, as all robots see it, and where each robot goes for it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/executor.h"
#include "navigation/prospect.h"
#include "navigation/right_of_way.h"
#include "sim/ways.h"

namespace avo::inline sim {

struct World;

/// Of one moment.
struct Claims {
  std::vector<Claimant> claimants;   // by passage
  std::vector<std::uint32_t> first;  // of each passage; one more than passages
  std::vector<std::vector<Claimant>> parts;

  [[nodiscard]] std::span<const Claimant> of(std::uint32_t passage) const {
    return std::span(claimants).subspan(first[passage], first[passage + 1] - first[passage]);
  }
};

/// Seen, or told, as the scene says. There are passages.
void collect_claims(const World& world, Executor& executor, Claims& claims);

/// What the robot claims itself, as the scene lets it: who tells claims makes no room. The way is
/// known.
Prospect prospect_of(const World& world, std::size_t slot, const Travel& travel);
Claimant claimant_of(const World& world, std::size_t slot, const Claim& claim);

/// Whether the nearest other robot that a robot senses is as near as claims count, m.
inline bool is_in_company(double radius, double nearest) {
  return nearest <= kClaimRange * radius;
}

/// What the rules at passages make of the heading. nearest: m, how far off the nearest other one is
/// that it senses; infinity where there is none.
Heading heed_passages(const World& world, const Claims& claims, std::size_t slot,
                      const Travel& travel, const Heading& heading, double nearest);

/// For whom the robot waits at a passage, if it does.
std::optional<Simulation::Wait> wait_of(const World& world, const Claims& claims, std::size_t slot);

}  // namespace avo::inline sim
