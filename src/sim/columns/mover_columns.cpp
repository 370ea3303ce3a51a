// SPDX-License-Identifier: Apache-2.0
#include "sim/columns/mover_columns.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "avo/error.h"
#include "guidance/resting.h"

namespace avo::inline sim {

MoverColumns::MoverColumns(const std::vector<MovingObstacle>& movers) {
  for (const MovingObstacle& obstacle : movers)
    add(obstacle, {obstacle.position, obstacle.velocity});
}

void MoverColumns::add(const MovingObstacle& obstacle, const PathWalk& start) {
  setup.push_back(obstacle);
  position.push_back(start.position), velocity.push_back(start.velocity);
  next_point.push_back(start.next_point);
  id.push_back({next_id++});
  look_over();
}

void MoverColumns::remove(std::size_t index) {
  const auto drop = [index](auto& column) {
    column.erase(column.begin() + static_cast<std::ptrdiff_t>(index));
  };
  drop(setup), drop(position), drop(velocity), drop(next_point), drop(id);
  look_over();
}

std::size_t MoverColumns::find(MovingObstacleId obstacle) const {
  const auto place = std::find(id.begin(), id.end(), obstacle);
  if (place == id.end())
    throw Error("moving obstacle " + std::to_string(obstacle.value) + ": found none of that id");
  return static_cast<std::size_t>(place - id.begin());
}

void MoverColumns::look_over() {
  has_paths = std::any_of(setup.begin(), setup.end(),
                          [](const MovingObstacle& one) { return !one.path.empty(); });
  foresight = {};
}

namespace {

// The disc of an obstacle at rest, or a disc that contains a slow one; none for an obstacle that
// moves, or will move.
std::optional<Wall> resting_disc(const MoverColumns& movers, std::size_t k) {
  const MovingObstacle& setup = movers.setup[k];
  const Vec2 p = movers.position[k], v = movers.velocity[k];
  if (setup.acceleration != Vec2{} || setup.path.size() > 1) return std::nullopt;
  if (!setup.path.empty() && norm(setup.path[0] - p) > setup.radius) return std::nullopt;
  return resting_disc(p, v, setup.radius, setup.path.empty());
}

}  // namespace

std::vector<Wall> MoverColumns::resting() const {
  std::vector<Wall> discs;
  for (std::size_t k = 0; k < setup.size(); ++k)
    if (const std::optional<Wall> disc = resting_disc(*this, k)) discs.push_back(*disc);
  return discs;
}

bool MoverColumns::rest_as(std::span<const Wall> discs) const {
  std::size_t count = 0;
  for (std::size_t k = 0; k < setup.size(); ++k) {
    const std::optional<Wall> disc = resting_disc(*this, k);
    if (!disc) continue;
    if (count == discs.size() || disc->a != discs[count].a || disc->radius != discs[count].radius)
      return false;
    ++count;
  }
  return count == discs.size();
}

Neighbor MoverColumns::sensed(std::size_t index) const {
  Neighbor neighbor{
      .position = position[index],
      .velocity = velocity[index],
      .radius = setup[index].radius,
      .behavior = Behavior::moves_on,
      .max_deviation = setup[index].max_deviation,
      .acceleration = setup[index].acceleration,
      .max_speed = setup[index].max_speed.value_or(std::numeric_limits<double>::infinity())};
  if (foresight.trajectory.empty() || setup[index].path.empty()) return neighbor;
  neighbor.max_deviation = 0.0;
  neighbor.trajectory = &foresight.trajectory[index];
  neighbor.trajectory_time = static_cast<double>(steps) * foresight.time_step;
  return neighbor;
}

void MoverColumns::advance(double time_step, double time) {
  ++steps;
  for (std::size_t k = 0; k < setup.size(); ++k) {
    if (!setup[k].trajectory.empty()) {
      const PathWalk next = on_trajectory(setup[k], time);
      position[k] = next.position, velocity[k] = next.velocity;
      continue;
    }
    if (!setup[k].path.empty()) {
      const PathWalk next = next_on_path(setup[k], walk(k), time_step);
      position[k] = next.position, velocity[k] = next.velocity, next_point[k] = next.next_point;
      continue;
    }
    const Vec2 a = setup[k].acceleration;
    position[k] = position[k] + time_step * velocity[k] + (0.5 * time_step * time_step) * a;
    velocity[k] = velocity[k] + time_step * a;
  }
}

}  // namespace avo::inline sim
