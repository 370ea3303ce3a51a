/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Robots in three dimensions (docs/space.md): decisions, simulations, and set points of quadrotors.
 * The rules of avo.h apply. z points upwards.
 */
#ifndef AVO_C_SPACE_H
#define AVO_C_SPACE_H

#include "avo.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------------------------- values */

typedef struct avo_vec3 {
  double x;
  double y;
  double z;
} avo_vec3;

/// All points within `radius` of a box that is turned about the vertical. Infinite bounds make a
/// floor, a ceiling, or a wall at all heights.
typedef struct avo_space_box {
  avo_vec3 min;    ///< m, in the frame of the box
  avo_vec3 max;    ///< m, >= min
  double heading;  ///< rad, counter-clockwise from above, about the origin
  double radius;   ///< m, >= 0
} avo_space_box;

/// What a robot remembers from one decision to the next; zeroed before the first one.
typedef struct avo_space_detour {
  float angle;
  float beside;
  float congestion;
  bool has_arrived;
  bool goal_taken;        ///< others are at rest on its goal
  avo_vec3 acceleration;  ///< m/s^2, of its last step
} avo_space_detour;

/// A decision.
typedef struct avo_space_plan {
  avo_vec3 new_velocity;   ///< m/s, the command that leads to next_velocity
  avo_vec3 next_velocity;  ///< m/s, at the end of the step
  avo_vec3 acceleration;   ///< m/s^2, at the start of the step
  avo_plan_status status;
  avo_safety_state state;  ///< of the state before the decision
  int32_t neighbor;        ///< if overlapping, index of the neighbor, or -1, as in a simulation
  int32_t box;             ///< or index of the box, or -1, as always in a simulation
  int32_t mover;           ///< or index of the mover, or -1, as always in a simulation
  float depth;             ///< m: the overlap, if overlapping
  double violation;        ///< m/s, the distance from the half-spaces; 0 if optimal
  bool evading;            ///< an evasive maneuver has replaced the robot's own choice
} avo_space_plan;

/* ---------------------------------------------------------------------------------- planner */

/// The robot that decides. Its limits along the vertical are `vertical` times the horizontal ones.
typedef struct avo_space_robot {
  size_t size;
  avo_vec3 position;            ///< m, the center of its ball
  avo_vec3 velocity;            ///< m/s
  avo_vec3 preferred_velocity;  ///< m/s
  double radius;                ///< m, > 0
  double max_acceleration;      ///< m/s^2, > 0
  double max_speed;             ///< m/s, > 0
  double vertical;              ///< > 0
  double climb;                 ///< m/s, > 0: the largest upward speed; may be infinite
  double sink;                  ///< m/s, > 0: the largest downward speed; may be infinite
  double downwash;              ///< m, >= 0: no robot may be so far below it
  double priority;              ///< > 0
  double max_braking;           ///< m/s^2, > 0; 0: max_acceleration
  double distance_to_goal;      ///< m, to where it comes to rest; infinite: there is no such goal
} avo_space_robot;
AVO_C_API avo_space_robot avo_default_space_robot(void);

/// Another robot, as a robot senses it. It decides as well.
typedef struct avo_space_neighbor {
  size_t size;
  avo_vec3 position;        ///< m
  avo_vec3 velocity;        ///< m/s
  double radius;            ///< m, > 0
  double max_acceleration;  ///< m/s^2, > 0
  double vertical;          ///< > 0
  double downwash;          ///< m, >= 0
  double priority;          ///< > 0
  double max_braking;       ///< m/s^2, > 0; 0: max_acceleration
  /// Steps since it was sensed, 0 to 1 000 000; it is extrapolated since then at constant velocity.
  int32_t age;
} avo_space_neighbor;
AVO_C_API avo_space_neighbor avo_default_space_neighbor(void);

/// A moving obstacle, as a robot senses it. It decides nothing.
typedef struct avo_space_mover {
  size_t size;
  avo_vec3 position;      ///< m, the center of its ball
  avo_vec3 velocity;      ///< m/s
  avo_vec3 acceleration;  ///< m/s^2, which it keeps up to max_deviation; 0 with max_speed
  double radius;          ///< m, > 0
  double max_deviation;   ///< m/s^2, >= 0, of its acceleration
  double max_speed;       ///< m/s, > 0, with max_deviation; may be infinite
  /// Steps since it was sensed, as those of a neighbor; extrapolated by its acceleration.
  int32_t age;
} avo_space_mover;
AVO_C_API avo_space_mover avo_default_space_mover(void);

