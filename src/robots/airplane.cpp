// SPDX-License-Identifier: Apache-2.0
// Airplanes. With heading h, n to its left, speed s and curvature κ,
//   p' = s h,  h' = s κ n,  s' = a_lin;   |a_lin| <= a_max,  s² |κ| <= a_lat,  s in [s_min, s_max]
// and both controls are held through a step. The circle that an airplane falls back on has the
// radius ρ = s²/a_lat, its center is to the right.
#include "robots/airplane.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elementary.h"
#include "core/plane.h"
#include "robots/ahead.h"

namespace avo::inline robots {
namespace {

// A part of a_lat: a reserve, so that a controller can return to a circle after a small deviation.
constexpr double kLateralReserve = 1e-6;
// Goals are steered to if a circle leads there that is this factor wider than the least one.
constexpr double kWiderLoiter = 1.05;

// The vector from the start to the point at that length of the arc.
Vec2 chord(const FlightArc& arc, double length) {
  const double half = 0.5 * arc.curvature * length;
  const Vec2 by = elementary::direction(half);
  const double straight = std::abs(half) < 1e-8 ? length : length * (by.y / half);
  return straight * turned(arc.heading, by);
}

// heading: unit
Vec2 loitering_along(const Airplane& airplane, Vec2 heading) {
  return -usable_acceleration(airplane) * perpendicular(heading);
}

// The airplane is set back onto the circle in each step: no errors accumulate, however long it
// stays there.
FlightStep hold_circle(const Airplane& airplane, const MotionState& state, double time_step) {
  const LoiterCircle& circle = state.circle;
  const double speed = std::sqrt(usable_acceleration(airplane) * circle.radius);
  const double length = speed * time_step, turn = length / circle.radius;
  const Vec2 out = state.position - circle.center;
  const Vec2 next = turned(out / norm(out), elementary::direction(-turn));
  FlightStep step;
  step.arc = {state.position, ahead_of(state.heading), -1.0 / circle.radius, length};
  step.chord = chord(step.arc);
  step.motion.next = {
      circle.center + circle.radius * next, {}, elementary::atan2(-next.x, next.y), circle};
  step.motion.next.velocity = speed * elementary::direction(step.motion.next.heading);
  step.motion.acceleration = usable_acceleration(airplane);
  step.motion.length = length;
  return step;
}

}  // namespace

double usable_acceleration(const Airplane& airplane) {
  return (1.0 - kLateralReserve) * airplane.lateral_acceleration;
}

Vec2 chord(const FlightArc& arc) {
  return chord(arc, arc.length);
}

ArcEnd end_of(const FlightArc& arc, Vec2 chord) {
  return {chord, turned(arc.heading, elementary::direction(arc.curvature * arc.length))};
}

// Where the path stops leading down, heading and n are at right angles. With σ the sign of κ it has
// come down by (1 + σ n × h)/|κ| by then. The code avoids the difference of nearly equal numbers.
double lowest(const FlightArc& arc, const ArcEnd& end, Vec2 n) {
  const double turn = arc.curvature * arc.length, down = dot(n, arc.heading);
  const double least = std::min(0.0, dot(n, end.chord));
  if (!(down < 0.0 && dot(n, end.heading) > 0.0)) return least;
  const double across = std::copysign(1.0, turn) * cross(n, arc.heading);
  const double part = across <= 0.0 ? down * down / (1.0 - across) : 1.0 + across;
  return std::min(least, -part / std::abs(arc.curvature));
}

double distance(const FlightArc& arc, Vec2 p) {
  const Vec2 to = p - arc.start;
  const double x = dot(arc.heading, to), y = cross(arc.heading, to);
  const double turn = elementary::atan2(arc.curvature * x, 1.0 - arc.curvature * y);
  const double along = std::abs(turn) < 1e-8 ? x : turn / arc.curvature;
  double least = std::min(norm(to), norm(to - chord(arc, arc.length)));
  if (along > 0.0 && along < arc.length) least = std::min(least, norm(to - chord(arc, along)));
  return least;
}

double sagitta(const FlightArc& arc) {
  // for half a turn at most: (1 - cos x) <= x²/2, and the chord is no longer than the arc
  return 0.125 * arc.length * arc.length * std::abs(arc.curvature);
}

FlightStep fly(const Airplane& airplane, const MotionLimits& limits, const MotionState& state,
               const Plan& plan, double time_step) {
  return fly_along(airplane, limits, state, ahead_of(state.heading), plan.acceleration, time_step);
}

FlightStep fly_along(const Airplane& airplane, const MotionLimits& limits, const MotionState& state,
                     Vec2 heading, Vec2 acceleration, double time_step) {
  if (acceleration == loitering_along(airplane, heading))
    return hold_circle(airplane, state, time_step);
  const double speed = norm(state.velocity), most = usable_acceleration(airplane);
  const double next_speed = std::clamp(speed + dot(heading, acceleration) * time_step,
                                       airplane.min_speed, limits.max_speed);
  const double top = std::max(speed, next_speed);
  const double across = std::clamp(cross(heading, acceleration), -most, most);
  FlightStep step;
  step.arc = {state.position, heading, across / (top * top),
              0.5 * (speed + next_speed) * time_step};
  MotionState& next = step.motion.next;
  step.chord = chord(step.arc);
  next.position = state.position + step.chord;
  next.heading = wrapped(state.heading + step.arc.curvature * step.arc.length);
  next.velocity = next_speed * elementary::direction(next.heading);
  next.circle = loiter_circle(airplane, next.position, next.velocity);
  step.motion.acceleration = norm(Vec2{(next_speed - speed) / time_step, across});
  step.motion.length = step.arc.length;
  return step;
}

FlightStep fly_along(const MotionModel& model, const MotionLimits& limits, const MotionState& state,
                     Vec2 heading, Vec2 acceleration, double time_step) {
  return fly_along(std::get<Airplane>(model), limits, state, heading, acceleration, time_step);
}

double usable_acceleration(const MotionModel& model) {
  return usable_acceleration(std::get<Airplane>(model));
}

Vec2 loitering(const MotionModel& model, const MotionState& state) {
  return loitering_along(std::get<Airplane>(model), ahead_of(state.heading));
}

bool turns_slowly(const MotionModel& model, double time_step) {
  const Airplane& airplane = std::get<Airplane>(model);
  return !(airplane.lateral_acceleration * time_step > kMostTurn * airplane.min_speed);
}

// Along the heading a_max, across it a_lat.
void append_own_half_planes(const Airplane& airplane, const Robot& robot, double time,
                            std::vector<HalfPlane>& half_planes) {
  const Vec2 h = ahead_of(robot.heading), n = perpendicular(h), v = robot.velocity;
  const auto bound = [&](Vec2 normal, double most) {
    half_planes.push_back({normal, dot(normal, v) - most});
    half_planes.push_back({-normal, -dot(normal, v) - most});
  };
  bound(h, robot.max_acceleration * time);
  bound(n, usable_acceleration(airplane) * time);
}

// Velocities at more than 45 degrees become turns at full rate: as much across as ahead.
Vec2 within_steering(const Airplane&, const Robot& robot, Vec2 v) {
  const Vec2 h = ahead_of(robot.heading), n = perpendicular(h);
  const double ahead = dot(h, v), across = cross(h, v);
  if (ahead >= std::abs(across)) return v;
  return norm(v) * (h + (across > 0.0 ? n : -n));
}

// Pure pursuit (Coulter, CMU 1992), no faster than its circle allows. If the goal is inside the
// smallest circle, the airplane flies away from the goal until the goal is outside.
Vec2 steered(const Airplane& airplane, const Robot& robot) {
  const double wanted = norm(robot.preferred_velocity);
  if (!(wanted > 0.0)) return {};
  const Vec2 to = robot.preferred_velocity / wanted, h = ahead_of(robot.heading);
  const double across = std::abs(cross(h, to));
  const double radius = across > 0.0 ? robot.distance_to_goal / (2.0 * across)
                                     : std::numeric_limits<double>::infinity();
  const double top = std::sqrt(usable_acceleration(airplane) * radius / kWiderLoiter);
  if (top < airplane.min_speed) return airplane.min_speed * h;
  const double fastest = std::min({std::max(wanted, airplane.min_speed), top, robot.max_speed});
  return within_steering(airplane, robot, fastest * to);
}

}  // namespace avo::inline robots

namespace avo {

const char* to_string(AfterGoal after_goal) {
  return after_goal == AfterGoal::leave ? "leave" : "loiter";
}

LoiterCircle loiter_circle(const Airplane& airplane, Vec2 position, Vec2 velocity) {
  const double radius = norm_squared(velocity) / usable_acceleration(airplane);
  return {position - (radius / norm(velocity)) * perpendicular(velocity), radius};
}

}  // namespace avo
