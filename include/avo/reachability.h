// SPDX-License-Identifier: Apache-2.0
// Which places robots can reach among walls, each as if it were alone. SI units.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "avo/export.h"
#include "avo/ids.h"
#include "avo/scenario.h"
#include "avo/vec.h"
#include "avo/wall.h"

namespace avo {

/// Reachability for one radius, decided exactly. It remembers its results, so that the next answers
/// come sooner: it must not be used by several threads at once.
class AVO_API Reachability {
 public:
  /// Throws Error on a radius, m, that is not > 0 and finite.
  Reachability(std::span<const Wall> walls, double radius);
  ~Reachability();
  Reachability(Reachability&&) noexcept;
  Reachability& operator=(Reachability&&) noexcept;

  /// Returns whether a robot at one place, m, can reach the other one. No wall is then nearer to
  /// either place than the radius, and some route is as wide as the robot.
  [[nodiscard]] bool connects(Vec2 from, Vec2 to);
  /// m: the place nearest to `to` that a robot at `from` can reach. It is `to` itself if the robot
  /// can reach it, and `from` if the robot can reach no other place.
  [[nodiscard]] Vec2 nearest(Vec2 from, Vec2 to);

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

/// A robot that cannot reach its goal because of obstacles and parked robots.
struct OutOfReach {
  RobotId robot;               ///< its value is its position in the scene's robots
  Vec2 nearest = {};           ///< m, the reachable place nearest to its goal
  double distance_left = 0.0;  ///< m, from there to the goal
  /// the goal is nearer to a wall than the radius; if false, there is no route
  bool is_in_wall = false;
  /// the robot has arrived there: within arrival_distance of the goal
  bool counts_as_there = false;
};

/// Returns the robots that cannot reach their goals, by robot, for a scene that passes validate().
AVO_API std::vector<OutOfReach> out_of_reach(const Scenario& scenario);

}  // namespace avo
