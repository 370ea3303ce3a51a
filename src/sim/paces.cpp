// SPDX-License-Identifier: Apache-2.0
// The planners of a world: one for all robots with the same method, time step and horizon.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/hash.h"
#include "sim/scene/scene_checks.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// Index of a pace that no robot of the fleet has, or the number of paces. The scene's stays.
std::size_t unused_pace(const World& world) {
  std::vector<bool> used(world.paces.size(), false);
  used[0] = true;
  for (const std::uint32_t index : world.fleet.pace) used[index] = true;
  return static_cast<std::size_t>(std::find(used.begin(), used.end(), false) - used.begin());
}

// What tells the paces of a scene apart.
struct PaceKey {
  Method method;
  double time_step, time_horizon, arrival_distance;  // s, s, m
  friend bool operator==(const PaceKey&, const PaceKey&) = default;
};

PaceKey key_of(const Pace& pace) {
  const PlannerOptions& options = pace.planner.options();
  return {options.method, options.time_step, options.time_horizon, options.arrival_distance};
}

std::uint64_t hash_of(const PaceKey& key) {
  auto hash = static_cast<std::uint64_t>(key.method);
  for (const double value : {key.time_step, key.time_horizon, key.arrival_distance})
    hash = mixed(hash, std::bit_cast<std::uint64_t>(value));
  return hash;
}

std::optional<std::uint32_t> known_pace(const World& world, const PaceKey& key) {
  if (key_of(world.paces.front()) == key) return 0;
  const auto [first, last] = world.pace_at.equal_range(hash_of(key));
  for (auto place = first; place != last; ++place) {
    const std::uint32_t index = place->second;
    if (index < world.paces.size() && key_of(world.paces[index]) == key) return index;
  }
  return std::nullopt;
}

}  // namespace

std::uint32_t World::pace_of(const RobotSetup& setup, bool may_replace) {
  if (is_parked(setup)) return 0;
  const PaceKey key{method_of(settings, setup), time_step_of(settings, setup),
                    time_horizon_of(settings, setup), arrival_distance_of(settings, setup)};
  if (const auto known = known_pace(*this, key)) return *known;
  PlannerOptions options = planner_options(settings, setup);
  options.wall_range = wall_range(!movers.setup.empty());
  // where there are more paces than robots, some are unused
  const bool replaces = may_replace && paces.size() > fleet.size() + 1;
  const std::size_t index = replaces ? unused_pace(*this) : paces.size();
  if (pace_at.size() > 2 * paces.size()) {  // most stand for others by now
    std::erase_if(pace_at, [&](const auto& entry) {
      return entry.second >= paces.size() || hash_of(key_of(paces[entry.second])) != entry.first;
    });
  }
  pace_at.emplace(hash_of(key), static_cast<std::uint32_t>(index));
  if (index == paces.size())
    paces.emplace_back(options);
  else
    paces[index] = Pace(options);
  return static_cast<std::uint32_t>(index);
}

std::vector<Pace> paces_among(const World& world, bool has_movers) {
  std::vector<Pace> paces = world.paces;
  for (Pace& pace : paces) {
    PlannerOptions options = pace.planner.options();
    if (options.wall_range == wall_range(has_movers)) continue;
    options.wall_range = wall_range(has_movers);
    pace = Pace(options);
  }
  return paces;
}

}  // namespace avo::inline sim
