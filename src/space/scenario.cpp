// SPDX-License-Identifier: Apache-2.0
#include "avo/space/scenario.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "avo/error.h"
#include "avo/space/planner.h"
#include "fields/sensing_checks.h"
#include "fields/space_fields.h"
#include "planner/options.h"
#include "planner/rules/arrival.h"
#include "space/certificate.h"
#include "space/mover_checks.h"
#include "space/mover_columns.h"
#include "space/own_space.h"
#include "space/senses.h"
#include "space/step_law.h"

namespace avo::space {

PlannerOptions planner_options(const Scenario& scenario) {
  PlannerOptions options{.method = Method::avo};
  options.motion = scenario.motion;
  options.time_step = scenario.time_step;
  options.control_time = scenario.control_time.value_or(options.control_time);
  options.response_time = scenario.response_time.value_or(options.response_time);
  options.comfort_acceleration = scenario.comfort_acceleration;
  options.comfort_jerk = scenario.comfort_jerk;
  options.time_horizon = scenario.time_horizon.value_or(options.time_horizon);
  options.certificate = scenario.certificate.value_or(Certificate::braking_trajectories);
  if (options.certificate == Certificate::braking_trajectories)
    options.sensing_error =
        scenario.sensing_error ? *scenario.sensing_error : declared_error(scenario);
  options.localization_error = most_lost(scenario.sensing.localization);
  options.max_neighbors = scenario.max_neighbors;
  options.arrival_distance = scenario.arrival_distance;
  options.never_swerves = scenario.never_swerves;
  if (!scenario.moving_obstacles.empty()) {
    for (const RobotSetup& robot : scenario.robots)
      options.wall_range = std::max(options.wall_range, evasion_range(robot_of(robot)));
  }
  return options;
}

Robot robot_of(const RobotSetup& setup) {
  Robot robot;
  robot.position = setup.position;
  robot.velocity = setup.velocity;
  robot.radius = setup.radius;
  robot.max_acceleration = setup.max_acceleration;
  robot.max_speed = setup.max_speed;
  robot.vertical = setup.vertical;
  robot.climb = setup.climb.value_or(robot.climb);
  robot.sink = setup.sink.value_or(robot.sink);
  robot.downwash = setup.downwash;
  robot.priority = setup.priority;
  robot.max_braking = setup.max_braking;
  if (!setup.quadrotor) return robot;
  const QuadrotorLimits limits = limits_of(*setup.quadrotor);
  robot.max_acceleration = limits.max_acceleration;
  robot.radius += limits.deviation;
  return robot;
}

double fleet_delay(const Scenario& scenario) {
  double delay = 0.0;
  for (const RobotSetup& setup : scenario.robots) {
    if (setup.quadrotor) delay = std::max(delay, limits_of(*setup.quadrotor).delay);
  }
  return delay;
}

namespace {

// The largest values of any robot, in one.
Robot largest_of(const Scenario& scenario) {
  Robot largest;
  largest.radius = largest.downwash = 0.0;
  bool first = true;
  for (const RobotSetup& setup : scenario.robots) {
    const Robot robot = robot_of(setup);
    largest.radius = std::max(largest.radius, robot.radius);
    largest.downwash = std::max(largest.downwash, robot.downwash);
    const auto widest = [first](double& value, double other, bool most) {
      value = first ? other : most ? std::max(value, other) : std::min(value, other);
    };
    widest(largest.max_speed, robot.max_speed, true);
    widest(largest.vertical, robot.vertical, true);
    widest(largest.max_acceleration, robot.max_acceleration, true);
    double braking = largest.max_braking.value_or(0.0);
    widest(braking, braking_limit(robot), false);
    largest.max_braking = braking;
    first = false;
  }
  return largest;
}

// m: the distance within which two robots have to sense each other, with the distance that both
// cover before they do.
double certified_range(const Scenario& scenario, const Robot& largest,
                       const PlannerOptions& options) {
  const double fastest = largest.max_speed * std::max(largest.vertical, 1.0);
  return sensing_range(largest, largest, options) + 2.0 * fastest * time_unseen(scenario);
}

double needed_radius(const Scenario& scenario, const PlannerOptions& options) {
  const Robot largest = largest_of(scenario);
  double radius = 0.0;
  if (options.certificate != Certificate::none)
    radius = std::max(certified_range(scenario, largest, options),
                      mover_range(scenario, largest, options));
  avo::Robot plane;
  plane.radius = largest.radius, plane.max_speed = largest.max_speed;
  plane.max_acceleration = std::min(largest.max_acceleration, *largest.max_braking);
  radius = std::max(radius, arrival_range(plane, largest.radius));
  // it sees others in time to evade them alone, from rest to rest
  const double contact = 2.0 * largest.radius + largest.downwash;
  const double evading = 2.0 * std::sqrt(contact / plane.max_acceleration);
  return std::max(radius, contact + 2.0 * largest.max_speed * evading);
}

void check_robot(const RobotSetup& robot, std::size_t k) {
  const PlaceOf place{"robots", k};
  require_ranges(robot, place);
  const auto require_slow = [&](double speed, double most, const char* limit) {
    if (speed > most * (1.0 + 1e-9))
      refuse(std::string(place("velocity")), text(speed) + " m/s at the start",
             std::string("<= its ") + limit + ", " + text(most) + " m/s");
  };
  require_slow(own_length(robot.velocity, robot.vertical), robot.max_speed, "max_speed");
  if (robot.climb) require_slow(robot.velocity.z, *robot.climb, "climb");
  if (robot.sink) require_slow(-robot.velocity.z, *robot.sink, "sink");
}

// The accelerations of a quadrotor's reference have to lie in the ball of its limits.
void check_quadrotor(const RobotSetup& robot, std::size_t k, Motion motion) {
  const PlaceOf place{"robots", k};
  const std::string name(place("quadrotor"));
  validate(*robot.quadrotor, name);
  if (motion != Motion::held)
    refuse("motion", to_string(motion), "held: " + name + " needs accelerations that are held");
  if (robot.vertical > 1.0)
    refuse(std::string(place("vertical")), text(robot.vertical), "<= 1 of a quadrotor");
  const double most = limits_of(*robot.quadrotor).max_acceleration;
  if (robot.max_braking.value_or(most) > most)
    refuse(std::string(place("max_braking")), text(*robot.max_braking),
           "<= " + text(most) + " m/s^2, the limit of its quadrotor");
}

// The box k in messages: by the obstacle of the scene file that it comes from.
std::string box_name(const Scenario& scenario, std::size_t k) {
  const bool is_known = k < scenario.obstacle_of_box.size();
  return is_known ? "obstacles." + std::to_string(scenario.obstacle_of_box[k])
                  : "boxes." + std::to_string(k);
}

bool has_nan(Vec3 p) {
  return std::isnan(p.x) || std::isnan(p.y) || std::isnan(p.z);
}

void check_box(const Box& box, const std::string& box_name) {
  require_ranges(box, Behind{box_name + "."});
  if (has_nan(box.min) || has_nan(box.max))
    refuse(box_name + ".box", "nan in min or max", "numbers");
  const bool is_sound = box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z;
  if (!is_sound) throw Error(box_name + ".box: min must not exceed max");
}

// Whether braking from the start keeps the robots apart, and from boxes.
void check_starts(const Scenario& scenario, const StepLaw& law) {
  Bodies others;
  others.reserve(scenario.robots.size());
  for (const RobotSetup& robot : scenario.robots)
    others.add(neighbor_of(robot_of(robot)), others.count);
  fill_braking(law, others);
  std::vector<NearBody> before;
  Constraints constraints;
  for (std::size_t k = 0; k < scenario.robots.size(); ++k) {
    const Robot robot = robot_of(scenario.robots[k]);
    begin_constraints(robot, others.braking(k), law, constraints);
    collect_constraints(robot, others, before, scenario.boxes, law, constraints);
    const std::string name = "robots." + std::to_string(k);
    if (constraints.invariant.broken.any())
      throw Error(name + " and robots." + std::to_string(constraints.invariant.broken.index) +
                  ": braking at the start leaves " + text(constraints.invariant.broken.depth) +
                  " m less than contact; move them apart");
    if (const Deepest& tight = constraints.boxes.tight; tight.any())
      throw Error(name + " and " + box_name(scenario, static_cast<std::size_t>(tight.index)) +
                  ": braking at the start leaves " + text(tight.depth) +
                  " m less than contact and the margin for rounding; move the robot away");
    before.push_back({static_cast<std::uint32_t>(k), others.number[k]});
  }
}

void check_mover_starts(const Scenario& scenario, const StepLaw& law) {
  std::vector<Robot> robots;
  for (const RobotSetup& setup : scenario.robots) robots.push_back(robot_of(setup));
  MoverColumns movers;
  for (std::size_t k = 0; k < scenario.moving_obstacles.size(); ++k) movers.add(0);
  movers.move_to(0, scenario.moving_obstacles, scenario.time_step);
  check_mover_starts(robots, movers.now, movers.id, law);
}

}  // namespace

Neighbor neighbor_of(const Robot& robot) {
  return {robot.position, robot.velocity, robot.radius,   robot.max_acceleration,
          robot.vertical, robot.downwash, robot.priority, robot.max_braking};
}

double sensing_radius_of(const Scenario& scenario) {
  if (scenario.sensing_radius) return *scenario.sensing_radius;
  if (scenario.robots.empty()) return 1.0;
  return needed_radius(scenario, planner_options(scenario));
}

double mover_range(const Scenario& scenario) {
  return mover_range(scenario, largest_of(scenario), planner_options(scenario));
}

void check_boxes(std::span<const Box> boxes) {
  for (std::size_t k = 0; k < boxes.size(); ++k) check_box(boxes[k], "boxes." + std::to_string(k));
}

void validate(const Scenario& scenario) {
  require_ranges(scenario, Behind{});
  check_sensing(scenario.sensing);
  for (std::size_t k = 0; k < scenario.robots.size(); ++k) check_robot(scenario.robots[k], k);
  for (std::size_t k = 0; k < scenario.robots.size(); ++k) {
    if (scenario.robots[k].quadrotor) check_quadrotor(scenario.robots[k], k, scenario.motion);
  }
  for (std::size_t k = 0; k < scenario.boxes.size(); ++k)
    check_box(scenario.boxes[k], box_name(scenario, k));
  check_moving_obstacles(scenario);
  const PlannerOptions options = planner_options(scenario);
  validate(options, "");
  require("duration", scenario.duration, {scenario.time_step, kLargest, false}, "s");
  if (scenario.sensing_error && options.certificate == Certificate::none)
    refuse("sensing_error", "one", "none with certificate none");
  const Planner planner(options);
  if (options.certificate == Certificate::none || scenario.robots.empty()) return;
  const Robot largest = largest_of(scenario);
  const double needed = certified_range(scenario, largest, options);
  if (scenario.sensing_radius && scenario.robots.size() > 1 && *scenario.sensing_radius < needed)
    throw Error("sensing_radius: found " + text(*scenario.sensing_radius) + ", must be >= " +
                text(needed) + ", in which two robots can stop before each other");
  const double of_movers = mover_range(scenario, largest, options);
  if (scenario.sensing_radius && *scenario.sensing_radius < of_movers)
    throw Error("sensing_radius: found " + text(*scenario.sensing_radius) + ", must be >= " +
                text(of_movers) + ", in which a robot can stop before moving obstacles");
  StepLaw law =
      step_law(options, Horizon(options.control_time, options.time_horizon, options.time_step));
  law.sensing_error = {};  // starts are true states
  check_starts(scenario, law);
  check_mover_starts(scenario, law);
}

}  // namespace avo::space
