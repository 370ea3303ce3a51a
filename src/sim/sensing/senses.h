// SPDX-License-Identifier: Apache-2.0
// What robots sense of others where the scene says that they sense with errors, late, or not at all
// (Scenario::sensing).
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/scenario.h"
#include "core/neighbor_columns.h"
#include "sim/columns/fleet.h"
#include "spatial/search.h"

namespace avo::inline sim {

struct World;

struct PastState {
  Vec2 position, velocity;  // m, m/s
};

/// A robot's state when a step begins.
struct Present {
  std::size_t slot, rank;
  PastState state;
  bool is_known = false;  // whether it is known when the robot was measured last:
  std::optional<std::int64_t> measured = {};  // generation or instant; nothing: never
};

/// One sensed robot or mover; see neighbor_of().
struct Sighting {
  double distance_squared = 0.0;  // m², to its sensed place
  int source = 0;                 // rank of a robot, or -1 - k for moving obstacle k
  int age = 0;                    // steps
  Vec2 position, velocity;        // m, m/s
  Vec2 parting = {};
  double position_error = 0.0;  // m
  // for robots only:
  std::size_t slot = 0;
  Expectation expected = Expectation::decides;
  Vec2 true_velocity = {};  // m/s, now
};

/// The state of a robot with a free clock at the start or end of one of its steps.
struct Knot {
  Instant at = 0;  // ns
  MotionState state;
};

/// The latest knots, as many as there is room for.
struct Track {
  std::vector<Knot> ring;
  std::size_t first = 0, count = 0;

  /// k: 0 is the oldest knot.
  const Knot& operator[](std::size_t k) const { return ring[(first + k) % ring.size()]; }
  const Knot& last() const { return (*this)[count - 1]; }
  void add(const Knot& knot);
};

/// The states that measurements may use. All robots' measurements are made from these states and
/// from
/// random numbers that are found by (seed, generation, observer, neighbor): tracks need no memory.
///
/// A generation is a step. Where clocks are free and measurements may be of the past, measurements
/// are identified by their instants instead. Each robot's track gives the state at any instant.
struct Senses {
  std::size_t depth = 0;            // generations, with the present one; 0: senses are exact
  bool by_time = false;             // past states by instants, with free clocks
  std::vector<PastState> past;      // by rank, `depth` each, generation g at g % depth
  std::vector<std::int64_t> since;  // by rank: the generation or instant in which the robot came
  std::vector<Track> tracks;        // by rank, where states are by time

  bool are_exact() const { return depth == 0; }
  /// Returns whether there is more than the present generation, which is known anyway.
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
  /// Makes the entry anew, as if another robot had come in its place.
  void renew(std::size_t rank, std::int64_t now);
  /// Stores the present generation, and the steps that have begun.
  void note(const Fleet& fleet, std::int64_t generation);

 private:
  Track spare_;  // for reserve_one()
};
/// What others can sense of a robot: its body, where that is not where it was decided to be.
PastState body_of(const Fleet& fleet, std::size_t slot);
/// The senses for a scene's robots, none of which has been added yet.
Senses senses_of(const Scenario& scenario);

/// Adds the remembered states to `hash`.
std::uint64_t hash_of(const Senses& senses, std::uint64_t hash);

std::size_t generations_needed(const Scenario& scenario);
/// Returns whether measurements are of instants of the past.
bool senses_by_time(const Scenario& scenario);
/// s: how far back the instants are. longest_step: s, of any robot.
double time_remembered(const Scenario& scenario, double longest_step);
/// The number of one robot's track; 0 where senses are not by time.
std::size_t knots_needed(const Scenario& scenario, double longest_step, const RobotSetup& robot);
/// s: how long a robot may be in sight before it is first sensed, except with the probability
/// dropped^(kMostCarried + 1).
double time_unseen(const Scenario& scenario, double longest_step);

/// Bounds of the errors that noise and rounding add to a measurement, of both coordinates together.
SensingError most_noise(const MeasurementNoise& model);

/// The same bound, m, for a robot's own place.
double most_lost(const LocalizationNoise& model);
/// m: the displacement from the true place of the robot in this slot to where it takes itself to be
/// now.
Vec2 own_error(const World& world, std::size_t slot);
inline Wall moved(const Wall& wall, Vec2 by) {
  return {wall.a + by, wall.b + by, wall.radius};
}

/// Selects the robots and movers that the robot in this slot senses, from those within the sensing
/// radius. They are ordered by sensed distance, robots before movers and by id where that is equal.
void look(const World& world, const Present& own, std::span<const Present> robots,
          std::span<const NeighborHit> movers, std::vector<Sighting>& seen);

/// The input of the observer's decision: the traits of the sensed robot, with the measured values.
Neighbor neighbor_of(const World& world, const Sighting& seen);
/// Appends the same to columns.
void append(const World& world, const Sighting& seen, NeighborColumns& to);
/// The same for all robots at once, where there are no movers; `robots` come nearest first. Each
/// robot must be seen as it truly is, or not at all. Otherwise it appends none and returns false,
/// and look() does not measure again.
bool append_as_they_are(const World& world, const Present& own, std::span<Present> robots,
                        NeighborColumns& to);

}  // namespace avo::inline sim
