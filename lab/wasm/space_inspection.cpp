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
#include "avo/space/simulation.h"
#include "host.h"

namespace avo_lab {
namespace {

using avo::Vec3;

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

}  // namespace

/// Returns a byte for each node of a grid over the cut in the room, bottom row first. It tells
/// whether the certificate admits that velocity at the end of the step.
AVO_EXPORT(std::size_t, admitted_in_cut)
(std::uint32_t robot, std::uint32_t columns, std::uint32_t rows) {
  const Cut cut = cut_from_room();
  const auto* space = std::get_if<SpaceRun>(&run());
  if (space == nullptr) throw avo::Error("space: found 2, must be 3 for this");
  const avo::space::Simulation::Perception seen = space->simulation->perceive({robot});
  const avo::space::Planner planner(planner_options(space->scenario));
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

}  // namespace avo_lab
