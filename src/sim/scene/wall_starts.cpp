// SPDX-License-Identifier: Apache-2.0
// Starts beside static obstacles: the first state of the certificate against walls.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "certificate/discs.h"
#include "certificate/fallback_areas.h"
#include "robots/model.h"
#include "sim/columns/fleet.h"
#include "sim/columns/static_world.h"
#include "sim/scene/assumptions.h"
#include "walls/segment.h"

namespace avo::inline sim {

void include_start(const Scenario& scenario, const RobotSetup& robot, const MotionState& state,
                   const CertificateLaw& law, WallNeeds& needs) {
  const StepLaw own = step_law(scenario, robot, law);
  const double stray = stray_of(robot.model, robot.max_acceleration, own.time_step).distance +
                       room_to_turn(robot.model, robot.max_speed);
  needs.include(traits_of(robot), stray, norm(state.velocity), own);
}

namespace {

// The walls that robots of some layers heed, and which obstacle each belongs to.
struct ListedWalls {
  LayerSet layers;
  std::vector<Wall> walls = {};
  std::vector<ObstacleId> obstacle = {};
  WallGrid grid = {};  // of the walls that a robot of the scene may be too near to
};

// Lists walls for the robots that are in the same layers of `telling`.
class WallsOfLayers {
 public:
  WallsOfLayers(const Scenario& scenario, std::span<const MotionState> states,
                const CertificateLaw& law)
      : scenario_(scenario),
        states_(states),
        law_(law),
        telling_(telling_layers(scenario.obstacles)) {}

  // Valid until the next call.
  const ListedWalls& of(const RobotSetup& robot) {
    const LayerSet layers = told(robot);
    const auto known = std::find_if(listed_.begin(), listed_.end(), [&](const ListedWalls& walls) {
      return walls.layers == layers;
    });
    return known != listed_.end() ? *known : listed_.emplace_back(list(robot));
  }

 private:
  [[nodiscard]] LayerSet told(const RobotSetup& robot) const {
    return {robot.layers.bits & telling_.bits};
  }
  [[nodiscard]] ListedWalls list(const RobotSetup& robot) const {
    ListedWalls listed{told(robot)};
    for (std::size_t k = 0; k < scenario_.obstacles.size(); ++k) {
      if (!heeds(robot.layers, scenario_.obstacles[k])) continue;
      const std::vector<Wall> walls = walls_of(std::span(&scenario_.obstacles[k], 1));
      listed.walls.insert(listed.walls.end(), walls.begin(), walls.end());
      listed.obstacle.insert(listed.obstacle.end(), walls.size(), ObstacleId{k});
    }
    WallNeeds needs;
    for (std::size_t i = 0; i < states_.size(); ++i)
      if (told(scenario_.robots[i]) == listed.layers)
        include_start(scenario_, scenario_.robots[i], states_[i], law_, needs);
    listed.grid = grid_of(listed.walls, needs);
    return listed;
  }

  const Scenario& scenario_;
  std::span<const MotionState> states_;
  const CertificateLaw& law_;
  LayerSet telling_;
  std::vector<ListedWalls> listed_;
};

}  // namespace

namespace {

// A disc of a robot at the start.
struct WallStartDisc {
  Vec2 center;
  double radius, lever;  // m
};

std::optional<WallStart> worst_wall(const Scenario& scenario, RobotId number,
                                    const MotionState& state, const WallStartDisc& disc,
                                    std::span<const Wall> walls, const CertificateLaw& law) {
  const RobotSetup& robot = listed_as(number, scenario.robots);
  const Vec2 center = disc.center;
  const double radius = disc.radius, lever = disc.lever;
  const WallRounding rounding = wall_rounding(radius + lengths_of_rounding(lever), robot.max_speed,
                                              ability_of(robot), step_law(scenario, robot, law));
  const double late = late_phase(robot, longest_first_step(law));
  const Vec2 to_stop = stopping_vector(state.velocity, decrement_of(robot, law.step), law.step);
  const LoiterCircle* circle = !can_rest(robot.model) ? &state.circle : nullptr;
  const auto start_at = [&](const Wall& wall) {
    const Segment segment{wall.a - center, wall.b - center};
    if (circle)
      return WallStart{number,
                       {},
                       distance(Vec2{}, segment),
                       distance(circle->center, {wall.a, wall.b}) - circle->radius,
                       radius + wall.radius + flight_margin(wall, radius, circle->radius)};
    return WallStart{number,
                     {},
                     distance(Vec2{}, segment),
                     distance({{}, to_stop}, segment) - late,
                     radius + wall.radius + wall_margin(wall, rounding)};
  };
  const auto lacks = [](const WallStart& start) { return start.required - start.kept; };
  std::optional<WallStart> worst;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    WallStart start = start_at(walls[k]);
    start.obstacle = {k};
    if (lacks(start) > 0.0 && (!worst || lacks(start) > lacks(*worst))) worst = start;
  }
  return worst;
}

}  // namespace

