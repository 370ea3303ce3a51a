// SPDX-License-Identifier: Apache-2.0
// When robots cross a line (docs/metrics.md).
#pragma once
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "avo/metrics.h"
#include "metrics/body.h"

namespace avo::inline metrics {

/// Each robot counts once, in either direction: where the center of its disc first crosses.
class LineFlow {
 public:
  /// Throws Error where the ends are not two points.
  explicit LineFlow(const MeasuringLine& line);

  /// Observes robots over a step that begins at that time, s.
  void observe(std::span<const Body> robots, double begin, double duration);
  void describe(RunMetrics& metrics) const;

 private:
  MeasuringLine line_;
  std::set<std::uint64_t> crossed_;
  std::vector<double> times_;  // s
};

}  // namespace avo::inline metrics
