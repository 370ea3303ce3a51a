// SPDX-License-Identifier: Apache-2.0
// The robots near a place where a robot is put down between two steps, while no robot moves.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "spatial/point_grid.h"

namespace avo::inline sim {

struct Fleet;

/// The largest values of any robot that a search has to allow for.
struct MostOfOthers {
  double radius = 0.0;   // m
  double speed = 0.0;    // m/s
  double seconds = 0.0;  // until rest
};

/// Robots near a place, from a grid. The grid is made at the second search before the next step:
/// one search of all robots costs less.
struct Bystanders {
  bool is_wanted = false, is_made = false;
  MostOfOthers most;        // of the robots in the grid
  double side = 0.0;        // m, of its cells
  PointGrid grid;           // of all robots at the time when it was made
  std::vector<RobotId> id;  // by index in the grid
  struct Late {
    RobotId id;
    Vec2 position;  // m, of its disc
  };
  std::vector<Late> late;  // robots that came or were moved since then
};

/// Forgets the grid; call it once all robots have moved.
void forget(Bystanders& bystanders);
/// Returns whether the robots that came since then cost more than a new grid; its cost is spread
/// over them.
bool has_many_late(const Bystanders& bystanders);
/// Notes that the robot has come, or has been moved, to that place of its disc, m.
void note_late(Bystanders& bystanders, RobotId robot, Vec2 position);
void make(Bystanders& bystanders, const Fleet& fleet, const MostOfOthers& most, double side);
/// Slots, in the order of ids, of all robots within the radius and of some others. It returns all
/// slots where the grid does not cover the radius.
std::vector<std::uint32_t> near_place(const Bystanders& bystanders, const Fleet& fleet, Vec2 center,
                                      double radius);

}  // namespace avo::inline sim
