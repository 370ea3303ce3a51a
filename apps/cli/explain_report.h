// SPDX-License-Identifier: Apache-2.0
// What avo explain says.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "avo/simulation.h"

namespace avo_cli {

/// All that there is to say of one decision.
struct Decision {
  std::string scene;
  std::int64_t robot = 0;
  double time = 0.0;
  avo::Vec2 goal;
  avo::Method method{};
  avo::Simulation::Perception seen;
  bool by_half_planes = true;  ///< else outside the union of the obstacles (§III-C)
  avo::HalfPlanes half_planes;
  std::vector<double> risks;  ///< of each neighbor seen, see Planner::half_plane_risk(); or none
  std::vector<avo::CertificateConstraint> constraints;
  avo::WallPlanes wall_planes;
  std::vector<avo::WallConstraint> wall_constraints;
  avo::Certificate certificate{};
  avo::Plan plan;
  avo::SafetyReport state;  ///< of the state in which it decides
  avo::Disc acceleration_disc, speed_disc;
};

/// A line on each thing.
std::string readable(const Decision& decision);
/// One JSON object (docs/scenes.md).
std::string to_json(const Decision& decision);

}  // namespace avo_cli
