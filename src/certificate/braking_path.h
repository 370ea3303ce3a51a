// SPDX-License-Identifier: Apache-2.0
// Straight full braking in steps: the motion that every robot can fall back on, known to all.
#pragma once
#include "avo/planner.h"
#include "avo/robot.h"
#include "avo/vec.h"

namespace avo::inline certificate {

/// What a robot can do to its speed, m/s². Of a_max alone: it brakes with as much.
struct Ability {
  double acceleration;  ///< [a_max]
  double braking;       ///< [b] that it surely brakes with

  Ability(double a_max) : Ability(a_max, a_max) {}
  Ability(double a_max, double b) : acceleration(a_max), braking(b) {}
};
template <typename Robot>
Ability ability_of(const Robot& robot) {
  return {robot.max_acceleration, braking_limit(robot)};
}
/// With which it slows down for what it sees coming.
template <typename Robot>
Ability planned_ability_of(const Robot& robot) {
  return {robot.max_acceleration, planned_braking(robot)};
}

/// What the certificates need to know of one step: from v to v_1 it moves by s v + (Δt - s) v_1,
/// inside the triangle of its ends and p + s v. Braking takes off u_b = b · braking_time, and v_1
/// is between the velocity that this leaves and one with |v_1 - v| <= u_a = a_max · braking_time.
struct StepLaw {
  double time_step = 0.1;           ///< [Δt] s
  double lag = 0.05;                ///< [s] s: Δt/2 (held), s(Δt) (exponential)
  double braking_time = 0.1;        ///< s: Δt (held), δ (1 - e^{-Δt/δ}) (exponential)
  SensingError sensing_error = {};  ///< of the robot that plans
  double control_time = 0.1;        ///< [δ] s, Eq. (7)
  double longest_step = 0.0;  ///< [L] s, of anybody whose clock is free; 0: all decide at once
  double localization_error = 0.0;  ///< [ε] m, of where A takes itself to be among the walls

  bool has_free_clocks() const { return longest_step > 0.0; }
  /// Whether all that decide move, until they do, as they are seen to brake.
  bool is_exact() const { return sensing_error == SensingError{} && !has_free_clocks(); }
};

/// The decision that leads to v_1 in one step: v' and the acceleration of Eq. (7).
Plan plan_to(const Robot& robot, Vec2 next_velocity, const StepLaw& law);

/// [u_a] m/s, most by which a decision that does not brake changes the velocity.
inline double increment(double max_acceleration, const StepLaw& law) {
  return max_acceleration * law.braking_time;
}
/// [u_b] m/s that one step of full braking takes off.
inline double braking_decrement(double max_braking, const StepLaw& law) {
  return max_braking * law.braking_time;
}
template <typename Robot>
double decrement_of(const Robot& robot, const StepLaw& law) {
  return braking_decrement(braking_limit(robot), law);
}

/// Steps that braking from `speed` takes until rest: ⌈speed / u⌉, one more where that is exact.
double braking_steps(double speed, double decrement);

/// The same without that step: a speed that rounding leaves above a whole number of u is that
/// number. What is left over moves a robot by less than 1e-9 u Δt.
double braking_steps_at_least(double speed, double decrement);

/// Velocity after one step of full braking, exactly 0 where that ends at rest.
Vec2 braked(Vec2 velocity, double decrement);

/// Full braking from a speed: whole steps, and a last one that takes off what is left.
struct BrakingProfile {
  double speed = 0.0;       ///< m/s
  double decrement = 0.0;   ///< [u_b] m/s
  double full_steps = 0.0;  ///< ⌊speed / u_b⌋
};
BrakingProfile braking_profile(double speed, double decrement);

/// Distances along a braking path, m: where an interval between steps begins, its middle Bézier
/// point, where it ends. Nondecreasing; all equal once at rest.
struct BrakingDistances {
  double start, middle, end;
};
BrakingDistances braking_distances(const BrakingProfile& braking, const StepLaw& law, int interval);

/// [l] m until rest, by steps of `decrement` and a last one of what is left. Not v²/2a: a robot
/// that moves in steps needs up to u Δt/8 more. Within a few ulp, any speed >= 0.
double stopping_length(const BrakingProfile& braking, const StepLaw& law);
inline double stopping_length(double speed, double decrement, const StepLaw& law) {
  return stopping_length(braking_profile(speed, decrement), law);
}

/// The way of full braking until rest, m.
Vec2 stopping_way(Vec2 velocity, double decrement, const StepLaw& law);

/// What accelerates all the time moves on a parabola. Where motion is exponential, this bounds how
/// far it may be in a step from a path of the law's kind that has the same ends and leaves with the
/// same velocity, m.
double parabola_error(Vec2 acceleration, const StepLaw& law);

/// A's path for a candidate: v_1 after one step, then braking. Relative to p_A.
struct CandidatePath {
  Vec2 first;              ///< m, end of the first step
  Vec2 next_velocity;      ///< [v_1] m/s
  Vec2 direction;          ///< of v_1; 0 at rest
  double speed = 0.0;      ///< |v_1| m/s
  double way = 0.0;        ///< m, of the first step at least, where the robot is not holonomic
  int moving = 0;          ///< intervals in which it moves, the first step included
  double bend = 0.0;       ///< m: what the arc of its first step asks for beyond a parabola
  Vec2 swing = {};         ///< m: p_1 of that parabola is so far from that of the braking path
  BrakingProfile braking;  ///< from v_1
};

/// The path of a robot that is not holonomic is that of the velocity that it reaches where v_1 was
/// wanted.
CandidatePath follow(const Robot& robot, Vec2 next_velocity, const StepLaw& law);

}  // namespace avo::inline certificate
