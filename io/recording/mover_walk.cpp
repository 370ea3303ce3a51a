// SPDX-License-Identifier: Apache-2.0
// The places of a scene's moving obstacles at the times of a recording.
#include "io/recording/mover_walk.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <utility>

#include "avo/error.h"
#include "core/ranges.h"

namespace avo_io {
namespace {

// The steps of moving obstacles between two times: whole steps, and a part of one more.
struct Walked {
  std::int64_t steps = 0;
  double step = 0.0, part = 0.0;  // s
};

// Returns the scene's steps. With free clocks it returns one step from row to row, in whole
// nanoseconds.
Walked walked_between(avo::Clock clock, double h, std::optional<double> before, double time) {
  if (clock == avo::Clock::common) {
    const auto steps_by = [h](double t) {
      constexpr double kMost = 0x1p62;  // no obstacle moves so many steps
      return static_cast<std::int64_t>(std::clamp(std::floor(t / h + 1e-6), -kMost, kMost));
    };
    const std::int64_t first = before ? std::max(steps_by(*before), std::int64_t{0}) : 0;
    const std::int64_t last = std::max(steps_by(time), first);
    return {last - first, h, std::max(time - h * static_cast<double>(last), 0.0)};
  }
  if (!before) return {};
  const double whole = (std::round(time * 1e9) - std::round(*before * 1e9)) / 1e9;
  return {1, whole > 0.0 ? whole : time - *before, 0.0};
}

// Moves an obstacle without a path: its acceleration is held all the time.
avo::PathWalk free_walk(const avo::MovingObstacle& obstacle, double time) {
  return {
      obstacle.position + time * obstacle.velocity + (0.5 * time * time) * obstacle.acceleration,
      obstacle.velocity + time * obstacle.acceleration};
}

}  // namespace

MoverWalk::MoverWalk(const avo::Scenario& scenario)
    : clock_(scenario.clock),
      time_step_(scenario.time_step),
      obstacles_(scenario.moving_obstacles) {
  for (const avo::MovingObstacle& obstacle : obstacles_)
    walks_.push_back({obstacle.position, obstacle.velocity});
  now_ = walks_;
}

void MoverWalk::go_to(double time) {
  const std::optional<double> before = std::exchange(last_time_, time);
  const Walked walked = walked_between(clock_, time_step_, before, time);
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    const avo::MovingObstacle& obstacle = obstacles_[k];
    if (!obstacle.trajectory.empty()) {
      now_[k] = on_trajectory(obstacle, time);
      continue;
    }
    if (obstacle.path.empty()) {
      now_[k] = free_walk(obstacle, time);
      continue;
    }
    if (!before && time != 0.0 && clock_ == avo::Clock::free)
      throw avo::Error(
          fmt::format("time: found {} s, must be 0 s in the first row: with free clocks nobody "
                      "knows how far moving_obstacles.{} is on its path by then",
                      time, k));
    avo::PathWalk& walk = walks_[k];
    if (walked.steps > avo::kMostSteps)
      throw avo::Error(fmt::format(
          "time: found {} s, must be {} steps of {} s later than the row before at most", time,
          avo::kMostSteps, walked.step));
    for (std::int64_t n = 0; n < walked.steps; ++n)
      walk = next_on_path(obstacle, walk, walked.step);
    now_[k] = walk;
    if (const double t = walked.part; t > 0.0) {
      const avo::PathWalk next = next_on_path(obstacle, walk, walked.step);
      const avo::Vec2 a = (next.velocity - walk.velocity) / walked.step;
      now_[k].position = walk.position + t * walk.velocity + (0.5 * t * t) * a;
      now_[k].velocity = walk.velocity + t * a;
    }
  }
}

// With a common clock the missing steps are known.
void MoverWalk::require_known(double time) const {
  if (clock_ == avo::Clock::common) return;
  for (std::size_t k = 0; k < obstacles_.size(); ++k)
    if (!obstacles_[k].path.empty())
      throw avo::Error(fmt::format(
          "time: found {} s after rows that are missing, must be all rows: with free clocks nobody "
          "knows how far moving_obstacles.{} is on its path by then",
          time, k));
}

}  // namespace avo_io
