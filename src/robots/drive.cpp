// SPDX-License-Identifier: Apache-2.0
// Differential drives. With h along the heading and n to its left, the point q = axle + L h has the
// velocity v h + L ω n, and so q can be accelerated in any direction. Where a is the acceleration
// of q, with k = b/2L and σ = L ω,
//   v' = a·h + σ²/L,   σ' = a·n - v σ/L,   wheels: v ± k σ, and v' ± k σ'.
// While a is held, q moves on a parabola, and the heading follows by h' = (σ/L) n.
//
// Let S = {V² G(φ)/L <= α_w - a_D √(1 + k²), V W(φ) <= w_max}, with V the speed of q, φ the angle
// of its velocity off the heading, and a_D = change_limit(). Straight braking at up to a_D keeps S
// and the wheels' limits (docs/certificate/wheels.md, "Differential drives").
#include "robots/drive.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <variant>

#include "core/elementary.h"
#include "core/scalar.h"
#include "robots/ahead.h"
#include "robots/drive_kernel.h"
#include "robots/drive_turns.h"

namespace avo {
namespace {

// A part of each limit, for rounding.
constexpr double kReserve = 0x1p-20;
double ratio(const DifferentialDrive& drive) {  // [k]
  return 0.5 * drive.track / drive.offset;
}

using One = scalar::Pack<double>;  // one drive, not lanes of several

// A step in the frame of its first heading, which is (1, 0).
struct AxleTurn {
  scalar::Turning<One> packed;
  Vec2 velocity, acceleration;  // of q, at the start
  double length;                // [h] s, of a substep
  int substeps;

  explicit AxleTurn(const scalar::Turning<One>& of)
      : packed(of),
        velocity(plain(of.velocity)),
        acceleration(plain(of.acceleration)),
        length(of.length.value),
        substeps(static_cast<int>(of.substeps.value)) {}

  Vec2 velocity_at(double substep) const { return plain(packed.velocity_at(One(substep))); }
};

// h: the first heading, a unit vector
AxleTurn turning_of(const DifferentialDrive& drive, Vec2 h, Vec2 velocity, Vec2 next_velocity,
                    double time_step) {
  const auto packed = [](Vec2 a) { return scalar::constant<One>(a); };
  return AxleTurn(scalar::turning_of(One(drive.offset), packed(h), packed(velocity),
                                     packed(next_velocity), One(time_step)));
}

Vec2 heading_of(Vec2 half) {
  return {half.x * half.x - half.y * half.y, 2.0 * half.x * half.y};
}

struct Wheels {
  double speed, acceleration;  // the larger one of both wheels
};

Wheels wheels_of(const DifferentialDrive& drive, Vec2 heading, Vec2 velocity, Vec2 acceleration) {
  const double k = ratio(drive), v = dot(heading, velocity), across = cross(heading, velocity);
  const double ahead = dot(heading, acceleration) + across * across / drive.offset;
  const double turning = cross(heading, acceleration) - v * across / drive.offset;
  return {std::abs(v) + k * std::abs(across), std::abs(ahead) + k * std::abs(turning)};
}

// How far wheels may be from the straight line between the ends of a substep: their second
// derivatives times h²/8. In the robot's frame V' = a - ω J V and a' = -ω J a, J a turn to the
// left,
//   |V''| <= 2 ω a + (ω' + ω²) V,
//   |V'''| <= 3 a (ω' + ω²) + V (3 ω ω' + ω'' + ω³),
// with bounds of |ω|, |ω'|, |ω''|: σ' = a·n - v ω is bounded, and thus σ within the substep.
Wheels between_samples(const DifferentialDrive& drive, const AxleTurn& turning, double across,
                       double top) {
  const double a = norm(turning.acceleration), h = turning.length;
  const double sigma = (across + a * h) / (1.0 - std::min(0.5, h * top / drive.offset));
  const double w = sigma / drive.offset, w1 = (a + top * w) / drive.offset;
  const double second = 2.0 * w * a + (w1 + w * w) * top, w2 = second / drive.offset;
  const double third = 3.0 * a * (w1 + w * w) + top * (3.0 * w * w1 + w2 + w * w * w);
  const double part = 0.125 * h * h * norm(Vec2{1.0, ratio(drive)});
  return {part * second, part * third};
}

}  // namespace

double most_acceleration(const DifferentialDrive& drive) {
  return drive.wheel_acceleration / norm(Vec2{1.0, ratio(drive)});
}

}  // namespace avo

