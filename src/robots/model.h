// SPDX-License-Identifier: Apache-2.0
// The interface of motion models for all other code. It has what a model answers, the motion after
// a decision, and its distance from the fallback. It also has the decisions that a robot can
// follow, and its steering. A robot that cannot rest falls back on a circle (src/robots/flight.h),
// every other robot on straight braking of its disc (src/certificate/braking_path.h).
//
// Everything is about the robot's disc, see disc_center(). Other code asks for what a model can do
// (model_traits()), and for values that only one model has.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "avo/half_plane.h"
#include "avo/planner.h"
#include "avo/robot.h"
#include "robots/motion.h"

namespace avo::inline robots {

/// What a model answers about a robot, by default as for a holonomic robot. The public answers are
/// is_holonomic(), can_rest() and moves_along_heading(). model.cpp has one row for each model.
struct ModelTraits {
  bool turns_in_place = false;       // it turns before it drives when it is at rest
  bool can_reverse = false;          // it may move against its heading
  bool leaves_at_goal = false;       // it leaves the scene after it has passed its goal
  bool swings = false;               // its disc moves differently from its axle
  bool has_own_half_planes = false;  // append_own_half_planes() limits its v'
  // half-planes do not suffice: within_own_limits() decides which velocities it can follow
  bool has_limits_within_steps = false;
  double reach = 1.0;        // [1, √2]: |v' - v| is at most this times a_max times the time
  double speed_ratio = 1.0;  // >= 1: the speed of its disc is at most this times max_speed
  double least_speed = 0.0;  // m/s: its start speed if it should start at rest
  // m, from its disc: the range of obstacles of its maneuvers; 0: it does not maneuver
  double maneuver_room = 0.0;
};
/// The row of a model that is not holonomic.
ModelTraits own_traits(const MotionModel& model);
// Nearly all robots are holonomic, for which the compiler knows the answers.
inline ModelTraits model_traits(const MotionModel& model) {
  return is_holonomic(model) ? ModelTraits{} : own_traits(model);
}

/// Returns whether a decision could lead it farther than others expect from its acceleration: it
/// must then keep their expectation.
inline bool may_exceed_reach(const ModelTraits& traits) {
  return traits.swings || traits.reach > 1.0;
}

struct MotionLimits {
  double planned_braking;  // m/s^2, with which a car stops if it must turn in place
  double max_speed;        // m/s
};

/// One exact step of a robot that is not holonomic; state.position is its disc's center.
MotionStep advance(const MotionModel& model, const MotionLimits& limits, const MotionState& state,
                   const Plan& plan, double time_step);

/// One of several such steps that are made together.
struct ModelStep {
  const MotionModel* model;
  MotionLimits limits;
  MotionState state;
  const Plan* plan;
  MotionStep result = {};
};
inline constexpr std::size_t kMostModelSteps = 16;
/// At most kMostModelSteps of them.
void advance_together(std::span<ModelStep> steps, double time_step);

/// The same step of each disc of the robot's footprint. state.position is that of the robot.
/// step.next.position is as far from it as the disc has moved. For a drive it is the robot's own
/// step alone, without the turn of its discs.
void advance_discs(const MotionModel& model, const MotionLimits& limits, const MotionState& state,
                   const Plan& plan, double time_step, std::span<MotionStep> discs);

/// The heading while the robot brakes, on a path of that length, m.
BrakingPose turn_while_braking(const MotionModel& model, Vec2 velocity, double heading,
                               double length);
/// The heading within a step, where the discs of a footprint may be anywhere within the spread.
/// None for a robot if advance_discs() has followed its discs on their paths.
std::optional<BrakingPose> turn_within(const MotionModel& model, const MotionState& from,
                                       const MotionState& to, double time_step);

/// The same robot within such a step, see within() in robots/motion.h.
MotionState within(const MotionModel& model, const MotionState& from, const MotionState& to,
                   double time, double duration);

/// The largest distance between the motions of any two decisions, beyond that of holonomic motion.
struct Stray {
  // factor on the mean of the largest velocities that a step adds and that braking takes off; 0: as
  // for holonomic robots
  double velocity = 0.0;
  double distance = 0.0;  // m, within the step
};
Stray stray_of(const MotionModel& model, double max_acceleration, double time_step);

/// The errors in place and velocity of others that see it within a step of that length. They expect
/// the effect of a_max on the velocity of its disc.
SensingError unforeseen(const MotionModel& model, double max_acceleration, double time_step);

/// m/s, over whole steps: the largest difference between the velocities of its disc and of its
/// axle. The axle is not faster than top_speed.
double swing_of(const MotionModel& model, double max_acceleration, double top_speed,
                double time_step);

/// Appends the half-planes of v' that the robot can follow, where a disc about v does not suffice:
/// Fig. 6(b). The velocities are reached after `time` s.
void append_own_half_planes(const Robot& robot, double time, std::vector<HalfPlane>& half_planes);

/// How a goal is approached.
struct Approach {
  bool at_once;        // a wish is approached as fast as the limits allow, and not with δ
  double time_step;    // s
  double near_enough;  // m, from the goal: near enough to stay
};

/// m/s: the preferred velocity that the model can steer to. A robot that can turn in place, or that
/// is holonomic, moves straight to its target.
Vec2 steered(const Robot& robot, const Approach& approach);
/// m/s: v, or a velocity near it in a direction that the robot can turn to while it drives.
Vec2 within_steering(const Robot& robot, Vec2 v);

/// m/s, for a robot at rest that turns in place: v, if necessary turned off its heading to the same
/// side. The angle is so large that the robot turns before it drives.
Vec2 turning_first(const Robot& robot, Vec2 v);

/// How soon a maneuvering car comes to a place: by its present move, by a first new move, or later.
enum class Nearness : std::uint8_t { begun, next, later };
/// Returns whether the disc, or the discs of a footprint, may be at a place in a heading (unit).
using ClearPlaces = std::function<bool(Vec2 place, Vec2 heading, Nearness nearness)>;
struct ManeuverMemory;  // robots/maneuver_memory.h
/// m/s: the velocity beside obstacles, in place of steered().
std::optional<Vec2> maneuver(const Robot& robot, const Approach& approach, bool is_beside,
                             const ClearPlaces& is_clear, ManeuverMemory& memory);

/// m/s, after a step that a_max changes by u: the limit for the program.
double top_speed_of(const Robot& robot, double u);
/// m/s: v, or a velocity near it that the robot can have after `time` s.
Vec2 within_own_limits(const Robot& robot, double time, Vec2 v);

/// m/s: the velocity nearest to w within `increment` of its velocity, among the velocities that it
/// can have.
Vec2 approached(const Robot& robot, double time, double increment, Vec2 w);

/// append_own_half_planes() appends at most so many.
inline constexpr std::size_t kMostOwnPlanes = 4;

/// m: the least distance from the goal of a step of a robot that cannot rest.
double pass(const MotionModel& model, const MotionLimits& limits, const MotionState& state,
            const Plan& plan, double time_step, Vec2 goal);
/// The circle that it falls back on; none for a robot that brakes.
std::optional<LoiterCircle> circle_of(const MotionModel& model, Vec2 position, Vec2 velocity);
/// m: the additional distance from its center, beyond its disc and braking, that its fallback may
/// need.
double room_to_turn(const MotionModel& model, double max_speed);
/// m: the radius of the tightest curve that it drives; 0: it may turn on the spot, or nearly so.
double turning_radius(const MotionModel& model);
/// m: how far the point that is planned for is ahead of the axle that it tows; 0: it tows none.
double towed_length(const MotionModel& model);
/// m: the radius with which its routes are found, for a disc of the other radius: that of each disc
/// of its footprint.
double route_radius(const MotionModel& model, double radius);
/// Returns whether every number is finite and in range, and the model allows these limits; the
/// acceleration is change_limit().
bool is_valid(const MotionModel& model, double most_change, double max_speed);

}  // namespace avo::inline robots