typedef struct avo_space_planner_id {
  uint32_t index;
  uint32_t generation;
} avo_space_planner_id;

/// def: of method AVO_METHOD_AVO, and of what space has.
AVO_C_API avo_result avo_create_space_planner(const avo_planner_def* def,
                                              avo_space_planner_id* planner);
AVO_C_API avo_result avo_destroy_space_planner(avo_space_planner_id planner);
AVO_C_API bool avo_space_planner_is_valid(avo_space_planner_id planner);
/// One decision. boxes: those within avo_space_planner_get_box_range(). movers: the moving
/// obstacles; beside them boxes within the planner's wall_range matter, too, which is best
/// avo_space_evasion_range(). detour: updated; null: the robot decides as for the first time.
/// Numbers out of range are the status AVO_PLAN_INVALID_INPUT.
AVO_C_API avo_result avo_space_planner_plan(avo_space_planner_id planner,
                                            const avo_space_robot* robot,
                                            const avo_space_neighbor* neighbors,
                                            size_t neighbor_count, const avo_space_box* boxes,
                                            size_t box_count, const avo_space_mover* movers,
                                            size_t mover_count, avo_space_detour* detour,
                                            avo_space_plan* plan);
/// m, from the robot's ball: boxes at a larger distance change nothing.
AVO_C_API avo_result avo_space_planner_get_box_range(avo_space_planner_id planner,
                                                     const avo_space_robot* robot, double* range);
/// m, between centers: within it a robot has to sense another one of these limits.
AVO_C_API avo_result avo_space_planner_get_sensing_range(avo_space_planner_id planner,
                                                         const avo_space_robot* robot,
                                                         const avo_space_robot* other,
                                                         double* range);
/// m, between centers: within it a robot has to sense a moving obstacle, so that it can be at rest
/// when the obstacle comes.
AVO_C_API avo_result avo_space_planner_get_mover_range(avo_space_planner_id planner,
                                                       const avo_space_robot* robot,
                                                       const avo_space_mover* mover, double* range);
/// m: how far from its place a robot's evasive maneuvers may lead.
AVO_C_API avo_result avo_space_evasion_range(const avo_space_robot* robot, double* range);

/* ---------------------------------------------------------------------------------- quadrotors */

/// What flies behind a robot, its reference.
typedef struct avo_quadrotor {
  double mass;            ///< kg, > 0; 0: there is no quadrotor
  double max_thrust;      ///< N, of all rotors, > its weight
  double min_thrust;      ///< N, >= 0, < its weight; -1: a tenth of its weight
  double max_tilt;        ///< rad, > 0, < pi/2
  double attitude_time;   ///< s, > 0: the mean delay of its acceleration behind a command
  double tracking_error;  ///< m, >= 0, as measured; -1: max_acceleration attitude_time^2
} avo_quadrotor;

/// What the reference of a quadrotor keeps to.
typedef struct avo_quadrotor_limits {
  double max_acceleration;  ///< m/s^2
  double deviation;         ///< m, of the vehicle from the reference of `delay` ago
  double delay;             ///< s
} avo_quadrotor_limits;
AVO_C_API avo_result avo_get_quadrotor_limits(const avo_quadrotor* quadrotor,
                                              avo_quadrotor_limits* limits);

/// What an autopilot is told for one instant. It has no yaw, which the autopilot is free to choose.
typedef struct avo_set_point {
  avo_vec3 position;      ///< m
  avo_vec3 velocity;      ///< m/s
  avo_vec3 acceleration;  ///< m/s^2, without gravity, to feed forward
} avo_set_point;

/// The message TrajectorySetpoint of PX4, in its local frame: north, east, down. The scene's x
/// points east, its y north and its z up. NaN is what the autopilot is free to choose.
typedef struct avo_px4_set_point {
  uint64_t timestamp;  ///< us
  float position[3];
  float velocity[3];
  float acceleration[3];  ///< m/s^2, without gravity
  float jerk[3];          ///< NaN
  float yaw, yawspeed;    ///< NaN
} avo_px4_set_point;
/// time: s, >= 0, of the autopilot's clock. Values that are not finite or beyond 1e12 are
/// AVO_ERROR_INVALID_VALUE.
AVO_C_API avo_result avo_get_px4_set_point(avo_set_point set_point, double time,
                                           avo_px4_set_point* result);

