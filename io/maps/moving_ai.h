// SPDX-License-Identifier: Apache-2.0
// Maps and scenarios of the MovingAI benchmarks (Sturtevant 2012).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/maps/occupancy_grid.h"
#include "io/text/source_text.h"

namespace avo_io {

/// Free are `.`, `G` and `S` (swamp); blocked `@`, `O`, `T` and `W` (water). Cell and origin are
/// left as they are. Throws SceneError.
OccupancyGrid read_moving_ai_map(const SourceText& source);

/// One row of a .scen file; cells count from the upper left.
struct ScenRow {
  std::size_t offset = 0;  ///< in the text
  std::string map;
  std::int64_t width = 0, height = 0;
  std::int64_t start_x = 0, start_y = 0, goal_x = 0, goal_y = 0;
};
/// Throws SceneError. Starts and goals are cells of a map of that size.
std::vector<ScenRow> read_scen(const SourceText& source);

}  // namespace avo_io
