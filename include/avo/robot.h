// SPDX-License-Identifier: Apache-2.0
// What a robot knows of itself and senses of the others (paper §IV-D). SI units.
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "avo/export.h"
#include "avo/model.h"
#include "avo/trajectory.h"
#include "avo/vec.h"

namespace avo {

/// rad, of the velocity off the heading of a robot with wheels: more is PlanStatus::invalid_input.
/// What is rounded to float keeps within it; others predict the car's braking that much off, 2 µm
/// after 2 m.
inline constexpr double kHeadingTolerance = 1e-6;

/// Robot A, the one that decides.
struct Robot {
  Vec2 position = {};             ///< [p_A] m, the center of its disc: see disc_center()
  Vec2 velocity = {};             ///< [v_A] m/s; of a differential drive that of this center
  Vec2 preferred_velocity = {};   ///< [v_A^pref] m/s
  double radius = 0.5;            ///< [r_A] m, > 0, of that disc
  double max_acceleration = 1.0;  ///< [a_A^max] m/s^2, > 0
  double max_speed = 2.0;         ///< [v_A^max] m/s, > 0
  /// m left to where it comes to rest, where it has such a goal. Method avo then makes no detours
  /// on the last of it, and follows a preferred velocity that brakes there without a lag.
  double distance_to_goal = std::numeric_limits<double>::infinity();
  /// A certificate judges what the model makes of a decision, Eqs. (24), (25).
  MotionModel model = Holonomic{};  // {} would fill the variant with zeros
  double heading = 0.0;  ///< [θ] rad, counter-clockwise from +x; read where it is not holonomic
  /// > 0: of a pair, A takes the part p_B/(p_A + p_B) of what both have to do, see
  /// reciprocal_share(). Others have to know it.
  double priority = 1.0;
  /// [b_A] m/s^2, > 0: with which it surely brakes, straight, whenever it has to, and others have
  /// to know it; unset: max_acceleration. Where it is less, a decision may ask for more of that;
  /// where it is more, it is for braking alone (docs/certificate/priorities.md, "Limits of
  /// braking").
  std::optional<double> max_braking = {};
  /// Of an airplane, the circle that the others know of it; unset: that of position and velocity.
  /// Remember it while the airplane is on it: made anew in each step, it drifts by rounding.
  std::optional<LoiterCircle> loiter = {};
};

/// What A counts on from another one.
enum class Behavior : std::uint8_t {
  decides,   ///< calls plan() at the same times: does its share, and can brake
  moves_on,  ///< reacts to nobody; keeps its acceleration, as far as max_deviation says: A does all
  /// Does its share as one that decides, and promises nothing: a robot of another make, a polite
  /// person. Half-planes count on the share. A certificate takes it to keep its velocity, as far as
  /// max_deviation says (docs/certificate/movers.md, "Robots that cooperate").
  cooperates,
};
AVO_API const char* to_string(Behavior behavior);

/// Another robot B as A senses it, or a moving obstacle. What is read of most comes first.
struct Neighbor {
  Vec2 position = {};             ///< [p_B] m
  Vec2 velocity = {};             ///< [v_B] m/s
  double radius = 0.5;            ///< [r_B] m, > 0
  double max_acceleration = 1.0;  ///< [a_B^max] m/s^2, > 0; not read where B moves on
  Behavior behavior = Behavior::decides;
  /// [d] whole steps, 0 to kMostAge: how long ago it was last sensed. It has been carried on since:
  /// at constant velocity, or at its acceleration where it moves on. braking_trajectories then
  /// allows for d Δt of whatever else it may have done, besides the declared SensingError of what
  /// was sensed (docs/certificate/errors.md, "Age").
  int age = 0;
  double priority = 1.0;  ///< [p_B] > 0, see Robot::priority; not read where B moves on
  /// [b_B] m/s^2, see Robot::max_braking; likewise
  std::optional<double> max_braking = {};
  /// What B falls back on, where it decides: to turn right on this circle for ever, which its
  /// position and velocity lie on. Its age is 0. Unset: to brake.
  std::optional<LoiterCircle> loiter = {};
  /// [η] m/s^2, >= 0. Of one that moves on: its acceleration may at any time be that far from the
  /// one given; of one that cooperates, from 0. A certificate keeps A clear of wherever it may then
  /// be while A moves. Of one that decides, and has an age: its acceleration, where that may be
  /// more than max_acceleration, as that of a car with the exact set, which is up to √2 times as
  /// much.
  double max_deviation = 0.0;
  /// m, >= 0: by how much more its position may be off than the declared SensingError and its age
  /// say, as that of a car whose body is off its axle, and which has been carried on.
  double position_error = 0.0;
  Vec2 acceleration = {};  ///< [a_B] m/s^2, observed; read only where B moves on
  /// m/s, > 0, of one that does not decide: it is never faster. Read only with a max_deviation
  /// or a likely_deviation.
  double max_speed = std::numeric_limits<double>::infinity();
  /// m/s^2, >= 0: of one that does not decide: its acceleration may well be that far from the one
  /// that max_deviation goes out from. No certificate counts on it; ways out reckon with as much of
  /// it as leaves a way (docs/movers.md, "Rule").
  double likely_deviation = 0.0;
  /// Unit, or 0: of one that does its share, and that coincides with A in place and velocity, the
  /// direction in which A leaves it; B has to mean the opposite one. That of parting_direction()
  /// suits any number of robots. Without it two that coincide, and wish for the same, stay one. It
  /// is in place of the pair's half-plane: of those that do not coincide it has to be 0.
  Vec2 parting = {};
  /// Of one that moves on: where it will be, as far as that is known (docs/movers.md). Then the
  /// certificate does not read its acceleration, and max_deviation is about the one on this
  /// trajectory. It has to stay while plan() runs.
  const Trajectory* trajectory = nullptr;
  double trajectory_time = 0.0;  ///< s: now, as the trajectory tells the time; -1e12 to 1e12
};

/// The direction in which a robot of the first id leaves one of the other id, where they coincide:
/// unit, the opposite one if the ids are exchanged, 0 of equal ids. Of any number of robots at one
/// place each leaves all others towards its own side.
AVO_API Vec2 parting_direction(std::uint64_t id, std::uint64_t other);

/// Whether A does a part only of what the two have to do to keep apart.
inline bool shares(const Neighbor& neighbor) {
  return neighbor.behavior != Behavior::moves_on;
}
/// Whether nobody counts on it to brake: it is where its motion leads.
inline bool is_predicted(const Neighbor& neighbor) {
  return neighbor.behavior != Behavior::decides;
}

/// Whether other errors are allowed for than the declared ones.
inline bool has_errors_of_its_own(const Neighbor& neighbor) {
  return neighbor.age > 0 || neighbor.position_error > 0.0;
}

/// [b] m/s^2, with which a robot brakes.
template <typename Robot>
inline double braking_limit(const Robot& robot) {
  return robot.max_braking.value_or(robot.max_acceleration);
}

/// [c] m/s^2, max(a_max, b): by which its velocity may change, whatever it does.
template <typename Robot>
inline double change_limit(const Robot& robot) {
  return std::max(robot.max_acceleration, braking_limit(robot));
}

/// m/s^2, min(a_max, b): with which it slows down for what it sees coming, such as its goal.
template <typename Robot>
inline double planned_braking(const Robot& robot) {
  return std::min(robot.max_acceleration, braking_limit(robot));
}

/// Of a Neighbor, steps.
inline constexpr int kMostAge = 1'000'000;

}  // namespace avo
