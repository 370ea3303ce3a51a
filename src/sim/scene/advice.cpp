// SPDX-License-Identifier: Apache-2.0
// Finds settings that can be simulated but do not fit the robots (paper §VI-A), with the
// arithmetic.
#include "sim/scene/advice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "avo/scenario.h"
#include "robots/model.h"
#include "sim/scene/assumptions.h"

namespace avo {
namespace {

/// The robot with the largest value, and that value; the first of equals. For parked robots it is
/// 0.
struct WorstRobot {
  std::size_t robot = 0;
  double value = 0.0;
};

template <class Measure>
WorstRobot worst(const std::vector<RobotSetup>& robots, Measure measure) {
  WorstRobot result;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const double value = is_parked(robots[i]) ? 0.0 : measure(robots[i]);
    if (value > result.value) result = {i, value};
  }
  return result;
}

bool cannot_stop(const RobotSetup& robot) {
  return !can_rest(robot.model);
}

/// The name of the value with which decisions slow a robot down.
std::string braking_key(const RobotSetup& robot) {
  return planned_braking(robot) < robot.max_acceleration ? "max_braking" : "max_acceleration";
}

/// [2 v_max / a_max], the paper's rule for δ: one decision then reaches every valid velocity.
double usual_control_time(const RobotSetup& robot) {
  return 2.0 * robot.max_speed / robot.max_acceleration;
}

std::string usual_control_time_of(const RobotSetup& robot, std::size_t index) {
  return "2 max_speed / max_acceleration = 2 * " + in_short(robot.max_speed) + " / " +
         in_short(robot.max_acceleration) + " = " + in_short(usual_control_time(robot)) + " s of " +
         robot_name(index);
}

void advise_control_time(const Scenario& scenario, std::vector<std::string>& lines) {
  // avo approaches v' as fast as it can, these others at once
  const auto& robots = scenario.robots;
  const auto is_paper = [&](const RobotSetup& r) {
    return method_traits(method_of(scenario, r)).lags;
  };
  const auto first = std::find_if(robots.begin(), robots.end(), is_paper);
  if (first == robots.end()) return;
  const double delta = planner_options(scenario, *first).control_time;
  // Twice the rule or half of it still behaves like the paper's own figures.
  const WorstRobot shortest = worst(robots, [&](const RobotSetup& r) {
    return is_paper(r) ? usual_control_time(r) / delta : 0.0;
  });
  if (shortest.value > 2.0) {
    const RobotSetup& robot = robots[shortest.robot];
    lines.push_back("control_time " + in_short(delta) + " s is less than half of " +
                    usual_control_time_of(robot, shortest.robot) + ": a decision changes its " +
                    "velocity by at most " + in_short(delta) + " * " +
                    in_short(robot.max_acceleration) + " = " +
                    in_short(delta * robot.max_acceleration) + " m/s");
  }
  const WorstRobot longest = worst(robots, [&](const RobotSetup& r) {
    return is_paper(r) ? delta / usual_control_time(r) : 0.0;
  });
  if (longest.value > 2.0)
    lines.push_back("control_time " + in_short(delta) + " s is more than twice " +
                    usual_control_time_of(robots[longest.robot], longest.robot) +
                    ": it responds slowly");
  if (scenario.time_step > 0.5 * delta)
    lines.push_back("time_step " + in_short(scenario.time_step) + " s is more than half of " +
                    "control_time = " + in_short(delta) + " s: the control is coarse");
}

void advise_time_step(const Scenario& scenario, std::vector<std::string>& lines) {
  const WorstRobot jump = worst(scenario.robots, [&](const RobotSetup& r) {
    return r.max_speed * time_step_of(scenario, r) / disc_radius(r);
  });
  if (jump.value <= 1.0) return;
  const RobotSetup& robot = scenario.robots[jump.robot];
  const double dt = time_step_of(scenario, robot);
  lines.push_back(
      "time_step " + in_short(dt) + " s lets " + robot_name(jump.robot) + " travel " +
      in_short(robot.max_speed) + " * " + in_short(dt) + " = " + in_short(robot.max_speed * dt) +
      " m between decisions, more than its radius = " + in_short(disc_radius(robot)) + " m");
}

void advise_time_horizon(const Scenario& scenario, std::vector<std::string>& lines) {
  const auto stops_within = [](const RobotSetup& r) { return r.max_speed / planned_braking(r); };
  const WorstRobot slowest = worst(scenario.robots, [&](const RobotSetup& r) {
    return cannot_stop(r) ? 0.0 : stops_within(r) - time_horizon_of(scenario, r);
  });
  if (!(slowest.value > 0.0)) return;
  const RobotSetup& robot = scenario.robots[slowest.robot];
  const double tau = time_horizon_of(scenario, robot);
  lines.push_back("time_horizon " + in_short(tau) + " s is shorter than " +
                  robot_name(slowest.robot) + " needs to stop, max_speed / " + braking_key(robot) +
                  " = " + in_short(robot.max_speed) + " / " + in_short(planned_braking(robot)) +
                  " = " + in_short(stops_within(robot)) + " s");
}

/// A certificate does not warn about its assumptions: broken_assumptions() does.
bool is_certified(const Scenario& scenario) {
  return std::any_of(scenario.robots.begin(), scenario.robots.end(),
                     [&](const RobotSetup& robot) { return keeps_certificate(scenario, robot); });
}

/// How far a robot's edge gets from the present place of its center, if its fallback begins only a
/// step later. It is r + v_max Δt + v_max² / (2 b), m; for a robot that flies room_to_turn()
/// replaces the last term.
double fallback_reach(const RobotSetup& robot, double time_step) {
  const double v = robot.max_speed;
  return disc_radius(robot) + v * time_step +
         (cannot_stop(robot) ? room_to_turn(robot.model, v) : 0.5 * v * v / planned_braking(robot));
}

std::string fallback_term(const RobotSetup& robot) {
  if (cannot_stop(robot)) return "2 max_speed^2 / lateral_acceleration";
  return "max_speed^2 / (2 " + braking_key(robot) + ")";
}

void advise_sensing_radius(const Scenario& scenario, std::vector<std::string>& lines) {
  std::vector<RobotSetup> robots = scenario.robots;
  if (robots.size() < 2 || is_certified(scenario)) return;
  const auto reach = [&](const RobotSetup& r) {
    return fallback_reach(r, time_step_of(scenario, r));
  };
  const WorstRobot first = worst(robots, reach);
  robots.erase(robots.begin() + static_cast<std::ptrdiff_t>(first.robot));
  const WorstRobot second = worst(robots, reach);
  const double needed = first.value + second.value;
  const double sensing_radius = sensing_radius_of(scenario);
  if (sensing_radius >= needed) return;
  const std::size_t other = second.robot + (second.robot >= first.robot ? 1 : 0);
  lines.push_back("sensing_radius " + in_short(sensing_radius) + " m is less than " +
                  robot_name(first.robot) + " and " + robot_name(other) +
                  " need to keep clear of each other, radius + max_speed * time_step + " +
                  fallback_term(scenario.robots[first.robot]) + " = " + in_short(first.value) +
                  " + " + in_short(second.value) + " = " + in_short(needed) + " m");
}

/// The cost of a step is about in proportion to the neighbors of a robot. Each gets a half-plane
/// where max_neighbors does not limit them.
void advise_crowding(const Scenario& scenario, std::vector<std::string>& lines) {
  constexpr double kMany = 50.0, kCostly = 4.0;  // neighbors; factor over the needed number
  if (scenario.max_neighbors || !scenario.sensing_radius) return;
  const double sensed = *scenario.sensing_radius, needed = needed_sensing_radius(scenario);
  if (sensed <= needed) return;
  const double seen = mean_neighbors(scenario, sensed);
  const double least = std::max(mean_neighbors(scenario, needed), 1.0);
  if (seen < kMany || seen < kCostly * least) return;
  const auto rounded = [](double value) {
    return in_short(value < 10.0 ? std::round(10.0 * value) / 10.0 : std::round(value));
  };
  lines.push_back("sensing_radius " + in_short(sensed) + " m is " + rounded(sensed / needed) +
                  " times the " + in_short(needed) + " m that the robots need: a robot senses " +
                  rounded(seen) + " others at the start instead of " + rounded(least) +
                  ", so that a step costs about " + rounded(seen / least) +
                  " times as much; leave sensing_radius out, or set max_neighbors");
}

/// docs/navigation.md, "Inside of walls": no direction then surely leads away from walls.
void advise_localization(const Scenario& scenario, std::vector<std::string>& lines) {
  const bool has_walls = !scenario.obstacles.empty() || !parked_discs(scenario.robots).empty();
  const double error = planner_options(scenario).localization_error;
  const WorstRobot lost =
      worst(scenario.robots, [&](const RobotSetup& r) { return 2.0 * error / disc_radius(r); });
  if (!has_walls || lost.value < 1.0) return;
  lines.push_back(
      "sensing.localization lets " + robot_name(lost.robot) + " be up to " + in_short(error) +
      " m off where it takes itself to be, and half of its radius is " +
      in_short(0.5 * disc_radius(scenario.robots[lost.robot])) + " m: it may stay in a corner");
}

void advise_slow_flights(const Scenario& scenario, std::vector<std::string>& lines) {
  const auto advise = [&](const WorstRobot& slow, const char* then) {
    const RobotSetup& robot = scenario.robots[slow.robot];
    lines.push_back("preferred_speed " + in_short(robot.preferred_speed) + " m/s of " +
                    robot_name(slow.robot) + " is less than its min_speed = " +
                    in_short(model_traits(robot.model).least_speed) + " m/s" + then);
  };
  const WorstRobot circling = worst(scenario.robots, [](const RobotSetup& r) {
    return r.preferred_speed > 0.0 ? 0.0 : model_traits(r.model).least_speed;
  });
  if (circling.value > 0.0) advise(circling, ": it circles where it starts, for ever");
  const WorstRobot slow = worst(scenario.robots, [](const RobotSetup& r) {
    return r.preferred_speed > 0.0 ? model_traits(r.model).least_speed / r.preferred_speed : 0.0;
  });
  if (slow.value > 1.0) advise(slow, ", with which it flies");
}

void advise_speeds(const Scenario& scenario, std::vector<std::string>& lines) {
  const WorstRobot wish =
      worst(scenario.robots, [](const RobotSetup& r) { return r.preferred_speed / r.max_speed; });
  if (wish.value > 1.0)
    lines.push_back("preferred_speed " + in_short(scenario.robots[wish.robot].preferred_speed) +
                    " m/s of " + robot_name(wish.robot) + " is more than its max_speed = " +
                    in_short(scenario.robots[wish.robot].max_speed) + " m/s");
  advise_slow_flights(scenario, lines);
  const WorstRobot start = worst(scenario.robots, [&](const RobotSetup& r) {
    return keeps_certificate(scenario, r) ? 0.0 : norm(r.velocity) / r.max_speed;
  });
  if (start.value > 1.0)
    lines.push_back("velocity of " + robot_name(start.robot) + " is " +
                    in_short(norm(scenario.robots[start.robot].velocity)) +
                    " m/s at the start, more than its max_speed = " +
                    in_short(scenario.robots[start.robot].max_speed) + " m/s: it brakes first");
}

}  // namespace

std::vector<std::string> advice(const Scenario& scenario) {
  std::vector<std::string> lines;
  if (scenario.robots.empty()) return lines;
  advise_control_time(scenario, lines);
  advise_time_step(scenario, lines);
  advise_time_horizon(scenario, lines);
  advise_sensing_radius(scenario, lines);
  advise_crowding(scenario, lines);
  advise_localization(scenario, lines);
  advise_speeds(scenario, lines);
  advise_overlaps(scenario, lines);
  return lines;
}

}  // namespace avo
