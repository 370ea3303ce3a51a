// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/wishes.h"

#include <algorithm>

#include "core/response_law_kernel.h"
#include "planner/decision.h"
#include "planner/rules/arrival.h"
#include "planner/rules/behind_walls.h"
#include "planner/stages/certify.h"
#include "planner/stages/execution.h"
#include "planner/stages/steer.h"
#include "robots/model.h"

namespace avo::inline planner {

std::optional<Vec2> push_within(const DiscPair& pair) {
  const Robot& robot = pair.robot;
  const Neighbor& neighbor = pair.neighbor;
  const double contact = robot.radius + neighbor.radius;
  if (!(pair.gap < kRoom * contact) || !(pair.gap > -contact)) return std::nullopt;
  const double defers = is_predicted(neighbor) ? 1.0 : deference(robot.priority, neighbor.priority);
  return defers * push_of(robot, neighbor);
}

namespace {

constexpr double kInSight = 4.0;  // τ: a neighbor farther off does not make a robot hurry

// Footprints push with the two discs of a pair that are nearest to each other. The discs that cover
// them overlap where trucks pass, and would push along the whole lane.
void push_by_discs(const RobotColumns& robots, std::size_t i, const StepLaw& law,
                   Traffic& traffic) {
  const Discs discs = discs_of(robots.robot(i), law);
  const Neighbors& neighbors = robots.neighbors[i];
  traffic.is_beside = false, traffic.push = traffic.push_at_rest = {};
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const DiscPair nearest = nearest_discs(discs, neighbors[k]);
    const std::optional<Vec2> push = push_within(nearest);
    if (!push) continue;
    traffic.is_beside = true;
    const double motion = motion_of(nearest.robot, nearest.neighbor);
    traffic.push = traffic.push + motion * *push;
    traffic.push_at_rest = traffic.push_at_rest + (1.0 - motion) * *push;
  }
}

// Beside walls a robot on its route does not yield: pushed back by walls and by others at rest, it
// would stand still for ever.
Vec2 push_among_walls(const Tile& tile, std::size_t i, const StepLaw& law, Vec2 push) {
  const std::span<const Wall> walls = tile.walls_of(i);
  if (walls.empty() || push == Vec2{}) return push;
  const Robot robot = tile.robots.robot(i);
  return !is_near_goal(robot) && is_beside(robot, walls, law) ? Vec2{} : push;
}

// For a robot with a gentle law: returns whether is_landing() is surely false and unhurried_part()
// is kUnhurried. It is computed without a division, and is nearly always true.
bool is_far_from_goal(const RobotColumns& robots, std::size_t i, const Execution& execution) {
  const ResponseLaw& law = execution.law;
  if (law.comfort_jerk < kUnlimited || law.control_time <= law.time_step) return false;
  const double v = robots.max_speed[i], a = robots.max_acceleration[i];
  const double fewest = v * (1.0 / (scalar::kFewestSteps * law.time_step));
  const double b = std::min({a, robots.max_braking[i], law.comfort_acceleration, fewest});
  const double response = law.response_time * v + 2.0 * law.time_step * a;  // times a
  return 2.0 * a * b * robots.distance_to_goal[i] > 1.01 * v * (v * a + 4.0 * b * response);
}

// Returns whether a robot at its max_speed could touch the neighbor k of the columns by then.
bool is_in_sight(const RobotColumns& robots, std::size_t i, const NeighborColumns& neighbors,
                 std::size_t k, double time_horizon) {
  const double nearing = robots.max_speed[i] + norm(Vec2{neighbors.v_x[k], neighbors.v_y[k]});
  const double distance = norm(Vec2{neighbors.x[k], neighbors.y[k]} - robots.position(i));
  return distance - robots.radius[i] - neighbors.radius[k] <= kInSight * time_horizon * nearing;
}

// The factor of unhurried_part(). Neighbors in sight that get half-planes count. If a robot has
// more priority than all of them, they leave it a path, and it must use it. Where a mover is in
// sight, robots hurry as among movers alone: otherwise movers would run into more robots at rest.
double hurry_of(const PlannerOptions& options, const RobotColumns& robots, std::size_t i) {
  const Neighbors& neighbors = robots.neighbors[i];
  const double priority = robots.priority[i];
  if (neighbors.count == 0) return 1.0;
  const NeighborColumns& columns = *neighbors.columns;
  if (!columns.has_movers && !columns.has_priorities && priority == 1.0) return 1.0;
  const std::size_t end = neighbors.first + planned_with(options, neighbors);
  double most = 0.0;
  for (std::size_t k = neighbors.first; k < end; ++k) {
    if (!is_in_sight(robots, i, columns, k, options.time_horizon)) continue;
    if (columns.is_predicted(k)) return kUnlimited;
    most = std::max(most, columns.priority[k]);
  }
  return most > 0.0 ? std::max(priority / most, 1.0) : 1.0;
}

// [m/s] The velocity that Eq. (23) is given in place of a wish without hurry.
Vec2 unhurried(Vec2 velocity, Vec2 wish, double part) {
  return velocity + std::min(part, 1.0) * (wish - velocity);
}

// [m/s] For a robot that may come to rest now: it must have its wish after the step.
Vec2 aim_near_goal(const Execution& execution, const Tile& tile, std::size_t i,
                   DecisionColumns& decisions, double hurry) {
  const Robot robot = tile.robots.robot(i);
  const Vec2 v = robot.velocity, wish = decisions.wish(i);
  const Haste haste = haste_of(robot, execution);
  if (haste.gain >= 1.0) return wish;
  if (!is_landing(robot, haste, execution))
    return unhurried(v, wish, hurry * unhurried_part(robot, execution));
  if (!is_holonomic(robot.model)) return wish;
  const Vec2 aim = v + (wish - v) / haste.gain;
  // an acceleration against the aim has to end at once
  if (dot(decisions.last_change(i), aim - v) < 0.0) decisions.last_x[i] = decisions.last_y[i] = 0.0;
  return aim;
}

// Returns whether the robot aims at the wish itself. A robot that flies does, and so does a robot
// with wheels that maneuvers. A robot with wheels on the last part of its route does too: the wish
// steers it to the place of its goal.
bool steers_by_wish(const Tile& tile, std::size_t i) {
  const MotionModel* model = tile.robots.model[i];
  return model != nullptr && (tile.maneuvers[i] != 0 || !can_rest(*model) ||
                              is_near_goal(tile.robots.distance_to_goal[i], tile.robots.radius[i]));
}

Vec2 aim_of(const PlannerOptions& options, const Execution& execution, const Tile& tile,
            std::size_t i, DecisionColumns& decisions) {
  const RobotColumns& robots = tile.robots;
  if (steers_by_wish(tile, i)) return decisions.wish(i);
  const double hurry = hurry_of(options, robots, i);
  if (!is_far_from_goal(robots, i, execution))
    return aim_near_goal(execution, tile, i, decisions, hurry);
  return unhurried(robots.velocity(i), decisions.wish(i), hurry * scalar::kUnhurried);
}

}  // namespace

