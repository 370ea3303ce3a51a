// SPDX-License-Identifier: Apache-2.0
// Three rows show a change: the velocity of the middle one is off the line between the other two.
#include "check/own_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/demand.h"
#include "core/elementary.h"

namespace avo::judge {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// For a row: each of its numbers is computed in a few operations.
constexpr double kRoundings = 8.0 * kEpsilon;

// A value that changes at a constant rate as long as nothing is decided, and its possible rounding.
struct Held {
  double off = 0.0, rounding = 0.0;  // both m/s, or both rad m
};

struct Rows {
  const TimedState &a, &b, &c;
  double first() const { return b.time - a.time; }
  double second() const { return c.time - b.time; }
  double speeds() const {
    return norm(a.row.velocity) + norm(b.row.velocity) + norm(c.row.velocity);
  }
};

Held velocity_of(const Rows& rows) {
  const double part = rows.first() / (rows.first() + rows.second());
  const Vec2 expected = (1.0 - part) * rows.a.row.velocity + part * rows.c.row.velocity;
  return {norm(rows.b.row.velocity - expected), kRoundings * rows.speeds()};
}

Held speed_of(const Rows& rows) {
  const double part = rows.first() / (rows.first() + rows.second());
  const double expected =
      (1.0 - part) * norm(rows.a.row.velocity) + part * norm(rows.c.row.velocity);
  return {std::abs(norm(rows.b.row.velocity) - expected), kRoundings * rows.speeds()};
}

double turn(const TimedState& from, const TimedState& to) {
  const Vec2 v = from.row.velocity, w = to.row.velocity;
  return elementary::atan2(cross(v, w), dot(v, w));
}

// Constant curvature: the turns are proportional to the lengths. At rest there is no heading to
// determine them.
Held turn_of(const Rows& rows) {
  const auto length_between = [](const TimedState& from, const TimedState& to) {
    return 0.5 * (to.time - from.time) * (norm(from.row.velocity) + norm(to.row.velocity));
  };
  const double first = length_between(rows.a, rows.b), second = length_between(rows.b, rows.c);
  const double whole = first + second;
  const auto rests = [](const TimedState& state) { return state.row.velocity == Vec2{}; };
  if (rests(rows.a) || rests(rows.b) || rests(rows.c)) return {};
  const double times = kEpsilon * (std::abs(rows.a.time) + std::abs(rows.c.time));
  // as a velocity across: the missing turn at the middle row, times the speed there
  const double off = std::abs(turn(rows.a, rows.b) * second - turn(rows.b, rows.c) * first) / whole;
  const double speed = norm(rows.b.row.velocity);
  return {off * speed, kRoundings * (rows.speeds() + speed) + times * speed * speed / whole};
}

// s, from the nearest of its times.
double off_time(double time, double phase, double time_step) {
  return std::abs(std::remainder(time - phase, time_step));
}

}  // namespace

std::optional<double> early_change(const CheckedRobot& robot, const RowPair& passage,
                                   JudgedClock& clock) {
  const std::optional<TimedState> before = clock.before;
  clock.before = passage.from;
  if (!before) return {};
  const Rows rows{*before, passage.from, passage.to};
  // a change of the acceleration times this is a change of the velocity
  const double lever = rows.first() * rows.second() / (rows.first() + rows.second());
  const double times = kRoundings * (std::abs(rows.a.time) + std::abs(rows.c.time));
  const double limit = braking_of(robot), a_max = std::isinf(limit) ? 0.0 : limit;
  double most = 0.0;  // m/s²
  const auto look = [&](const Held& held) {
    const double allowed = a_max * (passage.tolerance * lever + times) + held.rounding;
    if (held.off > allowed) most = std::max(most, held.off / lever);
  };
  if (is_holonomic(robot.kinematics) || std::holds_alternative<CheckedDrive>(robot.kinematics)) {
    look(velocity_of(rows));
  } else {
    look(speed_of(rows));
    look(turn_of(rows));
  }
  if (most == 0.0) return {};
  const double time = passage.from.time;
  if (!clock.phase) clock.phase = time;
  const double granted = passage.tolerance * *robot.time_step + kRoundings * std::abs(time);
  if (off_time(time, *clock.phase, *robot.time_step) <= granted) return {};
  return most;
}

}  // namespace avo::judge
