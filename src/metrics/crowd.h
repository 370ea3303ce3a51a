// SPDX-License-Identifier: Apache-2.0
// The surroundings of robots on their trips: danger, order and density (docs/metrics.md).
#pragma once
#include <vector>

#include "avo/metrics.h"
#include "metrics/trips.h"
#include "metrics/voronoi.h"
#include "spatial/point_grid.h"

namespace avo::inline metrics {

/// From the states of robots at the ends of steps.
class Crowd {
 public:
  /// Call it after a step of that duration, s.
  void observe(const Simulation& simulation, const Trips& trips, double duration);
  void describe(RunMetrics& metrics) const;

 private:
  void look_around(const FleetView& fleet, std::size_t robot, double duration);

  double time_ = 0.0;                                      // s, of all trips together
  double danger_time_ = 0.0, separation_in_danger_ = 0.0;  // s, m s
  double order_time_ = 0.0, order_ = 0.0;                  // s
  double density_ = 0.0, densest_ = 0.0;                   // s/m^2, 1/m^2

  std::vector<Vec2> positions_;  // m, of the robots, followed by those of moving obstacles
  std::vector<double> radii_;    // m
  PointGrid grid_;
  SearchScratch scratch_;
  VoronoiCell cell_;
};

}  // namespace avo::inline metrics
