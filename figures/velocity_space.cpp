// SPDX-License-Identifier: Apache-2.0
// Converts a robot's perception and choice to the sets in its velocity space.
#include "figures/velocity_space.h"

#include <algorithm>
#include <cmath>

#include "avo/half_plane.h"
#include "figures/colors.h"
#include "figures/contour.h"

namespace avo::figures {
namespace {

constexpr Color kPreferred = kBlue;
constexpr Color kChosen = kVermilion;
constexpr int kContourCells = 240;

std::string source_label(std::int64_t source) {
  return source >= 0 ? std::to_string(source) : std::string("o") + std::to_string(-1 - source);
}

// v'_B of a moving obstacle: its velocity, or the velocity that it approaches under the observed
// acceleration (§III-C).
Vec2 new_velocity_of(const Neighbor& neighbor, const PlannerOptions& options) {
  const bool observed =
      neighbor.behavior == Behavior::moves_on && !disregards_acceleration(options.method);
  if (!observed) return neighbor.velocity;
  return neighbor.velocity + options.control_time * neighbor.acceleration;
}

// Returns whether the chosen velocity lies on the line. Programs have tolerances, and a figure has
// pixels.
bool lies_on(const HalfPlane& plane, Vec2 chosen) {
  return std::fabs(violation(plane, chosen)) < 1e-3;
}

// Method avo: the speed planes of walls bound the target, except among moving obstacles alone.
void append_walls(const Simulation::Perception& perception, const Planner& planner,
                  const Plan& plan, bool movers, VelocitySpace& space) {
  WallPlanes walls;
  planner.collect_half_planes(perception.robot, perception.walls, walls);
  const auto append = [&](const std::vector<WallPlane>& planes, bool forbids) {
    for (const WallPlane& cut : planes) {
      const bool binding = forbids && lies_on(cut.plane, plan.new_velocity);
      space.half_planes.push_back({cut.plane, "w" + std::to_string(cut.wall), binding, forbids});
    }
  };
  const bool is_avo = method_traits(planner.options().method).has_rules;
  append(walls.speeds, !movers);
  append(walls.obstacles, !is_avo);
}

}  // namespace

LabeledObstacle obstacle_of(const Simulation::Perception& perception, std::size_t i,
                            const PlannerOptions& options) {
  const Response response = disregards_acceleration(options.method)
                                ? Response::velocity()
                                : Response::proportional(options.control_time);
  const Neighbor& neighbor = perception.neighbors[i];
  const Robot& robot = perception.robot;
  const Pair pair{robot.position - neighbor.position, robot.velocity - neighbor.velocity,
                  robot.radius + neighbor.radius};
  if (method_traits(options.method).is_reciprocal &&
      shares(neighbor)) {  // α times as large, with its apex moved by α to v_B
    const double alpha = reciprocal_share(robot.max_acceleration, neighbor.max_acceleration,
                                          robot.priority, neighbor.priority);
    const Pair own{pair.position, alpha * pair.velocity, pair.radius};
    return {{own, response, options.time_horizon / alpha},
            robot.velocity - own.velocity,
            source_label(perception.source[i])};
  }
  return {{pair, response, options.time_horizon},
          new_velocity_of(neighbor, options),
          source_label(perception.source[i])};
}

VelocitySpace velocity_space(const Simulation::Perception& perception, const Planner& planner) {
  VelocitySpace space;
  const Robot& robot = perception.robot;
  const Disc reachable = planner.acceleration_disc(robot);
  if (std::isfinite(reachable.radius)) space.acceleration_disc = reachable;
  space.speed_disc = planner.speed_disc(robot);

  PlanWorkspace workspace;
  Detour detour = perception.detour;
  const bool movers = perception.among_movers || avoids_union(planner.options().method);
  const Plan plan = planner.plan(robot, perception.neighbors, workspace, &detour, perception.walls);
  if (movers) {
    for (std::size_t i = 0; i < perception.neighbors.size(); ++i) {
      space.obstacles.push_back(obstacle_of(perception, i, planner.options()));
    }
  } else {
    HalfPlanes half_planes;
    planner.collect_half_planes(robot, perception.neighbors, workspace, half_planes,
                                perception.walls);
    for (const NeighborPlane& cut : half_planes.planes) {
      const auto i = static_cast<std::size_t>(cut.neighbor);
      space.half_planes.push_back(
          {cut.plane, source_label(perception.source[i]), lies_on(cut.plane, plan.new_velocity)});
      if (method_traits(planner.options().method).stays_in_cell)
        continue;  // cells are not obstacles
      space.obstacles.push_back(obstacle_of(perception, i, planner.options()));
      space.obstacles.back().label.clear();  // the half-plane has that label
      space.obstacles.back().forbids = false;
    }
  }
  append_walls(perception, planner, plan, movers, space);
  space.points = {{robot.velocity, "*v*", kBlack, true},
                  {robot.preferred_velocity, "*v*^{pref}", kPreferred},
                  {plan.new_velocity, "*v*′", kChosen}};
  return space;
}

std::vector<std::vector<Vec2>> obstacle_outline(const LabeledObstacle& labeled, const Box& view) {
  const Obstacle& obstacle = labeled.obstacle;
  const auto depth = [&](Vec2 u) {
    return closest_approach(obstacle, u - labeled.offset).distance - obstacle.pair.radius;
  };
  // |x(t)| changes by at most g(t) times the change of u, Eq. (9)
  return negative_set(view, kContourCells, depth, obstacle.response.gain(obstacle.time_horizon));
}

}  // namespace avo::figures
