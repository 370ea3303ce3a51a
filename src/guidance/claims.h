// SPDX-License-Identifier: Apache-2.0
// The claims of passages, as all robots see them, and the effect on a robot's heading.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "guidance/routes.h"
#include "navigation/prospect.h"
#include "navigation/right_of_way.h"

namespace avo::inline guidance {

struct Follower;

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

/// Appends the claims that a robot seems to have, by its place and its velocity, m/s. robot: as
/// others see it, without a claim.
void append_claims(const Routes& routes, Claimant robot, Vec2 velocity,
                   std::vector<Claimant>& claimants);

/// Orders the claims in the first `parts` parts by passage, of so many passages.
void order_claims(std::size_t passages, std::size_t parts, Claims& claims);

/// Returns whether the nearest other robot that a robot senses is within the range of claims, m.
inline bool is_in_company(double radius, double nearest) {
  return nearest <= kClaimRange * radius;
}

/// Applies the rules at passages to the heading.
Heading heed_passages(const Routes& routes, const Claims& claims, const Follower& robot,
                      const Travel& travel, const Heading& heading, double sensing_radius);

/// The robot for which this robot waits at a passage, if it waits. Simulation::Wait::robot has its
/// Claimant::rank. It moves no robot.
std::optional<Simulation::Wait> wait_of(const Routes& routes, const Claims& claims,
                                        const Follower& robot, const Travel& travel,
                                        double sensing_radius);

}  // namespace avo::inline guidance
