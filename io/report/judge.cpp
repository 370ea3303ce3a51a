// SPDX-License-Identifier: Apache-2.0
// Feeds a recording to the judge, with the facts that its scene gives.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "avo/checked.h"
#include "avo_io/errors.h"
#include "avo_io/judgement.h"
#include "avo_io/recording.h"
#include "io/recording/mover_walk.h"

namespace avo_io {
namespace {

/// Feeds the judge; robots of a recording without a scene are known from their first row on.
struct Judge {
  std::optional<avo::Scenario> scenario;
  bool has_robots;         // the scene
  avo::CheckedRobot like;  // all robots, if there is no scene
  std::unordered_map<std::int64_t, std::int64_t> index_of;
  avo::Check check;
  Judgement judgement;
  std::optional<double> last_time;
  // of the scene's robots: whether they have a row at the first time, and at the last
  std::vector<char> there_first, there_last;
  std::optional<MoverWalk> movers;  // of the scene

  Judge(const std::string& recording, const JudgeOptions& options);
  void number_densely(RecordedTime& moment);
  void add(RecordedTime& moment);
  void place_movers(double time);
  void compare_with_scene();
};

/// Takes the walls of all obstacles, and for each wall the number of its obstacle.
void take_walls(const avo::Scenario& scenario, avo::Check& check,
                std::vector<std::int64_t>& obstacle_of_wall) {
  std::vector<avo::CheckedWall> walls;
  for (const avo::StaticObstacle& obstacle : scenario.obstacles) {
    const avo::StaticObstacle both[] = {obstacle, {obstacle.measured, obstacle.radius}};
    for (const avo::Wall& wall : avo::walls_of(both)) {
      walls.push_back({wall.a, wall.b, wall.radius, obstacle.layers.bits});
      obstacle_of_wall.push_back(&obstacle - scenario.obstacles.data());
    }
  }
  check.set_walls(std::move(walls));
}

avo::Check check_of(const JudgeOptions& options_of_judge) {
  const std::optional<avo::Scenario>& scenario = options_of_judge.scenario;
  avo::CheckOptions rules{.relative_tolerance = options_of_judge.tolerance,
                          .movers_at_rest = options_of_judge.movers_at_rest};
  if (!scenario) return avo::Check({}, {}, rules);
  rules.arrival_distance = scenario->arrival_distance;
  std::vector<avo::CheckedRobot> robots;
  for (const avo::RobotSetup& setup : scenario->robots)
    robots.push_back(checked_robot(*scenario, setup));
  std::vector<avo::CheckedMover> obstacles;
  for (const avo::MovingObstacle& obstacle : scenario->moving_obstacles)
    obstacles.push_back({obstacle.position, obstacle.velocity, obstacle.acceleration,
                         obstacle.radius, !obstacle.trajectory.empty()});
  return avo::Check(robots, std::move(obstacles), rules);
}

Judge::Judge(const std::string& recording, const JudgeOptions& options)
    : scenario(options.scenario),
      has_robots(scenario && !scenario->robots.empty()),
      check(check_of(options)) {
  judgement.recording = recording;
  judgement.tolerance = options.tolerance;
  judgement.require_arrival = options.require_arrival;
  if (scenario) {
    judgement.scene = scenario->name;
    take_walls(*scenario, check, judgement.obstacle_of_wall);
    movers.emplace(*scenario);
  }
  if (has_robots) {
    judgement.time_step = scenario->time_step;
    judgement.scene_end = scenario->duration;
    judgement.free_clocks = scenario->clock == avo::Clock::free;
  } else {
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    judgement.knows_accelerations = options.max_acceleration.has_value();
    judgement.knows_speeds = options.max_speed.has_value();
    like = {options.radius, options.max_acceleration.value_or(kUnknown),
            options.max_speed.value_or(kUnknown)};
    like.max_braking = options.max_braking;
  }
}

constexpr double kJumpOfRadius = 0.1;  // the few digits of velocities explain no larger jump
constexpr double kJumpOfEstimates = 1.0;

void Judge::number_densely(RecordedTime& moment) {
  std::vector<avo::CheckedState>& rows = moment.rows;
  if (!judgement.knows_accelerations)
    like.largest_jump = like.radius * (moment.estimated ? kJumpOfEstimates : kJumpOfRadius);
  for (avo::CheckedState& row : rows) {
    const auto [place, is_new] = index_of.try_emplace(row.robot, 0);
    if (is_new) {
      place->second = check.add_robot(like);
      judgement.numbers.push_back(row.robot);
    }
    row.robot = place->second;
  }
  std::sort(rows.begin(), rows.end(),
            [](const auto& a, const auto& b) { return a.robot < b.robot; });
}

constexpr double kEven = 1e-6;  // of the step, because its digits may be rounded

// Returns the longest time between two rows of a recording, s. With free clocks there are rows at
// all decisions, so also at those of each robot.
double longest_step(const avo::Scenario& scenario) {
  if (scenario.clock == avo::Clock::common) return scenario.time_step;
  double step = std::numeric_limits<double>::infinity();
  for (const avo::RobotSetup& robot : scenario.robots)
    if (!is_parked(robot)) step = std::min(step, time_step_of(scenario, robot));
  return step;
}

bool is_uneven(const avo::Scenario& scenario, double duration) {
  const double step = longest_step(scenario);
  if (scenario.clock == avo::Clock::common) return std::abs(duration - step) > kEven * step;
  return duration > (1.0 + kEven) * step;
}

// Returns whether a time in between has no rows. With a common clock this takes one and a half
// steps: a shorter gap means a recording of other steps.
bool lacks_rows(const avo::Scenario& scenario, double duration) {
  const double most = scenario.clock == avo::Clock::common ? 1.5 : 1.0 + kEven;
  return duration > most * longest_step(scenario);
}

// Places the obstacles with a path or a trajectory. Robots affect only the times at which such
// obstacles decide.
void Judge::place_movers(double time) {
  movers->go_to(time);
  for (std::size_t k = 0; k < scenario->moving_obstacles.size(); ++k)
    if (!scenario->moving_obstacles[k].path.empty() ||
        !scenario->moving_obstacles[k].trajectory.empty())
      check.place_mover(static_cast<std::int64_t>(k), movers->position(k), movers->velocity(k));
}

void Judge::add(RecordedTime& moment) {
  const std::optional<double> before = std::exchange(last_time, moment.time);
  judgement.every = std::max(judgement.every, moment.every);
  judgement.estimated = judgement.estimated || moment.estimated;
  const bool thinned =
      before && (moment.every > 1 || (has_robots && lacks_rows(*scenario, moment.time - *before)));
  if (thinned) check.skip();
  if (scenario && thinned) movers->require_known(moment.time);
  if (scenario) place_movers(moment.time);
  if (!has_robots) {
    number_densely(moment);
  } else {
    if (before && is_uneven(*scenario, moment.time - *before)) {
      ++judgement.uneven_steps;
      if (!thinned) ++judgement.uneven_judged;
    }
    there_last.assign(scenario->robots.size(), 0);
    for (const avo::CheckedState& row : moment.rows)
      there_last[static_cast<std::size_t>(row.robot)] = 1;
    if (!before) there_first = there_last;
  }
  check.add(moment.time, moment.rows);
}

// Returns whether no step of the scene is left after that time. With free clocks, some robot
// decides at least once in the shortest time step.
bool is_end(const avo::Scenario& scenario, double time) {
  if (scenario.clock == avo::Clock::free)
    return time + (1.0 + kEven) * longest_step(scenario) >= scenario.duration;
  const auto steps = static_cast<double>(last_step(scenario, scenario.duration));
  return time >= (steps - 0.5) * scenario.time_step;
}

// Notes the robots and times of the scene that the recording lacks.
void Judge::compare_with_scene() {
  if (!has_robots) return;
  const avo::CheckReport& report = judgement.report;
  const auto has_left = [&](std::size_t k) {
    const auto* airplane = std::get_if<avo::Airplane>(&scenario->robots[k].model);
    return airplane != nullptr && airplane->after_goal == avo::AfterGoal::leave &&
           !std::binary_search(report.not_arrived.begin(), report.not_arrived.end(),
                               static_cast<std::int64_t>(k));
  };
  std::vector<bool> leaves_by_exit(there_last.size());
  for (const avo::Team& team : scenario->teams)
    for (const avo::TeamMember& member : team.members)
      leaves_by_exit[static_cast<std::size_t>(member.robot.value)] =
          std::holds_alternative<avo::Flow>(team.task);
  for (std::size_t k = 0; k < there_last.size(); ++k)
    if (there_first[k] == 0 || (there_last[k] == 0 && !has_left(k) && !leaves_by_exit[k]))
      judgement.lacking.push_back(static_cast<std::int64_t>(k));
  judgement.whole = report.from <= 0.5 * scenario->time_step &&
                    (is_end(*scenario, report.to) || report.arrived == report.with_goal);
}

}  // namespace

Judgement judge(const std::string& recording, const JudgeOptions& options) {
  Judge judge(recording, options);
  std::optional<std::int64_t> robots;
  if (judge.has_robots) robots = static_cast<std::int64_t>(judge.scenario->robots.size());
  RecordingReader reader(recording, robots);
  RecordedTime moment;
  while (reader.next(moment)) {
    try {
      judge.add(moment);
      if (options.judged) options.judged(moment.time);
    } catch (const avo::RowError& error) {  // of a scene's robot: without a scene, rows suffice
      throw RecordingError(reader.place(error.robot) + ": " + error.what());
    } catch (const avo::Error& error) {
      throw RecordingError(reader.place() + ": " + error.what());
    }
  }
  Judgement& judgement = judge.judgement;
  judgement.report = judge.check.report();
  judge.compare_with_scene();
  if (judgement.report.robot_steps == 0 && judgement.report.unjudged_steps == 0)
    throw RecordingError(reader.place() +
                         ": found no robot at two successive times, must be one or more");
  return std::move(judgement);
}

}  // namespace avo_io
