// SPDX-License-Identifier: Apache-2.0
// A judge of recorded motion: takes one time after the other and counts broken rules.
#include "avo/check.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "check/counts.h"
#include "check/course.h"
#include "check/crowd.h"
#include "check/demand.h"
#include "check/kinematics.h"
#include "check/own_clock.h"
#include "check/pair_judge.h"
#include "check/refuse.h"
#include "check/step.h"
#include "check/sweep.h"
#include "check/wall_judge.h"
#include "core/ranges.h"

namespace avo {
namespace {

using judge::MovingDisc;
using judge::note;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// The last observation of a robot.
struct Seen {
  CheckedState row;
  std::int64_t at = -1;  // number of the time, -1: never
  bool arrived = false, at_goal = false;
  judge::JudgedClock clock;
};

}  // namespace

struct Check::State {
  std::vector<CheckedRobot> robots;
  std::vector<CheckedMover> obstacles;
  // of each obstacle: its place at the last time, and at the next one, if it is placed there
  std::vector<std::optional<judge::PlacedObstacle>> placed_before, placed;
  CheckOptions options;
  CheckReport report;  // the part that is not derived from other data
  std::vector<Seen> seen;
  std::int64_t times = 0;
  double last_time = 0.0, last_arrival = 0.0;
  judge::PairJudge pairs;
  judge::WallJudge walls;

  // of the present step
  bool skipped = false;  // its rows in between are missing
  double duration = 0.0;
  std::vector<MovingDisc> movers;
  std::vector<judge::BoundingBox> boxes;

