/* SPDX-License-Identifier: Apache-2.0 */
/* Robots of space in C: a fleet with the hash of C++, a decision, refusals, set points. */
#include <avo_c/space.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "cpp_runs.h"

static avo_vec3 at(double x, double y, double z) {
  const avo_vec3 v = {x, y, z};
  return v;
}

static avo_robot_id robot(uint64_t value) {
  const avo_robot_id id = {value};
  return id;
}

static const double kFar = HUGE_VAL;

static avo_space_box floor_at(double z) {
  const avo_space_box box = {{-kFar, -kFar, -kFar}, {kFar, kFar, z}, 0.0, 0.0};
  return box;
}

/* Five drones of different kinds above a floor, and a quadrotor. */
static avo_space_simulation_id make_fleet(bool senses_late) {
  avo_space_robot_def robots[6];
  avo_space_simulation_def def = avo_default_space_simulation_def();
  avo_space_simulation_id fleet = {0, 0};
  const avo_space_box floor = floor_at(-4.0);
  for (int k = 0; k < 6; ++k) {
    robots[k] = avo_default_space_robot_def();
    robots[k].position = at(-9.0 + 0.1 * k, 2.5 * k - 6.0, 0.3 * k);
    robots[k].goal = at(9.0, 6.0 - 2.5 * k, 1.0);
  }
  robots[1].downwash = 1.0;
  robots[2].vertical = 0.5;
  robots[2].climb = 0.7;
  robots[3].max_braking = 0.8;
  robots[3].priority = 2.0;
  robots[4].radius = 0.8;
  robots[4].preferred_speed = 1.5;
  robots[5].quadrotor.mass = 1.2;
  robots[5].quadrotor.max_thrust = 26.0;
  robots[5].quadrotor.max_tilt = 0.6;
  robots[5].quadrotor.attitude_time = 0.12;
  def.robots = robots;
  def.robot_count = 6;
  def.boxes = &floor;
  def.box_count = 1;
  def.threads = 1;
  if (senses_late) {
    def.seed = 7;
    def.sensing.noise.position = 0.02;
    def.sensing.delay = 2;
    def.localization.position = 0.03;
    def.sensing_error.position = 0.3;
    def.sensing_error.velocity = 0.4;
  }
  REQUIRE(avo_create_space_simulation(&def, &fleet));
  return fleet;
}

static void decisions_are_told_as_in_cpp(void) {
  avo_space_simulation_id fleet = make_fleet(false);
  char words[512], expected[512];
  size_t size = 0;
  for (int k = 0; k < 50; ++k) REQUIRE(avo_space_simulation_step(fleet));
  REQUIRE(avo_space_simulation_explain(fleet, robot(4), NULL, 0, &size));
  CHECK(size > 20 && size <= sizeof words);
  REFUSES(avo_space_simulation_explain(fleet, robot(4), words, size - 1, &size),
          AVO_ERROR_BUFFER_TOO_SMALL, "capacity: found");
  REQUIRE(avo_space_simulation_explain(fleet, robot(4), words, sizeof words, &size));
  cpp_space_words(50, 3, expected, sizeof expected);
  CHECK(strlen(words) + 1 == size && strcmp(words, expected) == 0);
  REFUSES(avo_space_simulation_explain(fleet, robot(7), NULL, 0, &size), AVO_ERROR_INVALID_ID,
          "robot: found 7");
  REQUIRE(avo_destroy_space_simulation(fleet));
}