// Braking leaves less than the required distance.
std::optional<WallStart> worst_wall(const Scenario& scenario, RobotId number,
                                    const MotionState& state, std::span<const Wall> walls,
                                    const CertificateLaw& law) {
  const RobotSetup& robot = listed_as(number, scenario.robots);
  const Footprint footprint = footprint_of(robot.model);
  if (!footprint)
    return worst_wall(scenario, number, state, {state.position, disc_radius(robot), 0.0}, walls,
                      law);
  const BrakingPose pose = braking_pose(robot.model, state.velocity, state.heading,
                                        braking_limit(robot), step_law(scenario, robot, law));
  std::optional<WallStart> worst;
  for (int k = 0; k < footprint.discs; ++k) {
    const double ahead = footprint.ahead(k);
    const WallStartDisc disc{state.position + ahead * pose.ahead,
                             footprint.radius + std::abs(ahead) * pose.spread, ahead};
    const auto own = worst_wall(scenario, number, state, disc, walls, law);
    if (own && (!worst || own->required - own->kept > worst->required - worst->kept)) worst = own;
  }
  return worst;
}

namespace {

// Even-odd rule: how often a ray to the right crosses the closed chains.
bool is_inside(Vec2 p, const StaticObstacle& obstacle) {
  bool inside = false;
  for (const Chain& chain : obstacle.chains) {
    if (!chain.closed || chain.points.empty()) continue;
    Vec2 a = chain.points.back();
    for (const Vec2 b : chain.points) {
      if ((a.y > p.y) != (b.y > p.y)) {
        const double side = cross(b - a, p - a);
        if ((b.y > a.y) == (side > 0.0)) inside = !inside;
      }
      a = b;
    }
  }
  return inside;
}

}  // namespace

bool leaves_room(Vec2 p, const StaticObstacle& obstacle) {
  if (obstacle.fill == Fill::none) return true;
  return is_inside(p, obstacle) == (obstacle.fill == Fill::bounds);
}

MotionState start_of(const RobotSetup& robot) {
  MotionState state{disc_center(robot), start_velocity(robot), robot.heading};
  if (const auto circle = circle_of(robot.model, state.position, state.velocity))
    state.circle = *circle;
  return state;
}

void find_wall_starts(const Scenario& scenario, std::span<const MotionState> states,
                      const CertificateLaw& law, BrokenAssumptions& result) {
  if (scenario.obstacles.empty()) return;
  WallsOfLayers walls(scenario, states, law);
  std::vector<WallStart> beside;
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    const RobotSetup& robot = scenario.robots[i];
    if (!keeps(scenario, robot, law)) continue;
    const RobotId number{i};
    const MotionState& state = states[i];
    const ListedWalls& listed = walls.of(robot);
    if (worst_wall(scenario, number, state, listed.grid.near(state.position), law)) {
      beside.push_back(*worst_wall(scenario, number, state, listed.walls, law));
      beside.back().obstacle = listed_as(beside.back().obstacle, listed.obstacle);
    }
    for (std::size_t k = 0; k < scenario.obstacles.size(); ++k) {
      if (leaves_room(robot, states[i].position, scenario.obstacles[k])) continue;
      ++result.misplaced_count;
      if (result.misplaced.size() < BrokenAssumptions::kNamed)
        result.misplaced.push_back({number, {k}});
      break;
    }
  }
  result.beside_count = static_cast<std::int64_t>(beside.size());
  std::stable_sort(beside.begin(), beside.end(), [](const WallStart& a, const WallStart& b) {
    return a.required - a.kept > b.required - b.kept;
  });
  beside.resize(std::min(beside.size(), BrokenAssumptions::kNamed));
  result.beside = std::move(beside);
}

}  // namespace avo::inline sim
