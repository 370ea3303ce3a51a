// SPDX-License-Identifier: Apache-2.0
// Judges whether a run was safe, by Check's report on the states after every step.
#include "judge.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "avo/checked.h"

namespace avo::safety {
namespace {

// Returns the largest distance of the robot from the cubic between two states, m. It is 0 for held
// accelerations. Eqs. (8), (9) have x'''' = w e^{-t/δ}/δ³ with |w| <= δ a_max, and a cubic through
// positions and velocities errs by at most Δt⁴ |x''''|/384.
double interpolation_error(const PlannerOptions& options, double max_acceleration) {
  if (options.motion != Motion::exponential || adopts_at_once(options.method)) return 0.0;
  const double ratio = options.time_step / options.control_time;
  return ratio * ratio * options.time_step * options.time_step * max_acceleration / 384.0;
}

Check make_check(const Scenario& scenario) {
  const PlannerOptions options = planner_options(scenario);
  std::vector<CheckedRobot> robots;
  for (const RobotSetup& setup : scenario.robots) {
    CheckedRobot robot = checked_robot(setup);
    robot.goal.reset();
    if (is_holonomic(setup.model)) {
      robot.interpolation_error = interpolation_error(options, setup.max_acceleration);
      robot.straight = adopts_at_once(options.method);
    }
    if (scenario.clock == Clock::free && !robot.straight)
      robot.time_step = time_step_of(scenario, setup);
    robots.push_back(robot);
  }
  std::vector<CheckedMover> obstacles;
  for (const MovingObstacle& obstacle : scenario.moving_obstacles) {
    obstacles.push_back(
        {obstacle.position, obstacle.velocity, obstacle.acceleration, obstacle.radius});
  }
  std::vector<CheckedWall> walls;
  for (const Wall& wall : walls_of(scenario.obstacles)) {
    walls.push_back({wall.a, wall.b, wall.radius});
  }
  Check check(robots, std::move(obstacles));
  check.set_walls(std::move(walls));
  return check;
}

struct Rule {
  const char* what;
  CheckCount CheckReport::*count;
};

// The rules for robots with headings.
constexpr Rule kKinematics[] = {
    {"rows off their headings (m/s)", &CheckReport::headings},
    {"turns too sharp (rad)", &CheckReport::turns},
    {"steps above the lateral acceleration (m/s^2)", &CheckReport::lateral_accelerations},
    {"reversals (m/s)", &CheckReport::reversals},
    {"flights too slow (m/s)", &CheckReport::slow_flights},
    {"steps above the wheels' speed (m/s)", &CheckReport::wheel_speeds},
    {"steps above the wheels' acceleration (m/s^2)", &CheckReport::wheel_accelerations}};

void name_first(const char* what, const CheckCount& count, std::string& text) {
  if (!count.first) return;
  const CheckViolation& first = *count.first;
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, "%s%lld %s, first robot %lld", text.empty() ? "" : ", ",
                static_cast<long long>(count.count), what, static_cast<long long>(first.robot));
  text += buffer;
  if (first.other) text += " and " + std::to_string(*first.other);
  std::snprintf(buffer, sizeof buffer, " at %.4g s by %.2g", first.time, first.amount);
  text += buffer;
}

}  // namespace

std::optional<double> least_of(std::optional<double> a, std::optional<double> b) {
  return a && b ? std::min(*a, *b) : a ? a : b;
}

void Verdict::add(const Verdict& later) {
  overlapping_pairs += later.overlapping_pairs;
  moving_contacts += later.moving_contacts;
  resting_contacts += later.resting_contacts;
  static_contacts += later.static_contacts;
  evadable_hits += later.evadable_hits;
  deepest_contact = std::max(deepest_contact, later.deepest_contact);
  acceleration_violations += later.acceleration_violations;
  speed_violations += later.speed_violations;
  jumps += later.jumps;
  kinematic_violations += later.kinematic_violations;
  changes += later.changes;
  least_clearance = least_of(least_clearance, later.least_clearance);
  least_static_clearance = least_of(least_static_clearance, later.least_static_clearance);
  interpolation_error = std::max(interpolation_error, later.interpolation_error);
  if (violations.empty()) violations = later.violations;
}

struct Judge::State {
  Check check;
};

Judge::Judge(const Scenario& scenario) : state_(new State{make_check(scenario)}) {}
Judge::~Judge() = default;

void Judge::observe(const Simulation& simulation) {
  const MovingObstacleView obstacles = simulation.moving_obstacles();
  for (std::size_t k = 0; k < obstacles.setup.size(); ++k) {
    if (!obstacles.setup[k].path.empty())
      state_->check.place_mover(static_cast<std::int64_t>(k), obstacles.position[k],
                                obstacles.velocity[k]);
  }
  observe(simulation.time(), checked_states(simulation.fleet()));
}

void Judge::observe(double time, std::span<const CheckedState> rows) {
  state_->check.add(time, rows);
}

Verdict Judge::verdict() const {
  const CheckReport report = state_->check.report();
  Verdict verdict;
  verdict.overlapping_pairs = report.overlaps.count;
  verdict.moving_contacts =
      report.mover_contacts_moving.count + report.one_sided_contacts_moving.count;
  verdict.resting_contacts = report.mover_contacts_at_rest + report.one_sided_contacts_at_rest;
  verdict.static_contacts = report.static_contacts.count;
  verdict.deepest_contact =
      std::max(report.mover_contacts_moving.worst, report.one_sided_contacts_moving.worst);
  verdict.acceleration_violations = report.accelerations.count;
  verdict.speed_violations = report.speeds.count;
  verdict.jumps = report.jumps.count;
  verdict.changes = report.changes.count;
  verdict.least_clearance = report.least_clearance;
  verdict.least_static_clearance = report.least_static_clearance;
  verdict.interpolation_error = report.interpolation_error;
  name_first("overlapping pairs (m)", report.overlaps, verdict.violations);
  name_first("obstacle contacts in motion (m)", report.mover_contacts_moving, verdict.violations);
  name_first("one-sided contacts in motion (m)", report.one_sided_contacts_moving,
             verdict.violations);
  name_first("robots that touched a wall (m)", report.static_contacts, verdict.violations);
  name_first("steps above a_max (m/s^2)", report.accelerations, verdict.violations);
  name_first("states above v_max (m/s)", report.speeds, verdict.violations);
  name_first("jumps (m)", report.jumps, verdict.violations);
  for (const Rule& rule : kKinematics) {
    const CheckCount& count = report.*rule.count;
    verdict.kinematic_violations += count.count;
    name_first(rule.what, count, verdict.violations);
  }
  name_first("changes between decisions (m/s^2)", report.changes, verdict.violations);
  return verdict;
}

}  // namespace avo::safety