template <typename Trace>
void make_wishes(const Planner& planner, const Tile& tile, DecisionColumns& decisions,
                 Trace trace) {
  const PlannerOptions& options = planner.options();
  const RobotColumns& robots = tile.robots;
  decisions.reserve(robots.count);
  if (!method_traits(options.method).has_rules) {
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
    trace.keeps_right(robots, i, decisions);
    if (!traffic.is_beside && detour.beside == 0.0F) continue;
    if (traffic.is_beside && has_discs(robots, i)) push_by_discs(robots, i, law, traffic);
    traffic.push = push_among_walls(tile, i, law, traffic.push);
    const Robot robot = robots.robot(i);
    const PushRule rule = push_rule(robot, traffic.is_beside, options, detour);
    const Vec2 wish = wish_of(robot, decisions.wish(i), traffic, rule);
    trace.yields(robots, i, law, rule, wish);
    decisions.wish_x[i] = wish.x, decisions.wish_y[i] = wish.y;
  }
}

template void make_wishes(const Planner&, const Tile&, DecisionColumns&, NoTrace);
template void make_wishes(const Planner&, const Tile&, DecisionColumns&, Recorder);

void make_aims(const Planner& planner, const Execution& execution, const Tile& tile,
               DecisionColumns& decisions) {
  const RobotColumns& robots = tile.robots;
  std::copy_n(decisions.wish_x.begin(), robots.count, decisions.aim_x.begin());
  std::copy_n(decisions.wish_y.begin(), robots.count, decisions.aim_y.begin());
  if (!execution.law.is_gentle()) {  // accelerations are not used, but must be numbers
    std::fill_n(decisions.last_x.begin(), robots.count, 0.0);
    std::fill_n(decisions.last_y.begin(), robots.count, 0.0);
    return;
  }
  for (std::size_t i = 0; i < robots.count; ++i) {
    const Detour& detour = *tile.detour[i];
    decisions.last_x[i] = execution.braking_time * detour.acceleration_x;
    decisions.last_y[i] = execution.braking_time * detour.acceleration_y;
    const Vec2 aim = aim_of(planner.options(), execution, tile, i, decisions);
    decisions.aim_x[i] = aim.x, decisions.aim_y[i] = aim.y;
  }
}

}  // namespace avo::inline planner
