// SPDX-License-Identifier: Apache-2.0
// What robots sense of others where the scene says that they sense them wrongly, late, or not at
// all (Scenario::sensing).
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/scenario.h"
#include "neighbors/search.h"
#include "sim/fleet.h"

namespace avo {

struct World;

struct PastState {
  Vec2 position, velocity;  // m, m/s
};

/// One robot or mover as it is sensed.
struct Sighting {
  Neighbor neighbor;
  double distance_squared = 0.0;  // m², to where it looks to be
  int source = 0;                 // rank of a robot, or -1 - k for moving obstacle k
};

/// The states that measurements may be of. All robots' measurements are made from them and from
/// random numbers that are found by (seed, generation, observer, neighbor): tracks need no memory.
struct Senses {
  std::size_t depth = 0;            // generations, the present one among them; 0: senses are exact
  std::vector<PastState> past;      // by rank, `depth` each, generation g at g % depth
  std::vector<std::int64_t> since;  // by rank: the generation in which the robot came

  bool are_exact() const { return depth == 0; }
  /// Whether past is more than the present generation, which is known anyway.
  bool remember() const { return depth > 1; }
  const PastState& at(std::size_t rank, std::int64_t generation) const {
    return past[rank * depth + static_cast<std::size_t>(generation) % depth];
  }

  void reserve_one();
  /// Throws nothing after reserve_one().
  void add(std::int64_t generation);
  void remove(std::size_t rank);
  /// As if another robot had come in its place.
  void renew(std::size_t rank, std::int64_t generation);
  /// What the present generation is.
  void note(const Fleet& fleet, std::int64_t generation);
};

/// `hash`, and what they remember.
std::uint64_t hash_of(const Senses& senses, std::uint64_t hash);

std::size_t generations_needed(const SensingModel& model);
/// s: how long one may be in sight before it is sensed for the first time, but for a share of
/// dropped^(kMostCarried + 1).
double time_unseen(const Scenario& scenario);

/// Bounds of what noise adds to a measurement, of both coordinates, and what rounding adds to it.
SensingError most_noise(const MeasurementNoise& model);

/// Of the robots and movers within the sensing radius those that the robot in this slot senses,
/// nearest first where they look to be, robots before movers and by id where that is equal.
void look(const World& world, std::size_t slot, std::span<const NeighborHit> robots,
          std::span<const NeighborHit> movers, std::vector<Sighting>& seen);

}  // namespace avo
