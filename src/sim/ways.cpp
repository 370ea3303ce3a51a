// SPDX-License-Identifier: Apache-2.0
#include "sim/ways.h"

#include <algorithm>
#include <utility>

namespace avo {
namespace {

constexpr std::uint64_t kStepsBetweenLooks = 10;
constexpr double kSightReach = 0.1;  // m

}  // namespace

Ways::Ways(const Scenario& scenario)
    : follows_(scenario.navigation.value_or(true)), walls_(walls_of(scenario.obstacles)) {
  if (!walls_.empty()) sight_.emplace(walls_, kSightReach);
}

const Ways::Radius& Ways::of_radius(double radius) {
  auto& known = radii_[radius];
  if (!known) {
    known = std::make_unique<const Radius>(Radius{
        follows_ ? corner_graph(walls_, radius) : CornerGraph{radius, *sight_, {}, {}, {}, {}},
        FreeSpace(walls_, radius)});
  }
  return *known;
}

std::shared_ptr<const PathMap> Ways::map_to(const Radius& radius, Vec2 goal) {
  const Key key{radius.graph.radius, goal.x, goal.y};
  std::shared_ptr<const PathMap> map = maps_[key].lock();
  if (map) return map;
  std::erase_if(maps_, [](const auto& entry) { return entry.second.expired(); });
  map = std::make_shared<const PathMap>(path_map(radius.graph, goal));
  maps_[key] = map;
  return map;
}

Travel Ways::plan(double radius, Vec2 position, Vec2 goal) {
  const Radius& known = of_radius(radius);
  Travel travel;
  if (follows_) {
    travel.graph = &known.graph;
    travel.map = map_to(known, goal);
    LegScratch scratch;
    const Leg leg = next_leg(known.graph, *travel.map, position, PathMap::kNothing, false, scratch);
    travel.target = leg.target;
    if (leg.target != PathMap::kNothing) return travel;
  }
  if (!known.space.is_free(goal) || !known.space.are_connected(position, goal))
    travel.target = Travel::kUnreachable;
  return travel;
}

bool Ways::is_in_sight(Vec2 p, Vec2 q) const {
  return !sight_ || sight_->is_clear(p, q, 0.0);
}

Heading follow(Travel& travel, Vec2 position, Vec2 goal, const RobotTraits& robot,
               bool looks_around, LegScratch& scratch) {
  const Heading straight{goal, robot.preferred_speed};
  if (travel.graph == nullptr) return straight;
  if (travel.target == Travel::kUnreachable) return {position, robot.preferred_speed};
  const Leg leg =
      next_leg(*travel.graph, *travel.map, position, travel.target, looks_around, scratch);
  travel.target = leg.target;
  if (leg.is_last() || leg.target == PathMap::kNothing) return straight;
  const Vec2 way = leg.aim - position;
  const double distance = norm(way);
  if (!(distance > 0.0)) return straight;
  return {position + (leg.length / distance) * way,
          std::min(robot.preferred_speed, speed_limit(leg, robot.max_acceleration))};
}

std::vector<Travel> travels_of(Ways& ways, const Fleet& fleet) {
  std::vector<Travel> travels;
  travels.reserve(fleet.size());
  for (const std::uint32_t slot : fleet.slot_of) {
    travels.push_back(ways.plan(fleet.traits[slot].radius, fleet.position[slot], fleet.goal[slot]));
  }
  return travels;
}

bool looks_around(RobotId robot, std::int64_t steps) {
  return (robot.value + static_cast<std::uint64_t>(steps)) % kStepsBetweenLooks == 0;
}

}  // namespace avo