static void a_fleet_moves_as_in_cpp(void) {
  avo_space_simulation_id fleet = make_fleet(true);
  avo_vec3 positions[6], velocities[6];
  avo_space_plan plan;
  uint64_t hash = 0;
  double time = 0.0;
  bool is_at_goal = false;
  for (int k = 0; k < 50; ++k) REQUIRE(avo_space_simulation_step(fleet));
  REQUIRE(avo_space_simulation_get_state_hash(fleet, &hash));
  CHECK(hash == cpp_space_hash(50, true));
  REQUIRE(avo_destroy_space_simulation(fleet));
  fleet = make_fleet(false);
  for (int k = 0; k < 50; ++k) REQUIRE(avo_space_simulation_step(fleet));
  REQUIRE(avo_space_simulation_get_state_hash(fleet, &hash));
  CHECK(hash == cpp_space_hash(50, false) && hash != cpp_space_hash(50, true));
  REQUIRE(avo_space_simulation_get_time(fleet, &time));
  CHECK(fabs(time - 5.0) < 1e-9);
  int64_t steps = 0;
  bool can_step = true;
  REQUIRE(avo_space_simulation_get_steps(fleet, &steps));
  REQUIRE(avo_space_simulation_can_step_by(fleet, 5.05, &can_step));
  CHECK(steps == 50 && !can_step);
  REQUIRE(avo_space_simulation_can_step_by(fleet, 5.1, &can_step));
  CHECK(can_step);
  REQUIRE(avo_space_simulation_get_states(fleet, positions, velocities, 6));
  CHECK(positions[0].x > -7.0 && velocities[0].x > 0.5);
  REQUIRE(avo_space_simulation_get_plan(fleet, robot(4), &plan));
  CHECK(plan.status != AVO_PLAN_INVALID_INPUT && plan.state == AVO_SAFETY_SAFE);
  REQUIRE(avo_space_simulation_set_goal(fleet, robot(1), positions[0]));
  REQUIRE(avo_space_simulation_is_at_goal(fleet, robot(1), &is_at_goal));
  CHECK(is_at_goal);
  REFUSES(avo_space_simulation_get_states(fleet, positions, NULL, 5), AVO_ERROR_BUFFER_TOO_SMALL,
          "capacity: found 5, must be >= 6");
  REFUSES(avo_space_simulation_set_goal(fleet, robot(7), at(0, 0, 0)), AVO_ERROR_INVALID_ID,
          "robot: found 7, must be the id of one that is there");
  REFUSES(avo_space_simulation_set_goal(fleet, robot(0), at(0, 0, 0)), AVO_ERROR_INVALID_ID,
          "robot: found a null id");
  const avo_space_box around = floor_at(50.0);
  REFUSES(avo_space_simulation_set_boxes(fleet, &around, 1), AVO_ERROR_INVALID_VALUE,
          "is in it, or cannot brake before it");
  REQUIRE(avo_space_simulation_set_boxes(fleet, NULL, 0));
  REQUIRE(avo_space_simulation_all_at_goal(fleet, &is_at_goal));
  CHECK(!is_at_goal);
  REQUIRE(avo_destroy_space_simulation(fleet));
  CHECK(!avo_space_simulation_is_valid(fleet));
  REFUSES(avo_space_simulation_step(fleet), AVO_ERROR_INVALID_ID, "space simulation: found an id");
}

static void one_robot_gives_way(void) {
  avo_planner_def def = avo_default_planner_def(AVO_METHOD_AVO);
  avo_space_planner_id planner;
  avo_space_robot robot = avo_default_space_robot();
  avo_space_neighbor other = avo_default_space_neighbor();
  avo_space_detour memory = {0};
  avo_space_plan plan;
  const avo_space_box floor = floor_at(-1.0);
  double range = 0.0;
  REQUIRE(avo_create_space_planner(&def, &planner));
  robot.velocity = robot.preferred_velocity = at(1.5, 0.0, 0.0);
  other.position = at(6.0, 0.1, 0.0);
  other.velocity = at(-1.5, 0.0, 0.0);
  REQUIRE(avo_space_planner_plan(planner, &robot, &other, 1, &floor, 1, NULL, 0, &memory, &plan));
  CHECK(plan.state == AVO_SAFETY_SAFE && plan.acceleration.y < -0.2 && plan.box == -1);
  CHECK(memory.acceleration.y == plan.acceleration.y || memory.acceleration.y < 0.0);
  REQUIRE(avo_space_planner_get_sensing_range(planner, &robot, &robot, &range));
  CHECK(range > 4.0 && range < 40.0);
  REQUIRE(avo_space_planner_get_box_range(planner, &robot, &range));
  CHECK(range > 1.0 && range < 20.0);
  robot.position = at(0.0, 0.0, -2.0);
  REQUIRE(avo_space_planner_plan(planner, &robot, NULL, 0, &floor, 1, NULL, 0, NULL, &plan));
  CHECK(plan.status == AVO_PLAN_OVERLAPPING && plan.box == 0 && plan.depth > 0.4f);
  robot.size = 3;
  REFUSES(avo_space_planner_plan(planner, &robot, NULL, 0, NULL, 0, NULL, 0, NULL, &plan),
          AVO_ERROR_INVALID_DEFINITION, "robot.size: found 3");
  def.method = AVO_METHOD_ORCA;
  REFUSES(avo_create_space_planner(&def, &planner), AVO_ERROR_INVALID_VALUE, "method");
  REQUIRE(avo_destroy_space_planner(planner));
}

