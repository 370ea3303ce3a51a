// SPDX-License-Identifier: Apache-2.0
// What moves over one step of a recording, and its pairs seen as relative paths.
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

/// The step that is judged.
struct Step {
  double from = 0.0, duration = 0.0;  // s
  double relative_tolerance = 0.0;
  std::span<const CheckedRobot> robots;  // by number
};

/// A robot's disc or an obstacle over one step.
struct Mover {
  Vec2 from, from_velocity, to, to_velocity;  // m, m/s
  double radius = 0.0, error = 0.0;           // m
  std::int64_t index = 0;
  bool obstacle = false;
  bool newcomer = false;         // there at the end of the step only
  std::vector<Knot> knots = {};  // see Course; none: one cubic from end to end

  /// Cubics.
  std::size_t parts() const { return knots.empty() ? 1 : knots.size() - 1; }
};

/// The robot from row `before` to row `now`, `duration` s later.
Mover robot_mover(const CheckedRobot& robot, const CheckedState& before, const CheckedState& now,
                  double duration);
/// A robot without a row at the start of the step.
Mover newcomer(const CheckedRobot& robot, const CheckedState& now);
/// Where a body is, and how fast.
struct Place {
  Vec2 position, velocity;  // m, m/s
};
Place place_of(const CheckedObstacle& obstacle, double time);
Mover obstacle_mover(const Place& from, const Place& to, double radius, std::int64_t index);

/// Are the two there at the end of the step only?
inline bool end_only(const Mover& a, const Mover& b) {
  return a.newcomer || b.newcomer;
}

/// Part k of `parts`, a multiple of its own, of the path of one mover, seen from a point at rest,
/// m.
RelativePath path_of(const Mover& mover, double duration, Vec2 origin = {}, std::size_t k = 0,
                     std::size_t parts = 1);
/// All of it.
inline auto pieces_of(const Mover& mover, double duration, Vec2 origin) {
  const std::size_t parts = mover.newcomer ? 1 : mover.parts();
  const auto piece = [&mover, duration, origin, parts](std::size_t k) {
    return path_of(mover, duration, origin, k, parts);
  };
  return Pieces<decltype(piece)>{parts, piece};
}
/// Of two. Where it is end_only, all the path is there.
RelativePath relative_path(const Mover& a, const Mover& b, double duration, std::size_t k,
                           std::size_t parts);

/// All of it.
inline auto relative_pieces(const Mover& a, const Mover& b, double duration) {
  const std::size_t parts = end_only(a, b) ? 1 : std::max(a.parts(), b.parts());
  const auto piece = [&a, &b, duration, parts](std::size_t k) {
    return relative_path(a, b, duration, k, parts);
  };
  return Pieces<decltype(piece)>{parts, piece};
}

/// Holds the mover's disc at all times of the step.
Box box_of(const Mover& mover, std::size_t owner, double duration);

/// Largest speed on a part of the path, m/s; at most twice too high.
double speed_bound(const Mover& mover, double from_fraction, double to_fraction, double duration);

}  // namespace avo::judge
