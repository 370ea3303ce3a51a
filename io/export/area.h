// SPDX-License-Identifier: Apache-2.0
// The area where pedestrians can walk, as well-known text: exports describe walls by it.
#pragma once
#include <string>
#include <vector>

#include "avo/scenario.h"
#include "avo_io/recording.h"

namespace avo_io {

struct WalkableArea {
  std::string wkt;     ///< POLYGON, or MULTIPOLYGON if robots are in parts that do not meet
  avo::Vec2 min, max;  ///< m
};

/// The area within all bounds of the scene, without its solids and its walls. If the scene has no
/// bounds, it lies within a rectangle around all motion and all obstacles. Only parts in which
/// robots begin are kept.
class AreaFinder {
 public:
  /// `scenario` may be null; it must outlive this object.
  explicit AreaFinder(const avo::Scenario* scenario);
  void add(const RecordedTime& moment);
  /// Throws avo::Error if the area has no part.
  [[nodiscard]] WalkableArea found() const;

 private:
  void reach(avo::Vec2 point, double margin);
  [[nodiscard]] std::vector<avo::StaticObstacle> regions() const;

  const avo::Scenario* scenario_;
  double margin_ = 0.0;  // m, around centers
  avo::Vec2 min_, max_;
  std::vector<avo::Vec2> begin_;  // of the robots at the first time
};

}  // namespace avo_io
