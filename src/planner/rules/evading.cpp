// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/evading.h"

#include <algorithm>
#include <cstddef>

#include "certificate/discs.h"
#include "core/plane.h"
#include "planner/rules/arrival.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

constexpr double kLongFlight = 8.0;  // T, until a robot circles
constexpr double kLikelyFor = 1.5;   // T, for which likely deviations count
constexpr int kMostLikelyWork =
    25000;  // movers and intervals that a level with likely deviations may test

// [T] s: a robot that flies also needs time to turn.
double time_to_evade(const Robot& robot) {
  const double turning = room_to_turn(robot.model, robot.max_speed) / (2.0 * robot.max_speed);
  return std::max(time_to_speed(robot), turning);
}

// m/s: a speed that its disc never exceeds, where the robot itself keeps max_speed.
double fastest_of(const Robot& robot, double max_speed) {
  return model_traits(robot.model).speed_ratio * max_speed;
}

// m/s: after the end of a repeating trajectory the mover's place is not known.
double fastest_until(const Neighbor& neighbor, double time) {
  const Trajectory& trajectory = *neighbor.trajectory;
  const double end = trajectory.places().back().time;
  return trajectory.repeats_from() && neighbor.trajectory_time + time >= end
             ? kInfinity
             : trajectory.max_speed(neighbor.trajectory_time);
}

Predicted predicted(const Evading& evading, const Neighbor& neighbor, const Level& level,
                    TrajectorySteps* trajectory) {
  const StepLaw& law = evading.law.step;
  const Robot& robot = evading.robot;
  const SensingError error = error_against(neighbor, law);
  Predicted other;
  other.position = neighbor.position - robot.position;
  other.velocity = neighbor.velocity;
  const double contact = evading.radius + neighbor.radius, speed = norm(neighbor.velocity);
  const bool is_followed = neighbor.trajectory != nullptr;
  const Vec2 acceleration = shares(neighbor) || is_followed ? Vec2{} : neighbor.acceleration;
  const double kept =
      contact + error.position +
      (is_followed ? neighbor.trajectory->error() : parabola_error(acceleration, law));
  const double braking = evading.braking;
  const double time = evading.options.longest + law.time_step + braking;
  const double reaction = level.reaction * time_to_evade(robot);
  // an effect below this within that time is rounding
  const bool accelerates = norm(acceleration) * time * time > 0x1p-30 * contact;
  if (is_followed) other.trajectory = trajectory;
  if (accelerates) other.acceleration = acceleration;
  other.contact = kept + level.margin * contact;
  other.stop_contact = kept + 0.5 * level.margin * contact;
  other.drift = error.velocity;
  other.deviation = neighbor.max_deviation;
  other.reaction = reaction;
  if (const double likely = level.likely * neighbor.likely_deviation; likely > other.deviation) {
    other.deviation = likely;
    other.reaction = kLikelyFor * time_to_evade(robot);
  }
  other.asks_to_stop = level.stops;
  other.until = level.until * evading.options.longest;
  other.max_speed = neighbor.max_speed;
  other.fastest =
      (is_followed ? fastest_until(neighbor, time) : speed + time * norm(acceleration)) +
      error.velocity + other.deviation * (other.reaction + braking);
  return other;
}

// Follows the known trajectories, in the order of the neighbors.
void follow_trajectories(Evading& evading) {
  const auto is_followed = [](const Neighbor& n) { return !decides(n) && n.trajectory != nullptr; };
  std::vector<TrajectorySteps>& trajectories = evading.workspace.around.trajectories;
  const auto count = static_cast<std::size_t>(
      std::count_if(evading.sight.neighbors.begin(), evading.sight.neighbors.end(), is_followed));
  if (trajectories.size() < count) trajectories.resize(count);
  const double h = evading.law.step.time_step;
  const double most = (evading.options.longest + evading.braking) / h + 3.0;
  std::size_t k = 0;
  for (const Neighbor& neighbor : evading.sight.neighbors) {
    if (!is_followed(neighbor)) continue;
    trajectories[k].reserve(static_cast<std::size_t>(most));
    trajectories[k++].begin(*neighbor.trajectory, neighbor.trajectory_time, evading.robot.position,
                            h);
  }
}

// s, until an evasive maneuver brakes or circles, for any neighbors.
double longest_of_all(const Robot& robot) {
  return (can_rest(robot.model) ? kWideEvasion : kLongFlight) * time_to_evade(robot);
}