static avo_vec3 decided(int neighbor_age, int mover_age, avo_space_plan* plan) {
  avo_planner_def def = avo_default_planner_def(AVO_METHOD_AVO);
  avo_space_planner_id planner;
  avo_space_robot robot = avo_default_space_robot();
  avo_space_neighbor other = avo_default_space_neighbor();
  avo_space_mover mover = avo_default_space_mover();
  const avo_space_box floor = floor_at(-1.0);
  double range = 0.0;
  REQUIRE(avo_space_evasion_range(&robot, &def.wall_range));
  def.sensing_error.velocity = 0.05;
  REQUIRE(avo_create_space_planner(&def, &planner));
  robot.velocity = at(1.0, 0.0, 0.0);
  robot.preferred_velocity = at(2.0, 0.0, 0.0);
  other.position = at(3.0, 0.1, 0.0);
  other.velocity = at(-1.0, 0.0, 0.0);
  other.age = neighbor_age;
  mover.position = at(2.0, 8.0, 0.0);
  mover.velocity = at(0.0, -4.0, 0.0);
  mover.radius = 1.0;
  mover.max_deviation = 0.05;
  mover.age = mover_age;
  REQUIRE(avo_space_planner_get_mover_range(planner, &robot, &mover, &range));
  CHECK(range > 4.0 && range < 40.0);
  REQUIRE(avo_space_planner_plan(planner, &robot, &other, 1, &floor, 1, &mover, 1, NULL, plan));
  REQUIRE(avo_destroy_space_planner(planner));
  return plan->next_velocity;
}

static void one_robot_evades_what_moves(void) {
  const int ages[4][2] = {{0, 0}, {4, 0}, {0, 4}, {0, -1}};
  avo_space_plan plan;
  double expected[3];
  avo_vec3 first = at(0.0, 0.0, 0.0);
  for (int k = 0; k < 3; ++k) {
    const avo_vec3 next = decided(ages[k][0], ages[k][1], &plan);
    cpp_space_decision(ages[k][0], ages[k][1], expected);
    CHECK(next.x == expected[0] && next.y == expected[1] && next.z == expected[2]);
    CHECK(next.x != first.x || next.y != first.y || next.z != first.z);
    first = next;
  }
  CHECK(plan.evading && plan.mover == -1);
  decided(ages[3][0], ages[3][1], &plan);
  CHECK(plan.status == AVO_PLAN_INVALID_INPUT);
}

/* PX4 counts north, east and down, and packets of a Crazyflie have 16 bits for a number. */
static void autopilots_take(avo_set_point point) {
  avo_px4_set_point px4;
  avo_crazyflie_set_point crazyflie;
  point.position.y = 4.0, point.velocity.z = 0.5;
  REQUIRE(avo_get_px4_set_point(point, 2.000001, &px4));
  CHECK(px4.timestamp == 2000001 && px4.position[0] == 4.0F && px4.position[2] == -1.0F);
  CHECK(px4.position[1] == (float)point.position.x && px4.velocity[2] == -0.5F);
  CHECK(px4.acceleration[1] == (float)point.acceleration.x);
  CHECK(isnan(px4.jerk[0]) && isnan(px4.jerk[2]) && isnan(px4.yaw) && isnan(px4.yawspeed));
  REQUIRE(avo_get_crazyflie_set_point(point, &crazyflie));
  CHECK(crazyflie.position[0] == (float)point.position.x && crazyflie.position[1] == 4.0F);
  CHECK(crazyflie.velocity[2] == 0.5F && crazyflie.acceleration[0] == px4.acceleration[1]);
  CHECK(crazyflie.orientation[0] == 0.0F && crazyflie.orientation[3] == 1.0F);
  CHECK(crazyflie.roll_rate == 0.0F && crazyflie.yaw_rate == 0.0F);
  point.position.x = 32.768;
  REFUSES(avo_get_crazyflie_set_point(point, &crazyflie), AVO_ERROR_INVALID_VALUE,
          "position.0: found 32.768, must be <= 32.767 m");
  point.velocity.y = NAN;
  REFUSES(avo_get_px4_set_point(point, 0.0, &px4), AVO_ERROR_INVALID_VALUE, "velocity.1");
}

