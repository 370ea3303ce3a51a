// SPDX-License-Identifier: Apache-2.0
// The drawings of an inspector of space: what the certificate admits and what an obstacle forbids
// on a plane through the velocities, and braking paths.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "avo/error.h"
#include "avo/planner.h"
#include "avo/space/simulation.h"
#include "figures/velocity_space.h"
#include "host.h"
#include "io/text/json.h"
#include "planner/stages/certify.h"

namespace avo_lab {
namespace {

using avo::Vec3;

/// A plane through the velocities: a place in it and two directions, and a box on these, m/s.
struct Cut {
  Vec3 place, along, across;
  double left, bottom, right, top;

  [[nodiscard]] avo::Vec2 part_of(Vec3 a) const { return {dot(a, along), dot(a, across)}; }
};

Cut cut_from_room() {
  const std::vector<std::byte> room = taken_from_room();
  Cut cut{};
  if (room.size() != sizeof cut)
    throw avo::Error("cut: found " + std::to_string(room.size()) + " bytes, must be " +
                     std::to_string(sizeof cut));
  std::memcpy(&cut, room.data(), sizeof cut);
  return cut;
}

const SpaceRun& in_space() {
  const auto* space = std::get_if<SpaceRun>(&run());
  if (space == nullptr) throw avo::Error("space: found 2, must be 3 for this");
  return *space;
}

/// Appends x, y and z of a ball that brakes fully from step to step, until it rests.
template <typename Body>
void append_braking(const Body& body, const avo::StepLaw& law, std::vector<double>& points) {
  const double limit = body.max_braking.value_or(body.max_acceleration);
  Vec3 at = body.position, velocity = body.velocity;
  for (bool moves = true; moves;) {
    points.insert(points.end(), {at.x, at.y, at.z});
    moves = !(velocity == Vec3{});
    const double speed = norm(Vec3{velocity.x, velocity.y, velocity.z / body.vertical});
    const double left = speed - avo::braking_decrement(limit, law);
    const Vec3 next = left > 0.0 ? (left / speed) * velocity : Vec3{};
    at = at + law.lag * velocity + (law.time_step - law.lag) * next;
    velocity = next;
  }
}

/// Appends x, y and z of a moving obstacle that keeps its acceleration for so many steps.
void append_ahead(const avo::space::Mover& mover, std::size_t steps, double time_step,
                  std::vector<double>& points) {
  for (std::size_t k = 0; k < steps; ++k) {
    const double t = time_step * static_cast<double>(k);
    const Vec3 at = mover.position + t * mover.velocity + (0.5 * t * t) * mover.acceleration;
    points.insert(points.end(), {at.x, at.y, at.z});
  }
}

avo_io::Json path_as_json(const std::string& of, const std::vector<double>& points, double radius) {
  return {{"of", of}, {"points", points}, {"radius", radius}};
}

}  // namespace

/// Returns a byte for each node of a grid over the cut in the room, bottom row first. It tells
/// whether the certificate admits that velocity at the end of the step.
AVO_EXPORT(std::size_t, admitted_in_cut)
(std::uint32_t robot, std::uint32_t columns, std::uint32_t rows) {
  const Cut cut = cut_from_room();
  const SpaceRun& space = in_space();
  const avo::space::Simulation::Perception seen = space.simulation->perceive({robot});
  const avo::space::Planner planner(planner_options(space.scenario));
  avo::space::PlanWorkspace workspace;
  std::vector<std::uint8_t> admitted;
  for (std::uint32_t row = 0; row < rows; ++row) {
    const double y = cut.bottom + (cut.top - cut.bottom) * row / std::max(rows - 1.0, 1.0);
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double x = cut.left + (cut.right - cut.left) * column / std::max(columns - 1.0, 1.0);
      const Vec3 velocity = cut.place + x * cut.along + y * cut.across;
      admitted.push_back(planner.is_admitted(seen.robot, seen.neighbors, workspace, velocity,
                                             seen.boxes, seen.movers)
                             ? 1
                             : 0);
    }
  }
  return into_room(std::as_bytes(std::span(admitted)));
}

/// Returns JSON: rings, the boundary of the obstacle of that robot or moving obstacle, Eq. (29), on
/// the cut in the room. The cut has to be the plane of p and v of the two, in which all of the
/// obstacle's balls have their middles. Empty where it is another shape, with downwash, and for a
/// moving obstacle that accelerates.
AVO_EXPORT(std::size_t, outline_in_cut)
(std::uint32_t robot, std::uint32_t other, std::uint32_t is_mover) {
  const Cut cut = cut_from_room();
  const SpaceRun& space = in_space();
  const avo::space::Simulation::Perception seen = space.simulation->perceive({robot});
  const avo::PlannerOptions options = planner_options(space.scenario);
  avo_io::Json rings = avo_io::Json::array();
  const auto add = [&](const auto& body, double time_horizon) {
    const avo::Pair pair{cut.part_of(seen.robot.position - body.position),
                         cut.part_of(seen.robot.velocity - body.velocity),
                         seen.robot.radius + body.radius};
    const avo::figures::LabeledObstacle obstacle{
        {pair, avo::Response::proportional(options.control_time), time_horizon},
        cut.part_of(body.velocity),
        {}};
    for (const std::vector<avo::Vec2>& polygon :
         obstacle_outline(obstacle, {{cut.left, cut.bottom}, {cut.right, cut.top}})) {
      avo_io::Json& ring = rings.emplace_back(avo_io::Json::array());
      for (const avo::Vec2 at : polygon) ring.push_back({at.x, at.y});
    }
  };
  for (std::size_t k = 0; k < seen.neighbors.size() && is_mover == 0; ++k) {
    const avo::space::Neighbor& body = seen.neighbors[k];
    if (seen.neighbor_ids[k].value == other && seen.robot.downwash == 0.0 && body.downwash == 0.0)
      add(body, own_time_horizon(seen.robot, options));
  }
  for (std::size_t k = 0; k < seen.movers.size() && is_mover != 0; ++k)
    if (seen.mover_ids[k].value == other && seen.movers[k].acceleration == Vec3{})
      add(seen.movers[k], options.time_horizon);
  return into_room(rings.dump());
}

/// Returns JSON: the paths of the robot and of the robots that it sees if they brake now, from step
/// to step. Moving obstacles move on for as long as the robot brakes.
std::size_t space_braking_paths(const SpaceRun& space, std::uint32_t robot) {
  const avo::space::Simulation::Perception seen = space.simulation->perceive({robot});
  const avo::StepLaw law = avo::certificate_law(avo::Planner(planner_options(space.scenario))).step;
  std::vector<double> points;
  append_braking(seen.robot, law, points);
  const std::size_t steps = points.size() / 3;
  avo_io::Json json = avo_io::Json::array();
  json.push_back(path_as_json(name_of(robot), points, seen.robot.radius));
  for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
    points.clear();
    append_braking(seen.neighbors[k], law, points);
    const auto id = static_cast<std::int64_t>(seen.neighbor_ids[k].value);
    json.push_back(path_as_json(name_of(id), points, seen.neighbors[k].radius));
  }
  for (std::size_t k = 0; k < seen.movers.size(); ++k) {
    points.clear();
    append_ahead(seen.movers[k], steps, law.time_step, points);
    json.push_back(path_as_json("moving_obstacles." + std::to_string(seen.mover_ids[k].value),
                                points, seen.movers[k].radius));
  }
  return into_room(json.dump());
}

}  // namespace avo_lab
