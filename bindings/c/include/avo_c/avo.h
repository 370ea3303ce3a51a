/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The C interface of avo: multi-robot collision avoidance that respects acceleration limits. One
 * header, C99 or C++. SI units; angles in rad, counter-clockwise from +x. docs/c.md is its guide.
 *
 * Objects are named by ids. A zeroed id is null and names nothing. An id is stale if its object has
 * been destroyed: functions refuse it, they do not crash.
 *
 * Definitions (avo_*_def, avo_robot, avo_neighbor) come from avo_default_*(), which sets `size`.
 * A program that was compiled with an older version of this header has shorter definitions; members
 * beyond their size have their defaults. A size of 0, or a size that this library does not know, is
 * AVO_ERROR_INVALID_DEFINITION. In an array of definitions all have the size of the first one.
 * Numbers keep their ranges of the C++ interface and of scene files. A number out of range is
 * refused with the text that C++ gives. No number is changed to fit.
 *
 * Every function that can fail returns an avo_result. If that is not AVO_OK, the function writes
 * nothing through its pointers, unless its comment says so. avo_last_error() has the reason. No C++
 * exception leaves.
 *
 * Threads: an object may be used by one thread at a time, different objects by different threads.
 * Functions that take a planner, and those that only read a simulation, may run at the same time on
 * the same object. Nothing else may use an object while it is destroyed.
 */
#ifndef AVO_C_AVO_H
#define AVO_C_AVO_H

/* A foreign function interface that parses this header knows the types of fixed width itself:
 * cc -E -P -DAVO_FOR_FFI avo.h leaves declarations only. */
#ifdef AVO_FOR_FFI
#define AVO_C_API
#else
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#if defined(_WIN32) && defined(AVO_C_EXPORTING) /* while the library is compiled */
#define AVO_C_API __declspec(dllexport)
#elif defined(_WIN32)
#define AVO_C_API __declspec(dllimport)
#elif defined(__GNUC__)
#define AVO_C_API __attribute__((visibility("default")))
#else
#define AVO_C_API
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------------------------- results */

/// The result of a function: one of AVO_OK and AVO_ERROR_*.
typedef int32_t avo_result;
enum {
  AVO_OK = 0,
  AVO_ERROR_INVALID_ID = 1,          ///< null, stale, or of no such object
  AVO_ERROR_INVALID_ARGUMENT = 2,    ///< a null pointer where one is required, a bad count
  AVO_ERROR_INVALID_DEFINITION = 3,  ///< a definition without a size, or with an unknown one
  AVO_ERROR_INVALID_VALUE = 4,     ///< a value out of range, or an edit that would break a promise
  AVO_ERROR_INVALID_SCENE = 5,     ///< a scene, or a key=value, that cannot be used
  AVO_ERROR_FILE = 6,              ///< a file that cannot be read
  AVO_ERROR_BUFFER_TOO_SMALL = 7,  ///< the required size has been written
  AVO_ERROR_OUT_OF_MEMORY = 8,
  AVO_ERROR_UNSUPPORTED = 9,  ///< this library was built without it
  AVO_ERROR_INTERNAL = 10     ///< a fault of the library
};

/// One line on the last call on this thread that failed: where the error is, what was found and
/// what is allowed. "" if none has failed. Never null; valid until the next call on this thread
/// that fails.
AVO_C_API const char* avo_last_error(void);
/// "ok", "invalid id", ...; "unknown result" for any other number. Never null.
AVO_C_API const char* avo_result_text(avo_result result);
/// Version of the library, e.g. "0.1.0".
AVO_C_API const char* avo_version(void);

/* ---------------------------------------------------------------------------------- ids */

typedef struct avo_planner_id {
  uint32_t index;
  uint32_t generation;
} avo_planner_id;

typedef struct avo_navigator_id {
  uint32_t index;
  uint32_t generation;
} avo_navigator_id;

typedef struct avo_reference_tracker_id {
  uint32_t index;
  uint32_t generation;
} avo_reference_tracker_id;

typedef struct avo_trajectory_id {
  uint32_t index;
  uint32_t generation;
} avo_trajectory_id;

typedef struct avo_simulation_id {
  uint32_t index;
  uint32_t generation;
} avo_simulation_id;

typedef struct avo_scene_id {
  uint32_t index;
  uint32_t generation;
} avo_scene_id;

typedef struct avo_team_id {
  uint32_t index;
  uint32_t generation;
} avo_team_id;

/// Name of a robot within its simulation, never reused there. The robots of the definition are
/// 1, 2, ... in its order: the number of the C++ interface and of scene files, plus 1.
typedef struct avo_robot_id {
  uint64_t value;
} avo_robot_id;

/// Name of a static obstacle within its simulation, never reused there. The obstacles of the
/// definition are 1, 2, ... in its order.
typedef struct avo_obstacle_id {
  uint64_t value;
} avo_obstacle_id;

/// Name of a moving obstacle within its simulation, never reused there. The moving obstacles of the
/// definition are 1, 2, ... in its order.
typedef struct avo_moving_obstacle_id {
  uint64_t value;
} avo_moving_obstacle_id;

/* ---------------------------------------------------------------------------------- words */

/// Leaves a member to the library: the method's default, or what the member says.
enum { AVO_UNSET = -1 };

typedef int32_t avo_method;
enum {
  AVO_METHOD_AVO = 0,                ///< half-planes, a certificate, and rules for arriving
  AVO_METHOD_AVO_PAPER = 1,          ///< the paper alone
  AVO_METHOD_VELOCITY_OBSTACLE = 2,  ///< others keep their velocity
  AVO_METHOD_ORCA = 3,               ///< velocities are adopted at once
  AVO_METHOD_ORCA_CLAMPED = 4,       ///< the part of orca's choice that a_max allows within a step
  AVO_METHOD_RECIPROCAL_VELOCITY_OBSTACLE = 5,  ///< obstacles with an apex between both velocities
  AVO_METHOD_BUFFERED_VORONOI = 6,              ///< Voronoi cells less the radius, braking in them
  AVO_METHOD_EXTERNAL = 7,         ///< avo_external_method chooses; velocities are adopted at once
  AVO_METHOD_EXTERNAL_CLAMPED = 8  ///< the part of its choice that a_max allows within a step
};

typedef int32_t avo_certificate;
enum { AVO_CERTIFICATE_NONE = 0, AVO_CERTIFICATE_BRAKING_TRAJECTORIES = 2 };

typedef int32_t avo_motion;
enum { AVO_MOTION_HELD = 0, AVO_MOTION_EXPONENTIAL = 1 };

typedef int32_t avo_clock;
enum { AVO_CLOCK_COMMON = 0, AVO_CLOCK_FREE = 1 };

typedef int32_t avo_right_of_way;
enum { AVO_RIGHT_OF_WAY_NONE = 0, AVO_RIGHT_OF_WAY_SEEN = 1 };

typedef int32_t avo_noise_distribution;
enum { AVO_NOISE_GAUSSIAN = 0, AVO_NOISE_UNIFORM = 1 };

typedef int32_t avo_fill;
enum {
  AVO_FILL_NONE = 0,   ///< robots may be on either side of the walls
  AVO_FILL_SOLID = 1,  ///< robots may not be inside the closed chains
  AVO_FILL_BOUNDS = 2  ///< robots may not be outside the closed chains
};

typedef int32_t avo_behavior;
enum {
  AVO_BEHAVIOR_DECIDES = 0,     ///< it plans as this robot does, at the same times
  AVO_BEHAVIOR_MOVES_ON = 1,    ///< it reacts to no robot
  AVO_BEHAVIOR_COOPERATES = 2,  ///< it does its share, and does not promise to brake
  AVO_BEHAVIOR_PARKED = 3       ///< it never moves; as a neighbor it is at rest
};

typedef int32_t avo_model;
enum {
  AVO_MODEL_HOLONOMIC = 0,
  AVO_MODEL_CAR = 1,
  AVO_MODEL_DIFFERENTIAL_DRIVE = 2,
  AVO_MODEL_AIRPLANE = 3
};

typedef int32_t avo_acceleration_set;
enum { AVO_ACCELERATION_SET_INCIRCLE = 0, AVO_ACCELERATION_SET_EXACT = 1 };

typedef int32_t avo_after_goal;
enum { AVO_AFTER_GOAL_LOITER = 0, AVO_AFTER_GOAL_LEAVE = 1 };

/// How a decision was made.
typedef uint8_t avo_plan_status;
enum {
  AVO_PLAN_OPTIMAL = 0,
  AVO_PLAN_LEAST_UNSAFE = 1,
  /// the certificate refused the next velocity, or it left no evasive maneuver beside a mover:
  /// another one
  AVO_PLAN_REFUSED = 2,
  AVO_PLAN_BRAKING = 3,
  AVO_PLAN_OVERLAPPING = 4,
  /// a known or sensed number is not finite or out of range: the robot brakes
  AVO_PLAN_INVALID_INPUT = 5,
  AVO_PLAN_DETOUR = 6  ///< little of the route is left, see avo::PlanStatus::detour
};