static void set_points_are_one_delay_late(void) {
  const avo_quadrotor quadrotor = {1.2, 26.0, AVO_UNSET, 0.6, 0.12, AVO_UNSET};
  avo_quadrotor bad = quadrotor;
  avo_quadrotor_limits limits;
  avo_filter_id filter;
  avo_set_point point;
  double begin = 0.0, end = 0.0;
  REQUIRE(avo_get_quadrotor_limits(&quadrotor, &limits));
  CHECK(limits.delay == 0.12 && limits.max_acceleration > 4.0 && limits.max_acceleration < 7.0);
  CHECK(fabs(limits.deviation - limits.max_acceleration * 0.12 * 0.12) < 1e-12);
  bad.max_tilt = 2.0;
  REFUSES(avo_get_quadrotor_limits(&bad, &limits), AVO_ERROR_INVALID_VALUE, "quadrotor.max_tilt");
  REQUIRE(avo_create_filter(&quadrotor, 0.12, 0.1, &filter));
  for (int k = 0; k < 30; ++k) {
    const double t = 0.1 * k;
    REQUIRE(avo_filter_add(filter, at(t * t, 0.0, 1.0), at(2.0 * t, 0.0, 0.0), at(2.0, 0.0, 0.0)));
  }
  REFUSES(avo_filter_add(filter, at(0.0, NAN, 1.0), at(0.0, 0.0, 0.0), at(0.0, 0.0, 0.0)),
          AVO_ERROR_INVALID_VALUE, "position.1: found nan");
  REFUSES(avo_filter_add(filter, at(0.0, 0.0, 1.0), at(0.0, 0.0, 0.0), at(0.0, 0.0, INFINITY)),
          AVO_ERROR_INVALID_VALUE, "acceleration.2: found inf");
  REQUIRE(avo_filter_get_times(filter, &begin, &end));
  CHECK(fabs(end - 3.0) < 1e-9 && begin < end);
  REQUIRE(avo_filter_get_set_point(filter, end, &point));
  CHECK(fabs(point.position.x - 2.88 * 2.88) <= limits.deviation / 4.0 && point.position.z == 1.0);
  CHECK(fabs(point.acceleration.x - 2.0) < 1e-6);
  REFUSES(avo_filter_get_set_point(filter, end + 1.0, &point), AVO_ERROR_INVALID_VALUE, "time");
  autopilots_take(point);
  REQUIRE(avo_destroy_filter(filter));
  CHECK(!avo_filter_is_valid(filter));
}

