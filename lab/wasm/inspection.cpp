// SPDX-License-Identifier: Apache-2.0
// The drawings of an inspector besides the decision's data. They are the exact boundaries of
// obstacles, the velocities that the certificate admits, and the braking paths of all robots.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "avo/planner.h"
#include "figures/velocity_space.h"
#include "host.h"
#include "io/text/json.h"
#include "planner/stages/certify.h"

namespace avo_lab {
namespace {

using avo::Vec2;
using avo_io::Json;

constexpr int kCircleSides = 48;  // for the loiter circle of an airplane

Json flat(const std::vector<Vec2>& points) {
  Json json = Json::array();
  for (const Vec2 at : points) json.push_back(at.x), json.push_back(at.y);
  return json;
}

/// Returns the path of a disc that brakes fully from step to step, until it rests.
std::vector<Vec2> braking_path(Vec2 at, Vec2 velocity, double decrement, const avo::StepLaw& law) {
  std::vector<Vec2> path{at};
  while (!(velocity == Vec2{})) {
    const Vec2 next = avo::braked(velocity, decrement);
    at = at + law.lag * velocity + (law.time_step - law.lag) * next;
    velocity = next;
    path.push_back(at);
  }
  return path;
}

std::vector<Vec2> circle_of(const avo::LoiterCircle& circle) {
  std::vector<Vec2> path;
  for (int k = 0; k <= kCircleSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kCircleSides;
    path.push_back(circle.center + circle.radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return path;
}

/// Returns the path of a moving obstacle that keeps its present acceleration for so many steps.
std::vector<Vec2> path_ahead(const avo::Neighbor& mover, std::size_t steps, double time_step) {
  std::vector<Vec2> path;
  for (std::size_t k = 0; k < steps; ++k) {
    const double t = time_step * static_cast<double>(k);
    path.push_back(mover.position + t * mover.velocity + (0.5 * t * t) * mover.acceleration);
  }
  return path;
}

}  // namespace

/// Returns JSON: for each neighbor that the robot avoids by its obstacle, the boundary of the
/// obstacle, Eq. (29), inside the box, m/s.
AVO_EXPORT(std::size_t, outlines)
(std::uint32_t robot, double left, double bottom, double right, double top) {
  const avo::Simulation& simulation = *plane().simulation;
  const avo::Simulation::Perception seen = simulation.perceive({robot});
  const avo::Planner& planner = simulation.planner({robot});
  std::vector<std::size_t> avoided;
  if (seen.among_movers || avo::avoids_union(planner.options().method)) {
    for (std::size_t k = 0; k < seen.neighbors.size(); ++k) avoided.push_back(k);
  } else if (!avo::method_traits(planner.options().method).stays_in_cell) {
    avo::PlanWorkspace workspace;
    avo::HalfPlanes half_planes;
    planner.collect_half_planes(seen.robot, seen.neighbors, workspace, half_planes, seen.walls);
    for (const avo::NeighborPlane& plane : half_planes.planes)
      avoided.push_back(static_cast<std::size_t>(plane.neighbor));
  }
  Json json = Json::array();
  for (const std::size_t k : avoided) {
    Json rings = Json::array();
    for (const std::vector<Vec2>& polygon :
         avo::figures::obstacle_outline(avo::figures::obstacle_of(seen, k, planner.options()),
                                        {{left, bottom}, {right, top}})) {
      Json ring = Json::array();
      for (const Vec2 at : polygon) ring.push_back({at.x, at.y});
      rings.push_back(std::move(ring));
    }
    json.push_back({{"of", name_of(seen.source[k])}, {"rings", std::move(rings)}});
  }
  return into_room(json.dump());
}

/// Returns a byte for each node of a grid over the box, m/s, bottom row first. It tells whether the
/// certificate admits that velocity at the end of the step.
AVO_EXPORT(std::size_t, admitted)
(std::uint32_t robot, double left, double bottom, double right, double top, std::uint32_t columns,
 std::uint32_t rows) {
  const avo::Simulation& simulation = *plane().simulation;
  const avo::Simulation::Perception seen = simulation.perceive({robot});
  const auto between = [](double from, double to, std::uint32_t k, std::uint32_t count) {
    return from + (to - from) * k / std::max(count - 1.0, 1.0);
  };
  std::vector<Vec2> velocities;
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column)
      velocities.push_back(
          {between(left, right, column, columns), between(bottom, top, row, rows)});
  std::vector<std::uint8_t> admitted(velocities.size());
  avo::PlanWorkspace workspace;
  simulation.planner({robot}).find_admitted(seen.robot, seen.neighbors, workspace, velocities,
                                            admitted, seen.walls);
  return into_room(std::as_bytes(std::span(admitted)));
}

/// Returns JSON: the paths of the robot and of the neighbors that it sees if they brake now, from
/// step to step. Airplanes circle, and moving obstacles move on for as long as the robot brakes.
AVO_EXPORT(std::size_t, braking_paths)(std::uint32_t robot) {
  if (const auto* space = std::get_if<SpaceRun>(&run())) return space_braking_paths(*space, robot);
  const avo::Simulation& simulation = *plane().simulation;
  const avo::Simulation::Perception seen = simulation.perceive({robot});
  const avo::StepLaw law = avo::certificate_law(simulation.planner({robot})).step;
  const auto path_of = [&law](const auto& one) {
    return one.loiter ? circle_of(*one.loiter)
                      : braking_path(one.position, one.velocity, avo::decrement_of(one, law), law);
  };
  const std::vector<Vec2> own = path_of(seen.robot);
  Json json = Json::array();
  json.push_back({{"of", name_of(robot)}, {"points", flat(own)}, {"radius", seen.robot.radius}});
  for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
    const avo::Neighbor& neighbor = seen.neighbors[k];
    const bool brakes = neighbor.behavior == avo::Behavior::decides;
    json.push_back({{"of", name_of(seen.source[k])},
                    {"points", flat(brakes ? path_of(neighbor)
                                           : path_ahead(neighbor, own.size(), law.time_step))},
                    {"radius", neighbor.radius}});
  }
  return into_room(json.dump());
}

}  // namespace avo_lab
