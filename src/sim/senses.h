// SPDX-License-Identifier: Apache-2.0
// What robots sense of others where the scene says that they sense them wrongly, late, or not at
// all (Scenario::sensing).
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/scenario.h"
#include "core/neighbor_columns.h"
#include "neighbors/search.h"
#include "sim/fleet.h"

namespace avo::inline sim {

struct World;

struct PastState {
  Vec2 position, velocity;  // m, m/s
};

/// Where a robot is when a step begins.
struct Present {
  std::size_t slot, rank;
  PastState state;
};

/// One robot or mover as it is sensed; see neighbor_of().
struct Sighting {
  double distance_squared = 0.0;  // m², to where it looks to be
  int source = 0;                 // rank of a robot, or -1 - k for moving obstacle k
  int age = 0;                    // steps
  Vec2 position, velocity;        // m, m/s
  Vec2 parting = {};
  double position_error = 0.0;  // m
  // of robots alone:
  std::size_t slot = 0;
  Expectation expected = Expectation::decides;
  Vec2 true_velocity = {};  // m/s, now
};

/// Where one whose clock is free was when a step of its own began or ended.
struct Knot {
  Instant at = 0;  // ns
  MotionState state;
};

/// The latest of them, as many as there is room for.
struct Track {
  std::vector<Knot> ring;
  std::size_t first = 0, count = 0;

  /// k: 0 is the oldest one.
  const Knot& operator[](std::size_t k) const { return ring[(first + k) % ring.size()]; }
  const Knot& last() const { return (*this)[count - 1]; }
  void add(const Knot& knot);
};

/// The states that measurements may be of. All robots' measurements are made from them and from
/// random numbers that are found by (seed, generation, observer, neighbor): tracks need no memory.
///
/// A generation is a step. Where clocks are free and measurements may be of the past, they are told
/// by their instants instead, of which each robot's track knows any.
struct Senses {
  std::size_t depth = 0;            // generations, the present one among them; 0: senses are exact
  bool by_time = false;             // of the past, with free clocks
  std::vector<PastState> past;      // by rank, `depth` each, generation g at g % depth
  std::vector<std::int64_t> since;  // by rank: the generation or instant in which the robot came
  std::vector<Track> tracks;        // by rank, where they are by time

  bool are_exact() const { return depth == 0; }
  /// Whether there is more than the present generation, which is known anyway.
  bool remember() const { return depth > 1 || by_time; }
  const PastState& at(std::size_t rank, std::int64_t generation) const {
    const std::size_t k = depth == 1 ? 0 : static_cast<std::size_t>(generation) % depth;
    return past[rank * depth + k];
  }

  /// knots: see knots_needed().
  void reserve_one(std::size_t knots);
  /// Throws nothing after reserve_one(); now: generation or instant.
  void add(std::int64_t now);
  void remove(std::size_t rank);
  /// As if another robot had come in its place.
  void renew(std::size_t rank, std::int64_t now);
  /// What the present generation is, and which steps have begun.
  void note(const Fleet& fleet, std::int64_t generation);

 private:
  Track spare_;  // of reserve_one()
};
/// Of a scene's robots, none of whom is there yet.
Senses senses_of(const Scenario& scenario);

/// `hash`, and what they remember.
std::uint64_t hash_of(const Senses& senses, std::uint64_t hash);

std::size_t generations_needed(const Scenario& scenario);
/// Whether measurements are of instants of the past.
bool senses_by_time(const Scenario& scenario);
/// s: how far back, where they are. longest_step: s, of anybody's.
double time_remembered(const Scenario& scenario, double longest_step);
/// Of one robot's track; 0 where senses are not by time.
std::size_t knots_needed(const Scenario& scenario, double longest_step, const RobotSetup& robot);
/// s: how long one may be in sight before it is sensed for the first time, but for a share of
/// dropped^(kMostCarried + 1).
double time_unseen(const Scenario& scenario, double longest_step);

/// Bounds of what noise adds to a measurement, of both coordinates, and what rounding adds to it.
SensingError most_noise(const MeasurementNoise& model);

/// Likewise, m, of where a robot takes itself to be.
double most_lost(const LocalizationNoise& model);
/// m: from where the robot in this slot is to where it takes itself to be now.
Vec2 own_error(const World& world, std::size_t slot);
inline Wall moved(const Wall& wall, Vec2 by) {
  return {wall.a + by, wall.b + by, wall.radius};
}

/// Of the robots and movers within the sensing radius those that the robot in this slot senses,
/// nearest first where they look to be, robots before movers and by id where that is equal.
void look(const World& world, const Present& own, std::span<const Present> robots,
          std::span<const NeighborHit> movers, std::vector<Sighting>& seen);

/// What the observer decides from: the traits of whom it sees, with what is measured.
Neighbor neighbor_of(const World& world, const Sighting& seen);
/// The same into columns, behind the others.
void append(const World& world, const Sighting& seen, NeighborColumns& to);

}  // namespace avo::inline sim
