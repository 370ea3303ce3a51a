// SPDX-License-Identifier: Apache-2.0
#include "planner/wishes.h"

#include <algorithm>

#include "core/response_law_kernel.h"
#include "planner/arrival.h"
#include "planner/behind_walls.h"
#include "planner/certify.h"
#include "planner/steer.h"

namespace avo {
namespace {

// Beside walls a robot on its way does not give way: pushed back from them and from others at rest
// it would stand still for ever.
Vec2 push_among_walls(const Tile& tile, std::size_t i, const StepLaw& law, Vec2 push) {
  const std::span<const Wall> walls = tile.walls_of(i);
  if (walls.empty() || push == Vec2{}) return push;
  const Robot robot = tile.robots.robot(i);
  return !is_near_goal(robot) && is_beside(robot, walls, law) ? Vec2{} : push;
}

// Of a robot by a gentle law. Whether is_landing() surely says no, told without a division: nearly
// always.
bool is_far_from_goal(const RobotColumns& robots, std::size_t i, const Execution& execution) {
  if (execution.law.comfort_jerk < kUnlimited) return false;
  const double v = robots.max_speed[i], a = robots.max_acceleration[i];
  const double fewest = v * (1.0 / (scalar::kFewestSteps * execution.law.time_step));
  const double b = std::min({a, robots.max_braking[i], execution.law.comfort_acceleration, fewest});
  const double response =
      execution.law.response_time * v + 2.0 * execution.law.time_step * a;  // times a
  return 2.0 * a * b * robots.distance_to_goal[i] > 1.01 * v * (v * a + 4.0 * b * response);
}

}  // namespace

void make_wishes(const Planner& planner, const Tile& tile, DecisionColumns& decisions) {
  const PlannerOptions& options = planner.options();
  const RobotColumns& robots = tile.robots;
  decisions.reserve(robots.count);
  if (options.method != Method::avo) {
    std::copy_n(robots.preferred_x.begin(), robots.count, decisions.wish_x.begin());
    std::copy_n(robots.preferred_y.begin(), robots.count, decisions.wish_y.begin());
    return;
  }
  look_around(robots, decisions);
  for (std::size_t i = 0; i < robots.count; ++i) {
    const double time =
        time_to_speed(robots.max_speed[i], robots.max_acceleration[i], robots.radius[i]);
    decisions.ahead[i] =
        unusual_congestion(decisions.ahead[i], time, options.time_step, *tile.detour[i]);
  }
  keep_right(robots, decisions);
  const StepLaw law = certificate_law(planner).step;
  for (std::size_t i = 0; i < robots.count; ++i) {
    if (robots.has_models && tile.maneuvers[i] != 0) {
      decisions.wish_x[i] = robots.preferred_x[i], decisions.wish_y[i] = robots.preferred_y[i];
      continue;
    }
    Traffic traffic = decisions.traffic(i);
    Detour& detour = *tile.detour[i];
    if (detour.goal_taken) {
      detour.beside = 0.0F, detour.has_arrived = false;
      decisions.wish_x[i] = robots.preferred_x[i], decisions.wish_y[i] = robots.preferred_y[i];
      continue;
    }
    if (!traffic.is_beside && detour.beside == 0.0F) continue;
    traffic.push = push_among_walls(tile, i, law, traffic.push);
    const Vec2 wish = wish_of(robots.robot(i), decisions.wish(i), traffic, options, detour);
    decisions.wish_x[i] = wish.x, decisions.wish_y[i] = wish.y;
  }
}

void make_aims(const Execution& execution, const Tile& tile, DecisionColumns& decisions) {
  const RobotColumns& robots = tile.robots;
  std::copy_n(decisions.wish_x.begin(), robots.count, decisions.aim_x.begin());
  std::copy_n(decisions.wish_y.begin(), robots.count, decisions.aim_y.begin());
  if (!execution.law.is_gentle()) {  // no acceleration counts, but has to be a number
    std::fill_n(decisions.last_x.begin(), robots.count, 0.0);
    std::fill_n(decisions.last_y.begin(), robots.count, 0.0);
    return;
  }
  for (std::size_t i = 0; i < robots.count; ++i) {
    const Detour& detour = *tile.detour[i];
    decisions.last_x[i] = execution.braking_time * detour.acceleration_x;
    decisions.last_y[i] = execution.braking_time * detour.acceleration_y;
    if (robots.model[i] != nullptr || is_far_from_goal(robots, i, execution)) continue;
    const Robot robot = robots.robot(i);
    const Haste haste = haste_of(robot, execution);
    if (!is_landing(robot, haste, execution)) continue;
    const Vec2 v = robot.velocity, aim = v + (decisions.wish(i) - v) / haste.gain;
    // what still drives it on has to end at once
    if (dot(decisions.last_change(i), aim - v) < 0.0)
      decisions.last_x[i] = decisions.last_y[i] = 0.0;
    decisions.aim_x[i] = aim.x, decisions.aim_y[i] = aim.y;
  }
}

}  // namespace avo
