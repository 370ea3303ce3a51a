// SPDX-License-Identifier: Apache-2.0
#include "planner/stages/disc_pairs.h"

#include <limits>

#include "robots/footprint.h"

namespace avo::inline planner {

Discs discs_of(const Robot& robot, const StepLaw& law) {
  if (!has_footprint(robot.model)) return {{robot}, 1};
  const BrakingPose pose = braking_pose(robot, law);
  Discs result{{}, static_cast<std::size_t>(footprint_of(robot.model).discs)};
  for (std::size_t k = 0; k < result.count; ++k)
    result.discs[k] = disc_of(robot, pose, static_cast<int>(k));
  return result;
}

DiscPair nearest_discs(const Discs& discs, const Neighbor& neighbor) {
  DiscPair nearest{{}, {}, std::numeric_limits<double>::infinity()};
  for (int l = 0; l < disc_count(neighbor); ++l) {
    const Neighbor other = disc_of(neighbor, l);
    for (const Robot& disc : discs.all()) {
      const double gap = norm(disc.position - other.position) - disc.radius - other.radius;
      if (gap < nearest.gap) nearest = {disc, other, gap};
    }
  }
  return nearest;
}

bool has_discs(const RobotColumns& robots, std::size_t i) {
  if (robots.model[i] != nullptr && has_footprint(*robots.model[i])) return true;
  return robots.neighbors[i].columns->has_footprints;
}

}  // namespace avo::inline planner