/// What send_full_state_setpoint() of the Crazyflie's Python library takes, in the scene's frame,
/// with a level attitude.
typedef struct avo_crazyflie_set_point {
  float position[3];                      ///< m
  float velocity[3];                      ///< m/s
  float acceleration[3];                  ///< m/s^2, without gravity
  float orientation[4];                   ///< quaternion x, y, z, w
  float roll_rate, pitch_rate, yaw_rate;  ///< degrees/s
} avo_crazyflie_set_point;
/// A packet has thousandths in 16 bits. Values beyond 32.767 m, m/s or m/s^2 are
/// AVO_ERROR_INVALID_VALUE.
AVO_C_API avo_result avo_get_crazyflie_set_point(avo_set_point set_point,
                                                 avo_crazyflie_set_point* result);

typedef struct avo_filter_id {
  uint32_t index;
  uint32_t generation;
} avo_filter_id;

/// Makes set points of the reference of one quadrotor. fleet_delay: s, the largest attitude_time of
/// the fleet; time_step: s, of the reference.
AVO_C_API avo_result avo_create_filter(const avo_quadrotor* quadrotor, double fleet_delay,
                                       double time_step, avo_filter_id* filter);
AVO_C_API avo_result avo_destroy_filter(avo_filter_id filter);
AVO_C_API bool avo_filter_is_valid(avo_filter_id filter);
/// Adds the next step of the reference: the state at its start, and its acceleration. Values that
/// are not finite or beyond 1e12 are AVO_ERROR_INVALID_VALUE, and nothing is added then.
AVO_C_API avo_result avo_filter_add(avo_filter_id filter, avo_vec3 position, avo_vec3 velocity,
                                    avo_vec3 acceleration);
/// s: set points are known from `begin` to `end`.
AVO_C_API avo_result avo_filter_get_times(avo_filter_id filter, double* begin, double* end);
AVO_C_API avo_result avo_filter_get_set_point(avo_filter_id filter, double time,
                                              avo_set_point* set_point);

/* ---------------------------------------------------------------------------------- simulation */

/// A robot of a simulation.
typedef struct avo_space_robot_def {
  size_t size;
  avo_vec3 position;        ///< m
  avo_vec3 velocity;        ///< m/s
  avo_vec3 goal;            ///< m
  double radius;            ///< m, > 0
  double max_speed;         ///< m/s, > 0
  double max_acceleration;  ///< m/s^2, > 0; of a quadrotor that of its limits instead
  double preferred_speed;   ///< m/s, >= 0
  double vertical;          ///< > 0, see avo_space_robot
  double climb;             ///< m/s, > 0; may be infinite
  double sink;              ///< m/s, > 0; may be infinite
  double downwash;          ///< m, >= 0
  double priority;          ///< > 0
  double max_braking;       ///< m/s^2, > 0; 0: max_acceleration
  avo_quadrotor quadrotor;  ///< of mass 0: there is none
} avo_space_robot_def;
AVO_C_API avo_space_robot_def avo_default_space_robot_def(void);

/// Where a moving obstacle is at a time.
typedef struct avo_space_timed_point {
  double time;        ///< s
  avo_vec3 position;  ///< m
} avo_space_timed_point;

/// A ball that reacts to no robot. It keeps its acceleration, or it moves as a trajectory says;
/// with a trajectory, position and velocity are not read.
typedef struct avo_space_moving_obstacle_def {
  size_t size;
  avo_vec3 position;                        ///< m, at the start, or when it is added
  avo_vec3 velocity;                        ///< m/s, at that time
  avo_vec3 acceleration;                    ///< m/s^2; 0 with max_speed
  double radius;                            ///< m, > 0
  double max_deviation;                     ///< m/s^2, >= 0, that robots allow for
  double max_speed;                         ///< m/s, > 0, with max_deviation; 0: unset
  const avo_space_timed_point* trajectory;  ///< trajectory_count places by ascending times
  size_t trajectory_count;
} avo_space_moving_obstacle_def;
AVO_C_API avo_space_moving_obstacle_def avo_default_space_moving_obstacle_def(void);

