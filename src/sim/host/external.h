// SPDX-License-Identifier: Apache-2.0
// Robots of external methods: their function chooses for all of them at once, before a step moves
// any robot.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/external_method.h"
#include "avo/simulation.h"
#include "core/executor.h"

namespace avo::inline sim {

struct World;
struct Worker;

/// The columns of a MethodBatch, of some robots.
struct BatchColumns {
  std::vector<RobotId> id;
  std::vector<Robot> robot;
  std::vector<Vec2> goal;
  std::vector<std::size_t> first_neighbor, first_wall;
  std::vector<Neighbor> neighbor;
  std::vector<Wall> wall;

  void clear();
  /// Adds a robot with its neighbors and walls.
  void add(RobotId own_id, const Robot& own, Vec2 own_goal, std::span<const Neighbor> neighbors,
           std::span<const Wall> walls);
  void append(const BatchColumns& other);
};

/// The choices in a step. Allocates only while it grows.
struct ExternalChoices {
  std::vector<std::size_t> ranks;    // of the robots of external methods, ascending
  std::vector<std::uint32_t> slots;  // of the same robots
  // of them, each of one pace: parts[k] knows tiles[k]
  std::vector<std::span<const std::uint32_t>> tiles;
  std::vector<BatchColumns> parts;
  BatchColumns all;
  std::vector<Vec2> velocities;  // m/s, in that order
  std::vector<Vec2> chosen;      // m/s, by slot; empty where there are no such robots
  bool is_asked = false;         // the function runs: it must not change the simulation
};

/// Finds the robots of external methods.
void find_external(World& world);

/// Has the scene's function choose for them, from what they sense now. Throws Error where there is
/// no function, or a velocity is not finite. No robot has moved, and none remembers anything new.
void choose_externally(World& world, Executor& executor);

/// Makes the choices the preferred velocities of those robots in the worker's tile.
void take_chosen(const World& world, std::span<const std::uint32_t> slots, Worker& worker);

/// Has the function choose for a robot of an external method alone; for others does nothing.
void choose_externally(const World& world, RobotId robot, Vec2 goal, Simulation::Perception& seen);

}  // namespace avo::inline sim
