// SPDX-License-Identifier: Apache-2.0
// Robots that come into sight too late for braking.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "avo/simulation.h"

namespace avo::inline metrics {

/// Pairs in which one robot comes into the other's sight after the start, and is not safe then
/// (Planner::state() of these two alone).
class FirstSights {
 public:
  /// For scenes with a certificate. If all robots are seen from far enough away at all times, none
  /// can be too late and nothing is examined.
  explicit FirstSights(const Scenario& scenario);

  void observe(const Simulation& simulation);
  /// None without a certificate.
  [[nodiscard]] std::optional<std::int64_t> too_late() const;

 private:
  // RobotIds, or -1 - k for moving obstacle k
  using Names = std::set<std::int64_t>;

  bool certified_ = false, may_be_late_ = false;
  std::map<std::int64_t, Names> in_sight_;  // by the robot that senses
  std::set<std::pair<std::int64_t, std::int64_t>> late_;
  PlanWorkspace workspace_;
};

}  // namespace avo::inline metrics
