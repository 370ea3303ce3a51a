// SPDX-License-Identifier: Apache-2.0
// Which robots had a way out when they came to sense a moving obstacle.
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

/// Of each robot, the moving obstacles that it senses, and whether it had a way out from all that
/// it sensed when each of them came into its sight, the last time (docs/metrics.md).
class MoverSights {
 public:
  /// Of scenes with a certificate and moving obstacles; of others nothing is looked at.
  explicit MoverSights(const Scenario& scenario);

  /// What robots sense now that decide now.
  void observe(const Simulation& simulation);
  /// Robots (RobotId) and moving obstacles (index) that first touched in the step before.
  void take_hits(std::span<const std::pair<std::uint64_t, std::uint64_t>> hits);
  /// Hits of robots that had a way out; none without a certificate.
  [[nodiscard]] std::optional<std::int64_t> evadable() const;

 private:
  void look(const Simulation& simulation, std::size_t robot, std::map<std::uint64_t, bool>& sights);

  bool certified_ = false, has_movers_ = false;
  std::map<std::uint64_t, std::map<std::uint64_t, bool>> sights_;  // by RobotId and index
  std::vector<std::uint64_t> near_, sensed_;                       // scratch memory
  std::int64_t evadable_ = 0;
  PlanWorkspace workspace_;
};

}  // namespace avo::inline metrics
