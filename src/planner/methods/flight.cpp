// SPDX-License-Identifier: Apache-2.0
// Tries controls, beginning with the wanted ones; the motion that follows from them is tested.
#include "planner/methods/flight.h"

#include <algorithm>
#include <cmath>

#include "planner/stages/certify.h"
#include "planner/trace.h"
#include "robots/ahead.h"

namespace avo::inline planner {
namespace {

constexpr double kSpeedOff = 1e-9;   // of a limit of the speed, by rounding
constexpr double kCircleOff = 1e-6;  // of a circle's radius

MotionState state_of(const Robot& robot) {
  return {robot.position, robot.velocity, robot.heading, *robot.loiter};
}

Plan plan_of(const Planner& planner, const Robot& robot, Vec2 acceleration, PlanStatus status,
             double violation) {
  return {.new_velocity = robot.velocity + planner.options().control_time * acceleration,
          .acceleration = acceleration,
          .status = status,
          .violation = violation};
}

// The fastest allowed controls towards the target.
Controls wanted_controls(const Planner& planner, const Robot& robot, Vec2 target) {
  const Vec2 h = ahead_of(robot.heading), change = target - robot.velocity;
  const double step = planner.options().time_step, speed = norm(robot.velocity);
  const double a_max = robot.max_acceleration, a_lat = usable_acceleration(robot.model);
  const double ahead = std::clamp(dot(h, change) / step, -a_max, a_max);
  return {std::clamp(ahead, (model_traits(robot.model).least_speed - speed) / step,
                     (robot.max_speed - speed) / step),
          std::clamp(cross(h, change) / step, -a_lat, a_lat)};
}

}  // namespace

TriedControls controls_near(const Robot& robot, Controls wanted) {
  const double a_lat = usable_acceleration(robot.model), a_max = robot.max_acceleration;
  TriedControls tried;
  for (const double ahead : {wanted.ahead, 0.0, -a_max, a_max}) {
    tried.controls[tried.count++] = {ahead, wanted.left};
    for (int k = -TriedControls::kTurns; k <= TriedControls::kTurns; ++k)
      tried.controls[tried.count++] = {ahead, a_lat * k / TriedControls::kTurns};
  }
  const auto off = [&](const Controls& c) {
    return norm_squared(Vec2{c.ahead - wanted.ahead, c.left - wanted.left});
  };
  std::stable_sort(tried.controls.data(), tried.controls.data() + tried.count,
                   [&](const Controls& a, const Controls& b) { return off(a) < off(b); });
  return tried;
}

Plan loiter_on(const Planner& planner, const Robot& robot, PlanStatus status, double violation) {
  const Robot on_circle = with_circle(robot);
  return plan_of(planner, robot, loitering(robot.model, state_of(on_circle)), status, violation);
}

template <typename Trace>
Plan fly_towards(const Planner& planner, const Robot& given, const Neighbors& neighbors,
                 std::span<const Wall> walls, const FlightTarget& flight,
                 FlightConstraints& constraints, Trace trace) {
  const Robot robot = with_circle(given);
  const CertificateLaw law = certificate_law(planner);
  collect_flight(robot, neighbors, walls, law.step, constraints);
  const bool certified = law.kind != Certificate::none;
  const PlanStatus best = status_of(flight.violation);
  if (robot.preferred_velocity == Vec2{}) return loiter_on(planner, robot, best, flight.violation);
  const MotionState state = state_of(robot);
  const MotionLimits limits{robot.max_acceleration, robot.max_speed};
  const Vec2 h = ahead_of(robot.heading), n = perpendicular(h);
  const auto step_of = [&](Vec2 acceleration) {
    return fly_along(robot.model, limits, state, h, acceleration, law.step.time_step);
  };
  const auto admitted = [&](Vec2 acceleration) {
    return !certified || keeps_flight(constraints, robot, step_of(acceleration));
  };
  const Controls wanted = wanted_controls(planner, robot, flight.target);
  const Vec2 first = wanted.ahead * h + wanted.left * n;
  if constexpr (Trace::is_on) trace.proposes(step_of(first).motion.next.velocity);
  if (admitted(first)) return plan_of(planner, robot, first, best, flight.violation);
  if constexpr (Trace::is_on) trace.is_refused(robot, constraints, step_of(first));
  const TriedControls tried = controls_near(robot, wanted);
  for (std::size_t k = 0; k < tried.count; ++k) {
    const Vec2 acceleration = tried.controls[k].ahead * h + tried.controls[k].left * n;
    if (admitted(acceleration))
      return plan_of(planner, robot, acceleration, PlanStatus::refused, flight.violation);
  }
  return loiter_on(planner, robot, PlanStatus::braking, flight.violation);
}

template Plan fly_towards(const Planner&, const Robot&, const Neighbors&, std::span<const Wall>,
                          const FlightTarget&, FlightConstraints&, NoTrace);
template Plan fly_towards(const Planner&, const Robot&, const Neighbors&, std::span<const Wall>,
                          const FlightTarget&, FlightConstraints&, Recorder);

bool is_on_circle(const Neighbor& neighbor) {
  const auto& [center, radius] = *neighbor.loiter;
  const Vec2 out = neighbor.position - center;
  const double off = kCircleOff * radius;
  // it turns right
  return std::abs(norm(out) - radius) <= off &&
         std::abs(dot(out, neighbor.velocity)) <= off * norm(neighbor.velocity) &&
         cross(out, neighbor.velocity) < 0.0;
}

bool can_fly(const Robot& robot, double time_step) {
  if (robot.max_braking || !turns_slowly(robot.model, time_step)) return false;
  const double speed = norm(robot.velocity), least = model_traits(robot.model).least_speed;
  if (!(speed >= least * (1.0 - kSpeedOff) && speed <= robot.max_speed * (1.0 + kSpeedOff)))
    return false;
  if (!robot.loiter) return true;
  const LoiterCircle own = *circle_of(robot.model, robot.position, robot.velocity);
  const double off = kCircleOff * own.radius;
  return std::abs(own.radius - robot.loiter->radius) <= off &&
         norm(own.center - robot.loiter->center) <= off;
}

bool allows_loiterers(const PlannerOptions& options) {
  return method_traits(options.method).has_rules && options.motion == Motion::held &&
         options.clock == Clock::common && options.sensing_error == SensingError{} &&
         options.localization_error == 0.0;
}

Robot with_circle(const Robot& robot) {
  Robot on_circle = robot;
  if (!robot.loiter) on_circle.loiter = circle_of(robot.model, robot.position, robot.velocity);
  return on_circle;
}

}  // namespace avo::inline planner
