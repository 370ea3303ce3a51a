// SPDX-License-Identifier: Apache-2.0
// The limits of robots with headings. In addition to the relative tolerance, the loss of the rows
// in double precision is granted: a few roundings of each number.
#include "check/kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "check/arc.h"
#include "check/counts.h"
#include "check/demand.h"
#include "check/towed_axle.h"
#include "core/elementary.h"

namespace avo::judge {
namespace {

constexpr double kLimitRounding = 8.0 * std::numeric_limits<double>::epsilon();

// Rows' angles are wrapped into a turn.
double angle_rounding(const RowStep& step) {
  return kLimitRounding *
         (1.0 + std::abs(step.before.heading->angle) + std::abs(step.now.heading->angle));
}

double max_acceleration(const CheckedRobot& robot) {
  return robot.parked ? 0.0 : robot.max_acceleration;
}

double max_speed(const CheckedRobot& robot) {
  return robot.parked ? 0.0 : robot.max_speed;
}

void count_step(const RowStep& step, CheckCount& rule, double amount) {
  count(rule, {step.from, step.now.robot, {}, amount});
}

// Counts a broken rule if `value` is more than the limit, and than the granted excess.
void hold(const RowStep& step, CheckCount& rule, double value, double limit, double rounding) {
  if (value > limit * (1.0 + step.tolerance) + rounding) count_step(step, rule, value - limit);
}

// Accelerations along the heading and across it, m/s^2, and the roundings of both.
struct Pull {
  double slowing = 0.0;  // < 0: it speeds up
  double along = 0.0, across = 0.0, along_rounding = 0.0, across_rounding = 0.0;
};

Pull pull_of(const RowStep& step, const Arc& arc) {
  const double late = step.time_rounding / step.duration;  // relative
  Pull pull;
  pull.along = std::abs(arc.next_speed - arc.speed) / step.duration;
  const bool slows = arc.speed != 0.0 && (arc.next_speed < arc.speed) == (arc.speed > 0.0);
  pull.slowing = slows ? pull.along : -pull.along;
  pull.across = lateral_acceleration(arc);
  const double top = top_speed(arc);
  pull.along_rounding = late * pull.along + kLimitRounding * top / step.duration;
  const double per_turn = top > 0.0 ? top * (top / path_length(arc)) : 0.0;
  pull.across_rounding = (late + kLimitRounding) * pull.across + per_turn * angle_rounding(step);
  return pull;
}

// m: granted error of the positions of this step. The tolerance is that of lengths.
double granted_length(const RowStep& step, double length, double speed) {
  const double places = norm(step.before.position) + norm(step.now.position);
  return step.tolerance * (step.robot.radius + length) + kLimitRounding * (places + length) +
         angle_rounding(step) * length + step.time_rounding * speed;
}

void judge_jump(const RowStep& step, double off, double granted, CheckReport& report) {
  if (off > granted) count_step(step, report.jumps, off - granted);
}

void judge_arc(const RowStep& step, const Arc& arc, CheckReport& report) {
  const double top = top_speed(arc);
  const double off = norm(step.now.position - knot_on(arc, 0.0, 1.0).position);
  judge_jump(step, off, granted_length(step, top * step.duration, top), report);
}

// rad: the largest turn in this step.
double most_turn(const RowStep& step, const CheckedCar& car, const Arc& arc) {
  if (std::isfinite(car.max_curvature)) return car.max_curvature * path_length(arc);
  if (top_speed(arc) > 0.0) return std::numeric_limits<double>::infinity();
  return max_speed(step.robot) / car.wheelbase * step.duration;
}

// Returns whether the part along the heading is held to a_max by itself: a square's sides.
bool is_along_alone(const RowStep& step, const CheckedCar& car, const Pull& pull) {
  return car.exact_set && !(pull.slowing > max_acceleration(step.robot) &&
                            braking_of(step.robot) > max_acceleration(step.robot));
}

// m/s^2, to be compared with max_acceleration.
double pulled_by(const RowStep& step, const CheckedCar& car, const Arc& arc, const Pull& pull) {
  const double a_max = max_acceleration(step.robot), b = braking_of(step.robot);
  const double across = is_along_alone(step, car, pull) ? 0.0 : pull.across;
  if (!(b > a_max)) return norm(Vec2{pull.along, across});
  // it comes to rest at the end of its own step at the earliest
  const double length = longest_step(step.robot, step.duration);
  const double first = std::abs(arc.speed) + (length - step.duration) * pull.slowing;
  return demand_of({pull.slowing, across}, {a_max, std::min(b, first / length)}, car.exact_set);
}

void judge(const RowStep& step, const CheckedCar& car, CheckReport& report) {
  const Arc arc = arc_of(step.before, step.now, step.duration);
  const double a_max = max_acceleration(step.robot);
  const Pull pull = pull_of(step, arc);
  const double both = norm(Vec2{pull.along, pull.across});
  const double pulled = car.exact_set ? std::max(pull.along, pull.across) : both;
  report.largest_acceleration = std::max(report.largest_acceleration, pulled);
  hold(step, report.accelerations, pulled_by(step, car, arc, pull), a_max,
       pull.along_rounding + (is_along_alone(step, car, pull) ? 0.0 : pull.across_rounding));
  hold(step, report.lateral_accelerations, pull.across, a_max, pull.across_rounding);

  const double most = most_turn(step, car, arc);
  const double late = step.time_rounding / step.duration;
  hold(step, report.turns, std::abs(arc.turn), most,
       angle_rounding(step) + step.tolerance + (std::isfinite(most) ? late * most : 0.0));

  const double at_rest = (step.tolerance + kLimitRounding) * speed_scale(step.robot);
  const double backwards = car.reverse ? 0.0 : -std::min(arc.speed, arc.next_speed);
  const double both_ways =
      changes_direction(arc) ? std::min(std::abs(arc.speed), std::abs(arc.next_speed)) : 0.0;
  const double reversal = std::max(backwards, both_ways);
  if (reversal > at_rest) count_step(step, report.reversals, reversal);
  if (!(both_ways > at_rest)) judge_arc(step, arc, report);
}

void judge(const RowStep& step, const CheckedAirplane& model, CheckReport& report) {
  const Arc arc = arc_of(step.before, step.now, step.duration);
  const Pull pull = pull_of(step, arc);
  report.largest_acceleration =
      std::max(report.largest_acceleration, norm(Vec2{pull.along, pull.across}));
  hold(step, report.accelerations, pull.along, max_acceleration(step.robot), pull.along_rounding);
  hold(step, report.lateral_accelerations, pull.across, model.lateral_acceleration,
       pull.across_rounding);
  judge_arc(step, arc, report);
}

void judge(const RowStep& step, const CheckedDrive& drive, CheckReport& report) {
  const TowedAxle axle = towed_axle(step.before, step.now, drive.offset, step.duration);
  const double speeds = norm(step.before.velocity) + norm(step.now.velocity);
  const double late = step.time_rounding / step.duration;
  const double acceleration = norm(axle.acceleration);
  report.largest_acceleration = std::max(report.largest_acceleration, acceleration);
  const double velocity_rounding = kLimitRounding * speeds / step.duration;
  const double a_max = max_acceleration(step.robot);
  const double demand =
      demand_of(step.robot, a_max, step.before.velocity, step.now.velocity, step.duration);
  hold(step, report.accelerations, demand / step.duration, a_max,
       velocity_rounding + late * acceleration);

  const WheelPeaks peaks = wheel_peaks(axle, drive.track);
  const double lever = 1.0 + 0.5 * drive.track / drive.offset;
  hold(step, report.wheel_speeds, peaks.speed, step.robot.parked ? 0.0 : drive.wheel_speed,
       kLimitRounding * lever * speeds);
  const double spin = lever * speeds / drive.offset;  // 1/s
  hold(step, report.wheel_accelerations, peaks.acceleration,
       step.robot.parked ? 0.0 : drive.wheel_acceleration,
       lever * (velocity_rounding + late * acceleration) +
           (kLimitRounding + angle_rounding(step)) * (spin * speeds + acceleration));

  // the axle and the heading are where the point tows them
  const Vec2 h = elementary::direction(step.now.heading->angle);
  const double turned_off = drive.offset * norm(h - axle.heading.back());
  const double off = norm(step.now.position - knot_on(axle, 0.0, TowedAxle::kParts).position);
  const double length = 0.5 * speeds * step.duration + drive.offset;
  judge_jump(step, std::max(off, turned_off), granted_length(step, length, speeds), report);
}

void judge(const RowStep& /*step*/, const CheckedHolonomic& /*any*/, CheckReport& /*report*/) {}

// m/s, of a robot that cannot rest.
template <typename Kinematics>
double least_speed(const Kinematics& own) {
  if constexpr (requires { own.min_speed; }) return own.min_speed;
  return 0.0;
}

}  // namespace

double speed_scale(const CheckedRobot& robot) {
  return std::isinf(robot.max_speed) ? 1.0 : robot.max_speed;
}

bool can_rest(const CheckedRobot& robot) {
  return !std::holds_alternative<CheckedAirplane>(robot.kinematics);
}

double reach_of(const CheckedRobot& robot) {
  const auto* car = std::get_if<CheckedCar>(&robot.kinematics);
  const bool exact = car != nullptr && car->exact_set;
  return exact ? std::numbers::sqrt2 * robot.max_acceleration : robot.max_acceleration;
}

void judge_heading(const CheckedRobot& robot, const CheckedState& row, double time,
                   double tolerance, CheckReport& report) {
  const Vec2 h = elementary::direction(row.heading->angle);
  const double speed = row.heading->speed, granted = tolerance * speed_scale(robot);
  const double rounding =
      kLimitRounding * (1.0 + std::abs(row.heading->angle)) * norm(row.velocity);
  // a drive's point also swings out
  const bool swings = std::holds_alternative<CheckedDrive>(robot.kinematics);
  const double off =
      swings ? std::abs(dot(h, row.velocity) - speed) : norm(row.velocity - speed * h);
  if (off > granted + rounding) count(report.headings, {time, row.robot, {}, off});
  const double least =
      std::visit([](const auto& own) { return least_speed(own); }, robot.kinematics);
  if (!can_rest(robot) && least - speed > granted + rounding)
    count(report.slow_flights, {time, row.robot, {}, least - speed});
}

void judge_kinematics(const RowStep& step, CheckReport& report) {
  std::visit([&](const auto& kinematics) { judge(step, kinematics, report); },
             step.robot.kinematics);
}

}  // namespace avo::judge