/// What a navigator is about.
typedef uint8_t avo_navigator_status;
enum {
  AVO_NAVIGATOR_IDLE = 0,        ///< it has no goal: it stays where it is, and lets others pass
  AVO_NAVIGATOR_UNDER_WAY = 1,   ///< it moves on its route
  AVO_NAVIGATOR_WAITING = 2,     ///< at a stage
  AVO_NAVIGATOR_REACHED = 3,     ///< the goal is within the tolerances
  AVO_NAVIGATOR_STUCK = 4,       ///< without progress for movement_time_allowance
  AVO_NAVIGATOR_UNREACHABLE = 5  ///< the map leaves no route to its goal
};

/// What the preferred velocity of a robot leads to.
typedef uint8_t avo_guide;
enum {
  AVO_GUIDE_ROUTE = 0,    ///< to its goal, or to the next corner of its route
  AVO_GUIDE_LANE = 1,     ///< to the right-hand lane of a passage of two lanes
  AVO_GUIDE_PASSAGE = 2,  ///< where the right of way at a passage of one lane lets it go
  AVO_GUIDE_BACK = 3,     ///< away from its goal, out of a jam
  AVO_GUIDE_MOVER = 4,    ///< beside a mover at rest that stands on its goal
  AVO_GUIDE_PLACE = 5,    ///< to a place near its goal, which others share or stand on
  AVO_GUIDE_HOST = 6      ///< to what the host says; nowhere before its start_time
};

/// What is proved of a state before a decision.
typedef uint8_t avo_safety_state;
enum { AVO_SAFETY_UNKNOWN = 0, AVO_SAFETY_SAFE = 1, AVO_SAFETY_DOOMED = 2 };

/* ---------------------------------------------------------------------------------- values */

typedef struct avo_vec2 {
  double x;
  double y;
} avo_vec2;

typedef struct avo_sensing_error {
  double position;  ///< m, >= 0
  double velocity;  ///< m/s, >= 0
} avo_sensing_error;

/// Gaussian errors of sensed values, which the half-planes allow for.
typedef struct avo_sensing_noise {
  double position;  ///< m, >= 0
  double velocity;  ///< m/s, >= 0
  double quantile;  ///< standard deviations, >= 0
} avo_sensing_noise;

/// The disc that covers a car's body.
typedef struct avo_car_body {
  double offset;  ///< m, from the rear axle forward to its center; < 0: behind it
  double radius;  ///< m, > 0; 0: there is no body, the disc is about the axle
} avo_car_body;

/// Read where model is AVO_MODEL_CAR. The position is the center of the rear axle.
typedef struct avo_car {
  double wheelbase;      ///< m, > 0
  double max_curvature;  ///< 1/m, > 0; 0: unbounded
  avo_car_body body;
  avo_acceleration_set acceleration_set;
  bool reverse;  ///< may drive backwards
} avo_car;

/// Read where model is AVO_MODEL_DIFFERENTIAL_DRIVE. The position is the middle of the axle.
typedef struct avo_differential_drive {
  double track;  ///< m, > 0, between the wheels
  /// m, > 0, from the axle forward to the point that others sense. 0 for a robot of a simulation:
  /// half of the smaller one of its radius and track.
  double offset;
  double wheel_speed;         ///< m/s, > 0, of each wheel on the ground
  double wheel_acceleration;  ///< m/s^2, > 0, of each wheel
} avo_differential_drive;

/// Read where model is AVO_MODEL_AIRPLANE. It cannot stop.
typedef struct avo_airplane {
  double min_speed;             ///< m/s, > 0
  double lateral_acceleration;  ///< m/s^2, > 0
  avo_after_goal after_goal;
} avo_airplane;

/// Up to five discs of one radius in a row along the heading, which cover a body that is no disc.
/// The position is that of the model: the rear axle of a car, the middle of the axle of a drive.
typedef struct avo_footprint {
  double radius;   ///< m, > 0, of each disc
  double first;    ///< m, from the position forward to the rearmost center
  double spacing;  ///< m, >= 0, from one center to the next
  int32_t discs;   ///< 1 to 5; 0: no footprint, the robot is one disc
} avo_footprint;

/// The heading of a robot with a footprint while it brakes: within `spread` of `ahead`.
typedef struct avo_braking_pose {
  avo_vec2 ahead;  ///< unit
  double spread;   ///< rad
} avo_braking_pose;

/// The circle on which an airplane turns right if it decides nothing better.
typedef struct avo_loiter_circle {
  avo_vec2 center;  ///< m
  double radius;    ///< m, > 0; 0: there is none
} avo_loiter_circle;

/// All points within `radius` of the segment from a to b; a disc where a equals b.
typedef struct avo_wall {
  avo_vec2 a;     ///< m
  avo_vec2 b;     ///< m
  double radius;  ///< m, >= 0
} avo_wall;

/// What a robot remembers from one decision to the next; zeroed before the first one.
typedef struct avo_detour {
  float angle;
  float beside;
  float congestion;
  bool has_arrived;
  bool goal_taken;       ///< others are at rest on its goal, so that it comes to rest near them
  float acceleration_x;  ///< m/s^2, of its last step
  float acceleration_y;
} avo_detour;

/// A decision.
typedef struct avo_plan {
  avo_vec2 new_velocity;  ///< m/s, the command that leads to next_velocity; may exceed max_speed
  /// m/s, at the end of the step: send this to a base that takes velocities
  avo_vec2 next_velocity;
  avo_vec2 acceleration;  ///< m/s^2, at the start of the step
  avo_plan_status status;
  avo_safety_state state;  ///< of the state before the decision; unknown without a certificate
  bool evading;            ///< an evasive maneuver replaces the target: see avo_planner_evasion()
  int32_t neighbor;  ///< if overlapping, index of the neighbor, or -1, as always in a simulation
  int32_t wall;      ///< or index of the wall, or -1, as always in a simulation
  float depth;       ///< m: the overlap, if overlapping, see avo_safety_report
  double violation;  ///< m/s, the distance from the half-planes; 0 if optimal
} avo_plan;

/* ---------------------------------------------------------------------------------- planner */

/// One robot's planner. The methods' defaults are those of avo_default_planner_def().
typedef struct avo_planner_def {
  size_t size;
  avo_method method;
  avo_motion motion;
  double control_time;  ///< s, >= 1e-6
  double time_horizon;  ///< s, > 0
  double time_step;     ///< s, > 0
  int32_t unused;       ///< 0: the place of a removed member
  avo_certificate certificate;
  int32_t max_neighbors;  ///< >= 1, so many nearest neighbors get a half-plane; 0: all
  avo_clock clock;
  avo_sensing_error sensing_error;
  avo_sensing_noise sensing_noise;
  /// s, >= 0, with a free clock, the longest of any other robot; 0: time_step
  double longest_step;
  double arrival_distance;    ///< m, > 0
  double localization_error;  ///< m, >= 0, error of the robot's own place among the walls
  /// >= 0, in max_speed/max_acceleration; 0: at once. 0 except with method avo
  double response_time;
  /// m/s^2, > 0, the part that is used without need; 0: max_acceleration
  double comfort_acceleration;
  /// m/s^3, > 0, the part that is used without need; 0: what follows from response_time
  double comfort_jerk;
  double margin;  ///< m, >= 0, preferred clearance from others; 0 except with method avo
  /// m, >= 0, from the robot's disc, within which all walls are given; INFINITY: all
  double wall_range;
  /// true: movers touch the robot only at rest, always. false: where braking comes too late, a
  /// robot alone among movers may pass in front of one. false except with method avo.
  bool never_swerves;
} avo_planner_def;

/// The robot that decides.
typedef struct avo_robot {
  size_t size;
  avo_vec2 position;            ///< m, the center of its disc
  avo_vec2 velocity;            ///< m/s
  avo_vec2 preferred_velocity;  ///< m/s
  double radius;                ///< m, > 0, of that disc
  double max_acceleration;      ///< m/s^2, > 0
  double max_speed;             ///< m/s, > 0
  double distance_to_goal;      ///< m, to where it comes to rest; infinite: there is no such goal
  double heading;               ///< rad; read where the model is not holonomic
  double priority;              ///< > 0
  double max_braking;           ///< m/s^2, > 0, may exceed max_acceleration; 0: max_acceleration
  avo_loiter_circle loiter;     ///< of an airplane; radius 0: the circle of position and velocity
  avo_car car;
  avo_differential_drive drive;
  avo_airplane airplane;
  avo_model model;
  avo_footprint footprint;  ///< of a car or a drive; radius then covers it at any heading
  /// m, > 0: to where its route turns, such as the next corner, if that is nearer than its goal.
  /// Cars and drives with a footprint maneuver by it. Infinite: its route does not turn
  double lookahead;
} avo_robot;

/// Another robot, or a moving obstacle, as a robot senses it.
typedef struct avo_neighbor {
  size_t size;
  avo_vec2 position;        ///< m
  avo_vec2 velocity;        ///< m/s
  double radius;            ///< m, > 0
  double max_acceleration;  ///< m/s^2, > 0; not read where it moves on
  double priority;          ///< > 0; not read where it moves on
  /// m/s^2, > 0, may exceed max_acceleration; 0: max_acceleration; not read where it moves on
  double max_braking;
  avo_loiter_circle loiter;  ///< its fallback; radius 0: it brakes
  double max_deviation;      ///< m/s^2, >= 0, of its acceleration, where it does not decide
  double position_error;     ///< m, >= 0, in addition to the declared sensing_error
  avo_vec2 acceleration;     ///< m/s^2, observed; read where it moves on
  double max_speed;  ///< m/s, > 0, where it does not decide, with max_deviation; may be infinite
  double
      likely_deviation;  ///< m/s^2, >= 0, where it does not decide; only evasive maneuvers count it
  avo_behavior behavior;
  int32_t age;  ///< steps since it was sensed, 0 to 1 000 000
  /// Unit, or 0: the direction in which the robot leaves this neighbor, where both coincide in
  /// place and velocity; see avo_parting_direction().
  avo_vec2 parting;
  /// Where it moves on: its future places; null: unknown. The trajectory must exist while a call
  /// with this neighbor runs.
  avo_trajectory_id trajectory;
  double trajectory_time;  ///< s: the present time on the trajectory's clock
  /// From its position, where it is no disc; discs 0: none. radius then covers it at any heading.
  avo_footprint footprint;
  avo_braking_pose pose;  ///< read only with a footprint: see avo_planner_braking_pose()
} avo_neighbor;

