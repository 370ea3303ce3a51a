// SPDX-License-Identifier: Apache-2.0
#include "sim/sensing/sense_query.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/plane.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// m: others farther away matter only if they are among the nearest, or outliers.
double near_range(const World& world, std::size_t slot) {
  const double everyone = world.sensing_radius;
  if (!world.senses.are_exact() || world.outliers.usual == Scrutiny::everyone) return everyone;
  // an external method chooses from all that its robot senses
  if (!world.external.ranks.empty() && is_external(world.fleet.conduct[slot].method))
    return everyone;
  if (!world.all_matter_to(slot)) return -1.0;
  const Vec2 p = world.fleet.position[slot];
  const double farthest = std::max({std::abs(p.x), std::abs(p.y), everyone});
  if (world.summary.is_fast || !(farthest <= kMostRelevantPosition)) return everyone;
  return world.fleet.range[slot].at(norm(world.fleet.velocity[slot]));
}

}  // namespace

std::size_t nearest_sought(const World& world) {
  return world.outliers.usual == Scrutiny::everyone ? std::numeric_limits<std::size_t>::max()
                                                    : world.most_nearest();
}

NeighborQuery sought_by(const World& world, std::size_t slot) {
  constexpr double kMargin = 1.125;  // for motion since then
  const Fleet& fleet = world.fleet;
  return {.position = fleet.position[slot],
          .self = fleet.rank[slot],
          .most = nearest_sought(world),
          .near = near_range(world, slot),
          .far = world.sensing_radius,
          .guess = kMargin * static_cast<double>(fleet.nearest[slot])};
}

double range_of(const NeighborQuery& query) {
  const bool is_less = query.near >= 0.0 && query.near < query.far;
  return is_less ? query.near : std::numeric_limits<double>::infinity();
}

}  // namespace avo::inline sim