// s, until an evasive maneuver brakes: long enough to leave the strip of the widest neighbor. Until
// a robot circles: long enough to pass by, since all of its circle must be clear then.
double longest_beside(const Robot& robot, std::span<const Neighbor> neighbors) {
  if (!can_rest(robot.model)) return longest_of_all(robot);
  const double time = time_to_evade(robot);
  double contact = 0.0;  // m
  for (const Neighbor& neighbor : neighbors)
    if (!decides(neighbor)) contact = std::max(contact, robot.radius + neighbor.radius);
  const double wide = time + 2.0 * contact / robot.max_speed;
  return std::clamp(wide, kLongestEvasion * time, kWideEvasion * time);
}

// s: the braking time of a robot of that speed, plus a step and rounding.
double braking_time_of(const Robot& robot, double speed, const StepLaw& law) {
  return law.time_step * (2.0 + speed / decrement_of(robot, law));
}

}  // namespace

double evasion_range(const Robot& robot) {
  return (longest_of_all(robot) + 0.5 * time_to_evade(robot)) * robot.max_speed +
         room_to_turn(robot.model, robot.max_speed);
}

double longest_evasion(const Robot& robot, const StepLaw& law) {
  const double longest = std::min(longest_of_all(robot), kMostEvasionSteps * law.time_step);
  const double braking = braking_time_of(robot, fastest_of(robot, robot.max_speed), law);
  return longest + law.time_step + std::min(braking, kMostBraking * law.time_step);
}

std::optional<Evading> begin_evading(const CertificateLaw& law, const Robot& robot,
                                     const Sight& sight, EvasionWorkspace& workspace) {
  if (law.kind == Certificate::none) return std::nullopt;
  Evading evading{law, robot, sight, workspace, {}, route_radius(robot.model, robot.radius)};
  evading.options = {
      .law = law.step,
      .decrement = decrement_of(robot, law.step),
      .max_speed = fastest_of(robot, std::max(robot.max_speed, norm(robot.velocity))),
      .longest =
          std::min(longest_beside(robot, sight.neighbors), kMostEvasionSteps * law.step.time_step),
      .wheels = is_holonomic(robot.model) ? nullptr : &robot};
  if (const Footprint footprint = footprint_of(robot.model)) {
    evading.options.footprint = footprint;
    evading.options.lever = farthest_center(footprint);
  }
  const bool brakes = can_rest(robot.model);
  if (brakes && !(evading.options.max_speed <= kMostBraking * evading.options.decrement))
    return std::nullopt;
  if (brakes) evading.braking = braking_time_of(robot, evading.options.max_speed, law.step);
  follow_trajectories(evading);
  return evading;
}

void look_around(Evading& evading, const Level& level) {
  Surroundings& around = evading.workspace.around;
  around.work = level.likely > 0.0 ? kMostLikelyWork : kMostWork;
  evading.options.increment =
      level.part * increment(evading.robot.max_acceleration, evading.law.step);
  around.others.clear();
  TrajectorySteps* trajectory = around.trajectories.data();
  for (const Neighbor& neighbor : evading.sight.neighbors) {
    if (decides(neighbor)) continue;
    around.others.push_back(predicted(evading, neighbor, level, trajectory));
    if (neighbor.trajectory != nullptr) ++trajectory;
  }
  begin_evasions(evading.options, around);
}

void keep_walls(Evading& evading) {
  const Robot& robot = evading.robot;
  std::vector<KeptWall>& kept = evading.workspace.around.walls;
  kept.clear();
  if (evading.sight.walls.empty()) return;
  const StepLaw& law = evading.law.step;
  const double v_max = robot.max_speed, circle = room_to_turn(robot.model, v_max);
  const double lever = evading.options.lever;
  const WallRounding rounding =
      wall_rounding(evading.radius + lengths_of_rounding(lever), v_max, ability_of(robot), law);
  const double needed = wall_reach(v_max, v_max, ability_of(robot), law) + circle;
  const double used = (evading.options.longest + 0.5 * time_to_evade(robot)) * v_max + circle;
  const double reach = std::max(needed, std::min(evading.sight.wall_range, used));
  for (const Wall& wall : evading.sight.walls) {
    const Segment segment{wall.a - robot.position, wall.b - robot.position};
    const double held = evading.radius + wall.radius + law.localization_error;
    if (distance(Vec2{}, segment) > held + lever + reach) continue;
    const double margin = can_rest(robot.model) ? wall_margin(wall, rounding)
                                                : 2.0 * flight_margin(wall, robot.radius, circle);
    kept.push_back({segment, held + margin});
  }
  if (!kept.empty()) evading.options.known = reach;
}

}  // namespace avo::inline planner