namespace avo::inline robots {

// G and W of a unit vector.
double most_speed(const DifferentialDrive& drive, double most_braking, double along,
                  double across) {
  const double k = ratio(drive), root = norm(Vec2{1.0, k}), aside = std::abs(across);
  const double left = drive.wheel_acceleration - most_braking * root;
  const bool grows = along > 0.0 && k * aside <= (1.0 + root) * along;  // φ <= (π - atan k)/2
  const double g = grows ? aside * (aside + k * along) : 0.5 * (1.0 + root);
  const double w = along > 0.0 && aside <= k * along ? along + k * aside : root;
  const double by_speed = drive.wheel_speed / w;
  const bool by_wheels = g * by_speed * by_speed <= drive.offset * left;
  return by_wheels ? by_speed : std::sqrt(std::max(0.0, drive.offset * left / g));
}

namespace {

// rad, after a turn by twice the angle of `half`.
double turned_twice(double heading, Vec2 half) {
  return std::remainder(heading + 2.0 * elementary::atan2(half.y, half.x), 2.0 * std::numbers::pi);
}

// rad, after that time, in which the velocity changes to next_velocity.
double next_heading(const DifferentialDrive& drive, const MotionState& state, Vec2 next_velocity,
                    double time) {
  const AxleTurn turning =
      turning_of(drive, ahead_of(state.heading), state.velocity, next_velocity, time);
  return turned_twice(state.heading, plain(scalar::half_turned(turning.packed, One(drive.offset))));
}

// The whole step except its heading.
MotionStep without_heading(const MotionState& state, const Plan& plan, double time_step) {
  const Vec2 a = plan.acceleration;
  MotionStep step;
  step.next.velocity = state.velocity + time_step * a;
  // a speed below the rounding of its computation counts as rest
  if (norm_squared(step.next.velocity) < 0x1p-100 * norm_squared(state.velocity))
    step.next.velocity = {};
  step.next.position = state.position + (0.5 * time_step) * (state.velocity + step.next.velocity);
  step.acceleration = norm(a);
  step.length = 0.5 * time_step * (norm(state.velocity) + norm(step.next.velocity));
  return step;
}

}  // namespace

MotionStep advance_drive(const DifferentialDrive& drive, const MotionState& state, const Plan& plan,
                         double time_step) {
  MotionStep step = without_heading(state, plan, time_step);
  step.next.heading = next_heading(drive, state, step.next.velocity, time_step);
  return step;
}

void advance_drives(std::span<ModelStep* const> steps, double time_step) {
  DriveTurns turns;
  for (ModelStep* step : steps) {
    step->result = without_heading(step->state, *step->plan, time_step);
    turns.add(std::get<DifferentialDrive>(*step->model), ahead_of(step->state.heading),
              step->state.velocity, step->result.next.velocity);
  }
  turn(turns, time_step);
  for (std::size_t k = 0; k < steps.size(); ++k)
    steps[k]->result.next.heading = turned_twice(steps[k]->state.heading, turns.half(k));
}

MotionState within_step(const DifferentialDrive& drive, const MotionState& from,
                        const MotionState& to, double time, double duration) {
  MotionState state = within(from, to, false, time, duration);
  if (time > 0.0) state.heading = next_heading(drive, from, state.velocity, time);
  return state;
}

namespace {

// Returns whether bounds over the whole step keep all limits, as they do for most steps. While v >
// 0, σ' = a·n - v σ/L makes |σ| <= Σ = |σ| at the start + a Δt. And v > 0 stays, since v² + σ² = V²
// and V > Σ. The speed at the end is within S by G <= s (s + k), where s = Σ/V is below 1/2, and by
// W <= 1 + k s, which the bound of the speed of wheels implies. Twice the reserve ensures that the
// samples of follows_along() agree.
bool surely_follows(const DifferentialDrive& drive, double most_braking, const AxleTurn& turning,
                    double top, double next_speed) {
  const double a = norm(turning.acceleration), k = ratio(drive);
  const double gained = a * turning.length * turning.substeps;
  const double sigma = std::abs(turning.velocity.y) + gained;
  const bool goes_ahead = turning.velocity.x > 0.0 && next_speed - gained > sigma;
  if (!goes_ahead || !(2.0 * sigma < next_speed)) return false;
  constexpr double kLeft = 1.0 - 2.0 * kReserve;
  const Wheels more = between_samples(drive, turning, sigma, top);
  const double root = norm(Vec2{1.0, k}), s = sigma / next_speed;
  const double speed = top + k * sigma + more.speed;
  const double acceleration =
      a * root + sigma * (sigma + k * top) / drive.offset + more.acceleration;
  const double left = kLeft * drive.offset * (drive.wheel_acceleration - most_braking * root);
  return speed <= kLeft * drive.wheel_speed && acceleration <= kLeft * drive.wheel_acceleration &&
         next_speed * next_speed * (s * (s + k)) <= kLeft * left;
}

// h: the heading, a unit vector
bool follows_along(const DifferentialDrive& drive, double most_braking, Vec2 h, Vec2 velocity,
                   Vec2 next_velocity, double time_step) {
  const AxleTurn turning = turning_of(drive, h, velocity, next_velocity, time_step);
  const double top = std::max(norm(velocity), norm(next_velocity));
  if (turning.length * top > drive.offset * (kSubturn + kReserve)) return false;
  if (surely_follows(drive, most_braking, turning, top, norm(next_velocity))) return true;
  constexpr double kLeft = 1.0 - kReserve;
  const auto kept = [&](const Wheels& wheels, const Wheels& more) {
    return wheels.speed + more.speed <= kLeft * drive.wheel_speed &&
           wheels.acceleration + more.acceleration <= kLeft * drive.wheel_acceleration;
  };
  const scalar::HalfTurns<One> turns(turning.packed, One(drive.offset));
  scalar::Vec<One> half = scalar::constant<One>({1.0, 0.0});
  Vec2 heading{1.0, 0.0};
  for (int k = 0; k < turning.substeps; ++k) {
    const Vec2 v = turning.velocity_at(k);
    const Wheels more = between_samples(drive, turning, std::abs(cross(heading, v)), top);
    if (!kept(wheels_of(drive, heading, v, turning.acceleration), more)) return false;
    half = turns.after(One(k), half);
    heading = heading_of(plain(half));
    const Wheels end = wheels_of(drive, heading, turning.velocity_at(k + 1), turning.acceleration);
    if (!kept(end, more)) return false;
  }
  const Vec2 v = turning.velocity_at(turning.substeps);
  const double speed = norm(v);
  if (!(speed > 0.0)) return true;
  return speed <= kLeft * most_speed(drive, most_braking, dot(heading, v) / speed,
                                     cross(heading, v) / speed);
}

}  // namespace

bool follows(const DifferentialDrive& drive, double most_braking, const MotionState& state,
             Vec2 next_velocity, double time_step) {
  return follows_along(drive, most_braking, ahead_of(state.heading), state.velocity, next_velocity,
                       time_step);
}

// The farthest velocity between straight braking and v that it can follow.
Vec2 within_own_limits(const DifferentialDrive& drive, const Robot& robot, double time, Vec2 v) {
  const Vec2 h = ahead_of(robot.heading);
  const auto can_follow = [&](Vec2 next) {
    return follows_along(drive, change_limit(robot), h, robot.velocity, next, time);
  };
  if (can_follow(v)) return v;
  const double speed = norm(robot.velocity), u = robot.max_acceleration * time;
  const Vec2 backup = speed > u ? ((speed - u) / speed) * robot.velocity : Vec2{};
  constexpr int kBisections = 6;
  double possible = 0.0, refused = 1.0;
  for (int i = 0; i < kBisections; ++i) {
    const double part = 0.5 * (possible + refused);
    (can_follow(backup + part * (v - backup)) ? possible : refused) = part;
  }
  return backup + possible * (v - backup);
}

}  // namespace avo::inline robots
