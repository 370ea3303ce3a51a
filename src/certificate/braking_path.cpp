// SPDX-License-Identifier: Apache-2.0
// Straight full braking in steps.
#include "certificate/braking_path.h"

#include <algorithm>
#include <cmath>

#include "certificate/kernels.h"
#include "robots/model.h"

namespace avo::inline certificate {

using Real = scalar::Pack<double>;
double braking_steps(double speed, double decrement) {
  return speed > 0.0 ? braking_profile(speed, decrement).full_steps + 1.0 : 0.0;
}

double braking_steps_at_least(double speed, double decrement) {
  const double steps = speed / decrement;
  // of each of the subtractions that lead to it
  const double rounding = 0x1p-30 + 0x1p-51 * steps * steps;
  return std::max(std::ceil(steps - rounding), 0.0);
}

BrakingProfile braking_profile(double speed, double decrement) {
  const auto packed = scalar::profile<Real>(speed, decrement);
  return {speed, decrement, packed.full_steps.value};
}

// The point is (Δt - s) v_1 + (v_1/|v_1|) D(|v_1|) and a constant. The second term grows with v_1
// by D/|v_1| across it, and along it by D', the time for which braking moves the point.
PointGrowth point_growth(const BrakingProfile& braking, double speed, int interval, int point,
                         const StepLaw& law) {
  double across = law.time_step - law.lag, along = across;
  if (interval == 0) return {across, along};
  const int m = interval - 1;
  const BrakingDistances distances = braking_distances(braking, law, m);
  const double distance = point == 0   ? distances.start
                          : point == 1 ? distances.middle
                                       : distances.end;
  // in the step that ends at rest only the lag counts
  const double to_point = point == 0 ? 0.0 : point == 1 ? law.lag : law.time_step;
  const double to_rest = law.time_step * braking.full_steps + law.lag;
  across += speed > 0.0 ? distance / speed : law.lag;
  along += std::min(law.time_step * m + to_point, to_rest);
  return {across, along};
}

double stopping_length(const BrakingProfile& braking, const StepLaw& law) {
  return scalar::stopping_length(scalar::constant<Real>(braking), law).value;
}

BrakingDistances braking_distances(const BrakingProfile& profile, const StepLaw& law,
                                   int interval) {
  const auto braking = scalar::constant<Real>(profile);
  const auto now = scalar::distances(braking, law, Real(interval));
  const auto next = scalar::distances(braking, law, Real(interval + 1.0));
  return {now.start.value, now.middle.value, next.start.value};
}

Vec2 stopping_vector(Vec2 velocity, double decrement, const StepLaw& law) {
  const double speed = norm(velocity);
  return speed > 0.0 ? (stopping_length(speed, decrement, law) / speed) * velocity : Vec2{};
}

double parabola_error(Vec2 acceleration, const StepLaw& law) {
  if (law.lag == 0.5 * law.time_step) return 0.0;
  return 0.125 * law.time_step * law.time_step * norm(acceleration);
}

Vec2 braked(Vec2 velocity, double decrement) {
  const double speed = norm(velocity);
  return speed > decrement ? ((speed - decrement) / speed) * velocity : Vec2{};
}

Plan plan_to(const Robot& robot, Vec2 next_velocity, const StepLaw& law) {
  const auto plan = scalar::plan_to(scalar::constant<Real>(robot.velocity),
                                    scalar::constant<Real>(next_velocity), law);
  const auto& [v_new, a] = plan;
  return {.new_velocity = plain(v_new), .acceleration = plain(a)};
}

namespace {

// path.first and path.next_velocity are those of the step.
void brake_after(const Robot& robot, const StepLaw& law, CandidatePath& path) {
  const double decrement = decrement_of(robot, law);
  path.speed = norm(path.next_velocity);
  path.direction = path.speed > 0.0 ? path.next_velocity / path.speed : Vec2{};
  const bool stays = path.speed == 0.0 && robot.velocity == Vec2{} && path.first == Vec2{};
  constexpr double kForEver = 1e9;  // more than any constraint's interval
  path.braking = braking_profile(path.speed, decrement);
  const double steps = path.speed > 0.0 ? std::min(path.braking.full_steps + 1.0, kForEver) : 0.0;
  path.moving = stays ? 0 : 1 + static_cast<int>(steps);
  path.end = path.first;
}

}  // namespace

CandidatePath path_after(const Robot& robot, const MotionStep& step, const StepLaw& law) {
  CandidatePath path;
  path.first = step.next.position;
  path.next_velocity = step.next.velocity;
  path.bend = step.bend;
  path.swing = law.lag * step.swing;
  path.length = step.length;
  brake_after(robot, law, path);
  return path;
}

CandidatePath follow(const Robot& robot, Vec2 next_velocity, const StepLaw& law) {
  if (!is_holonomic(robot.model))
    return path_after(robot,
                      advance(robot.model, {planned_braking(robot), robot.max_speed},
                              {{}, robot.velocity, robot.heading},
                              plan_to(robot, next_velocity, law), law.time_step),
                      law);
  CandidatePath path;
  path.first = law.lag * robot.velocity + (law.time_step - law.lag) * next_velocity;
  path.next_velocity = next_velocity;
  brake_after(robot, law, path);
  return path;
}

}  // namespace avo::inline certificate