/// The evasive maneuver that a robot takes in place of its target.
typedef struct avo_evasion {
  /// m/s, the velocity that the evasive maneuver approaches, or holds; 0: it brakes from the start.
  /// The velocity of an airplane where it begins to circle
  avo_vec2 velocity;
  double duration;   ///< s, from the decision: the robot then brakes or circles
  int32_t neighbor;  ///< index of the mover that it evades; -1: the plan is not evading
} avo_evasion;

/// A place at a time.
typedef struct avo_timed_place {
  double time;        ///< s
  avo_vec2 position;  ///< m
} avo_timed_place;

/// What avo_planner_state() proves.
typedef struct avo_safety_report {
  double time;   ///< s: if doomed, the time of contact
  double depth;  ///< m, >= 0: the overlap now, or while all fall back
  /// if doomed, index of the neighbor with the earliest contact; if unknown, of the deepest one; or
  /// -1
  int32_t neighbor;
  int32_t wall;  ///< or index of the wall, or -1
  avo_safety_state state;
} avo_safety_report;

/// The usual options of the method; those of AVO_METHOD_AVO for an unknown method.
AVO_C_API avo_planner_def avo_default_planner_def(avo_method method);
AVO_C_API avo_robot avo_default_robot(void);
AVO_C_API avo_neighbor avo_default_neighbor(void);
/// The direction in which a robot of the first id leaves a robot of the other id, where they
/// coincide. It is a unit vector, opposite if the ids are exchanged, 0 for equal ids.
AVO_C_API avo_vec2 avo_parting_direction(uint64_t id, uint64_t other);

/// The future places of a mover, straight from place to place at constant speed on each leg; times
/// ascend. Before the first place it rests there; after the last place it keeps its last velocity.
/// error: m, >= 0, by which it may be off. repeats_from: s, the time of one of the places. After
/// the last place the mover is, at unknown times, at any place where it was from that time on. NaN:
/// it does not repeat.
AVO_C_API avo_result avo_create_trajectory(const avo_timed_place* places, size_t count,
                                           double error, double repeats_from,
                                           avo_trajectory_id* trajectory);
AVO_C_API avo_result avo_destroy_trajectory(avo_trajectory_id trajectory);
AVO_C_API bool avo_trajectory_is_valid(avo_trajectory_id trajectory);

AVO_C_API avo_result avo_create_planner(const avo_planner_def* def, avo_planner_id* planner);
AVO_C_API avo_result avo_destroy_planner(avo_planner_id planner);
AVO_C_API bool avo_planner_is_valid(avo_planner_id planner);

/// [T_e] s, the time constant with which a robot of these limits (m/s, m/s^2) approaches its
/// target; 0: at once.
AVO_C_API avo_result avo_planner_response_time(avo_planner_id planner, double max_speed,
                                               double max_acceleration, double* time);

/// Decides for one robot among neighbors that plan reciprocally, others that move on, and walls.
/// The plan says AVO_PLAN_INVALID_INPUT where a number of robot, neighbors or walls is out of
/// range: the result is then AVO_OK. detour: the memory of the robot, updated; or null. neighbors
/// and walls may be null where their counts are 0. Scratch memory is kept for each thread: nothing
/// is allocated once it has grown.
AVO_C_API avo_result avo_planner_plan(avo_planner_id planner, const avo_robot* robot,
                                      const avo_neighbor* neighbors, size_t neighbor_count,
                                      const avo_wall* walls, size_t wall_count, avo_detour* detour,
                                      avo_plan* plan);
/// Decides for one robot among movers that do not react.
AVO_C_API avo_result avo_planner_plan_among_movers(avo_planner_id planner, const avo_robot* robot,
                                                   const avo_neighbor* movers, size_t mover_count,
                                                   avo_plan* plan);
/// The evasive maneuver behind `evading` of avo_planner_plan(): the mover that the robot evades,
/// and the evasive maneuver that it takes. detour is not updated.
AVO_C_API avo_result avo_planner_evasion(avo_planner_id planner, const avo_robot* robot,
                                         const avo_neighbor* neighbors, size_t neighbor_count,
                                         const avo_wall* walls, size_t wall_count,
                                         const avo_detour* detour, avo_evasion* evasion);
/// Whether some evasive maneuver is clear of all neighbors that do not decide, if they move as
/// predicted.
AVO_C_API avo_result avo_planner_has_evasive_maneuver(
    avo_planner_id planner, const avo_robot* robot, const avo_neighbor* neighbors,
    size_t neighbor_count, const avo_wall* walls, size_t wall_count, bool* has_evasive_maneuver);
/// What others have to know of a robot with a footprint: avo_neighbor.pose, and its footprint from
/// the center of its disc.
AVO_C_API avo_result avo_planner_braking_pose(avo_planner_id planner, const avo_robot* robot,
                                              avo_braking_pose* pose, avo_footprint* footprint);
/// The fewest discs that cover a rectangle along the heading and exceed its long sides by at most
/// `excess`. offset: m, from the position forward to its center.
AVO_C_API avo_result avo_cover_rectangle(double length, double width, double offset, double excess,
                                         avo_footprint* footprint);
/// The same for a polygon, by its corners in the robot's frame: x along the heading, y to its left.
AVO_C_API avo_result avo_cover_polygon(const avo_vec2* corners, size_t corner_count, double excess,
                                       avo_footprint* footprint);
/// Whether the robot can go on without contact, as far as that is proved.
AVO_C_API avo_result avo_planner_state(avo_planner_id planner, const avo_robot* robot,
                                       const avo_neighbor* neighbors, size_t neighbor_count,
                                       const avo_wall* walls, size_t wall_count,
                                       avo_safety_report* report);

/* ---------------------------------------------------------------------------------- a scene */

/// A robot of a simulation.
typedef struct avo_robot_def {
  size_t size;
  avo_vec2 position;        ///< m
  avo_vec2 velocity;        ///< m/s
  avo_vec2 goal;            ///< m
  double radius;            ///< m, > 0
  double max_speed;         ///< m/s, > 0
  double max_acceleration;  ///< m/s^2, > 0
  double preferred_speed;   ///< m/s, >= 0
  double heading;           ///< rad; not read for holonomic robots
  double priority;          ///< > 0
  double time_step;         ///< s, > 0, its own where the clock is free; 0: the simulation's
  double max_braking;       ///< m/s^2, > 0, may exceed max_acceleration; 0: max_acceleration
  avo_car car;
  avo_differential_drive drive;
  avo_airplane airplane;
  avo_model model;
  uint32_t layers;        ///< bit k: it is in layer k
  uint32_t avoids;        ///< bit k: it avoids robots in layer k
  bool unused;            ///< false: the place of a removed member
  avo_behavior behavior;  ///< what others count on; the goal of a parked one is its position
  int32_t method;         ///< its own avo_method; AVO_UNSET: the simulation's
  /// s, > 0, its own; 0: the simulation's if it has the simulation's method
  double time_horizon;
  double arrival_distance;  ///< m, > 0, its own; 0: the simulation's
  avo_footprint footprint;  ///< of a car or a drive; discs 0: none
  double start_time;        ///< s, >= 0; until then it stands at its start, and others pass it
} avo_robot_def;

/// A disc that reacts to no robot. It moves with constant acceleration, along a path, or as a
/// trajectory says; with a trajectory, position and velocity are not read.
typedef struct avo_moving_obstacle_def {
  size_t size;
  avo_vec2 position;      ///< m
  avo_vec2 velocity;      ///< m/s
  avo_vec2 acceleration;  ///< m/s^2; 0 with max_speed
  double radius;          ///< m, > 0
  double max_deviation;   ///< m/s^2, >= 0
  double max_speed;       ///< m/s, > 0, with max_deviation; 0: unset
  const avo_vec2* path;   ///< m, path_count points, with max_deviation and max_speed
  size_t path_count;
  const avo_timed_place* trajectory;  ///< trajectory_count places by ascending times
  size_t trajectory_count;
} avo_moving_obstacle_def;

/// Walls from each point to the next one; if closed, also from the last point to the first.
typedef struct avo_chain {
  const avo_vec2* points;  ///< m, at least one; a single point is a disc
  size_t point_count;
  bool closed;
} avo_chain;

/// All layers, 0 to 31.
#define AVO_ALL_LAYERS UINT32_C(0xffffffff)

/// A static obstacle.
typedef struct avo_obstacle_def {
  size_t size;
  const avo_chain* chains;
  size_t chain_count;
  double radius;  ///< m, >= 0, of all its walls
  avo_fill fill;
  uint32_t layers;  ///< bit k: robots in layer k heed it; AVO_ALL_LAYERS: every robot does
} avo_obstacle_def;

