// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/flight_evasion.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "certificate/flight_evasions.h"
#include "core/plane.h"
#include "planner/methods/flight.h"
#include "robots/ahead.h"

namespace avo::inline planner {
namespace {

// From p_A, as evasive maneuvers are.
MotionState state_now(const Robot& robot) {
  const LoiterCircle circle = *with_circle(robot).loiter;
  return {{}, robot.velocity, robot.heading, {circle.center - robot.position, circle.radius}};
}

FlightStep step_by(const Evading& evading, const MotionState& now, Vec2 acceleration) {
  const Robot& robot = evading.robot;
  return fly_along(robot.model, {robot.max_acceleration, robot.max_speed}, now,
                   ahead_of(robot.heading), acceleration, evading.law.step.time_step);
}

bool take_step(Evading& evading, Vec2 acceleration) {
  const MotionState now = state_now(evading.robot);
  return take_first_flight(evading.options, evading.workspace.around, now,
                           step_by(evading, now, acceleration));
}

constexpr std::size_t kControls = 9;

// The controls of evasive maneuvers from a state with that speed: straight, left or right, at that
// speed, or towards the highest or the lowest. After a step the rest of an evasive maneuver is an
// evasive maneuver as well.
std::array<FlightControl, kControls> controls_of(const Robot& robot, double speed) {
  std::array<FlightControl, kControls> controls;
  std::size_t count = 0;
  for (const double target : {speed, robot.max_speed, model_traits(robot.model).least_speed})
    for (const double turn : {0.0, 1.0, -1.0}) controls[count++] = {target, turn};
  return controls;
}

bool may_circle_later(Evading& evading) {
  Surroundings& around = evading.workspace.around;
  if (may_circle(evading.options, around)) return true;
  const auto controls = controls_of(evading.robot, norm(around.after.velocity));
  return std::any_of(controls.begin(), controls.end(), [&](const FlightControl& control) {
    return may_circle_after(evading.options, around, control);
  });
}

// The first step of an evasive maneuver, and the control that it belongs to.
struct FirstFlight {
  Vec2 acceleration;
  FlightControl control;
  double detour = 0.0;  // m²/s⁴, squared distance from the wanted acceleration
};
using FirstFlights = std::array<FirstFlight, kControls>;

// Returns the steps, nearest to the wanted acceleration first.
FirstFlights first_flights(const Evading& evading, Vec2 wanted) {
  const Robot& robot = evading.robot;
  const Vec2 h = ahead_of(robot.heading), n = perpendicular(h);
  const double speed = norm(robot.velocity), step = evading.law.step.time_step;
  const double a_max = robot.max_acceleration, a_lat = usable_acceleration(robot.model);
  const auto controls = controls_of(robot, speed);
  FirstFlights flights;
  for (std::size_t k = 0; k < kControls; ++k) {
    const double ahead = std::clamp((controls[k].speed - speed) / step, -a_max, a_max);
    flights[k] = {ahead * h + (controls[k].turn * a_lat) * n, controls[k]};
    flights[k].detour = norm_squared(flights[k].acceleration - wanted);
  }
  std::stable_sort(flights.begin(), flights.end(),
                   [](const FirstFlight& a, const FirstFlight& b) { return a.detour < b.detour; });
  return flights;
}

// The circle that the robot is on is always admitted.
bool is_admitted(const Evading& evading, Vec2 acceleration) {
  const Robot robot = with_circle(evading.robot);
  const MotionState now{robot.position, robot.velocity, robot.heading, *robot.loiter};
  if (acceleration == loitering(robot.model, now)) return true;
  return keeps_flight(*evading.sight.flight, robot, step_by(evading, now, acceleration));
}

// The evasive maneuver that was last found clear.
Evasion last_evasion(const Evading& evading) {
  const EvasionState& last = evading.workspace.around.last;
  return {-1, last.velocity, last.time};
}

// Finds an evasive maneuver that is clear after that step.
bool leaves_a_flight(Evading& evading, Vec2 acceleration) {
  return take_step(evading, acceleration) && may_circle_later(evading);
}

bool is_evasion_clear(Evading& evading, const FirstFlight& flight) {
  Surroundings& around = evading.workspace.around;
  return take_step(evading, flight.acceleration) &&
         (may_circle(evading.options, around) ||
          may_circle_after(evading.options, around, flight.control));
}

// The replacement nearest to the wanted acceleration that bisection finds.
Taken nearer_flight(Evading& evading, const FirstFlight& flight, Vec2 wanted) {
  double refused = 0.0, kept = 1.0;
  Taken best{flight.acceleration, last_evasion(evading)};
  for (int k = 0; k < kNearer; ++k) {
    const double part = 0.5 * (refused + kept);
    const Vec2 between = wanted + part * (flight.acceleration - wanted);
    if (is_admitted(evading, between) && leaves_a_flight(evading, between)) {
      kept = part, best = {between, last_evasion(evading)};
    } else {
      refused = part;
    }
  }
  return best;
}

// Where others refuse the first steps of evasive maneuvers: finds another step that leaves an
// evasive maneuver.
bool find_flight_beside(Evading& evading, Vec2 wanted, Taken& found) {
  const Robot& robot = evading.robot;
  const Vec2 h = ahead_of(robot.heading), n = perpendicular(h);
  const TriedControls tried = controls_near(robot, {dot(h, wanted), cross(h, wanted)});
  for (std::size_t k = 0; k < tried.count; ++k) {
    const Vec2 acceleration = tried.controls[k].ahead * h + tried.controls[k].left * n;
    if (!is_admitted(evading, acceleration) || !leaves_a_flight(evading, acceleration)) continue;
    found = {acceleration, last_evasion(evading)};
    return true;
  }
  return false;
}

}  // namespace

bool may_circle_after_choice(Evading& evading, Vec2 acceleration) {
  return take_step(evading, acceleration) && may_circle(evading.options, evading.workspace.around);
}

bool has_clear_flight(Evading& evading) {
  take_no_flight(evading.workspace.around, evading.robot.velocity);
  return may_circle_later(evading);
}

EvasionFound find_flight(Evading& evading, Vec2 wanted, Taken& found) {
  if (leaves_a_flight(evading, wanted)) return EvasionFound::as_wanted;
  bool is_refused = false;
  for (const FirstFlight& flight : first_flights(evading, wanted)) {
    if (!is_evasion_clear(evading, flight)) continue;
    if (!is_admitted(evading, flight.acceleration)) {
      is_refused = true;
      continue;
    }
    found = nearer_flight(evading, flight, wanted);
    return EvasionFound::another;
  }
  return is_refused && find_flight_beside(evading, wanted, found) ? EvasionFound::another
                                                                  : EvasionFound::none;
}

}  // namespace avo::inline planner
