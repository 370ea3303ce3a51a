// SPDX-License-Identifier: Apache-2.0
// What a motion model is to all others: what it makes of a decision, how far that may be from what
// it falls back on, which decisions it can follow, and where it steers. An airplane falls back
// on a circle (src/robots/airplane.h), every other robot on straight braking of its disc
// (src/certificate/braking_path.h).
//
// All of it is about the robot's disc, see disc_center(). Models are told apart in src/robots
// alone.
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

struct MotionLimits {
  double planned_braking;  // m/s^2, with which a car stops that has to turn in place
  double max_speed;        // m/s
};

/// One step of a robot that is not holonomic, exactly; of state.position its disc's center.
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

/// The same robot in the midst of such a step, see within() in robots/motion.h.
MotionState within(const MotionModel& model, const MotionState& from, const MotionState& to,
                   double time, double duration);

/// How far any two decisions may lead apart, besides what holonomic motion makes of them.
struct Stray {
  double velocity = 0.0;  // of the mean of what a step adds and braking takes off at most; 0: as
                          // holonomic ones
  double distance = 0.0;  // m, within the step
};
Stray stray_of(const MotionModel& model, double max_acceleration, double time_step);

/// What others who see it in the midst of a step of that length, and expect of it what a_max does
/// to the velocity of its disc, may be off by in place and velocity.
SensingError unforeseen(const MotionModel& model, double max_acceleration, double time_step);

/// m/s, over whole steps: by how much the velocity of its disc may differ from that of its axle,
/// which is not faster than top_speed.
double swing_of(const MotionModel& model, double max_acceleration, double top_speed,
                double time_step);

/// m/s: that its disc never exceeds, where the robot itself keeps to max_speed.
double fastest_of(const MotionModel& model, double max_speed);

/// Whether its disc moves otherwise than its axle.
bool swings(const MotionModel& model);

/// Whether a decision could lead it farther than others expect of its acceleration: it has to keep
/// to that.
bool may_exceed_reach(const MotionModel& model);

/// [1, √2]: of the decisions, |v' - v| is at most that much of a_max times the time.
double reach_of(const MotionModel& model);

/// The half-planes of v' that the robot can follow, where a disc about v does not say it all:
/// Fig. 6(b). Velocities that are reached after `time` s.
void append_own_half_planes(const Robot& robot, double time, std::vector<HalfPlane>& half_planes);

/// How a goal is come to.
struct Approach {
  bool at_once;        // a wish is gone for as fast as the limits allow, and not approached with δ
  double time_step;    // s
  double near_enough;  // m, from the goal, to stay there
};

/// m/s: the preferred velocity as the model can go about it. One that can turn in place, or that is
/// holonomic, heads for it at once.
Vec2 steered(const Robot& robot, const Approach& approach);
/// m/s: v, or what comes near it of the directions that the robot can turn to while it drives.
Vec2 within_steering(const Robot& robot, Vec2 v);

/// m/s, of one at rest that turns in place: v, where necessary so far off its heading to the same
/// side that it turns before it drives.
Vec2 turning_first(const Robot& robot, Vec2 v);

/// What leads a maneuvering car to a place: what it does already, what it would begin with, or what
/// comes later.
enum class Nearness : std::uint8_t { begun, next, later };
/// Whether the disc may be at a place.
using ClearPlaces = std::function<bool(Vec2 place, Nearness nearness)>;
struct ManeuverMemory;  // robots/maneuver_memory.h
/// m/s: beside what is in the way, instead of steered().
std::optional<Vec2> maneuver(const Robot& robot, const Approach& approach, bool is_beside,
                             const ClearPlaces& is_clear, ManeuverMemory& memory);
/// m, from its disc, of what may be in the way; 0: it needs none.
double room_for_maneuvers(const MotionModel& model);

/// m/s, after a step that a_max changes by u: what the program is given.
double top_speed_of(const Robot& robot, double u);
/// m/s: v, or what comes near it of the velocities that the robot can have after `time` s.
Vec2 within_own_limits(const Robot& robot, double time, Vec2 v);

/// m/s: what comes nearest to w within `increment` of its velocity, of those velocities.
Vec2 approached(const Robot& robot, double time, double increment, Vec2 w);

bool has_own_half_planes(const MotionModel& model);
/// Whether these do not say it all: what it can follow is asked of within_own_limits().
bool has_limits_within_steps(const MotionModel& model);
inline bool has_own_limits(const MotionModel& model) {
  return has_own_half_planes(model) || has_limits_within_steps(model);
}

/// append_own_half_planes() appends no more.
inline constexpr std::size_t kMostOwnPlanes = 4;

/// Whether it cannot stop: it comes to its goal by passing it, at its preferred speed.
bool passes_goal(const MotionModel& model);
/// Whether it leaves the scene once it has passed its goal.
bool leaves_at_goal(const MotionModel& model);
/// m: how near a step of one that passes its goal comes to it.
double pass(const MotionModel& model, const MotionLimits& limits, const MotionState& state,
            const Plan& plan, double time_step, Vec2 goal);
/// The circle that it falls back on; none of one that brakes.
std::optional<LoiterCircle> circle_of(const MotionModel& model, Vec2 position, Vec2 velocity);
/// m: farther from its center than its disc and braking reach, what it may need to fall back on.
double room_to_turn(const MotionModel& model, double max_speed);
/// m/s: with which it starts that is said to be at rest.
double least_speed(const MotionModel& model);

/// Whether it turns before it drives where it is at rest.
bool turns_in_place(const MotionModel& model);
/// Whether it may move against its heading.
bool can_reverse(const MotionModel& model);
/// Whether every number is finite and in range, and the model keeps up with these limits; of the
/// acceleration, change_limit().
bool is_valid(const MotionModel& model, double most_change, double max_speed);

}  // namespace avo::inline robots