typedef int32_t avo_team_task;
/// What the robots of a team do together.
enum {
  AVO_TASK_QUEUE = 0,   ///< they stand in a row along `points`, from its head, and move up
  AVO_TASK_FOLLOW = 1,  ///< the first one goes to its goal, the others follow; `points` are slots
  AVO_TASK_PATROL = 2,  ///< each goes from point to point for ever
  AVO_TASK_FLOW = 3     ///< they leave by the nearest exit; `points` are two for each exit
};

/// Robots with one task, see avo_team_lead(). A robot is in one team at most.
typedef struct avo_team_def {
  size_t size;
  avo_team_task task;
  const avo_robot_id* robots;
  size_t robot_count;
  const avo_vec2* points;  ///< m, point_count points; slots: x ahead and y to the left of the first
  size_t point_count;
  double spacing;        ///< m, > 0: between places, robots of a row, goals on an exit; 0: usual
  double service;        ///< s, >= 0, that the first one waits at the head; NAN: until it is served
  double pass_distance;  ///< m, > 0: of a patrol, from a point to go on to the next; 0: usual
} avo_team_def;

/// The error of each coordinate of a measurement.
typedef struct avo_measurement_noise {
  double position;   ///< m, >= 0: standard deviation; for uniform noise the bound
  double velocity;   ///< m/s, >= 0: standard deviation; for uniform noise the bound
  double truncated;  ///< standard deviations of gaussian noise, > 0, <= 8; 0: unset, 3
  avo_noise_distribution distribution;
} avo_measurement_noise;

/// How robots sense others.
typedef struct avo_sensing_model {
  avo_measurement_noise noise;
  double dropped;  ///< 0 to 0.999, share of the measurements that are missed
  int32_t delay;   ///< steps, 0 to 100, from a measurement to the decision
  bool occlusion;  ///< a robot is not sensed if its center is behind an obstacle
} avo_sensing_model;

/// The error of each coordinate of a robot's own place.
typedef struct avo_localization_noise {
  double position;   ///< m, >= 0: standard deviation; for uniform noise the bound
  double truncated;  ///< see avo_measurement_noise
  avo_noise_distribution distribution;
} avo_localization_noise;

/// Calls task(task_context, index, worker) once for each index in [0, count), in any order, and
/// returns when all calls have returned. The worker is less than the `workers` of the definition.
/// No two calls at the same time have the same worker. The task takes no lock that the host could
/// hold, and calls nothing of the host. This function must not call anything of the simulation that
/// steps, and must not be left by an exception or longjmp. It is called for two tasks or more, with
/// one worker as well, from 256 robots on. The thread that steps does single tasks and small fleets
/// itself.
typedef void avo_task(void* task_context, size_t index, size_t worker);
typedef void avo_run_tasks(void* run_context, size_t count, avo_task* task, void* task_context);

/// What the robots of an external method know when they decide, by ascending id. One entry for each
/// robot, neighbor or wall; valid during the call.
typedef struct avo_method_batch {
  size_t size;       ///< of this struct, bytes
  double time;       ///< s, now
  double time_step;  ///< s, until the robots decide again
  size_t robot_count;
  const avo_robot_id* id;
  const avo_vec2* position;            ///< m, the centers of their discs
  const avo_vec2* velocity;            ///< m/s
  const avo_vec2* preferred_velocity;  ///< m/s, to the goal, around walls with navigation
  const avo_vec2* goal;                ///< m
  const double* radius;                ///< m
  const double* max_speed;             ///< m/s
  const double* max_acceleration;      ///< m/s^2
  const double* max_braking;           ///< m/s^2
  const double* heading;               ///< rad; of robots that are not holonomic
  /// Robot i senses the neighbors first_neighbor[i] up to before first_neighbor[i + 1], nearest
  /// first, and the walls first_wall[i] up to before first_wall[i + 1], in no order.
  const size_t* first_neighbor;
  const size_t* first_wall;
  size_t neighbor_count;
  const avo_vec2* neighbor_position;        ///< m
  const avo_vec2* neighbor_velocity;        ///< m/s
  const double* neighbor_radius;            ///< m
  const double* neighbor_max_acceleration;  ///< m/s^2; 0: it moves on
  const uint8_t* neighbor_behavior;         ///< of avo_behavior
  size_t wall_count;
  const avo_wall* wall;
} avo_method_batch;

/// Chooses a velocity for each robot of the batch, m/s; they are the preferred ones before the
/// call. The thread that steps calls it once in a step. Any other result than 0 ends the step,
/// which moved no robot. It must not step or change the simulation that asks it: these calls fail
/// meanwhile.
typedef int32_t avo_external_method(void* context, const avo_method_batch* batch,
                                    avo_vec2* velocities);

/// A simulation: the settings of a scene, its robots and obstacles, and its threads. Pointers are
/// read while the simulation is made, not later; but run_tasks, run_context, external and
/// external_context are used as long as it lives.
typedef struct avo_simulation_def {
  size_t size;
  const char* name;         ///< of the scene, for avo_summary alone; null: ""
  double time_step;         ///< s, > 0
  double duration;          ///< s, >= time_step: of a whole run, see avo_simulation_can_step_by()
  double control_time;      ///< s, > 0; 0: the method's
  double time_horizon;      ///< s, > 0; 0: the method's
  double sensing_radius;    ///< m, > 0; 0: the radius that the robots need
  double arrival_distance;  ///< m, > 0
  double longest_step;      ///< s, > 0, where the clock is free; 0: the longest of the robots
  uint64_t seed;            ///< of sensing and of clocks
  int32_t max_neighbors;    ///< >= 1; 0: all
  avo_method method;
  int32_t unused;               ///< 0: the place of a removed member
  avo_certificate certificate;  ///< AVO_UNSET: the method's
  avo_motion motion;
  avo_clock clock;
  int32_t navigation;  ///< 0: no, 1: yes; AVO_UNSET: where there are static obstacles
  avo_right_of_way right_of_way;
  avo_sensing_model sensing;
  /// that robots declare; both NAN: the error that follows from sensing
  avo_sensing_error sensing_error;
  /// Robots may start, be added and be moved where they break the assumptions of the certificate,
  /// as onto others.
  bool allow_broken_assumptions;

  const avo_robot_def* robots;
  size_t robot_count;
  const avo_moving_obstacle_def* moving_obstacles;
  size_t moving_obstacle_count;
  const avo_obstacle_def* obstacles;
  size_t obstacle_count;

  /// 0 to 1024; 0: as many as processors that this process may use. Read where run_tasks is null
  int32_t threads;
  int32_t workers;                      ///< 1 to 1024, of run_tasks
  avo_run_tasks* run_tasks;             ///< the host's own threads; null: those of the library
  void* run_context;                    ///< for run_tasks
  bool metrics;                         ///< judge every step, for avo_simulation_summary()
  avo_localization_noise localization;  ///< robots know their velocity and heading exactly
  double response_time;                 ///< see avo_planner_def; NAN: the method's
  double comfort_acceleration;          ///< see avo_planner_def; 0: none
  double comfort_jerk;                  ///< see avo_planner_def; 0: none
  double margin;                        ///< see avo_planner_def
  bool never_swerves;                   ///< see avo_planner_def
  const avo_team_def* teams;            ///< that each step leads
  size_t team_count;
  /// 1 to 64 bytes, where some robots have an external method: its name in saved states; or null
  const char* external_method;
  avo_external_method* external;  ///< its function; null: avo_simulation_set_external() gives it
  void* external_context;         ///< for the function
  /// how the bases of all robots execute commands; null: exactly
  const struct avo_execution_model* execution;
  double execution_error;  ///< m, >= 0, added to radii where execution is set; NAN: its bound
} avo_simulation_def;

AVO_C_API avo_robot_def avo_default_robot_def(void);
AVO_C_API avo_moving_obstacle_def avo_default_moving_obstacle_def(void);
AVO_C_API avo_obstacle_def avo_default_obstacle_def(void);
AVO_C_API avo_team_def avo_default_team_def(void);
AVO_C_API avo_simulation_def avo_default_simulation_def(void);

/// Loads the scene of a built-in name, e.g. "circle-100", or of a file. overrides: override_count
/// times "key=value" on a key of the scene; null where there are none. AVO_ERROR_UNSUPPORTED in a
/// library that was built without scene files.
AVO_C_API avo_result avo_load_scene(const char* name_or_path, const char* const* overrides,
                                    size_t override_count, avo_scene_id* scene);
/// Makes a scene from `length` bytes of YAML. Messages begin with `file`, and files that the scene
/// names are relative to it.
AVO_C_API avo_result avo_parse_scene(const char* yaml, size_t length, const char* file,
                                     const char* const* overrides, size_t override_count,
                                     avo_scene_id* scene);
AVO_C_API avo_result avo_destroy_scene(avo_scene_id scene);
AVO_C_API bool avo_scene_is_valid(avo_scene_id scene);
/// Writes the scene as a definition, to change and to simulate. Its pointers point to memory of the
/// scene, valid until the scene is destroyed. Set def->size before, as avo_default_simulation_def()
/// does. The other members are overwritten.
AVO_C_API avo_result avo_scene_get_def(avo_scene_id scene, avo_simulation_def* def);

