// SPDX-License-Identifier: Apache-2.0
// Columns of robots and obstacles: adding, removing, hashing.
#include "sim/fleet.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "avo/error.h"

namespace avo {
namespace {

// Finalizer of a 64-bit mixing generator: every input bit reaches every output bit.
std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
  hash += value + 0x9e3779b97f4a7c15u;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
  return hash ^ (hash >> 31);
}

std::uint64_t mixed(std::uint64_t hash, double value) {
  return mixed(hash, std::bit_cast<std::uint64_t>(value));
}

std::uint64_t mixed(std::uint64_t hash, Vec2 value) {
  return mixed(mixed(hash, value.x), value.y);
}

template <typename T>
void erase_at(std::vector<T>& column, std::size_t index) {
  column.erase(column.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace

void Fleet::add(RobotId robot, const RobotSetup& robot_setup) {
  // a car's velocity points along its heading
  Vec2 v = robot_setup.velocity;
  double angle = 0.0;
  if (robot_setup.car) {
    angle = robot_setup.car->heading;
    v = norm(v) * Vec2{std::cos(angle), std::sin(angle)};
  }
  id.push_back(robot);
  setup.push_back(robot_setup);
  goal.push_back(robot_setup.goal);
  position.push_back(robot_setup.position);
  velocity.push_back(v);
  heading.push_back(angle);
  next_position.push_back({});
  next_velocity.push_back({});
  next_heading.push_back(0.0);
  detour.push_back({});
  plan.push_back({});
  applied_acceleration.push_back(0.0);
}

void Fleet::remove(std::size_t index) {
  erase_at(id, index);
  erase_at(setup, index);
  erase_at(goal, index);
  erase_at(position, index);
  erase_at(velocity, index);
  erase_at(heading, index);
  erase_at(next_position, index);
  erase_at(next_velocity, index);
  erase_at(next_heading, index);
  erase_at(detour, index);
  erase_at(plan, index);
  erase_at(applied_acceleration, index);
}

void Fleet::swap_generations() {
  position.swap(next_position);
  velocity.swap(next_velocity);
  heading.swap(next_heading);
}

std::size_t Fleet::index_of(RobotId robot) const {
  const auto found = std::lower_bound(id.begin(), id.end(), robot,
                                      [](RobotId a, RobotId b) { return a.value < b.value; });
  if (found == id.end() || !(*found == robot)) {
    throw Error("robot " + std::to_string(robot.value) + ": found none of that id");
  }
  return static_cast<std::size_t>(found - id.begin());
}

void ObstacleColumns::add(const MovingObstacle& obstacle) {
  setup.push_back(obstacle);
  position.push_back(obstacle.position);
  velocity.push_back(obstacle.velocity);
}

void ObstacleColumns::advance(double time_step) {
  for (std::size_t k = 0; k < setup.size(); ++k) {
    const Vec2 a = setup[k].acceleration;
    position[k] = position[k] + time_step * velocity[k] + (0.5 * time_step * time_step) * a;
    velocity[k] = velocity[k] + time_step * a;
  }
}

std::uint64_t hash_of(const Fleet& fleet, const ObstacleColumns& obstacles, std::int64_t steps) {
  std::uint64_t hash = mixed(0, static_cast<std::uint64_t>(steps));
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    hash = mixed(hash, fleet.id[i].value);
    hash = mixed(mixed(hash, fleet.position[i]), fleet.velocity[i]);
    hash = mixed(hash, fleet.heading[i]);
    hash = mixed(mixed(hash, fleet.detour[i].angle), fleet.detour[i].yielded);
  }
  for (std::size_t k = 0; k < obstacles.setup.size(); ++k) {
    hash = mixed(mixed(hash, obstacles.position[k]), obstacles.velocity[k]);
  }
  return hash;
}

}  // namespace avo
