// SPDX-License-Identifier: Apache-2.0
// Judges the rows of one time: each robot by itself.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "avo/error.h"
#include "check/check_state.h"
#include "check/counts.h"
#include "check/course.h"
#include "check/demand.h"
#include "check/kinematics.h"
#include "check/refuse.h"
#include "core/ranges.h"

namespace avo {
namespace {

using judge::MovingDisc;
using judge::note;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace

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
  const Vec2 shift = judge::center_of(robot, now) - judge::center_of(robot, before);
  const double jump = norm(shift - (0.5 * duration) * sum);
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
  judge::SeenRobot& mine = seen[static_cast<std::size_t>(now.robot)];
  const auto amount = judge::early_change(
      robot, {{mine.row, last_time}, {now, time}, options.relative_tolerance}, mine.clock);
  if (!amount) return;
  ++report.changes.count;
  note(report.changes, {last_time, now.robot, {}, *amount});
}

// Returns whether it passes the goal within the step; it may begin and end elsewhere.
bool Check::State::passes(const MovingDisc& disc, Vec2 goal, double within) const {
  if (disc.newcomer) return false;
  const double limit = within * (1.0 + options.relative_tolerance) + disc.error;
  const auto path = judge::pieces_of(disc, duration, goal);
  return lower_bound(path) <= limit && nearest_instant(path).distance <= limit;
}

void Check::State::judge_arrival(double time, const CheckedState& row, const MovingDisc& disc) {
  const auto index = static_cast<std::size_t>(row.robot);
  const std::optional<Vec2>& goal = robots[index].goal;
  if (!goal) return;
  const double within = robots[index].arrival_distance.value_or(options.arrival_distance);
  judge::SeenRobot& mine = seen[index];
  mine.at_goal = norm(*goal - row.position) <= within &&
                 !walls.hides(row.position, *goal, robots[index].layers);
  const bool arrives = judge::can_rest(robots[index])
                           ? mine.at_goal
                           : passes(disc, *goal, within) || (skipped && mine.at_goal);
  if (mine.arrived || !arrives) return;
  mine.arrived = true;
  last_arrival = time;
}

void Check::State::add_newcomer(const CheckedRobot& robot, const CheckedState& row) {
  for (std::size_t disc = 0; disc < judge::disc_count(robot); ++disc)
    discs.push_back(judge::newcomer(robot, disc, row));
}

void Check::State::judge_row(double time, const CheckedState& row) {
  const auto index = static_cast<std::size_t>(row.robot);
  const CheckedRobot& robot = robots[index];
  judge::SeenRobot& mine = seen[index];
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
      discs.push_back(judge::robot_disc(robot, disc, mine.row, row, duration));
      report.interpolation_error = std::max(report.interpolation_error, discs.back().error);
    }
  } else {
    if (mine.at >= 0) ++report.gaps;
    mine.clock.before.reset();
    add_newcomer(robot, row);
  }
  judge_arrival(time, row, discs.back());
  mine.row = row;
  mine.at = times;
}

}  // namespace avo