/* ---------------------------------------------------------------------------------- simulation */

/// m: the sensing radius that the robots of a definition need, whatever its sensing_radius. The
/// certificate refuses a smaller one, and a larger one costs time. A sensing_radius of 0 means this
/// value.
AVO_C_API avo_result avo_needed_sensing_radius(const avo_simulation_def* def, double* radius);

AVO_C_API avo_result avo_create_simulation(const avo_simulation_def* def,
                                           avo_simulation_id* simulation);
/// Within a function that a step of the simulation calls it is AVO_ERROR_INVALID_VALUE.
AVO_C_API avo_result avo_destroy_simulation(avo_simulation_id simulation);
AVO_C_API bool avo_simulation_is_valid(avo_simulation_id simulation);

/// One sensing-acting cycle of all robots. The result has the same bits for any number of threads
/// or workers. The calling thread alone steps a fleet of less than 256. Airplanes that have arrived
/// may leave. Where memory runs out, either no robot has moved, or every later step fails until a
/// state is restored. The same holds where run_tasks breaks its contract. Where memory runs out for
/// metrics alone, the step is done, and the metrics end.
AVO_C_API avo_result avo_simulation_step(avo_simulation_id simulation);

/// Sets the function behind the simulation's external_method. A simulation that was made from a
/// saved state needs it.
AVO_C_API avo_result avo_simulation_set_external(avo_simulation_id simulation,
                                                 avo_external_method* external, void* context);

/// Adds a robot. Its number is greater than all before. It is refused where the certificate cannot
/// keep it from others or obstacles, unless the definition has allow_broken_assumptions. Moving a
/// robot is refused in the same cases.
AVO_C_API avo_result avo_simulation_add_robot(avo_simulation_id simulation,
                                              const avo_robot_def* def, avo_robot_id* robot);
AVO_C_API avo_result avo_simulation_remove_robot(avo_simulation_id simulation, avo_robot_id robot);
/// The goal that it has already changes nothing.
AVO_C_API avo_result avo_simulation_set_goal(avo_simulation_id simulation, avo_robot_id robot,
                                             avo_vec2 goal);
/// Puts the robot down elsewhere, at rest; an airplane keeps its velocity. It keeps its number and
/// forgets what it remembers of its route.
AVO_C_API avo_result avo_simulation_move_robot(avo_simulation_id simulation, avo_robot_id robot,
                                               avo_vec2 position);
/// Changes what the robot can do and how it behaves. All of the definition is taken but position,
/// velocity, heading, goal and model; another model and another time_step are refused. A robot at
/// rest can be parked where it stands, and a parked robot set free; its goal is then its place.
/// Otherwise it is refused as in add_robot. Take the present definition from
/// avo_simulation_get_robot_def().
AVO_C_API avo_result avo_simulation_change_robot(avo_simulation_id simulation, avo_robot_id robot,
                                                 const avo_robot_def* def);
/// The preferred velocity, m/s, that the robot has from now on, in place of a route to its goal;
/// null: it goes to its goal again. Meanwhile it is never at its goal.
AVO_C_API avo_result avo_simulation_set_preferred_velocity(avo_simulation_id simulation,
                                                           avo_robot_id robot,
                                                           const avo_vec2* velocity);
/// Moves the robot from now on: after each step it has this velocity, m/s, at most its max_speed.
/// It decides nothing, and others keep clear of it alone; null: it brakes, and then decides again.
/// A robot in motion is not touched by it as long as the velocity changes by at most
/// max_acceleration * time_step a step. It is refused as in change_robot.
AVO_C_API avo_result avo_simulation_set_velocity(avo_simulation_id simulation, avo_robot_id robot,
                                                 const avo_vec2* velocity);
/// The same calls for `count` robots: one goal, velocity or definition for each robot. Where one of
/// them is refused, nothing has changed. avo_simulation_add_robots() writes the ids of the robots.
AVO_C_API avo_result avo_simulation_set_goals(avo_simulation_id simulation,
                                              const avo_robot_id* robots, const avo_vec2* goals,
                                              size_t count);
AVO_C_API avo_result avo_simulation_set_preferred_velocities(avo_simulation_id simulation,
                                                             const avo_robot_id* robots,
                                                             const avo_vec2* velocities,
                                                             size_t count);
AVO_C_API avo_result avo_simulation_add_robots(avo_simulation_id simulation,
                                               const avo_robot_def* defs, size_t count,
                                               avo_robot_id* robots);
AVO_C_API avo_result avo_simulation_remove_robots(avo_simulation_id simulation,
                                                  const avo_robot_id* robots, size_t count);
/// A person, a vehicle or a player comes. It is refused if some robot cannot keep clear of it.
AVO_C_API avo_result avo_simulation_add_moving_obstacle(avo_simulation_id simulation,
                                                        const avo_moving_obstacle_def* def,
                                                        avo_moving_obstacle_id* obstacle);
/// Its place, velocity, radius, limits and path are those of the definition from now on. Nothing is
/// promised of what the host changes faster than max_deviation and max_speed allow.
AVO_C_API avo_result avo_simulation_change_moving_obstacle(avo_simulation_id simulation,
                                                           avo_moving_obstacle_id obstacle,
                                                           const avo_moving_obstacle_def* def);
AVO_C_API avo_result avo_simulation_remove_moving_obstacle(avo_simulation_id simulation,
                                                           avo_moving_obstacle_id obstacle);
/// A door closes. The call takes at most as long as making the simulation.
AVO_C_API avo_result avo_simulation_add_obstacle(avo_simulation_id simulation,
                                                 const avo_obstacle_def* def,
                                                 avo_obstacle_id* obstacle);
/// A door opens.
AVO_C_API avo_result avo_simulation_remove_obstacle(avo_simulation_id simulation,
                                                    avo_obstacle_id obstacle);

/// Writes the state into the buffer of `capacity` bytes, and the number of bytes to *size. If there
/// are too many, it also writes *size and returns AVO_ERROR_BUFFER_TOO_SMALL. Without a buffer
/// (null) it only writes the size, AVO_OK. The bytes are the same on every machine.
AVO_C_API avo_result avo_simulation_save(avo_simulation_id simulation, void* buffer,
                                         size_t capacity, size_t* size);
/// Goes back, or forth, to a state that this simulation or another one of the same settings has
/// saved. Changes nothing where it fails. Metrics begin anew, or end where
/// memory runs out for them.
AVO_C_API avo_result avo_simulation_restore(avo_simulation_id simulation, const void* saved,
                                            size_t size);
/// Makes a simulation that continues from a saved state. Only threads, workers, run_tasks and
/// run_context of def are read; null: the defaults. metrics is AVO_ERROR_UNSUPPORTED here.
AVO_C_API avo_result avo_create_simulation_from_saved(const void* saved, size_t size,
                                                      const avo_simulation_def* def,
                                                      avo_simulation_id* simulation);

/// Columns of the present generation: `count` entries each, one for each robot, by ascending id.
/// They belong to the simulation and are valid until the next call that changes it (step, add,
/// remove, change, set_goal, set_preferred_velocity, set_velocity, move_robot, restore, destroy).
typedef struct avo_columns {
  size_t count;
  const avo_robot_id* id;
  const avo_vec2* position;            ///< m
  const avo_vec2* velocity;            ///< m/s
  const double* heading;               ///< rad
  const avo_vec2* goal;                ///< m
  const avo_plan* plan;                ///< of its last decision; zeroed before the first
  const avo_detour* detour;            ///< what it remembers
  const double* applied_acceleration;  ///< m/s^2, the largest |a| within the last step
} avo_columns;

/// Columns of the moving obstacles, by ascending id; they are valid as long as avo_columns.
typedef struct avo_moving_obstacle_columns {
  size_t count;
  const avo_vec2* position;    ///< m
  const avo_vec2* velocity;    ///< m/s
  const uint32_t* next_point;  ///< index into its path of the point that it moves to
} avo_moving_obstacle_columns;

AVO_C_API avo_result avo_simulation_columns(avo_simulation_id simulation, avo_columns* columns);
AVO_C_API avo_result avo_simulation_moving_obstacles(avo_simulation_id simulation,
                                                     avo_moving_obstacle_columns* columns);

/// Values of one robot. AVO_ERROR_INVALID_ID where it does not exist, or no longer.
AVO_C_API avo_result avo_simulation_get_position(avo_simulation_id simulation, avo_robot_id robot,
                                                 avo_vec2* position);
AVO_C_API avo_result avo_simulation_get_velocity(avo_simulation_id simulation, avo_robot_id robot,
                                                 avo_vec2* velocity);
AVO_C_API avo_result avo_simulation_get_heading(avo_simulation_id simulation, avo_robot_id robot,
                                                double* heading);
AVO_C_API avo_result avo_simulation_get_goal(avo_simulation_id simulation, avo_robot_id robot,
                                             avo_vec2* goal);
AVO_C_API avo_result avo_simulation_get_plan(avo_simulation_id simulation, avo_robot_id robot,
                                             avo_plan* plan);
AVO_C_API avo_result avo_simulation_get_applied_acceleration(avo_simulation_id simulation,
                                                             avo_robot_id robot,
                                                             double* acceleration);
/// Whether it is within arrival_distance of its goal now, with no wall between. It also counts if
/// it rests as near as others at rest leave room, where their goals are too close together for all
/// of them.
AVO_C_API avo_result avo_simulation_is_at_goal(avo_simulation_id simulation, avo_robot_id robot,
                                               bool* is_at_goal);
