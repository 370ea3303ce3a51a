// SPDX-License-Identifier: Apache-2.0
// How far each robot of a fleet in space is from the nearest other one.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/space/robot.h"
#include "avo/space/scenario.h"
#include "io/recording/recording_blocks.h"

namespace avo_io {

/// Finds clearances of the robots of one scene; it owns the memory for that.
class SpaceClearances {
 public:
  explicit SpaceClearances(const avo::space::Scenario& scenario);
  /// Fills the clearances at one of the times in the block, m: from the body of the nearest other
  /// robot, downwash included. Below 0, the two overlap. The clearance is infinite without another
  /// robot, and not a number for a robot that is not there.
  void find(const BlockShape& shape, std::size_t time, RecordingBlock& block);
  /// Fills the clearances of all robots of the scene at their present places, m.
  void find(std::span<const avo::space::Robot> robots, std::span<float> clearance);

 private:
  // of those in order_
  void find_among(const double* x, const double* y, const double* z, float* clearance);

  struct Body {
    double radius = 0.0, downwash = 0.0;  // m
  };
  std::vector<Body> bodies_;
  double largest_ = 0.0;            // m: the largest radius
  std::vector<std::size_t> order_;  // of the robots that are there, by x
  std::vector<double> x_, y_, z_;   // m, of robots
};

}  // namespace avo_io
