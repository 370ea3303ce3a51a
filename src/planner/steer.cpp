// SPDX-License-Identifier: Apache-2.0
#include "planner/steer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "certificate/wall_constraints.h"
#include "planner/decision.h"
#include "robots/model.h"
#include "walls/segment.h"

namespace avo {
namespace {

// Of the robot's radius: what a maneuver keeps from walls and others, begun or not.
constexpr double kKeeps = 0.05;
constexpr double kKeepsOnceBegun = 0.01;
constexpr double kTouching = 0.001;    // likewise: who is nearer already may stay as near
constexpr double kNearlyAtRest = 0.1;  // of its radius, m that a neighbor needs to stop

// What is in the way of a maneuver. Of more, the others are not looked at.
struct Surroundings {
  struct Obstacle {
    Segment segment;
    double keep, keep_once_begun;  // m, from the segment
  };
  static constexpr std::size_t kMost = 32;
  std::array<Obstacle, kMost> obstacles;
  std::size_t count = 0;

  void add(const Robot& robot, double room, const Segment& segment, double radius) {
    const double away = distance(robot.position, segment), contact = robot.radius + radius;
    if (count == kMost || away > contact + room) return;
    const double nearest = away - kTouching * robot.radius;
    obstacles[count++] = {segment, std::min(contact + kKeeps * robot.radius, nearest),
                          std::min(contact + kKeepsOnceBegun * robot.radius, nearest)};
  }
  bool are_clear(Vec2 place, bool begun) const {
    return std::none_of(obstacles.data(), obstacles.data() + count, [&](const Obstacle& o) {
      return distance(place, o.segment) < (begun ? o.keep_once_begun : o.keep);
    });
  }
};

// Walls that the robot could come to touch.
void add_walls(const Robot& robot, std::span<const Wall> walls, const StepLaw& law, double room,
               Surroundings& surroundings) {
  const double reach = wall_reach(robot.max_speed, robot.max_speed, ability_of(robot), law);
  for (const Wall& wall : walls)
    surroundings.add(robot, std::min(room, reach), {wall.a, wall.b},
                     wall.radius + law.localization_error);
}

// Who cannot back off stays for ever where it has come nose to nose with others: they are in its
// way as walls are, once they are slow.
void add_slow_neighbors(const Robot& robot, const Neighbors& neighbors, double room,
                        Surroundings& surroundings) {
  if (can_reverse(robot.model)) return;
  for (std::size_t k = 0; k < neighbors.count; ++k) {
    const Neighbor neighbor = neighbors[k];
    const double speed = norm(neighbor.velocity), time = 0.5 * speed / braking_limit(neighbor);
    if (speed * time > kNearlyAtRest * robot.radius) continue;
    surroundings.add(robot, room, {neighbor.position, neighbor.position + time * neighbor.velocity},
                     neighbor.radius);
  }
}

std::optional<Vec2> maneuver_of(const PlannerOptions& options, const StepLaw& law, Tile& tile,
                                std::size_t i) {
  const double room = room_for_maneuvers(*tile.robots.model[i]);
  if (room == 0.0) return std::nullopt;
  const Robot robot = tile.robots.robot(i);
  Surroundings surroundings;
  add_walls(robot, tile.walls_of(i), law, room, surroundings);
  const bool beside_walls = surroundings.count > 0;
  add_slow_neighbors(robot, tile.robots.neighbors[i], room, surroundings);
  if (surroundings.count == 0) return std::nullopt;
  const auto wish = maneuver(robot, approach_of(options), [&surroundings](Vec2 place, bool begun) {
    return surroundings.are_clear(place, begun);
  });
  tile.maneuvers[i] = wish && beside_walls ? 1 : 0;
  return wish;
}

}  // namespace

void steer(const PlannerOptions& options, const StepLaw& law, Tile& tile) {
  RobotColumns& robots = tile.robots;
  tile.maneuvers.assign(robots.count, 0);
  for (std::size_t i = 0; i < robots.count; ++i) {
    if (robots.model[i] == nullptr) continue;
    std::optional<Vec2> wish;
    if (options.method == Method::avo) wish = maneuver_of(options, law, tile, i);
    if (!wish) wish = steered(robots.robot(i), approach_of(options));
    robots.preferred_x[i] = wish->x, robots.preferred_y[i] = wish->y;
  }
}

}  // namespace avo
