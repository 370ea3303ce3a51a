// SPDX-License-Identifier: Apache-2.0
// How far each robot of a fleet in space is from the nearest other one.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/space/scenario.h"
#include "io/recording/recording_blocks.h"

namespace avo_io {

/// Finds clearances of the robots of one scene; it owns the memory for that.
class SpaceClearances {
 public:
  explicit SpaceClearances(const avo::space::Scenario& scenario);
  /// Fills the clearances at one of the times in the block, m: from the body of the nearest other
  /// robot, downwash included; less than 0: they overlap; infinite: there is no other robot;
  /// not a number: it is not there.
  void find(const BlockShape& shape, std::size_t time, RecordingBlock& block);

 private:
  struct Body {
    double radius = 0.0, downwash = 0.0;  // m
  };
  std::vector<Body> bodies_;
  double largest_ = 0.0;            // m: the largest radius
  std::vector<std::size_t> order_;  // of the robots that are there, by x
};

}  // namespace avo_io
