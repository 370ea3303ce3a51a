// SPDX-License-Identifier: Apache-2.0
// The claims of passages, as all robots see them, and the effect on each robot's heading.
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

/// The claims of one moment.
struct Claims {
  std::vector<Claimant> claimants;  // by passage
  // index of the first claimant of each passage; one more than passages
  std::vector<std::uint32_t> first;
  std::vector<std::vector<Claimant>> parts;

  [[nodiscard]] std::span<const Claimant> of(std::uint32_t passage) const {
    return std::span(claimants).subspan(first[passage], first[passage + 1] - first[passage]);
  }
};

/// Collects the claims as others see them. There must be passages.
void collect_claims(const World& world, Executor& executor, Claims& claims);

/// The robot's own claim. Its route must be known.
Prospect prospect_of(const World& world, std::size_t slot, const Travel& travel);
Claimant claimant_of(const World& world, std::size_t slot, const Claim& claim);

/// Returns whether the nearest other robot that a robot senses is within the range of claims, m.
inline bool is_in_company(double radius, double nearest) {
  return nearest <= kClaimRange * radius;
}

/// Applies the rules at passages to the heading. nearest: m, the distance of the nearest other
/// robot that it senses; infinity if there is none.
Heading heed_passages(const World& world, const Claims& claims, std::size_t slot,
                      const Travel& travel, const Heading& heading, double nearest);

/// The robot for which this robot waits at a passage, if it waits.
std::optional<Simulation::Wait> wait_of(const World& world, const Claims& claims, std::size_t slot);

}  // namespace avo::inline sim