/* A ball and a balloon come, change and go. */
static void moving_obstacles_come_and_go(void) {
  avo_space_robot_def robot_def = avo_default_space_robot_def();
  avo_space_simulation_def def = avo_default_space_simulation_def();
  avo_space_moving_obstacle_def ball = avo_default_space_moving_obstacle_def();
  const avo_space_timed_point places[2] = {{0.0, {0.0, 9.0, 0.0}}, {6.0, {0.0, 9.0, 6.0}}};
  avo_space_simulation_id fleet;
  avo_moving_obstacle_id ids[2], thrown;
  avo_vec3 positions[2], velocities[2];
  avo_space_plan plan;
  size_t count = 0;
  ball.trajectory = places;
  ball.trajectory_count = 2;
  def.robots = &robot_def;
  def.robot_count = 1;
  def.moving_obstacles = &ball;
  def.moving_obstacle_count = 1;
  ball.trajectory_count = 0;
  ball.position = at(2.0, 0.0, 0.0);
  robot_def.velocity = at(2.0, 0.0, 0.0);
  REFUSES(avo_create_space_simulation(&def, &fleet), AVO_ERROR_INVALID_VALUE,
          "robot 0 and moving obstacle 0 start too fast for their distance");
  ball.trajectory_count = 2;
  ball.position = at(0.0, 0.0, 0.0);
  robot_def.velocity = at(0.0, 0.0, 0.0);
  REQUIRE(avo_create_space_simulation(&def, &fleet));
  ball.trajectory_count = 0;
  ball.position = at(12.0, 0.0, 0.0);
  ball.velocity = at(-4.0, 0.0, 0.0);
  for (int k = 0; k < 20; ++k) REQUIRE(avo_space_simulation_step(fleet));
  REQUIRE(avo_space_simulation_add_moving_obstacle(fleet, &ball, &thrown));
  CHECK(thrown.value == 2);
  REQUIRE(avo_space_simulation_get_moving_obstacles(fleet, positions, velocities, 2));
  CHECK(fabs(positions[0].z - 2.0) < 1e-9 && positions[1].x == 12.0 && velocities[1].x == -4.0);
  bool evading = false;
  for (int k = 0; k < 30; ++k) {
    REQUIRE(avo_space_simulation_step(fleet));
    REQUIRE(avo_space_simulation_get_plan(fleet, robot(1), &plan));
    evading = evading || plan.evading;
  }
  CHECK(evading);
  REQUIRE(avo_space_simulation_get_moving_obstacles(fleet, positions, NULL, 2));
  CHECK(fabs(positions[1].x) < 1e-9);
  ball.position = at(40.0, 0.0, 0.0);
  REQUIRE(avo_space_simulation_change_moving_obstacle(fleet, thrown, &ball));
  ids[0].value = 1;
  REQUIRE(avo_space_simulation_remove_moving_obstacle(fleet, ids[0]));
  REQUIRE(avo_space_simulation_moving_obstacle_ids(fleet, ids, 2, &count));
  CHECK(count == 1 && ids[0].value == 2);
  REQUIRE(avo_space_simulation_get_moving_obstacles(fleet, positions, velocities, 1));
  CHECK(positions[0].x == 40.0);
  ids[0].value = 1;
  REFUSES(avo_space_simulation_remove_moving_obstacle(fleet, ids[0]), AVO_ERROR_INVALID_ID,
          "obstacle: found 1, must be the id of one that is there");
  ball.radius = 0.0;
  REFUSES(avo_space_simulation_add_moving_obstacle(fleet, &ball, &thrown), AVO_ERROR_INVALID_VALUE,
          "moving obstacle 2: radius: found 0");
  REQUIRE(avo_destroy_space_simulation(fleet));
}

/* Without a certificate, a ball may touch robot 2 from the start. */
static void contacts_are_named_by_ids(void) {
  avo_space_robot_def robots[2] = {avo_default_space_robot_def(), avo_default_space_robot_def()};
  avo_space_simulation_def def = avo_default_space_simulation_def();
  avo_space_moving_obstacle_def balls[2] = {avo_default_space_moving_obstacle_def(),
                                            avo_default_space_moving_obstacle_def()};
  avo_space_simulation_id fleet;
  avo_space_touched touched;
  avo_space_plan plan;
  robots[1].position = robots[1].goal = at(0, 40, 0);
  balls[0].position = at(0, 20, 0);
  balls[1].position = at(0, 40.7, 0);
  def.robots = robots;
  def.robot_count = 2;
  def.moving_obstacles = balls;
  def.moving_obstacle_count = 2;
  def.certificate = AVO_CERTIFICATE_NONE;
  REQUIRE(avo_create_space_simulation(&def, &fleet));
  REQUIRE(avo_space_simulation_step(fleet));
  REQUIRE(avo_space_simulation_get_plan(fleet, robot(2), &plan));
  CHECK(plan.status == AVO_PLAN_OVERLAPPING && fabsf(plan.depth - 0.3F) < 1e-6F);
  CHECK(plan.neighbor == -1 && plan.box == -1 && plan.mover == -1);
  REQUIRE(avo_space_simulation_get_touched(fleet, robot(2), &touched));
  CHECK(touched.moving_obstacle.value == 2);
  CHECK(touched.robot.value == 0 && touched.obstacle.value == 0);
  REQUIRE(avo_space_simulation_get_touched(fleet, robot(1), &touched));
  CHECK(touched.moving_obstacle.value == 0 && touched.robot.value == 0);
  REFUSES(avo_space_simulation_get_touched(fleet, robot(9), &touched), AVO_ERROR_INVALID_ID,
          "robot: found 9");
  REQUIRE(avo_destroy_space_simulation(fleet));
}

