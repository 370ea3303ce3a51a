// SPDX-License-Identifier: Apache-2.0
// A mover's trajectory in the time steps of the robot that plans.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/trajectory.h"
#include "certificate/braking_path.h"
#include "certificate/constraint_columns.h"

namespace avo::inline certificate {

/// In interval k of the robot's time the mover moves straight from place k to place k + 1, up to
/// bend[k] and the trajectory's own error.
struct TrajectorySteps {
  std::vector<double> x, y;  // m, from `origin`; with room for the lanes of a pack after them
  std::vector<double> bend;  // m

  /// Reserves room for so many intervals; allocates only while it grows.
  void reserve(std::size_t intervals);
  /// Begins at the time `now` of the trajectory.
  void begin(const Trajectory& trajectory, double now, Vec2 origin, double time_step);
  /// Computes the places until the end of that interval.
  void look_ahead(std::size_t intervals);

  /// The index of the step that begins at that time from now on, s. It computes the places until
  /// there.
  std::size_t step_at(double time) {
    const auto step = static_cast<std::size_t>(time / time_step_ + 0.5);
    look_ahead(step + 1);
    return step;
  }
  const Trajectory& trajectory() const { return *trajectory_; }
  double now() const { return now_; }
  Vec2 origin() const { return origin_; }
  Vec2 place(std::size_t k) const { return {x[k], y[k]}; }
  /// m/s, on interval k.
  Vec2 velocity(std::size_t k) const { return (place(k + 1) - place(k)) / time_step_; }

 private:
  const Trajectory* trajectory_ = nullptr;
  double now_ = 0.0, time_step_ = 0.0;
  Vec2 origin_;
  std::size_t known_ = 0;  // intervals
  std::size_t ahead_ = 0;  // index of the first place that is later
};

/// Returns whether the mover keeps so far from the place, for ever after that time of its
/// trajectory.
bool passes_by(const Trajectory& trajectory, double from, Vec2 place, double distance);

}  // namespace avo::inline certificate
