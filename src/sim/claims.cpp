// SPDX-License-Identifier: Apache-2.0
#include "sim/claims.h"

#include <algorithm>

#include "sim/clocks.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// of a robot; memory for more is allocated when it is needed
constexpr std::size_t kMostClaims = 4;

void collect_claims(const World& world, const Routes& routes, Executor& executor, Claims& claims) {
  const std::size_t robots = world.fleet.size(), parts = executor.workers();
  claims.parts.resize(std::max(claims.parts.size(), parts));
  parallel_for(executor, parts, [&](std::size_t part, std::size_t) {
    std::vector<Claimant>& own = claims.parts[part];
    own.clear();
    own.reserve(kMostClaims * (robots / parts + 1));
    for (std::size_t k = part * robots / parts; k < (part + 1) * robots / parts; ++k) {
      const std::uint32_t slot = world.fleet.slot_of[k];
      if (world.fleet.is_parked(slot) || !world.fleet.heads_for_goal(slot)) continue;
      append_claims(routes, claimant_of(world, slot), world.fleet.velocity[slot], own);
    }
  });
  claims.claimants.reserve(kMostClaims * robots);
  order_claims(routes.passages.size(), parts, claims);
}

}  // namespace

Claimant claimant_of(const World& world, std::size_t slot) {
  const Conduct& conduct = world.fleet.conduct[slot];
  const bool shares = shares_room(world, slot);
  return {{},
          world.fleet.position[slot],
          conduct.layers.bits,
          conduct.avoids.bits,
          shares ? world.end_of(slot) : Vec2{},
          shares ? world.fleet.traits[slot].radius : 0.0,
          static_cast<std::uint32_t>(world.fleet.rank[slot])};
}

Follower follower_of(const World& world, std::size_t slot, Vec2 lost, double nearest) {
  const Fleet& fleet = world.fleet;
  const Vec2 position = fleet.position[slot];
  return {.place = lost == Vec2{} ? position : position + lost,
          .as_seen = claimant_of(world, slot),
          .traits = fleet.traits[slot],
          .end = world.end_of(slot),
          .own_path = own_path_of(fleet.own_model(slot)),
          .nearest = nearest,
          .detour = fleet.detour[slot].angle,
          .looks_around = looks_around(fleet.id[slot], decisions_of(world, slot)),
          .rests = rests_at_place(world, slot) || world.waits_to_start(slot)};
}

void collect_claims(const World& world, Executor& executor, std::vector<Claims>& claims) {
  claims.resize(world.routes.size());
  for (std::size_t k = 0; k < world.routes.size(); ++k)
    if (!world.routes[k].passages.empty())
      collect_claims(world, world.routes[k], executor, claims[k]);
}

std::optional<Simulation::Wait> wait_of(const World& world, std::span<const Claims> claims,
                                        std::size_t slot) {
  const Fleet& fleet = world.fleet;
  const std::size_t floor = world.floor_of(slot);
  if (!fleet.decides(slot) || world.routes[floor].passages.empty() || world.waits_to_start(slot))
    return std::nullopt;
  const Travel& travel = world.travels[static_cast<std::size_t>(fleet.rank[slot])];
  auto wait = wait_of(world.routes[floor], claims[floor], follower_of(world, slot, {}, 0.0), travel,
                      world.sensing_radius);
  if (wait) wait->robot = fleet.id[fleet.slot_of[static_cast<std::size_t>(wait->robot.value)]];
  return wait;
}

}  // namespace avo::inline sim
