// SPDX-License-Identifier: Apache-2.0
// Straight full braking in steps: the fallback motion of every robot, which all robots know.
#pragma once
#include "avo/planner.h"
#include "avo/robot.h"
#include "avo/vec.h"
#include "core/vector_of.h"
#include "robots/motion.h"

namespace avo::inline certificate {

/// How much a robot can change its speed, m/s². Built from a_max alone, it brakes with a_max.
struct Ability {
  double acceleration;  ///< [a_max]
  double braking;       ///< [b] the deceleration with which it surely brakes

  Ability(double a_max) : Ability(a_max, a_max) {}
  Ability(double a_max, double b) : acceleration(a_max), braking(b) {}
};
template <typename Robot>
Ability ability_of(const Robot& robot) {
  return {robot.max_acceleration, braking_limit(robot)};
}
/// The limits with which it slows down for what it foresees.
template <typename Robot>
Ability planned_ability_of(const Robot& robot) {
  return {robot.max_acceleration, planned_braking(robot)};
}

/// What the certificates need to know of one step. From v to v_1 a robot moves by s v + (Δt - s)
/// v_1, inside the triangle of its ends and p + s v. Braking takes off u_b = b · braking_time. v_1
/// is between the velocity after braking and a velocity with |v_1 - v| <= u_a = a_max ·
/// braking_time.
struct StepLaw {
  double time_step = 0.1;           ///< [Δt] s
  double lag = 0.05;                ///< [s] s: Δt/2 (held), s(Δt) (exponential)
  double braking_time = 0.1;        ///< s: Δt (held), δ (1 - e^{-Δt/δ}) (exponential)
  SensingError sensing_error = {};  ///< of the robot that plans
  double control_time = 0.1;        ///< [δ] s, Eq. (7)
  /// [L] s, the longest step of any robot with a free clock; 0: all decide at the same times
  double longest_step = 0.0;
  double localization_error = 0.0;  ///< [ε] m, the error of A's own position among the walls

  bool has_free_clocks() const { return longest_step > 0.0; }
  /// Returns whether all neighbors that decide brake on the sensed path, until they decide again.
  bool is_exact() const { return sensing_error == SensingError{} && !has_free_clocks(); }
};

/// The decision that leads to v_1 in one step: v' and the acceleration of Eq. (7).
Plan plan_to(const Robot& robot, Vec2 next_velocity, const StepLaw& law);

/// [u_a] m/s, the largest change of velocity by a decision that does not brake.
inline double increment(double max_acceleration, const StepLaw& law) {
  return max_acceleration * law.braking_time;
}
/// [u_b] m/s, the speed that one step of full braking takes off.
inline double braking_decrement(double max_braking, const StepLaw& law) {
  return max_braking * law.braking_time;
}
template <typename Robot>
double decrement_of(const Robot& robot, const StepLaw& law) {
  return braking_decrement(braking_limit(robot), law);
}

/// Steps of braking from `speed` to rest: ⌈speed / u⌉, one more where that is exact.
double braking_steps(double speed, double decrement);

/// Steps of braking to rest, without the extra step. A speed that rounding leaves above a whole
/// number of u counts as that number. The rest moves a robot by less than 1e-9 u Δt.
double braking_steps_at_least(double speed, double decrement);

/// The velocity after one step of full braking, exactly 0 where the step ends at rest.
Vec2 braked(Vec2 velocity, double decrement);

/// Full braking from a speed: whole steps, and a last step that takes off the rest.
struct BrakingProfile {
  double speed = 0.0;       ///< m/s
  double decrement = 0.0;   ///< [u_b] m/s
  double full_steps = 0.0;  ///< ⌊speed / u_b⌋
};
BrakingProfile braking_profile(double speed, double decrement);

/// Distances along a braking path, m: at the start of an interval between steps, at its middle
/// Bézier point, and at its end. They are nondecreasing, and all equal once at rest.
struct BrakingDistances {
  double start, middle, end;
};
BrakingDistances braking_distances(const BrakingProfile& braking, const StepLaw& law, int interval);

/// s: how a point of a path that brakes after v_1 moves with v_1, across it and along it.
struct PointGrowth {
  double across, along;
};
/// `interval` 0 is the step to v_1, and `speed` is |v_1|, with which `braking` begins. `point`: 0
/// is the start of the interval, 1 its middle Bézier point, 2 its end.
PointGrowth point_growth(const BrakingProfile& braking, double speed, int interval, int point,
                         const StepLaw& law);

/// [l] m until rest, by steps of `decrement` and a last step that takes off the rest. It is not
/// v²/2a: a robot that moves in steps needs up to u Δt/8 more. It is exact within a few ulp, for
/// any speed >= 0.
double stopping_length(const BrakingProfile& braking, const StepLaw& law);
inline double stopping_length(double speed, double decrement, const StepLaw& law) {
  return stopping_length(braking_profile(speed, decrement), law);
}

/// The displacement of full braking until rest, m.
Vec2 stopping_vector(Vec2 velocity, double decrement, const StepLaw& law);

/// A body with constant acceleration moves on a parabola. Where motion is exponential, a path of
/// the law's kind with the same ends and the same first velocity differs from it. This is a bound
/// of the difference within a step, m.
double parabola_error(Vec2 acceleration, const StepLaw& law);

/// A's path for a candidate: v_1 after one step, then braking. Relative to p_A.
template <int D>
struct CandidatePathOf {
  using Vector = VectorOf<D>;
  Vector first;          ///< m, end of the first step
  Vector next_velocity;  ///< [v_1] m/s
  Vector direction;      ///< of v_1; 0 at rest
  double speed = 0.0;    ///< |v_1| m/s
  /// m, a lower bound of the distance of the first step, where the robot is not holonomic
  double length = 0.0;
  int moving = 0;          ///< number of intervals in which it moves, with the first step
  double bend = 0.0;       ///< m: how much more the arc of its first step needs than a parabola
  Vector swing = {};       ///< m: distance from p_1 of that parabola to p_1 of the braking path
  BrakingProfile braking;  ///< from v_1
  // of a disc of a footprint (docs/certificate/footprints.md):
  Vec2 begin = {}, end = {};  ///< m: first and last point of the step; `end` is `first` otherwise
  double grown_within = 0.0;  ///< m, of the disc's radius within the step
  double grown = 0.0;         ///< m, of its radius after the step
  double lever = 0.0;         ///< m, from the robot to the disc, in the direction of v_1
};
using CandidatePath = CandidatePathOf<2>;

/// The path of a robot that is not holonomic uses the velocity that it reaches when v_1 is
/// commanded.
CandidatePath follow(const Robot& robot, Vec2 next_velocity, const StepLaw& law);

/// The path after a step of a robot that is not holonomic; the step begins at {0, 0}.
CandidatePath path_after(const Robot& robot, const MotionStep& step, const StepLaw& law);

}  // namespace avo::inline certificate
