// SPDX-License-Identifier: Apache-2.0
// What a robot knows of itself and senses of the others (paper §IV-D). SI units.
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "avo/export.h"
#include "avo/footprint.h"
#include "avo/ids.h"
#include "avo/model.h"
#include "avo/trajectory.h"
#include "avo/vec.h"

namespace avo {

/// rad, angle from the heading to the velocity of a robot with wheels: more is
/// PlanStatus::invalid_input. Values rounded to float keep within it. Others predict the car's
/// braking with this error: 2 µm after 2 m.
inline constexpr double kHeadingTolerance = 1e-6;

/// Robot A, the robot that decides.
struct Robot {
  Vec2 position = {};  ///< [p_A] m, the center of its disc: see disc_center()
  /// [v_A] m/s; for a differential drive the velocity of this center
  Vec2 velocity = {};
  Vec2 preferred_velocity = {};   ///< [v_A^pref] m/s
  double radius = 0.5;            ///< [r_A] m, > 0, of that disc; it covers a footprint
  double max_acceleration = 1.0;  ///< [a_A^max] m/s^2, > 0
  double max_speed = 2.0;         ///< [v_A^max] m/s, > 0
  /// m, left to the place where it comes to rest, if it has such a goal. Method avo then makes no
  /// detours on the last part, and follows a preferred velocity that brakes there without a lag.
  double distance_to_goal = std::numeric_limits<double>::infinity();
  /// A certificate judges the motion that the model makes of a decision, Eqs. (24), (25).
  MotionModel model = Holonomic{};  // {} would fill the variant with zeros
  /// [θ] rad, counter-clockwise from +x; read where the model is not holonomic
  double heading = 0.0;
  /// > 0: in a pair, A does the part p_B/(p_A + p_B) of the avoidance of both, see
  /// reciprocal_share(). Others have to know it.
  double priority = 1.0;
  /// [b_A] m/s^2, > 0: the deceleration with which it surely brakes, straight, whenever it has to;
  /// others have to know it. Unset: max_acceleration. Where it is less, a decision may ask for more
  /// of max_acceleration. Where it is more, it is for braking alone
  /// (docs/certificate/priorities.md, "Limits of braking").
  std::optional<double> max_braking = {};
  /// For an airplane, the circle that the others know; unset: the circle of position and velocity.
  /// Remember it while the airplane is on it: a circle made anew in each step drifts by rounding.
  std::optional<LoiterCircle> loiter = {};
  /// m, > 0: to the point at which the preferred velocity aims, if that is nearer than the goal. It
  /// is the next corner of the route, or a place in the lane. A car with a footprint maneuvers by
  /// it, because its route turns there.
  double lookahead = std::numeric_limits<double>::infinity();
};

/// What A counts on from a neighbor.
enum class Behavior : std::uint8_t {
  decides,  ///< it calls plan() at the same times: it does its share, and can brake
  /// it reacts to no robot; it keeps its acceleration, as far as max_deviation says: A does all
  moves_on,
  /// It does its share as a robot that decides does, and promises nothing: a robot of another make,
  /// a polite person. Half-planes count on the share. A certificate assumes that it keeps its
  /// velocity, as far as max_deviation says (docs/certificate/movers.md, "Robots that cooperate").
  cooperates,
  /// It never moves and decides nothing: a disc that does not move, and that no robot may touch. As
  /// a Neighbor it is at rest: velocity, acceleration and deviations are 0, without a trajectory.
  parked,
};
AVO_API const char* to_string(Behavior behavior);

/// Another robot B as A senses it, or a moving obstacle. The fields that are read most come first.
struct Neighbor {
  Vec2 position = {};             ///< [p_B] m
  Vec2 velocity = {};             ///< [v_B] m/s
  double radius = 0.5;            ///< [r_B] m, > 0
  double max_acceleration = 1.0;  ///< [a_B^max] m/s^2, > 0; not read where B moves on
  Behavior behavior = Behavior::decides;
  /// [d] whole steps, 0 to kMostAge: the time since it was last sensed. Its state has been
  /// extrapolated since then, at constant velocity, or at its acceleration where it moves on.
  /// Certificate braking_trajectories allows for d Δt of any other motion, besides the declared
  /// SensingError of the sensed state (docs/certificate/errors.md, "Age").
  int age = 0;
  double priority = 1.0;  ///< [p_B] > 0, see Robot::priority; not read where B moves on
  /// [b_B] m/s^2, see Robot::max_braking; not read where B moves on
  std::optional<double> max_braking = {};
  /// The fallback of B, where it decides: B turns right for ever on this circle, and its position
  /// and velocity lie on it. Its age is 0. Unset: B brakes.
  std::optional<LoiterCircle> loiter = {};
  /// [η] m/s^2, >= 0. Where B moves on: its acceleration may at any time differ that much from the
  /// one given. Where B cooperates: it may differ that much from 0. A certificate keeps A clear of
  /// all places where B may then be while A moves. Where B decides and has an age: its
  /// acceleration, if that may be more than max_acceleration. For a car with the exact set it is up
  /// to √2 times as much.
  double max_deviation = 0.0;
  /// m, >= 0: the error of its position beyond the declared SensingError and its age. An example is
  /// an extrapolated car with its body off its axle.
  double position_error = 0.0;
  Vec2 acceleration = {};  ///< [a_B] m/s^2, observed; read only where B moves on
  /// m/s, > 0, where B does not decide: it is never faster. Read only with a max_deviation or a
  /// likely_deviation.
  double max_speed = std::numeric_limits<double>::infinity();
  /// m/s^2, >= 0, where B does not decide: its acceleration is likely to differ that much from the
  /// center of max_deviation. No certificate counts on it. Evasive maneuvers take as much of it
  /// into account as leaves an evasive maneuver (docs/movers.md, "Rule").
  double likely_deviation = 0.0;
  /// Unit, or 0: the direction in which A leaves B, where B does its share and coincides with A in
  /// place and velocity. B must have the opposite direction. The directions of parting_direction()
  /// suit any number of robots. Without it two robots that coincide, and prefer the same velocity,
  /// stay together. It takes the place of the pair's half-plane: it must be 0 for robots that do
  /// not coincide.
  Vec2 parting = {};
  /// Where B moves on: its future places, as far as they are known (docs/movers.md). The
  /// certificate then does not read its acceleration, and max_deviation is about the acceleration
  /// on this trajectory. The trajectory has to stay valid while plan() runs.
  const Trajectory* trajectory = nullptr;
  double trajectory_time = 0.0;  ///< s: the present time on the trajectory's clock; -1e12 to 1e12
  /// Its discs from its position, where it is no disc; `radius` then covers them at any heading.
  /// The centers are along `ahead`.
  Footprint footprint = {};
  Vec2 ahead = {};  ///< unit: along its heading; read only with a footprint
  /// rad, 0 to π: while B brakes, its heading may differ that much from `ahead`. It is 0 for a
  /// robot that brakes along its heading; see braking_pose() for a differential drive.
  double spread = 0.0;
};

/// Returns the direction in which a robot of the first id leaves a robot of the other id, where
/// they coincide. It is a unit vector, opposite if the ids are exchanged, 0 for equal ids. Among
/// any number of robots at one place, each robot leaves all others towards its own side.
AVO_API Vec2 parting_direction(std::uint64_t id, std::uint64_t other);

/// Returns whether A does only a part of what both must do to keep apart.
inline bool shares(const Neighbor& neighbor) {
  return neighbor.behavior == Behavior::decides || neighbor.behavior == Behavior::cooperates;
}
/// Returns whether B does not promise to brake: it is where its motion leads.
inline bool is_predicted(const Neighbor& neighbor) {
  return neighbor.behavior != Behavior::decides;
}

/// Returns whether B has errors besides the declared ones.
inline bool has_errors_of_its_own(const Neighbor& neighbor) {
  return neighbor.age > 0 || neighbor.position_error > 0.0;
}

/// [b] m/s^2, the deceleration with which a robot brakes.
template <typename Robot>
inline double braking_limit(const Robot& robot) {
  return robot.max_braking.value_or(robot.max_acceleration);
}

/// [c] m/s^2, max(a_max, b): the largest change of its velocity in a second, whatever it does.
template <typename Robot>
inline double change_limit(const Robot& robot) {
  return std::max(robot.max_acceleration, braking_limit(robot));
}

/// m/s^2, min(a_max, b): the deceleration for what it foresees, such as its goal.
template <typename Robot>
inline double planned_braking(const Robot& robot) {
  return std::min(robot.max_acceleration, braking_limit(robot));
}

/// Steps: the largest age of a Neighbor.
inline constexpr int kMostAge = 1'000'000;

}  // namespace avo