/* The goal of the second robot is below the floor. */
static void goals_out_of_reach_are_told(void) {
  avo_space_robot_def robots[2] = {avo_default_space_robot_def(), avo_default_space_robot_def()};
  avo_space_simulation_def def = avo_default_space_simulation_def();
  const avo_space_box floor = floor_at(-1.0);
  avo_space_simulation_id fleet;
  avo_robot_id ids[2];
  bool all_at_goal = true;
  size_t count = 0;
  double left = 0.0;
  avo_space_route route;
  robots[0].goal = at(2.0, 0.0, 1.0);
  robots[1].position = at(0.0, 9.0, 0.0);
  robots[1].goal = at(0.0, 9.0, -3.5);
  def.robots = robots;
  def.robot_count = 2;
  def.boxes = &floor;
  def.box_count = 1;
  REQUIRE(avo_create_space_simulation(&def, &fleet));
  REQUIRE(avo_space_simulation_unreachable(fleet, NULL, 0, &count));
  CHECK(count == 1);
  REQUIRE(avo_space_simulation_unreachable(fleet, ids, 2, &count));
  CHECK(ids[0].value == 2);
  REQUIRE(avo_space_simulation_get_distance_left(fleet, ids[0], &left));
  CHECK(fabs(left - 3.0) < 0.1);
  REQUIRE(avo_space_simulation_get_distance_left(fleet, robot(1), &left));
  CHECK(left == 0.0);
  REQUIRE(avo_space_simulation_get_route(fleet, robot(1), &route));
  CHECK(fabs(route.length - sqrt(5.0)) < 1e-9 && route.distance_left == 0.0);
  CHECK(route.next.x == 2.0 && route.next.y == 0.0 && route.next.z == 1.0);
  REQUIRE(avo_space_simulation_get_route(fleet, robot(2), &route));
  CHECK(isinf(route.length) && fabs(route.distance_left - 3.0) < 0.1 && route.next.z > -0.6);
  REFUSES(avo_space_simulation_get_route(fleet, robot(1), NULL), AVO_ERROR_INVALID_ARGUMENT,
          "route");
  REFUSES(avo_space_simulation_get_distance_left(fleet, robot(3), &left), AVO_ERROR_INVALID_ID,
          "robot: found 3, must be the id of one that is there");
  REQUIRE(avo_space_simulation_set_boxes(fleet, NULL, 0));
  for (int k = 0; k < 100; ++k) REQUIRE(avo_space_simulation_step(fleet));
  REQUIRE(avo_space_simulation_all_at_goal(fleet, &all_at_goal));
  CHECK(all_at_goal);
  REQUIRE(avo_destroy_space_simulation(fleet));
}

/* Steps until something happens. */
static size_t next_space_events(avo_space_simulation_id fleet, avo_event* events, size_t capacity) {
  size_t count = 0;
  for (int k = 0; k < 500 && count == 0; ++k) {
    REQUIRE(avo_space_simulation_step(fleet));
    REQUIRE(avo_space_simulation_events(fleet, events, capacity, &count));
  }
  return count;
}

