// SPDX-License-Identifier: Apache-2.0
#include "space/mover_columns.h"

#include <algorithm>
#include <string>

#include "avo/error.h"

namespace avo::space {

void MoverColumns::add(std::int64_t step) {
  id.push_back({next_id++});
  since.push_back(step);
  now.emplace_back();
  before.emplace_back();
}

void MoverColumns::remove(std::size_t k) {
  const auto drop = [k](auto& column) {
    column.erase(column.begin() + static_cast<std::ptrdiff_t>(k));
  };
  drop(id), drop(since), drop(now), drop(before);
}

std::size_t MoverColumns::find(MovingObstacleId obstacle) const {
  const auto place = std::find(id.begin(), id.end(), obstacle);
  if (place == id.end())
    throw Error("moving obstacle " + std::to_string(obstacle.value) + ": found none of that id");
  return static_cast<std::size_t>(place - id.begin());
}

void MoverColumns::move_to(std::int64_t step, std::span<const MovingObstacle> obstacles,
                           double time_step) {
  for (std::size_t k = 0; k < now.size(); ++k)
    now[k] = mover_at(obstacles[k], own_time(obstacles[k], since[k], step, time_step));
}

double own_time(const MovingObstacle& obstacle, std::int64_t since, std::int64_t step,
                double time_step) {
  return static_cast<double>(obstacle.trajectory.empty() ? step - since : step) * time_step;
}

}  // namespace avo::space
