// SPDX-License-Identifier: Apache-2.0
// A judge of recorded motion in space that shares no formula with the planner. It judges the
// separation of every pair in continuous time, downwash, boxes, moving obstacles, limits and
// arrival.
#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "avo/check.h"
#include "avo/export.h"
#include "avo/space/box.h"
#include "avo/vec3.h"

namespace avo::space {

/// The body and the limits of a recorded robot. Infinite limits are not checked.
struct CheckedRobot {
  double radius = 0.5;            ///< m, > 0
  double downwash = 0.0;          ///< m, >= 0: no robot may be so far below it, within the radii
  double max_acceleration = 1.0;  ///< m/s^2, > 0, along the horizontal
  double max_speed = 2.0;         ///< m/s, > 0, along the horizontal
  double vertical = 1.0;          ///< > 0, of both limits along the vertical
  double climb = std::numeric_limits<double>::infinity();  ///< m/s, > 0
  double sink = std::numeric_limits<double>::infinity();   ///< m/s, > 0
  /// m/s^2, > 0: where it is more than max_acceleration, a step may slow the robot down straight by
  /// that much.
  std::optional<double> max_braking = {};
  std::optional<Vec3> goal = {};  ///< m
};

/// A moving obstacle. Between two times it is on the cubic with its positions and velocities.
struct CheckedMover {
  double radius = 0.5;    ///< m, > 0
  bool straight = false;  ///< it moves straight and evenly instead
};

/// One row of a recording, or the state of a moving obstacle.
struct CheckedState {
  std::int64_t robot = 0;  ///< index into the robots given, or of the moving obstacle
  Vec3 position, velocity;
};

/// Takes the rows of one time after the other. Between two rows a robot is on the cubic with their
/// positions and velocities.
class AVO_API Check {
 public:
  /// Throws Error on values out of range.
  explicit Check(std::vector<CheckedRobot> robots, std::vector<Box> boxes = {},
                 const CheckOptions& options = {}, std::vector<CheckedMover> movers = {});
  ~Check();
  Check(Check&&) noexcept;
  Check& operator=(Check&&) noexcept;

  /// Adds all rows of one time, by ascending robot; times ascend, by 1e-12 s or more. Throws Error
  /// on anything else. A robot may be missing: it is judged over the steps that have it at both
  /// ends. movers: the states of all moving obstacles, in their order.
  void add(double time, std::span<const CheckedState> rows,
           std::span<const CheckedState> movers = {});
  /// Moving obstacles have come, gone or changed at the time of the last add(). There are these
  /// from then on, and states says where they were at that time. The report names them by the
  /// numbers in their states.
  void set_movers(std::vector<CheckedMover> movers, std::span<const CheckedState> states);
  /// Declares that rows are missing between the last add() and the next one: the step is one of
  /// CheckReport::unjudged_steps.
  void skip();
  /// The report of the plane; a static contact names a robot and a box. No robot has a heading.
  [[nodiscard]] CheckReport report() const;

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo::space
