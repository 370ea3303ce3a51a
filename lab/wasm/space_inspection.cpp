// SPDX-License-Identifier: Apache-2.0
// The velocities that the certificate admits to a robot of space, on a plane through them.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "avo/error.h"
#include "avo/space/planner.h"
#include "host.h"

namespace avo_lab {
namespace {

using avo::Vec3;
using avo::space::Box;
using avo::space::Neighbor;
using avo::space::Robot;

/// A plane through the velocities: a place in it and two directions, and a box on these, m/s.
struct Cut {
  Vec3 place, along, across;
  double left, bottom, right, top;
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

/// What a robot senses exactly.
struct Surroundings {
  std::vector<Neighbor> neighbors;
  std::vector<Box> boxes;
};

Surroundings surroundings_of(const SpaceRun& run, std::size_t robot,
                             const avo::PlannerOptions& options) {
  const std::span<const Robot> robots = run.simulation->robots();
  const Robot& own = robots[robot];
  const double radius = sensing_radius_of(run.scenario), range = box_range(own, options);
  Surroundings around;
  for (std::size_t k = 0; k < robots.size(); ++k)
    if (k != robot && norm(robots[k].position - own.position) <= radius)
      around.neighbors.push_back(neighbor_of(robots[k]));
  for (const Box& box : run.scenario.boxes)
    if (norm(displacement_to(box, own.position)) <= range) around.boxes.push_back(box);
  return around;
}

}  // namespace

/// Returns a byte for each node of a grid over the cut in the room, bottom row first. It tells
/// whether the certificate admits that velocity at the end of the step.
AVO_EXPORT(std::size_t, admitted_in_cut)
(std::uint32_t robot, std::uint32_t columns, std::uint32_t rows) {
  const Cut cut = cut_from_room();
  const auto* space = std::get_if<SpaceRun>(&run());
  if (space == nullptr) throw avo::Error("space: found 2, must be 3 for this");
  if (robot >= space->simulation->size())
    throw avo::Error("robot " + std::to_string(robot) + ": found none of that id");
  const avo::space::Planner planner(planner_options(space->scenario));
  const Surroundings around = surroundings_of(*space, robot, planner.options());
  avo::space::PlanWorkspace workspace;
  std::vector<std::uint8_t> admitted;
  for (std::uint32_t row = 0; row < rows; ++row) {
    const double y = cut.bottom + (cut.top - cut.bottom) * row / std::max(rows - 1.0, 1.0);
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double x = cut.left + (cut.right - cut.left) * column / std::max(columns - 1.0, 1.0);
      const Vec3 velocity = cut.place + x * cut.along + y * cut.across;
      admitted.push_back(planner.is_admitted(space->simulation->robots()[robot], around.neighbors,
                                             workspace, velocity, around.boxes)
                             ? 1
                             : 0);
    }
  }
  return into_room(std::as_bytes(std::span(admitted)));
}

}  // namespace avo_lab