/// s: when the robot decides next; infinite if it is parked.
AVO_C_API avo_result avo_simulation_get_next_decision(avo_simulation_id simulation,
                                                      avo_robot_id robot, double* time);
/// The preferred velocity that the host gave to the robot, m/s. *is_set: whether there is one; if
/// not, *velocity is not written.
AVO_C_API avo_result avo_simulation_get_preferred_velocity(avo_simulation_id simulation,
                                                           avo_robot_id robot, avo_vec2* velocity,
                                                           bool* is_set);
/// The velocity of set_velocity, until it is taken back, in the same way.
AVO_C_API avo_result avo_simulation_get_host_velocity(avo_simulation_id simulation,
                                                      avo_robot_id robot, avo_vec2* velocity,
                                                      bool* is_set);
/// Whether the host moves the robot by set_velocity, or the robot brakes since it was given back.
/// It decides nothing meanwhile.
AVO_C_API avo_result avo_simulation_is_moved(avo_simulation_id simulation, avo_robot_id robot,
                                             bool* is_moved);
/// Whether the robot decided in the last step.
AVO_C_API avo_result avo_simulation_decided(avo_simulation_id simulation, avo_robot_id robot,
                                            bool* decided);
/// m: from the nearest place that the robot can reach, where its route ends, to its goal. 0 where
/// no wall keeps it from its goal.
AVO_C_API avo_result avo_simulation_get_distance_left(avo_simulation_id simulation,
                                                      avo_robot_id robot, double* distance);
/// The rest of a robot's route.
typedef struct avo_route {
  double length;         ///< m; infinite for robots that avo_simulation_unreachable() lists
  avo_vec2 next;         ///< m, its next point, a corner of a wall or its end
  double distance_left;  ///< m, see avo_simulation_get_distance_left()
} avo_route;
/// The shortest route that the robot knows: around walls with navigation, else straight.
AVO_C_API avo_result avo_simulation_get_route(avo_simulation_id simulation, avo_robot_id robot,
                                              avo_route* route);
/// The robot for which another robot waits at a passage of one lane.
typedef struct avo_wait {
  bool waits;          ///< if false, the other members have no meaning
  avo_vec2 passage;    ///< m, the middle of its axis
  avo_robot_id robot;  ///< the robot that comes towards it, or stands in its path
  bool inside;         ///< whether that robot is in the passage
  avo_vec2 a, b;       ///< m, the two sides of the passage where it is narrowest
} avo_wait;
AVO_C_API avo_result avo_simulation_get_wait(avo_simulation_id simulation, avo_robot_id robot,
                                             avo_wait* wait);
/// The decision that the robot would make now, in words, with the reason and the names of those
/// that cause it. It is one or two sentences in UTF-8, with a 0 at the end. Buffer, capacity and
/// size are those of avo_simulation_save(). AVO_ERROR_INVALID_VALUE for a parked robot.
AVO_C_API avo_result avo_simulation_explain(avo_simulation_id simulation, avo_robot_id robot,
                                            char* buffer, size_t capacity, size_t* size);
/// The robot's row in the columns. The row differs from the value of the id.
AVO_C_API avo_result avo_simulation_index_of(avo_simulation_id simulation, avo_robot_id robot,
                                             size_t* index);
/// The robot's definition with its present position, velocity, heading and goal; all other values
/// are as defined. def->size must be set.
AVO_C_API avo_result avo_simulation_get_robot_def(avo_simulation_id simulation, avo_robot_id robot,
                                                  avo_robot_def* def);

AVO_C_API avo_result avo_simulation_get_time(avo_simulation_id simulation, double* time);  ///< s
AVO_C_API avo_result avo_simulation_get_steps(avo_simulation_id simulation, int64_t* steps);
/// m: how far robots sense. Where the definition says 0, an added robot that needs more makes it
/// grow.
AVO_C_API avo_result avo_simulation_get_sensing_radius(avo_simulation_id simulation,
                                                       double* radius);
AVO_C_API avo_result avo_simulation_get_robot_count(avo_simulation_id simulation, size_t* count);
/// A number that changes whenever robots come, go or are restored. As long as it stays, the ids
/// and, except states and goals, the definitions stay.
AVO_C_API avo_result avo_simulation_get_roster(avo_simulation_id simulation, uint64_t* roster);
/// The number that a step may use: threads of the library, or workers of the host.
AVO_C_API avo_result avo_simulation_get_threads(avo_simulation_id simulation, int32_t* threads);
/// Whether the next step ends by that time, s. A whole run steps while this is true for `duration`.
AVO_C_API avo_result avo_simulation_can_step_by(avo_simulation_id simulation, double time,
                                                bool* can_step);
AVO_C_API avo_result avo_simulation_all_at_goal(avo_simulation_id simulation, bool* all_at_goal);
/// Equal for equal states, bit by bit: the hash of the C++ interface.
AVO_C_API avo_result avo_simulation_get_state_hash(avo_simulation_id simulation, uint64_t* hash);
/// Robots that cannot reach their goals even alone, by ascending id. For a goal too near to a wall,
/// no place within arrival_distance may be in reach either. They go as near as they can. It writes
/// as many ids as fit into the buffer's `capacity`. *count: the number of such robots; without a
/// buffer (null) it only writes that. AVO_ERROR_BUFFER_TOO_SMALL if there are too many: *count is
/// written.
AVO_C_API avo_result avo_simulation_unreachable(avo_simulation_id simulation, avo_robot_id* buffer,
                                                size_t capacity, size_t* count);
/// Robots with discs within `radius`, m, of the point, the nearest disc first. buffer and
/// count are those of avo_simulation_unreachable().
AVO_C_API avo_result avo_simulation_robots_within(avo_simulation_id simulation, avo_vec2 center,
                                                  double radius, avo_robot_id* buffer,
                                                  size_t capacity, size_t* count);
/// The robots with the discs nearest to the point, nearest first: at most `capacity`.
AVO_C_API avo_result avo_simulation_nearest_robots(avo_simulation_id simulation, avo_vec2 position,
                                                   avo_robot_id* buffer, size_t capacity,
                                                   size_t* count);
/// Whether a disc of that radius, m, > 0, would touch no robot, no moving obstacle and no wall
/// there. It must not be inside a solid or outside of bounds either. layers, here and below: only
/// robots that are in one of them count, and static obstacles that a robot in them heeds. All
/// moving obstacles and parked robots count.
AVO_C_API avo_result avo_simulation_is_free(avo_simulation_id simulation, avo_vec2 position,
                                            double radius, uint32_t layers, bool* is_free);
/// What a ray, or a moving disc, touches first. At most one id is not 0; all are 0 where it touches
/// nothing.
typedef struct avo_hit {
  double distance;  ///< m, from the start; the whole length where it touches nothing
  avo_vec2 center;  ///< m, of the disc then
  avo_robot_id robot;
  avo_moving_obstacle_id moving_obstacle;
  avo_obstacle_id obstacle;
} avo_hit;
/// A disc of that radius, m, >= 0, moves straight from one point to the other.
AVO_C_API avo_result avo_simulation_cast_ray(avo_simulation_id simulation, avo_vec2 from,
                                             avo_vec2 to, double radius, uint32_t layers,
                                             avo_hit* hit);
/// Whether no static obstacle stops a disc of that radius, m, >= 0, on the straight line between
/// the points.
AVO_C_API avo_result avo_simulation_is_in_sight(avo_simulation_id simulation, avo_vec2 from,
                                                avo_vec2 to, double radius, uint32_t layers,
                                                bool* is_in_sight);
/// The present moving obstacles, by ascending id, as their columns. buffer and count are those of
/// avo_simulation_unreachable().
AVO_C_API avo_result avo_simulation_moving_obstacle_ids(avo_simulation_id simulation,
                                                        avo_moving_obstacle_id* buffer,
                                                        size_t capacity, size_t* count);
/// The present static obstacles, by ascending id. buffer and count are those of
/// avo_simulation_unreachable().
AVO_C_API avo_result avo_simulation_obstacles(avo_simulation_id simulation, avo_obstacle_id* buffer,
                                              size_t capacity, size_t* count);
/// Definitions of obstacles that are there; a moving one has its present position and velocity.
/// They point to memory of the simulation, valid until the next call that changes it. def->size
/// must be set.
AVO_C_API avo_result avo_simulation_get_moving_obstacle_def(avo_simulation_id simulation,
                                                            avo_moving_obstacle_id obstacle,
                                                            avo_moving_obstacle_def* def);
AVO_C_API avo_result avo_simulation_get_obstacle_def(avo_simulation_id simulation,
                                                     avo_obstacle_id obstacle,
                                                     avo_obstacle_def* def);

typedef int32_t avo_event_kind;
/// In the order in which the events of one robot are listed.
enum {
  AVO_EVENT_GONE = 0,     ///< the robot was removed, or it is an airplane that left
  AVO_EVENT_CAME = 1,     ///< the robot was added
  AVO_EVENT_LEFT = 2,     ///< it was at its goal, and was pushed away, is steered, or has a new one
  AVO_EVENT_ARRIVED = 3,  ///< it is at its goal, and was not; a new goal counts anew
  AVO_EVENT_UNREACHABLE = 4,  ///< walls keep it from its goal, and did not; a new goal counts anew
  AVO_EVENT_STUCK = 5,  ///< it makes no progress; once, until it gets on again or has a new goal
  /// its disc overlaps that of a moving obstacle, or of a robot that the host moves, and did not
  AVO_EVENT_CONTACT = 6
};

