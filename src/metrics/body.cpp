// SPDX-License-Identifier: Apache-2.0
#include "metrics/body.h"

#include <cmath>
#include <numbers>

namespace avo {

// Ids ascend in both.
void collect_robots(const FleetView& fleet, const BodyStep& step, std::vector<Body>& robots) {
  const LastSeen& last = step.last;
  robots.clear();
  std::size_t j = 0;
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    while (j < last.robots.size() && last.robots[j].id.value < fleet.id[i].value) ++j;
    if (j == last.robots.size() || !(last.robots[j].id == fleet.id[i])) continue;
    Body body;
    body.name = fleet.id[i].value;
    body.setup = &fleet.setup[i];
    body.radius = disc_radius(fleet.setup[i]);
    body.velocity = last.robots[j].velocity;
    const MotionModel& model = fleet.setup[i].model;
    body.position = disc_center(model, last.robots[j].position, last.robots[j].heading);
    const Vec2 next = disc_center(model, fleet.position[i], fleet.heading[i]);
    body.w = fleet.plan[i].new_velocity - body.velocity;
    body.exact = step.moves && is_holonomic(model);
    const Vec2 start = step.at_once && body.exact ? fleet.velocity[i] : body.velocity;
    if (!step.moves) {
      body.path.control.fill(body.position);
    } else if (!moves_along_heading(model)) {
      body.path = hermite_path(body.position, start, next, fleet.velocity[i], step.duration);
    } else {
      const double turn =
          std::remainder(fleet.heading[i] - last.robots[j].heading, 2.0 * std::numbers::pi);
      body.arc = arc_path(body.position, next, turn);
      body.path =
          hermite_path(*body.arc, norm(body.velocity), norm(fleet.velocity[i]), step.duration);
    }
    robots.push_back(body);
  }
}

void collect_obstacles(const ObstacleView& now, const BodyStep& step,
                       std::vector<Body>& obstacles) {
  const LastSeen& last = step.last;
  obstacles.clear();
  for (std::size_t k = 0; k < now.setup.size() && k < last.obstacles.size(); ++k) {
    Body body;
    body.name = k;
    body.radius = now.setup[k].radius;
    body.position = last.obstacles[k].position;
    body.velocity = last.obstacles[k].velocity;
    body.exact = step.moves && now.setup[k].acceleration == Vec2{} && now.setup[k].path.empty();
    body.path =
        hermite_path(body.position, body.velocity, now.position[k], now.velocity[k], step.duration);
    if (!step.moves) body.path.control.fill(body.position);
    obstacles.push_back(body);
  }
}

}  // namespace avo
