// SPDX-License-Identifier: Apache-2.0
// Robots that sense each other wrongly, late, or not at all.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "placement.h"

namespace avo::safety {

/// The difference between a sensed state and the true one, for position and velocity alike.
enum class ErrorShape : std::uint8_t {
  uniform,  ///< anywhere in the disc of the bound, new for every observer, neighbor and step
  rim,      ///< on its rim, new for every observer, neighbor and step
  farther,  ///< on its rim: the neighbor seems farther away, and seems to move away
  bias,     ///< on its rim, the same for all neighbors and steps of an observer
  flips,    ///< on its rim: farther away in one step, nearer in the next
};
inline constexpr int kErrorShapes = 5;

struct Sensing {
  SensingError error = {};     ///< the largest error that happens
  SensingError declared = {};  ///< the error that the robots plan with
  ErrorShape shape = ErrorShape::uniform;
  bool delayed = false;   ///< states are one step old, extrapolated at constant velocity
  bool stale = false;     ///< states are one step old, unchanged
  double missed = 0.0;    ///< part of the neighbors that is missed in a step, new in each step
  double radius = 1.0;    ///< the apparent size of neighbors, as a part of their radii
  bool promised = false;  ///< the certificate covers all of these errors
};

/// What the observers see, one observer after the other, step by step.
class Senses {
 public:
  Senses(const Sensing& sensing, std::size_t robots, double time_step, std::uint64_t seed);

  /// Finds what `observer` sees of all others, nearest first. `before`: one step ago.
  void observe(std::size_t observer, std::span<const Robot> robots, std::span<const Robot> before,
               std::int64_t step, std::vector<Neighbor>& neighbors);

 private:
  // Returns the error of position or velocity, as a part of the bound; `away` points to the
  // neighbor.
  Vec2 error(std::size_t observer, Vec2 away, std::int64_t step);
  Vec2 in_unit_disc();

  Sensing sensing_;
  double time_step_;
  Random random_;
  std::vector<Vec2> bias_;
};

}  // namespace avo::safety