/// What happened to one robot.
typedef struct avo_event {
  avo_event_kind kind;
  avo_robot_id robot;
  avo_moving_obstacle_id moving_obstacle;  ///< of a contact with one; else a null id
  bool at_rest;                            ///< of a contact: the robot has not moved in the step
  avo_robot_id moved_robot;  ///< of a contact with a robot that the host moves; else a null id
} avo_event;

/// Begins to watch the robots, or begins anew. Each step then has the events since the step before,
/// those of edits and of a restore too. What holds now is no event. stuck_after, s: a robot that
/// makes no progress for so long is stuck; 0: 3 s. If memory runs out for events alone, the step is
/// done, and the events end.
AVO_C_API avo_result avo_simulation_watch(avo_simulation_id simulation, double stuck_after);
/// The events of the last step, by robot and then by kind. buffer and count are those of
/// avo_simulation_unreachable(). AVO_ERROR_UNSUPPORTED if the simulation is not watched.
AVO_C_API avo_result avo_simulation_events(avo_simulation_id simulation, avo_event* buffer,
                                           size_t capacity, size_t* count);
/// Why the robot of that event is stuck, in the words of avo_simulation_explain() at that time; ""
/// of other events. event: an index into the events of the last step. Buffer, capacity and size are
/// those of avo_simulation_save().
AVO_C_API avo_result avo_simulation_event_sentence(avo_simulation_id simulation, size_t event,
                                                   char* buffer, size_t capacity, size_t* size);

/* ---------------------------------------------------------------------------------- teams */

typedef int32_t avo_formation;
enum {
  AVO_FORMATION_LINE = 0,    ///< side by side
  AVO_FORMATION_COLUMN = 1,  ///< one behind the other
  AVO_FORMATION_WEDGE = 2,   ///< a V with its point ahead
  AVO_FORMATION_BLOCK = 3,   ///< rows, as wide as deep
  AVO_FORMATION_RING = 4     ///< on a circle
};

/// Writes `count` slots of a formation, m, about `center`. It faces `heading`, rad; neighboring
/// slots are at least `spacing` apart, m, > 0.
AVO_C_API avo_result avo_formation_slots(avo_formation formation, size_t count, double spacing,
                                         avo_vec2 center, double heading, avo_vec2* slots);
/// Writes `count` slots, m, turned by `heading`, rad, and moved so that their origin is at
/// `center`. placed may be slots.
AVO_C_API avo_result avo_place_slots(const avo_vec2* slots, size_t count, avo_vec2 center,
                                     double heading, avo_vec2* placed);
/// Writes for each of `count` places the index of its slot. The sum of the distances is then least,
/// and no two of the lines cross. slot_count >= count.
AVO_C_API avo_result avo_assign_slots(const avo_vec2* positions, size_t count,
                                      const avo_vec2* slots, size_t slot_count, size_t* chosen);
/// Sends each robot to a slot as avo_assign_slots() says. Where it fails, nothing has changed.
AVO_C_API avo_result avo_simulation_form_up(avo_simulation_id simulation,
                                            const avo_robot_id* robots, size_t count,
                                            const avo_vec2* slots, size_t slot_count);

/// A team that the host leads. The simulation leads the teams of its own definition.
AVO_C_API avo_result avo_create_team(const avo_team_def* def, avo_team_id* team);
/// The number of teams that the simulation leads: those of its definition.
AVO_C_API avo_result avo_simulation_team_count(avo_simulation_id simulation, size_t* count);
/// The team of that number, 0 for the first one, for the functions below. The simulation leads it;
/// avo_destroy_team() destroys only this id.
AVO_C_API avo_result avo_simulation_team(avo_simulation_id simulation, size_t number,
                                         avo_team_id* team);
/// *task: the task, without robots. Its points are valid until the task changes or the team is
/// gone.
AVO_C_API avo_result avo_team_get_task(avo_team_id team, avo_team_def* task);
/// Gives the team another task, of a definition; its robots are not read. The robots keep the
/// goals that they had before they joined. Where it fails, nothing has changed.
AVO_C_API avo_result avo_team_set_task(avo_team_id team, avo_simulation_id simulation,
                                       const avo_team_def* task);
AVO_C_API avo_result avo_destroy_team(avo_team_id team);
AVO_C_API bool avo_team_is_valid(avo_team_id team);
/// Sets goals and preferred velocities of the robots for the next step: call it before each step.
/// Robots that are gone leave the team.
AVO_C_API avo_result avo_team_lead(avo_team_id team, avo_simulation_id simulation);
/// The first robot of a queue goes to its own goal, the others move up. Writes the id of the first
/// robot: null if the team is empty or not a queue.
AVO_C_API avo_result avo_team_serve(avo_team_id team, avo_simulation_id simulation,
                                    avo_robot_id* robot);
/// The robots go to their own goals again, and the team is empty.
AVO_C_API avo_result avo_team_disband(avo_team_id team, avo_simulation_id simulation);
/// Another robot joins, as the last one.
AVO_C_API avo_result avo_team_add(avo_team_id team, avo_robot_id robot);
/// The robot leaves the team. Its goal stays as the team has set it.
AVO_C_API avo_result avo_team_remove(avo_team_id team, avo_robot_id robot);
/// The robots of the team, of a queue from its head. buffer and count are those of
/// avo_simulation_unreachable().
AVO_C_API avo_result avo_team_robots(avo_team_id team, avo_robot_id* buffer, size_t capacity,
                                     size_t* count);

/// Metrics by published definitions (docs/metrics.md). A trip belongs to a robot that is not
/// parked, and lasts until it first arrives. NAN: no data.
typedef struct avo_run_metrics {
  int64_t trips;
  int64_t collision_robot_steps;  ///< with another robot, as in collision_pairs
  double overlap_depth;           ///< the deepest, as a part of both radii; 0: none
  double success;                 ///< share of trips: no overlap, within 3 ideal times
  double collision;               ///< share of trips with an overlap
  double timeout;                 ///< share of the other trips
  /// s, excess of the duration of trips that end over their ideal times
  double extra_time_mean;
  double extra_time_p75;
  double extra_time_p90;
  double flowtime;  ///< s, sum of all trips' times; only if all have arrived
  /// mean over trips that end: length divided by the length of the shortest route
  double path_ratio;
  double effort;            ///< m^2/s^3, mean of the trips' integrals of |a|^2
  double acceleration_rms;  ///< |a|/a_max, root mean square over all trips' time
  double jerk;              ///< m/s^3, root mean square over all trips' steps
  double reversals;         ///< of the acceleration, mean number a trip
  /// Share of the steps in motion in which the acceleration turned by more than 135 degrees from
  /// the step before, both of more than 0.3 a_max.
  double turned_back;
  double efficacy;       ///< mean speed along the route, divided by the preferred speed
  double deadlock_time;  ///< s, mean time a trip without progress
} avo_run_metrics;

/// The results of a run since it began or was restored.
typedef struct avo_summary {
  size_t size;
  int64_t robots;
  int64_t parked;  ///< parked robots among them; they have arrived where they stand
  int64_t steps;
  int64_t arrived;               ///< robots that were ever at their goals
  int64_t collision_pairs;       ///< pairs of robots that ever overlapped and avoid each other
  int64_t one_sided_collisions;  ///< pairs in which only one robot avoids the other
  /// the pairs among them that overlapped in a step in which that one moved
  int64_t one_sided_collisions_in_motion;
  int64_t mover_collisions;  ///< (robot, moving obstacle) pairs
  /// the pairs among them that overlapped in a step in which the robot moved
  int64_t mover_collisions_in_motion;
  int64_t static_collisions;    ///< robots that touched a static obstacle
  int64_t first_seen_too_late;  ///< pairs; -1 without a certificate
  /// robot-steps with half-planes that had no point in common
  int64_t infeasible_steps;
  int64_t unreachable;          ///< robots
  int64_t decisions[7];         ///< robot-steps, by avo_plan_status
  double first_collision_time;  ///< s; NAN: none
  double min_clearance;         ///< m, between robots that avoid each other; NAN: there are none
  double min_static_clearance;  ///< m, from static obstacles; NAN: there are none
  double max_acceleration;      ///< m/s^2, the largest applied |a|
  double acceleration_excess;   ///< m/s^2, the largest |a| - max(a_max, b); 0 if kept
  double max_speed;             ///< m/s
  double mean_arrival;          ///< s, over robots that arrived; NAN: none
  double last_arrival;          ///< s; NAN: not all have arrived
  avo_run_metrics metrics;
  /// The mover_collisions in which the robot had an evasive maneuver when it first sensed the
  /// obstacle; -1 without a certificate.
  int64_t mover_collisions_evadable;
} avo_summary;

AVO_C_API avo_summary avo_default_summary(void);
/// AVO_ERROR_UNSUPPORTED where the definition did not ask for metrics. summary->size must be set.
AVO_C_API avo_result avo_simulation_summary(avo_simulation_id simulation, avo_summary* summary);

/* ---------------------------------------------------------------------------------- navigator */

