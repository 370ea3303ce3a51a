// SPDX-License-Identifier: Apache-2.0
// Who comes into sight too late to be braked for.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "avo/simulation.h"

namespace avo::inline metrics {

/// Pairs of which one comes into the other's sight after the start, and is not safe then
/// (Planner::state() of these two alone).
class FirstSights {
 public:
  /// Of scenes with a certificate. Where everybody is seen from far enough away at all times, none
  /// can be too late and nothing is looked at.
  explicit FirstSights(const Scenario& scenario);

  void observe(const Simulation& simulation);
  /// None without a certificate.
  [[nodiscard]] std::optional<std::int64_t> too_late() const;

 private:
  // RobotIds, or -1 - k for moving obstacle k
  using Names = std::set<std::int64_t>;

  bool certified_ = false, may_be_late_ = false;
  std::map<std::int64_t, Names> in_sight_;  // by the robot that looks
  std::set<std::pair<std::int64_t, std::int64_t>> late_;
  PlanWorkspace workspace_;
};

}  // namespace avo::inline metrics
