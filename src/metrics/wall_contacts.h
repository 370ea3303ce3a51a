// SPDX-License-Identifier: Apache-2.0
// Which robots touched a wall, and how near any robot came to one.
#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "avo/wall.h"
#include "metrics/body.h"
#include "spatial/segment_grid.h"

namespace avo::inline metrics {

/// Contact begins at this part of the radii: less overlap than that is rounding.
inline constexpr double kContact = 1e-9;

struct WallContacts {
  std::vector<Wall> walls = {};
  std::vector<LayerSet> layers = {};           // of each wall's obstacle
  SegmentGrid grid = SegmentGrid();            // of the walls
  double found_within = -1.0;                  // m, of a wall's middle line; negative: not made yet
  std::set<std::uint64_t> touched = {};        // ids of robots
  std::vector<std::uint64_t> touching = {};    // in this step
  std::optional<double> least_clearance = {};  // m

  /// Takes the walls of those obstacles in place of the earlier ones.
  void take(std::span<const StaticObstacle> obstacles);
  /// Observes robots over a step of time_step s; exact robots move by the response, where it is
  /// set.
  void observe(std::span<const Body> robots, const std::optional<Response>& response,
               double time_step);

 private:
  void find_within(double distance);
};

}  // namespace avo::inline metrics
