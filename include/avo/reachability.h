// SPDX-License-Identifier: Apache-2.0
// Which places robots get to among walls, as if each were alone. SI units.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "avo/export.h"
#include "avo/scenario.h"
#include "avo/vec.h"
#include "avo/wall.h"

namespace avo {

/// Of one radius, decided exactly. It remembers what it has found, so that the next answers come
/// sooner: not for several threads at once.
class AVO_API Reachability {
 public:
  /// Throws Error on a radius, m, that is not > 0 and finite.
  Reachability(std::span<const Wall> walls, double radius);
  ~Reachability();
  Reachability(Reachability&&) noexcept;
  Reachability& operator=(Reachability&&) noexcept;

  /// Whether a robot at one place, m, gets to the other one: no wall is nearer to either than the
  /// radius, and some way is as wide as the robot.
  [[nodiscard]] bool connects(Vec2 from, Vec2 to);
  /// m: the place nearest to `to` that a robot gets to; `to` itself where it gets there, and `from`
  /// where it gets nowhere.
  [[nodiscard]] Vec2 nearest(Vec2 from, Vec2 to);

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

/// A robot that obstacles and parked robots keep from its goal.
struct OutOfReach {
  std::size_t robot = 0;       ///< index into the scene's robots
  Vec2 nearest = {};           ///< m, the place nearest to its goal that it gets to
  double distance_left = 0.0;  ///< m, from there to the goal
  bool is_in_wall = false;     ///< the goal is nearer to a wall than the radius; else no way leads
  bool counts_as_there = false;  ///< it has arrived there: within arrival_distance of the goal
};

/// Of a scene that passes validate(), by robot.
AVO_API std::vector<OutOfReach> out_of_reach(const Scenario& scenario);

}  // namespace avo
