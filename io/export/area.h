// SPDX-License-Identifier: Apache-2.0
// Where pedestrians can walk, as well-known text: what exports say of walls.
#pragma once
#include <string>
#include <vector>

#include "avo/scenario.h"
#include "avo_io/recording.h"

namespace avo_io {

struct WalkableArea {
  std::string wkt;     ///< POLYGON, or MULTIPOLYGON where robots are in parts that do not meet
  avo::Vec2 min, max;  ///< m
};

/// Within all bounds of the scene, or, where it has none, within a rectangle around all motion and
/// all obstacles; without its solids and its walls. Only parts in which robots begin.
class AreaFinder {
 public:
  /// `scenario`: may be none; outlives this.
  explicit AreaFinder(const avo::Scenario* scenario);
  void add(const RecordedTime& moment);
  /// Throws avo::Error where it has no part.
  [[nodiscard]] WalkableArea found() const;

 private:
  void reach(avo::Vec2 point, double margin);
  [[nodiscard]] std::vector<avo::StaticObstacle> regions() const;

  const avo::Scenario* scenario_;
  double margin_ = 0.0;  // m, around centers
  avo::Vec2 min_, max_;
  std::vector<avo::Vec2> begin_;  // of the robots of the first time
};

}  // namespace avo_io