typedef struct avo_space_simulation_def {
  size_t size;
  double time_step;             ///< s, > 0
  double control_time;          ///< s, > 0; 0: usual
  double time_horizon;          ///< s, > 0; 0: usual
  double response_time;         ///< >= 0, of max_speed/max_acceleration; AVO_UNSET: usual
  double comfort_acceleration;  ///< m/s^2, > 0; 0: none
  double comfort_jerk;          ///< m/s^3, > 0; 0: none
  double sensing_radius;        ///< m, > 0, between centers; 0: what the robots need
  double arrival_distance;      ///< m, > 0
  avo_motion motion;            ///< of all robots
  avo_certificate certificate;  ///< AVO_UNSET: usual
  int32_t max_neighbors;        ///< >= 1, nearest neighbors that get a half-space; 0: all
  bool navigation;              ///< robots follow routes around boxes
  bool never_swerves;           ///< see avo_planner_def
  uint64_t seed;                ///< of sensing
  avo_sensing_model sensing;
  /// that robots declare; both NAN: the error that follows from sensing
  avo_sensing_error sensing_error;
  int32_t threads;  ///< 0 to 1024; 0: as many as the machine has
  const avo_space_robot_def* robots;
  size_t robot_count;  ///< >= 1
  const avo_space_moving_obstacle_def* moving_obstacles;
  size_t moving_obstacle_count;
  const avo_space_box* boxes;
  size_t box_count;
  avo_localization_noise localization;  ///< robots know their velocity exactly
} avo_space_simulation_def;
AVO_C_API avo_space_simulation_def avo_default_space_simulation_def(void);

typedef struct avo_space_simulation_id {
  uint32_t index;
  uint32_t generation;
} avo_space_simulation_id;

AVO_C_API avo_result avo_create_space_simulation(const avo_space_simulation_def* def,
                                                 avo_space_simulation_id* simulation);
/// Makes the simulation of a scene file with `space: 3`, with overrides "key=value".
AVO_C_API avo_result avo_load_space_simulation(const char* path, const char* const* overrides,
                                               size_t override_count, int32_t threads,
                                               avo_space_simulation_id* simulation);
AVO_C_API avo_result avo_destroy_space_simulation(avo_space_simulation_id simulation);
AVO_C_API bool avo_space_simulation_is_valid(avo_space_simulation_id simulation);
/// All robots decide, and move.
AVO_C_API avo_result avo_space_simulation_step(avo_space_simulation_id simulation);
AVO_C_API avo_result avo_space_simulation_get_time(avo_space_simulation_id simulation,
                                                   double* time);
AVO_C_API avo_result avo_space_simulation_get_steps(avo_space_simulation_id simulation,
                                                    int64_t* steps);
/// Whether the next step ends by that time, s. A whole run steps while this is true for the
/// duration of the scene.
AVO_C_API avo_result avo_space_simulation_can_step_by(avo_space_simulation_id simulation,
                                                      double time, bool* can_step);
AVO_C_API avo_result avo_space_simulation_get_robot_count(avo_space_simulation_id simulation,
                                                          size_t* count);
/// Writes the states of all robots in the order of the definition, which is that of their ids 1, 2,
/// ... Either array may be null.
/// capacity: elements of the arrays; where it is less than the number of robots, the result is
/// AVO_ERROR_BUFFER_TOO_SMALL.
AVO_C_API avo_result avo_space_simulation_get_states(avo_space_simulation_id simulation,
                                                     avo_vec3* positions, avo_vec3* velocities,
                                                     size_t capacity);
/// The last decision of a robot. AVO_ERROR_INVALID_ID where there is no such robot, here and below.
AVO_C_API avo_result avo_space_simulation_get_plan(avo_space_simulation_id simulation,
                                                   avo_robot_id robot, avo_space_plan* plan);
/// What a robot touches, or will touch although it brakes. At most one id is not 0. The boxes of
/// the definition are the static obstacles 1, 2, ... in its order.
typedef struct avo_space_touched {
  avo_robot_id robot;
  avo_moving_obstacle_id moving_obstacle;
  avo_obstacle_id obstacle;
} avo_space_touched;
/// What the robot touches by its last decision, if that is AVO_PLAN_OVERLAPPING; `depth` of its
/// plan says how deep. All ids are 0 where the decision is another one.
AVO_C_API avo_result avo_space_simulation_get_touched(avo_space_simulation_id simulation,
                                                      avo_robot_id robot,
                                                      avo_space_touched* touched);
/// The decision that the robot makes in the next step in words, with the reason and the names of
/// those that cause it. It is one or two sentences in UTF-8, with a 0 at the end. Buffer, capacity
/// and size are those of avo_simulation_save(). Nothing moves; no other call of this simulation may
/// run at the same time.
AVO_C_API avo_result avo_space_simulation_explain(avo_space_simulation_id simulation,
                                                  avo_robot_id robot, char* buffer, size_t capacity,
                                                  size_t* size);
