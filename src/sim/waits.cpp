// SPDX-License-Identifier: Apache-2.0
// Reports which robot waits for which at a passage, as the rules of right_of_way.h have decided. It
// moves no robot.
#include <optional>

#include "sim/claims.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// A robot inside comes before a robot outside. Then a robot in the opposite direction comes before
// one in the same direction, and then the nearer one first.
bool is_waited_for_first(const Claimant& robot, const Claimant& a, const Claimant& b) {
  if (a.claim.inside != b.claim.inside) return a.claim.inside;
  const bool a_comes = a.claim.forward != robot.claim.forward;
  const bool b_comes = b.claim.forward != robot.claim.forward;
  if (a_comes != b_comes) return a_comes;
  return norm_squared(a.position - robot.position) < norm_squared(b.position - robot.position);
}

}  // namespace

std::optional<Simulation::Wait> wait_of(const World& world, const Claims& claims,
                                        std::size_t slot) {
  const Fleet& fleet = world.fleet;
  if (fleet.conduct[slot].parked) return std::nullopt;
  const auto rank = static_cast<std::uint32_t>(fleet.rank[slot]);
  const Travel& travel = world.ways.travels[rank];
  if (!travel.is_known()) return std::nullopt;
  const Vec2 p = fleet.position[slot];
  const auto claim = prospect_of(world, slot, travel).claim;
  if (!claim) return std::nullopt;
  const Passage& passage = world.ways.passages[claim->passage];
  const Claimant robot = claimant_of(world, slot, *claim);
  const RobotTraits& traits = fleet.traits[slot];
  const std::span<const Claimant> claimants = claims.of(claim->passage);
  const Course course =
      right_of_way(passage, robot, planned_braking(traits), claimants, world.sensing_radius);
  if (!course.target && course.max_speed >= traits.preferred_speed) return std::nullopt;
  const Claimant* first = nullptr;
  for (const Claimant& other : claimants) {
    const bool is_seen = norm(other.position - p) <= world.sensing_radius;
    if (other.rank == rank || (robot.avoids & other.layers) == 0 || !is_seen) continue;
    if (first == nullptr || is_waited_for_first(robot, other, *first)) first = &other;
  }
  if (first == nullptr) return std::nullopt;
  const Segment gap = world.ways.passages.narrowest_gap(claim->passage);
  return Simulation::Wait{.passage = axis_point(passage, true, 0.5 * passage.length()).point,
                          .robot = fleet.id[fleet.slot_of[first->rank]],
                          .inside = first->claim.inside,
                          .a = gap.a,
                          .b = gap.b};
}

}  // namespace avo::inline sim