/* One robot arrives. The other one has a goal and goes nowhere, until a player touches it. */
static void events_are_told(void) {
  avo_space_robot_def robots[2] = {avo_default_space_robot_def(), avo_default_space_robot_def()};
  avo_space_simulation_def def = avo_default_space_simulation_def();
  avo_space_moving_obstacle_def player = avo_default_space_moving_obstacle_def();
  avo_moving_obstacle_id ball;
  avo_space_simulation_id fleet;
  avo_event events[4];
  char words[512];
  size_t count = 9, size = 0;
  robots[0].goal = at(2.0, 0.0, 1.0);
  robots[1].position = at(0.0, 9.0, 0.0);
  robots[1].goal = at(0.0, 9.0, -3.5);
  robots[1].preferred_speed = 0.0;
  def.robots = robots;
  def.robot_count = 2;
  REQUIRE(avo_create_space_simulation(&def, &fleet));
  REFUSES(avo_space_simulation_events(fleet, events, 4, &count), AVO_ERROR_UNSUPPORTED,
          "must be one after avo_space_simulation_watch()");
  REFUSES(avo_space_simulation_watch(fleet, -1.0), AVO_ERROR_INVALID_VALUE,
          "stuck_after: found -1, must be > 0 s");
  REQUIRE(avo_space_simulation_watch(fleet, 9.0));
  REQUIRE(avo_space_simulation_events(fleet, events, 4, &count));
  CHECK(count == 0);
  CHECK(next_space_events(fleet, events, 4) == 1);
  CHECK(events[0].kind == AVO_EVENT_ARRIVED && events[0].robot.value == 1);
  CHECK(events[0].moving_obstacle.value == 0 && !events[0].at_rest);
  CHECK(next_space_events(fleet, events, 4) == 1);
  CHECK(events[0].kind == AVO_EVENT_STUCK && events[0].robot.value == 2);
  REQUIRE(avo_space_simulation_event_sentence(fleet, 0, words, sizeof words, &size));
  CHECK(size > 20 && strlen(words) + 1 == size);
  REFUSES(avo_space_simulation_event_sentence(fleet, 1, words, sizeof words, &size),
          AVO_ERROR_INVALID_VALUE, "event: found 1, must be less than the number of events, 1");
  player.position = at(0.0, 30.0, 0.0);
  REQUIRE(avo_space_simulation_add_moving_obstacle(fleet, &player, &ball));
  player.position = at(0.0, 9.2, 0.0);
  REQUIRE(avo_space_simulation_change_moving_obstacle(fleet, ball, &player));
  REQUIRE(avo_space_simulation_step(fleet));
  REFUSES(avo_space_simulation_events(fleet, events, 0, &count), AVO_ERROR_BUFFER_TOO_SMALL,
          "capacity: found 0, must be >= 1");
  REQUIRE(avo_space_simulation_events(fleet, events, 4, &count));
  CHECK(count == 1 && events[0].kind == AVO_EVENT_CONTACT && events[0].robot.value == 2);
  CHECK(events[0].moving_obstacle.value == ball.value);
  REQUIRE(avo_destroy_space_simulation(fleet));
}

static void scene_files_are_read(void) {
  const char* const overrides[] = {"robots.0.radius=0.25"};
  avo_space_simulation_id fleet;
  size_t count = 0;
  FILE* file = fopen("c_space.yaml", "w");
  CHECK(file != NULL);
  fputs("version: 1\nspace: 3\nrobots:\n  - {position: [0, 0, 0], goal: [5, 0, 1]}\n", file);
  fclose(file);
  REQUIRE(avo_load_space_simulation("c_space.yaml", overrides, 1, 1, &fleet));
  REQUIRE(avo_space_simulation_get_robot_count(fleet, &count));
  CHECK(count == 1);
  REQUIRE(avo_destroy_space_simulation(fleet));
  remove("c_space.yaml");
  REFUSES(avo_load_space_simulation("circle-10", NULL, 0, 1, &fleet), AVO_ERROR_INVALID_SCENE,
          "circle-10: found no scene with space: 3");
}

int main(void) {
  a_fleet_moves_as_in_cpp();
  decisions_are_told_as_in_cpp();
  one_robot_gives_way();
  one_robot_evades_what_moves();
  set_points_are_one_delay_late();
  moving_obstacles_come_and_go();
  contacts_are_named_by_ids();
  goals_out_of_reach_are_told();
  events_are_told();
  scene_files_are_read();
  return 0;
}