/// Whether the robot is within the arrival distance of its goal, with no box between.
AVO_C_API avo_result avo_space_simulation_is_at_goal(avo_space_simulation_id simulation,
                                                     avo_robot_id robot, bool* is_at_goal);
AVO_C_API avo_result avo_space_simulation_all_at_goal(avo_space_simulation_id simulation,
                                                      bool* all_at_goal);
/// m: from the nearest place that the robot can reach, where its route ends, to its goal. 0 where
/// no box keeps it from its goal.
AVO_C_API avo_result avo_space_simulation_get_distance_left(avo_space_simulation_id simulation,
                                                            avo_robot_id robot, double* distance);
/// The rest of a robot's route.
typedef struct avo_space_route {
  double length;         ///< m; infinite for robots that avo_space_simulation_unreachable() lists
  avo_vec3 next;         ///< m, its next point, a bend or its end
  double distance_left;  ///< m, see avo_space_simulation_get_distance_left()
} avo_space_route;
/// The route that the robot knows: around boxes with navigation, else straight.
AVO_C_API avo_result avo_space_simulation_get_route(avo_space_simulation_id simulation,
                                                    avo_robot_id robot, avo_space_route* route);
/// Robots that boxes keep from their goals, by ascending id: they go as near as they can. buffer
/// and count are those of avo_simulation_unreachable().
AVO_C_API avo_result avo_space_simulation_unreachable(avo_space_simulation_id simulation,
                                                      avo_robot_id* buffer, size_t capacity,
                                                      size_t* count);
/// Begins to watch the robots, as avo_simulation_watch(). Robots neither come nor go.
AVO_C_API avo_result avo_space_simulation_watch(avo_space_simulation_id simulation,
                                                double stuck_after);
/// The events of the last step, as avo_simulation_events().
AVO_C_API avo_result avo_space_simulation_events(avo_space_simulation_id simulation,
                                                 avo_event* buffer, size_t capacity, size_t* count);
/// Why the robot of that event is stuck, as avo_simulation_event_sentence().
AVO_C_API avo_result avo_space_simulation_event_sentence(avo_space_simulation_id simulation,
                                                         size_t event, char* buffer,
                                                         size_t capacity, size_t* size);
AVO_C_API avo_result avo_space_simulation_set_goal(avo_space_simulation_id simulation,
                                                   avo_robot_id robot, avo_vec3 goal);
/// A helicopter, a ball or a player comes. It is refused if it touches some robot, or if some robot
/// cannot brake before it, as in the definition of a simulation.
AVO_C_API avo_result avo_space_simulation_add_moving_obstacle(
    avo_space_simulation_id simulation, const avo_space_moving_obstacle_def* def,
    avo_moving_obstacle_id* obstacle);
/// Its place, velocity, radius, limits and trajectory are those of the definition from now on.
/// Nothing is promised of what the host changes faster than max_deviation and max_speed allow.
AVO_C_API avo_result avo_space_simulation_change_moving_obstacle(
    avo_space_simulation_id simulation, avo_moving_obstacle_id obstacle,
    const avo_space_moving_obstacle_def* def);
AVO_C_API avo_result avo_space_simulation_remove_moving_obstacle(avo_space_simulation_id simulation,
                                                                 avo_moving_obstacle_id obstacle);
/// The present moving obstacles, by ascending id. buffer and count are those of
/// avo_simulation_unreachable().
AVO_C_API avo_result avo_space_simulation_moving_obstacle_ids(avo_space_simulation_id simulation,
                                                              avo_moving_obstacle_id* buffer,
                                                              size_t capacity, size_t* count);
/// The states of these, in that order. The arrays are those of avo_space_simulation_get_states().
AVO_C_API avo_result avo_space_simulation_get_moving_obstacles(avo_space_simulation_id simulation,
                                                               avo_vec3* positions,
                                                               avo_vec3* velocities,
                                                               size_t capacity);
/// Replaces all boxes; refused where a robot is in one, or cannot brake before it.
AVO_C_API avo_result avo_space_simulation_set_boxes(avo_space_simulation_id simulation,
                                                    const avo_space_box* boxes, size_t box_count);
/// Equal for equal states, bit by bit, whatever the number of threads.
AVO_C_API avo_result avo_space_simulation_get_state_hash(avo_space_simulation_id simulation,
                                                         uint64_t* hash);

#ifdef __cplusplus
}
#endif

#endif
