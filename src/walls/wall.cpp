// SPDX-License-Identifier: Apache-2.0
#include "avo/wall.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace avo {

std::vector<Wall> walls_of(std::span<const StaticObstacle> obstacles) {
  std::vector<Wall> walls;
  for (const StaticObstacle& obstacle : obstacles) {
    for (const Chain& chain : obstacle.chains) {
      const std::vector<Vec2>& points = chain.points;
      const std::size_t count = points.size();
      if (count == 1) walls.push_back({points[0], points[0], obstacle.radius});
      for (std::size_t k = 0; k + 1 < count; ++k) {
        walls.push_back({points[k], points[k + 1], obstacle.radius});
      }
      if (chain.closed && count > 2)
        walls.push_back({points[count - 1], points[0], obstacle.radius});
    }
  }
  return walls;
}

std::vector<StaticObstacle> heeded(std::span<const StaticObstacle> obstacles, LayerSet robot) {
  std::vector<StaticObstacle> result;
  std::copy_if(obstacles.begin(), obstacles.end(), std::back_inserter(result),
               [&](const StaticObstacle& obstacle) { return heeds(robot, obstacle); });
  return result;
}

}  // namespace avo
