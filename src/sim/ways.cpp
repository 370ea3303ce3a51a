// SPDX-License-Identifier: Apache-2.0
#include "sim/ways.h"

#include <algorithm>
#include <utility>

#include "navigation/right_of_way.h"

namespace avo {
namespace {

constexpr std::uint64_t kStepsBetweenLooks = 10;
constexpr double kSightReach = 0.1;  // m

// Where the target is, and how far it is from there to the goal; nothing where there is no target.
std::optional<std::pair<Vec2, double>> rest_of(const Travel& travel) {
  if (travel.graph == nullptr) return std::nullopt;
  const PathMap& map = *travel.map;
  if (travel.target == PathMap::kGoal && map.is_free) return std::pair(map.goal, 0.0);
  if (travel.target >= map.length.size()) return std::nullopt;
  return std::pair(travel.graph->points[travel.target], map.length[travel.target]);
}

// The travel where it goes on, of those that are planned anew where walls have changed.
Travel replanned(const Travel& before, Travel fresh, Vec2 position) {
  const auto kept = rest_of(before);
  if (!kept || !rest_of(fresh)) return fresh;
  LegScratch scratch;
  Travel first = before;
  first.target =
      next_leg(*before.graph, *before.map, position, PathMap::kNothing, false, scratch).target;
  if (rest_of(first) != rest_of(fresh)) return fresh;
  const std::vector<Vec2>& points = fresh.graph->points;
  Travel travel = fresh;
  travel.target = before.target;
  if (before.target != PathMap::kGoal) {
    const auto place = std::find(points.begin(), points.end(), kept->first);
    travel.target = static_cast<std::uint32_t>(place - points.begin());
  }
  return rest_of(travel) == kept ? travel : fresh;
}

}  // namespace

Ways::Ways(const Scenario& settings, std::span<const Wall> walls)
    : follows_(settings.navigation.value_or(true)),
      heeds_passages_(follows_ && settings.right_of_way != RightOfWay::none),
      walls_(walls.begin(), walls.end()) {
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

Travel Ways::resume(double radius, Vec2 goal, std::uint32_t target) {
  Travel travel;
  travel.target = target;
  if (!follows_) return travel;
  const Radius& known = of_radius(radius);
  travel.graph = &known.graph, travel.map = map_to(known, goal);
  return travel;
}

std::size_t Ways::most_targets() const {
  std::size_t most = 0;
  for (const auto& [radius, known] : radii_) most = std::max(most, known->graph.points.size() + 1);
  return most;
}

void Ways::find_passages(std::vector<double> radii) {
  if (walls_.empty() || !heeds_passages_ || radii == passage_radii_) return;
  passages = Passages(walls_, radii, kClaimRange);
  passage_radii_ = std::move(radii);
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

void plan_travels(Ways& ways, const Fleet& fleet) {
  if (ways.empty()) return;
  ways.travels.reserve(fleet.size());
  for (const std::uint32_t slot : fleet.slot_of) {
    ways.travels.push_back(
        ways.plan(fleet.traits[slot].radius, fleet.position[slot], fleet.goal[slot]));
  }
}

void replan_travels(const Ways& before, Ways& ways, const Fleet& fleet) {
  plan_travels(ways, fleet);
  if (before.empty() || ways.empty()) return;
  for (std::size_t rank = 0; rank < ways.travels.size(); ++rank) {
    Travel& travel = ways.travels[rank];
    travel = replanned(before.travels[rank], travel, fleet.position[fleet.slot_of[rank]]);
  }
}

bool looks_around(RobotId robot, std::int64_t steps) {
  return (robot.value + static_cast<std::uint64_t>(steps)) % kStepsBetweenLooks == 0;
}

}  // namespace avo
