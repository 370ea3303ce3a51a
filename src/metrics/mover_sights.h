// SPDX-License-Identifier: Apache-2.0
// Which robots had an evasive maneuver when they first sensed a moving obstacle.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "avo/simulation.h"

namespace avo::inline metrics {

/// The moving obstacles that each robot senses. For each moving obstacle it stores whether the
/// robot had an evasive maneuver when that obstacle last came into its sight. Such a maneuver keeps
/// clear of everything that the robot sensed then (docs/metrics.md).
class MoverSights {
 public:
  /// For scenes with a certificate and moving obstacles; in others nothing is examined.
  explicit MoverSights(const Scenario& scenario);

  /// Observes what the robots that decide now sense now.
  void observe(const Simulation& simulation);
  /// Takes robots (RobotId) and moving obstacles (id) that first touched in the step before.
  void take_hits(std::span<const std::pair<std::uint64_t, std::uint64_t>> hits);
  /// Hits of robots that had an evasive maneuver; none without a certificate.
  [[nodiscard]] std::optional<std::int64_t> evadable() const;

 private:
  void look(const Simulation& simulation, RobotId robot, std::map<std::uint64_t, bool>& sights);

  bool certified_ = false;
  std::map<std::uint64_t, std::map<std::uint64_t, bool>>
      sights_;                                // by RobotId and MovingObstacleId
  std::vector<std::uint64_t> near_, sensed_;  // scratch memory
  std::int64_t evadable_ = 0;
  PlanWorkspace workspace_;
};

}  // namespace avo::inline metrics
