// SPDX-License-Identifier: Apache-2.0
#include "metrics/mover_sights.h"

#include <algorithm>
#include <cstddef>

#include "metrics/certified.h"

namespace avo::inline metrics {

MoverSights::MoverSights(const Scenario& scenario) : certified_(some_keep_certificate(scenario)) {}

// Only a robot with a new obstacle in reach is asked what it senses: most steps cost distances
// alone.
void MoverSights::observe(const Simulation& simulation) {
  const MovingObstacleView movers = simulation.moving_obstacles();
  if (!certified_ || (movers.id.empty() && sights_.empty())) return;
  const FleetView fleet = simulation.fleet();
  const double reach = simulation.sensing_radius();
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    if (is_parked(fleet.setup[i])) continue;
    // a robot senses when it decides
    if (simulation.next_decision(fleet.id[i]) != simulation.time()) continue;
    std::map<std::uint64_t, bool>& sights = sights_[fleet.id[i].value];
    near_.clear();
    for (std::size_t k = 0; k < movers.position.size(); ++k) {
      const double squared = norm_squared(movers.position[k] - fleet.position[i]);
      if (squared <= reach * reach) near_.push_back(movers.id[k].value);
    }
    const bool is_as_before =
        std::equal(near_.begin(), near_.end(), sights.begin(), sights.end(),
                   [](std::uint64_t mover, const auto& sight) { return mover == sight.first; });
    if (!is_as_before) look(simulation, fleet.id[i], sights);
  }
}

void MoverSights::look(const Simulation& simulation, RobotId robot,
                       std::map<std::uint64_t, bool>& sights) {
  const Simulation::Perception seen = simulation.perceive(robot);
  sensed_.clear();
  for (const std::int64_t source : seen.source)
    if (source < 0) sensed_.push_back(static_cast<std::uint64_t>(-1 - source));
  std::sort(sensed_.begin(), sensed_.end());
  std::erase_if(sights, [&](const auto& sight) {
    return !std::binary_search(sensed_.begin(), sensed_.end(), sight.first);
  });
  if (sights.size() == sensed_.size()) return;
  const bool has_evasive_maneuver = simulation.planner(robot).has_evasive_maneuver(
      seen.robot, seen.neighbors, workspace_, seen.walls);
  for (const std::uint64_t mover : sensed_) sights.try_emplace(mover, has_evasive_maneuver);
}

void MoverSights::take_hits(std::span<const std::pair<std::uint64_t, std::uint64_t>> hits) {
  for (const auto& [robot, mover] : hits) {
    const auto sights = sights_.find(robot);
    if (sights == sights_.end()) continue;
    const auto sight = sights->second.find(mover);
    if (sight != sights->second.end() && sight->second) ++evadable_;
  }
}

std::optional<std::int64_t> MoverSights::evadable() const {
  return certified_ ? std::optional(evadable_) : std::nullopt;
}

}  // namespace avo::inline metrics
