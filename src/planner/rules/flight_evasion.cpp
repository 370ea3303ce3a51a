// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/flight_evasion.h"

#include <algorithm>
#include <array>
#include <optional>
#include <variant>

#include "certificate/flight_ways.h"
#include "core/plane.h"
#include "planner/methods/flight.h"
#include "robots/ahead.h"

namespace avo::inline planner {
namespace {

constexpr std::array<double, 3> kTurnsOfWays{0.0, 1.0, -1.0};  // straight, left, right

// From p_A, as ways out are.
MotionState state_now(const Robot& robot) {
  const LoiterCircle circle = *with_circle(robot).loiter;
  return {
      {}, robot.velocity, robot.heading, {circle.center - robot.position, circle.radius}};
}

FlightStep step_by(const Evading& evading, const MotionState& now, Vec2 acceleration) {
  const Robot& robot = evading.robot;
  return fly_along(std::get<Airplane>(robot.model), {robot.max_acceleration, robot.max_speed}, now,
                   ahead_of(robot.heading), acceleration, evading.law.step.time_step);
}

bool take_step(Evading& evading, Vec2 acceleration) {
  const MotionState now = state_now(evading.robot);
  return take_first_flight(evading.options, evading.workspace.around, now,
                           step_by(evading, now, acceleration));
}

// The control changes the speed by as much as it can, or it holds the speed. Controls are fixed, or
// hold what the step before has led to, so that after a step the rest of a way out is a way out.
bool may_circle_later(Evading& evading) {
  Surroundings& around = evading.workspace.around;
  if (may_circle(evading.options, around)) return true;
  const Robot& robot = evading.robot;
  const double held = norm(around.after.velocity);
  for (const double speed : {held, robot.max_speed, least_speed(robot.model)}) {
    for (const double turn : kTurnsOfWays)
      if (may_circle_after(evading.options, around, {speed, turn})) return true;
  }
  return false;
}

// The circle that the airplane is on is always admitted.
bool is_admitted(const Evading& evading, Vec2 acceleration) {
  const Robot robot = with_circle(evading.robot);
  const MotionState now{robot.position, robot.velocity, robot.heading, *robot.loiter};
  if (acceleration == loitering(std::get<Airplane>(robot.model), now)) return true;
  return keeps_flight(*evading.sight.flight, robot, step_by(evading, now, acceleration));
}

// Finds a way out that is clear after that step.
std::optional<Evasion> find_flight_after(Evading& evading, Vec2 acceleration) {
  if (!take_step(evading, acceleration) || !may_circle_later(evading)) return std::nullopt;
  const WayState& last = evading.workspace.around.last;
  return Evasion{-1, last.velocity, last.time};
}

}  // namespace

bool may_circle_after_choice(Evading& evading, Vec2 acceleration) {
  return take_step(evading, acceleration) &&
         may_circle(evading.options, evading.workspace.around);
}

bool has_clear_flight(Evading& evading) {
  take_no_flight(evading.workspace.around, evading.robot.velocity);
  return may_circle_later(evading);
}

Way find_flight(Evading& evading, Vec2 wanted, Taken& found) {
  if (find_flight_after(evading, wanted)) return Way::as_wanted;
  const Robot& robot = evading.robot;
  const Vec2 h = ahead_of(robot.heading), n = perpendicular(h);
  const TriedControls tried = controls_near(robot, {dot(h, wanted), cross(h, wanted)});
  for (std::size_t k = 0; k < tried.count; ++k) {
    const Vec2 acceleration = tried.controls[k].ahead * h + tried.controls[k].left * n;
    if (!is_admitted(evading, acceleration)) continue;
    const auto way = find_flight_after(evading, acceleration);
    if (!way) continue;
    found = {acceleration, *way};
    return Way::another;
  }
  return Way::none;
}

}  // namespace avo::inline planner