/// How a base executes velocity commands: T dv/dt = w(t - d) + e - v, with the command w and an
/// error |e| <= velocity_error. T and d are constant, and known with the errors given. Each
/// coordinate is executed by itself: x and y of a holonomic base, the wheels of a differential
/// drive. All are 0 of a base that executes exactly.
typedef struct avo_execution_model {
  double time_constant;            ///< [T] s, >= 0, of the velocity's first-order lag
  double time_constant_error;      ///< s, 0 to T
  double dead_time;                ///< [d] s, >= 0, from command to effect
  double dead_time_error;          ///< s, 0 to d
  double deadband;                 ///< m/s, >= 0: the base executes a slower coordinate as 0
  double quantum;                  ///< m/s, >= 0: coordinates are whole multiples; 0: any
  double velocity_error;           ///< [e] m/s, >= 0
  double heading_age;              ///< s, >= 0, of the heading of avo_drive_command()
  double measured_position_error;  ///< m, >= 0, of the body
  double measured_velocity_error;  ///< m/s, >= 0, of the body
} avo_execution_model;

/// How far a base is from its reference at most.
typedef struct avo_execution_error {
  double position;  ///< m: the robot's disc is larger by this, for itself and for others
  double velocity;  ///< m/s: others that sense the base add both to their sensing error
  double command;   ///< m/s: the base, or each wheel, must accept commands of this speed
} avo_execution_error;

/// What a base is told for the next time_step.
typedef struct avo_base_command {
  /// m/s: a holonomic base gets this velocity, a differential drive gets avo_drive_command() of it
  avo_vec2 velocity;
  avo_vec2 next_reference;  ///< m, where the reference is at the next decision
  avo_vec2 next_velocity;   ///< m/s, its velocity then
  double deviation;         ///< m, of the body from the reference at the decision
  bool has_left;            ///< it was more than the bound: the reference begins anew at the body
} avo_base_command;

/// What a differential drive is told.
typedef struct avo_wheel_command {
  double speed;         ///< m/s, of the middle of its axle
  double turning_rate;  ///< rad/s, counter-clockwise
} avo_wheel_command;

/// The bounds for a robot of these limits.
AVO_C_API avo_result avo_find_execution_error(const avo_execution_model* model,
                                              const avo_robot* robot, double time_step,
                                              avo_execution_error* error);
/// To be called at each cycle of the wheels' controller, with the present body.
AVO_C_API avo_result avo_drive_command(const avo_execution_model* model, const avo_robot* body,
                                       avo_vec2 velocity, avo_wheel_command* command);

/// Keeps the reference of one robot beside avo_planner_plan(), and makes its base follow the
/// reference. A navigator with an execution has one itself. The planner is not needed afterwards.
AVO_C_API avo_result avo_create_reference_tracker(const avo_execution_model* model,
                                                  avo_planner_id planner,
                                                  avo_reference_tracker_id* tracker);
AVO_C_API avo_result avo_destroy_reference_tracker(avo_reference_tracker_id tracker);
AVO_C_API bool avo_reference_tracker_is_valid(avo_reference_tracker_id tracker);
/// The robot to plan for in place of the measured body. reference->size must be set.
AVO_C_API avo_result avo_reference_tracker_reference(avo_reference_tracker_id tracker,
                                                     const avo_robot* body, avo_robot* reference);
/// The command for the plan of that robot: to be called once every time_step.
AVO_C_API avo_result avo_reference_tracker_follow(avo_reference_tracker_id tracker,
                                                  const avo_robot* body, const avo_plan* plan,
                                                  avo_base_command* command);
/// The reference begins anew at the body, as when the robot was moved by hand.
AVO_C_API avo_result avo_reference_tracker_forget(avo_reference_tracker_id tracker);
/// For the largest limits that the robot has had so far.
AVO_C_API avo_result avo_reference_tracker_error(avo_reference_tracker_id tracker,
                                                 const avo_robot* body, avo_execution_error* error);

/// One robot on board: its route, the right of way at passages, and its goal. Robots of a fleet
/// agree on what their planners share, on the map, and on fleet_radii.
typedef struct avo_navigator_def {
  size_t size;
  double preferred_speed;  ///< m/s, >= 0; AVO_UNSET: max_speed
  uint64_t id;  ///< its number among the robots, which breaks ties, and names it in words
  const double* fleet_radii;  ///< m, > 0: of all robots of the fleet, or null
  size_t fleet_radius_count;
  double xy_goal_tolerance;         ///< m, > 0; 0: the planner's arrival_distance
  double yaw_goal_tolerance;        ///< rad, > 0
  double required_movement_radius;  ///< m, > 0
  double movement_time_allowance;   ///< s, > 0
  double route_tolerance;           ///< m, > 0, of a given route; 0: 0.3 of the radius
  avo_right_of_way right_of_way;
  bool navigation;  ///< routes lead around the obstacles of the map
  uint32_t layers;  ///< bit k: it is in layer k; of the map it heeds the obstacles of its layers
  /// How the base executes commands; null: exactly. If given, the robot of a step is the body as it
  /// is measured, and the command of the decision is for the base.
  const avo_execution_model* execution;
} avo_navigator_def;

/// A place on a mission.
typedef struct avo_stage {
  avo_vec2 position;  ///< m
  double wait;        ///< s, >= 0, that it rests there; 0: it passes; INFINITY: until go_on
} avo_stage;

/// One decision of a navigator.
typedef struct avo_navigator_decision {
  avo_plan plan;
  avo_vec2 preferred_velocity;  ///< m/s
  double route_left;            ///< m
  double distance_left;         ///< m, from the end of the route to the goal
  double stopping_distance;     ///< m, that it needs to brake from its present velocity
  double without_progress;      ///< s
  avo_vec2 passage;             ///< m, where it waits for another robot
  int32_t waits_for;            ///< index of that robot in the neighbors given; -1: none
  avo_navigator_status status;
  avo_guide guide;
  bool has_command;          ///< where the definition has an execution
  avo_base_command command;  ///< send this in place of the plan then
  bool inside;               ///< whether the robot that it waits for is in the passage
  avo_vec2 a, b;             ///< m, the two sides of the passage where it is narrowest
} avo_navigator_decision;

AVO_C_API avo_navigator_def avo_default_navigator_def(void);
/// planner: the options of its planner. obstacles: the map; null where their count is 0.
AVO_C_API avo_result avo_create_navigator(const avo_planner_def* planner,
                                          const avo_navigator_def* def,
                                          const avo_obstacle_def* obstacles, size_t obstacle_count,
                                          avo_navigator_id* navigator);
AVO_C_API avo_result avo_destroy_navigator(avo_navigator_id navigator);
AVO_C_API bool avo_navigator_is_valid(avo_navigator_id navigator);
/// heading: rad, in which a robot with wheels is to stand there; NAN: any. is_shared: others have
/// the same goal.
AVO_C_API avo_result avo_navigator_set_goal(avo_navigator_id navigator, avo_vec2 goal,
                                            double heading, bool is_shared);
/// Follows a route of another planner, of two points, m, or more.
AVO_C_API avo_result avo_navigator_set_route(avo_navigator_id navigator, const avo_vec2* points,
                                             size_t count, double heading);
/// Goes by the map from stage to stage.
AVO_C_API avo_result avo_navigator_set_stages(avo_navigator_id navigator, const avo_stage* stages,
                                              size_t count, double heading);
AVO_C_API avo_result avo_navigator_go_on(avo_navigator_id navigator);  ///< ends a wait
AVO_C_API avo_result avo_navigator_clear_goal(avo_navigator_id navigator);
/// Another map: a door has closed or opened, or the robot is in other layers now; 0: it stays in
/// its layers.
AVO_C_API avo_result avo_navigator_set_obstacles(avo_navigator_id navigator,
                                                 const avo_obstacle_def* obstacles,
                                                 size_t obstacle_count, uint32_t layers);
/// One cycle, every time_step. preferred_velocity and distance_to_goal of the robot are not read.
/// time: s, of any clock that does not go back.
AVO_C_API avo_result avo_navigator_step(avo_navigator_id navigator, const avo_robot* robot,
                                        const avo_neighbor* neighbors, size_t neighbor_count,
                                        double time, avo_navigator_decision* decision);
/// The decision that it would make now in words, as avo_simulation_explain(). Neighbors are named
/// by their indices.
AVO_C_API avo_result avo_navigator_explain(avo_navigator_id navigator, const avo_robot* robot,
                                           const avo_neighbor* neighbors, size_t neighbor_count,
                                           char* buffer, size_t capacity, size_t* size);
/// m: the corners of the route that is left, to its end. buffer and count are those of
/// avo_simulation_unreachable().
AVO_C_API avo_result avo_navigator_route(avo_navigator_id navigator, avo_vec2* buffer,
                                         size_t capacity, size_t* count);
/// What the robot remembers.
AVO_C_API avo_result avo_navigator_get_detour(avo_navigator_id navigator, avo_detour* detour);
/// m: how far a robot with such a planner has to sense such others. has_map: with passages.
AVO_C_API avo_result avo_sensing_range(const avo_planner_def* planner, const avo_robot* robot,
                                       const avo_robot* others, size_t other_count, bool has_map,
                                       double* range);
/// m: walls with a surface farther off change no decision.
AVO_C_API avo_result avo_wall_range(const avo_planner_def* planner, const avo_robot* robot,
                                    double* range);

#ifdef __cplusplus
}
#endif

#endif