  void require_sound(double time, std::span<const CheckedState> rows) const;
  void add_newcomer(const CheckedRobot& robot, const CheckedState& row);
  void judge_row(double time, const CheckedState& row);
  void judge_step(const CheckedRobot& robot, const CheckedState& before, const CheckedState& now,
                  double time);
  void judge_limits(const CheckedRobot& robot, const CheckedState& before, const CheckedState& now,
                    double time);
  void judge_changes(const CheckedRobot& robot, const CheckedState& now, double time);
  [[nodiscard]] bool passes(const MovingDisc& mover, Vec2 goal, double within) const;
  void judge_arrival(double time, const CheckedState& row, const MovingDisc& mover);
  [[nodiscard]] std::vector<std::optional<Vec2>> places_at_rest() const;
};

void Check::State::require_sound(double time, std::span<const CheckedState> rows) const {
  judge::require_time(time, times > 0 ? std::optional(last_time) : std::nullopt);
  std::int64_t lowest = 0;
  for (const CheckedState& row : rows) {
    const auto count = static_cast<std::int64_t>(robots.size());
    if (row.robot < lowest || row.robot >= count)
      refuse("robot", std::to_string(row.robot),
             std::to_string(lowest) + " to " + std::to_string(count - 1) +
                 ", each once and ascending");
    lowest = row.robot + 1;
    try {
      judge::require_sound(robots[static_cast<std::size_t>(row.robot)], row);
    } catch (const Error& error) {
      throw RowError(row.robot, error.what());
    }
  }
}

// |Δv| and |Δp - Δt (v_0 + v_1)/2| against what a_max and braking allow in this step. The numbers
// of a row are rounded: their rounding is granted in addition to the tolerance. Over skipped rows
// the velocity may have turned: any change may have been braking.
void Check::State::judge_limits(const CheckedRobot& robot, const CheckedState& before,
                                const CheckedState& now, double time) {
  const Vec2 change = now.velocity - before.velocity, sum = before.velocity + now.velocity;
  const double step_rounding = kEpsilon * (std::abs(time) + std::abs(last_time));
  const double speeds = norm(before.velocity) + norm(now.velocity);
  const double acceleration = norm(change) / duration;
  report.largest_acceleration = std::max(report.largest_acceleration, acceleration);
  const double reach = robot.parked ? 0.0 : judge::reach_of(robot);
  const double any = std::max(reach, judge::braking_of(robot)), a_max = skipped ? any : reach;
  const double demand =
      skipped ? norm(change)
              : judge::demand_of(robot, a_max, before.velocity, now.velocity, duration);
  const double grant = 1.0 + options.relative_tolerance;
  if (demand > grant * a_max * (duration + step_rounding) + kEpsilon * speeds) {
    judge::count(report.accelerations, {last_time, now.robot, {}, demand / duration - a_max});
  }
  const Vec2 way = judge::center_of(robot, now) - judge::center_of(robot, before);
  const double jump = norm(way - (0.5 * duration) * sum);
  double within = 0.5 * (grant * any) * duration * (duration + 2.0 * step_rounding);
  if (robot.largest_jump && !skipped && std::isinf(any))
    within = 0.5 * norm(change) * (duration + 2.0 * step_rounding) + *robot.largest_jump;
  const double rounding = kEpsilon * (norm(before.position) + norm(now.position)) +
                          (step_rounding + 2.0 * kEpsilon * duration) * speeds;
  if (jump > within + rounding) {
    judge::count(report.jumps, {last_time, now.robot, {}, jump - within});
  }
}

void Check::State::judge_step(const CheckedRobot& robot, const CheckedState& before,
                              const CheckedState& now, double time) {
  if (judge::has_heading(robot, before, now)) {
    ++report.with_heading;
    const double time_rounding = kEpsilon * (std::abs(time) + std::abs(last_time));
    return judge::judge_kinematics(
        {robot, before, now, last_time, duration, time_rounding, options.relative_tolerance},
        report);
  }
  if (!is_holonomic(robot.kinematics)) ++report.without_heading;
  judge_limits(robot, before, now, time);
}

void Check::State::judge_changes(const CheckedRobot& robot, const CheckedState& now, double time) {
  if (!robot.time_step) return;
  Seen& mine = seen[static_cast<std::size_t>(now.robot)];
  const auto amount = judge::early_change(
      robot, {{mine.row, last_time}, {now, time}, options.relative_tolerance}, mine.clock);
  if (!amount) return;
  ++report.changes.count;
  note(report.changes, {last_time, now.robot, {}, *amount});
}

// Returns whether it passes the goal within the step; it may begin and end elsewhere.
bool Check::State::passes(const MovingDisc& mover, Vec2 goal, double within) const {
  if (mover.newcomer) return false;
  const double limit = within * (1.0 + options.relative_tolerance) + mover.error;
  const auto path = judge::pieces_of(mover, duration, goal);
  return lower_bound(path) <= limit && nearest_instant(path).distance <= limit;
}

void Check::State::judge_arrival(double time, const CheckedState& row, const MovingDisc& mover) {
  const auto index = static_cast<std::size_t>(row.robot);
  const std::optional<Vec2>& goal = robots[index].goal;
  if (!goal) return;
  const double within = robots[index].arrival_distance.value_or(options.arrival_distance);
  Seen& mine = seen[index];
  mine.at_goal = norm(*goal - row.position) <= within &&
                 !walls.hides(row.position, *goal, robots[index].layers);
  const bool arrives = judge::can_rest(robots[index])
                           ? mine.at_goal
                           : passes(mover, *goal, within) || (skipped && mine.at_goal);
  if (mine.arrived || !arrives) return;
  mine.arrived = true;
  last_arrival = time;
}

void Check::State::add_newcomer(const CheckedRobot& robot, const CheckedState& row) {
  for (std::size_t disc = 0; disc < judge::disc_count(robot); ++disc)
    movers.push_back(judge::newcomer(robot, disc, row));
}

void Check::State::judge_row(double time, const CheckedState& row) {
  const auto index = static_cast<std::size_t>(row.robot);
  const CheckedRobot& robot = robots[index];
  Seen& mine = seen[index];
  const double speed = norm(row.velocity);
  report.largest_speed = std::max(report.largest_speed, speed);
  const double v_max = robot.parked ? 0.0 : robot.max_speed;
  if (speed > v_max * (1.0 + options.relative_tolerance)) {
    judge::count(report.speeds, {time, row.robot, {}, speed - v_max});
  }
  if (row.heading && !is_holonomic(robot.kinematics))
    judge::judge_heading(robot, row, time, options.relative_tolerance, report);
  const bool was_there = mine.at >= 0 && mine.at == times - 1;
  if (was_there && skipped) {
    if (is_holonomic(robot.kinematics)) judge_limits(robot, mine.row, row, time);
    mine.clock.before.reset();
    add_newcomer(robot, row);
  } else if (was_there) {
    ++report.robot_steps;
    judge_step(robot, mine.row, row, time);
    judge_changes(robot, row, time);
    for (std::size_t disc = 0; disc < judge::disc_count(robot); ++disc) {
      movers.push_back(judge::robot_mover(robot, disc, mine.row, row, duration));
      report.interpolation_error = std::max(report.interpolation_error, movers.back().error);
    }
  } else {
    if (mine.at >= 0) ++report.gaps;
    mine.clock.before.reset();
    add_newcomer(robot, row);
  }
  judge_arrival(time, row, movers.back());
  mine.row = row;
  mine.at = times;
}

Check::Check(const std::vector<CheckedRobot>& robots, std::vector<CheckedMover> movers,
             const CheckOptions& options)
    : state_(std::make_unique<State>()) {
  judge::require_sound(options);
  for (std::size_t k = 0; k < movers.size(); ++k)
    judge::require_sound("movers." + std::to_string(k), movers[k]);
  state_->options = options;
  state_->obstacles = std::move(movers);
  state_->placed_before.resize(state_->obstacles.size());
  state_->placed.resize(state_->obstacles.size());
  for (const CheckedRobot& robot : robots) add_robot(robot);
}
Check::~Check() = default;
Check::Check(Check&&) noexcept = default;
Check& Check::operator=(Check&&) noexcept = default;

std::int64_t Check::add_robot(const CheckedRobot& robot) {
  const auto index = static_cast<std::int64_t>(state_->robots.size());
  if (index >= kMostRobots)
    throw Error("robots: found more than " + std::to_string(kMostRobots) +
                ", the most there can be");
  judge::require_sound("robots." + std::to_string(index), robot);
  state_->seen.emplace_back();
  state_->robots.push_back(robot);
  state_->pairs.add_robot(robot);
  return index;
}

void Check::set_walls(std::vector<CheckedWall> walls) {
  for (std::size_t k = 0; k < walls.size(); ++k)
    judge::require_sound("walls." + std::to_string(k), walls[k]);
  state_->walls.set_walls(std::move(walls));
}

void Check::place_mover(std::int64_t mover, Vec2 position, Vec2 velocity) {
  const auto count = static_cast<std::int64_t>(state_->obstacles.size());
  if (mover < 0 || mover >= count)
    refuse("mover", std::to_string(mover), "0 to " + std::to_string(count - 1));
  const std::string place = "movers." + std::to_string(mover);
  require(place + ".position", position, "m");
  require(place + ".velocity", velocity, "m/s");
  state_->placed[static_cast<std::size_t>(mover)] = judge::PlacedObstacle{position, velocity};
}

void Check::skip() {
  state_->skipped = state_->times > 0;
}

void Check::add(double time, std::span<const CheckedState> rows) {
  State& state = *state_;
  state.require_sound(time, rows);
  const bool begins = state.times == 0;
  state.duration = begins ? 0.0 : time - state.last_time;
  if (begins) state.last_time = state.report.from = time;
  state.movers.clear();
  for (const CheckedState& row : rows) state.judge_row(time, row);
  const judge::JudgedStep step{state.last_time, state.duration, state.options.relative_tolerance,
                               state.robots};
  for (const MovingDisc& robot : state.movers) state.walls.judge(robot, step);
  for (std::size_t k = 0; k < state.obstacles.size(); ++k) {
    const CheckedMover& obstacle = state.obstacles[k];
    const auto told = [&](double t) { return judge::place_of(obstacle, t); };
    const judge::PlacedObstacle to = state.placed[k].value_or(told(time));
    const judge::PlacedObstacle from =
        begins && state.placed[k] ? to : state.placed_before[k].value_or(told(state.last_time));
    state.movers.push_back(
        judge::obstacle_mover(from, to, obstacle.radius, static_cast<std::int64_t>(k)));
    if (obstacle.straight && state.placed[k] && !begins)
      state.movers.back().from_velocity = state.movers.back().to_velocity =
          (to.position - from.position) / state.duration;
  }
  state.boxes.clear();
  for (std::size_t i = 0; i < state.movers.size(); ++i)
    state.boxes.push_back(judge::box_of(state.movers[i], i, state.duration));
  judge::sweep(
      state.boxes, [&state] { return state.pairs.reach(); },
      [&](std::size_t a, std::size_t b) {
        state.pairs.meet(state.movers[std::min(a, b)], state.movers[std::max(a, b)], step);
      });
  state.last_time = state.report.to = time;
  state.report.rows += static_cast<std::int64_t>(rows.size());
  state.report.steps = state.times++;
  if (std::exchange(state.skipped, false)) ++state.report.unjudged_steps;
  state.placed_before = state.placed;
}

// By robot, of the discs of robots at rest at the last time.
std::vector<std::optional<Vec2>> Check::State::places_at_rest() const {
  std::vector<std::optional<Vec2>> places(robots.size());
  for (std::size_t k = 0; k < robots.size(); ++k) {
    const bool rests = seen[k].at == times - 1 && seen[k].row.velocity == Vec2{};
    if (rests) places[k] = judge::center_of(robots[k], seen[k].row);
  }
  return places;
}

CheckReport Check::report() const {
  const State& state = *state_;
  CheckReport report = state.report;
  double last_arrival = state.last_arrival;
  const std::vector<std::optional<Vec2>> at_rest = state.places_at_rest();
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const Seen& other = state.seen[i];
    if (other.at >= 0) ++report.robots;
    if (!state.robots[i].goal) continue;
    ++report.with_goal;
    // of its disc, with its present heading
    const Vec2 goal =
        *state.robots[i].goal + (at_rest[i].value_or(other.row.position) - other.row.position);
    const bool rests = !other.at_goal && judge::rests_at_crowd(i, goal, state.robots, at_rest);
    if (other.arrived || rests) ++report.arrived;
    if (other.at_goal || rests) ++report.at_goal_at_end;
    if (!other.arrived && !rests) report.not_arrived.push_back(static_cast<std::int64_t>(i));
    if (!other.arrived && rests) last_arrival = state.last_time;
  }
  if (report.with_goal > 0 && report.arrived == report.with_goal)
    report.last_arrival = last_arrival;
  state.pairs.write(report);
  state.walls.write(report);
  report.movers_at_rest = state.options.movers_at_rest;
  return report;
}

bool CheckReport::broken() const {
  const CheckCount* rules[] = {&overlaps,
                               &mover_contacts_moving,
                               &one_sided_contacts_moving,
                               &static_contacts,
                               &accelerations,
                               &speeds,
                               &jumps,
                               &headings,
                               &turns,
                               &lateral_accelerations,
                               &reversals,
                               &slow_flights,
                               &wheel_speeds,
                               &wheel_accelerations,
                               &changes};
  const bool is_run_over = mover_contacts_at_rest + one_sided_contacts_at_rest > 0;
  if (is_run_over && !movers_at_rest) return true;
  return std::any_of(std::begin(rules), std::end(rules),
                     [](const CheckCount* rule) { return rule->count > 0; });
}

}  // namespace avo
