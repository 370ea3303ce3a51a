// SPDX-License-Identifier: Apache-2.0
// Edits of many robots at once: all of them, or none where one is refused.
#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "core/ranges.h"
#include "sim/host/edits.h"
#include "sim/scene/edit_checks.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

void require_as_many(const char* what, std::size_t found, std::size_t robots) {
  if (found != robots)
    refuse(what, std::to_string(found), std::to_string(robots) + ", one for each robot");
}

// Refuses values that the call for one robot refuses.
void check_values(const World& world, std::span<const RobotId> robots, std::span<const Vec2> values,
                  const char* key, const char* unit) {
  require_as_many(key, values.size(), robots.size());
  for (std::size_t k = 0; k < robots.size(); ++k) {
    if (world.fleet.is_parked(world.fleet.find(robots[k])))
      refuse(name_of(robots[k]), "a value for it", "one that is not parked");
    if (!kAnyValue.contains(values[k].x) || !kAnyValue.contains(values[k].y))
      require(name_of(robots[k]) + ": " + key, values[k], unit);
  }
}

}  // namespace

void set_goals(World& world, std::span<const RobotId> robots, std::span<const Vec2> goals) {
  check_values(world, robots, goals, "goals", "m");
  for (std::size_t k = 0; k < robots.size(); ++k) set_goal(world, robots[k], goals[k]);
}

void set_preferred_velocities(World& world, std::span<const RobotId> robots,
                              std::span<const Vec2> velocities) {
  check_values(world, robots, velocities, "velocities", "m/s");
  for (std::size_t k = 0; k < robots.size(); ++k)
    set_preferred_velocity(world, robots[k], velocities[k]);
}

std::vector<RobotId> add_robots(World& world, std::span<const RobotSetup> setups) {
  const std::uint64_t next = world.next_id;
  const double sensing_radius = world.sensing_radius;
  std::vector<RobotId> added;
  added.reserve(setups.size());
  try {
    for (const RobotSetup& setup : setups) added.push_back(add_robot(world, setup));
  } catch (...) {
    while (!added.empty()) {
      remove_robot(world, added.back());
      added.pop_back();
    }
    world.next_id = next, world.sensing_radius = sensing_radius;
    throw;
  }
  return added;
}

void remove_robots(World& world, std::span<const RobotId> robots) {
  std::vector<std::uint64_t> ids;
  for (const RobotId robot : robots) {
    static_cast<void>(world.fleet.find(robot));
    ids.push_back(robot.value);
  }
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end()) refuse(name_of(RobotId{*twice}), "it twice", "there once");
  for (auto id = ids.rbegin(); id != ids.rend(); ++id) remove_robot(world, {*id});
}

}  // namespace avo::inline sim
