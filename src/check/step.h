// SPDX-License-Identifier: Apache-2.0
// The bodies that move over one step of a recording, and their pairs as relative paths.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/check.h"
#include "check/arc.h"
#include "check/pieces.h"
#include "check/relative_path.h"
#include "check/sweep.h"

namespace avo::judge {

/// The judged step.
struct JudgedStep {
  double from = 0.0, duration = 0.0;  // s
  double relative_tolerance = 0.0;
  std::span<const CheckedRobot> robots;  // by number
};

/// A robot's disc or a mover over one step.
struct MovingDisc {
  Vec2 from, from_velocity, to, to_velocity;  // m, m/s
  double radius = 0.0, error = 0.0;           // m
  std::int64_t index = 0;
  bool is_mover = false;
  bool newcomer = false;               // present only at the end of the step
  std::vector<CourseKnot> knots = {};  // see DiscCourse; empty: one cubic from end to end

  /// The number of cubics.
  std::size_t parts() const { return knots.empty() ? 1 : knots.size() - 1; }
};

/// A disc of the robot from row `before` to row `now`, `duration` s later.
MovingDisc robot_disc(const CheckedRobot& robot, std::size_t disc, const CheckedState& before,
                      const CheckedState& now, double duration);
/// A disc of a robot without a row at the start of the step.
MovingDisc newcomer(const CheckedRobot& robot, std::size_t disc, const CheckedState& now);
/// The place and the velocity of a body.
struct PlacedMover {
  Vec2 position, velocity;  // m, m/s
};
PlacedMover place_of(const CheckedMover& mover, double time);
MovingDisc mover_disc(const PlacedMover& from, const PlacedMover& to, double radius,
                      std::int64_t index);

/// Returns whether one of the two is present only at the end of the step.
inline bool end_only(const MovingDisc& a, const MovingDisc& b) {
  return a.newcomer || b.newcomer;
}

/// Part k of `parts`, a multiple of its own number, of the path of one disc, relative to a point
/// at rest, m.
RelativePath path_of(const MovingDisc& disc, double duration, Vec2 origin = {}, std::size_t k = 0,
                     std::size_t parts = 1);
/// The whole path.
inline auto pieces_of(const MovingDisc& disc, double duration, Vec2 origin) {
  const std::size_t parts = disc.newcomer ? 1 : disc.parts();
  const auto piece = [&disc, duration, origin, parts](std::size_t k) {
    return path_of(disc, duration, origin, k, parts);
  };
  return Pieces<decltype(piece)>{parts, piece};
}
/// The path of two discs relative to each other. Where it is end_only, there is one part.
RelativePath relative_path(const MovingDisc& a, const MovingDisc& b, double duration, std::size_t k,
                           std::size_t parts);

/// The whole path.
inline auto relative_pieces(const MovingDisc& a, const MovingDisc& b, double duration) {
  const std::size_t parts = end_only(a, b) ? 1 : std::max(a.parts(), b.parts());
  const auto piece = [&a, &b, duration, parts](std::size_t k) {
    return relative_path(a, b, duration, k, parts);
  };
  return Pieces<decltype(piece)>{parts, piece};
}

/// Contains the disc at all times of the step.
BoundingBox box_of(const MovingDisc& disc, std::size_t owner, double duration);

/// Upper bound of the speed on a part of the path, m/s; at most twice the largest speed.
double speed_bound(const MovingDisc& disc, double from_fraction, double to_fraction,
                   double duration);

}  // namespace avo::judge
