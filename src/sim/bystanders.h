// SPDX-License-Identifier: Apache-2.0
// Who is near where somebody is put down between two steps, while nobody moves.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "neighbors/uniform_grid.h"

namespace avo::inline sim {

struct Fleet;

/// What a search has to allow for of any robot.
struct MostOfOthers {
  double radius = 0.0;   // m
  double speed = 0.0;    // m/s
  double seconds = 0.0;  // until rest
};

/// Made when somebody looks for a second time before the next step: one search of all costs less.
struct Bystanders {
  bool is_wanted = false, is_made = false;
  MostOfOthers most;          // of those in the grid
  double side = 0.0;          // m, of its cells
  UniformGrid grid;           // of all when it was made
  std::vector<RobotId> id;    // by what the grid calls them
  std::vector<RobotId> late;  // that came or were moved since
};

/// Once all have moved.
void forget(Bystanders& bystanders);
/// Whether those who have come since cost more than to make it anew, which is spread over them.
bool has_many_late(const Bystanders& bystanders);
/// That robot has come, or has been moved.
void note_late(Bystanders& bystanders, RobotId robot);
void make(Bystanders& bystanders, const Fleet& fleet, const MostOfOthers& most, double side);
/// Slots, in the order of ids, of all within the radius and of some others; of all where the
/// bystanders are not known as far as that.
std::vector<std::uint32_t> near_place(const Bystanders& bystanders, const Fleet& fleet, Vec2 center,
                                      double radius);

}  // namespace avo::inline sim
