// SPDX-License-Identifier: Apache-2.0
#include "metrics/first_sights.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "avo/assumptions.h"
#include "metrics/certified.h"

namespace avo::inline metrics {

FirstSights::FirstSights(const Scenario& scenario) : certified_(some_keep_certificate(scenario)) {
  if (!certified_) return;
  const std::optional<SensingNeed> need = sensing_need(scenario);
  may_be_late_ = scenario.sensing.misses() || (need && need->range > sensing_radius_of(scenario));
}

void FirstSights::observe(const Simulation& simulation) {
  if (!may_be_late_) return;
  const FleetView fleet = simulation.fleet(Columns::id);
  std::map<std::int64_t, Names> in_sight;
  for (const RobotId robot : fleet.id) {
    const auto self = static_cast<std::int64_t>(robot.value);
    const auto before = in_sight_.find(self);
    if (simulation.next_decision(robot) != simulation.time()) {  // a robot senses when it decides
      if (before != in_sight_.end()) in_sight.insert(*before);
      continue;
    }
    if (simulation.planner(robot).options().certificate == Certificate::none) continue;
    const Simulation::Perception seen = simulation.perceive(robot);
    Names& now = in_sight[self];
    for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
      const std::int64_t other = seen.source[k];
      now.insert(other);
      const bool is_known = other < 0 || in_sight_.contains(other);
      const bool is_new = before != in_sight_.end() && is_known && !before->second.contains(other);
      if (!is_new) continue;
      const SafetyReport report =
          simulation.planner(robot).state(seen.robot, std::span(&seen.neighbors[k], 1), workspace_);
      if (report.state != SafetyState::safe) late_.insert(std::minmax(self, other));
    }
  }
  in_sight_ = std::move(in_sight);
}

std::optional<std::int64_t> FirstSights::too_late() const {
  return certified_ ? std::optional(static_cast<std::int64_t>(late_.size())) : std::nullopt;
}

}  // namespace avo::inline metrics
