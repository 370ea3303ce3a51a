/* SPDX-License-Identifier: Apache-2.0 */
/* A sky of airplanes, and a yard of all else that C can define: robots that have wheels or none,
 * walls, moving obstacles, edits, saved states. Their state hashes are those of the same in C++. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "cpp_runs.h"

static avo_vec2 at(double x, double y) {
  const avo_vec2 v = {x, y};
  return v;
}

static void define_robots(avo_robot_def robots[6]) {
  for (int k = 0; k < 6; ++k) robots[k] = avo_default_robot_def();
  robots[0].position = at(-8.0, -6.0);
  robots[0].goal = at(8.0, -5.0);
  robots[0].priority = 3.0;
  robots[1].position = at(8.0, -3.0);
  robots[1].goal = at(-8.0, -4.0);
  robots[1].heading = 3.1;
  robots[1].model = AVO_MODEL_CAR;
  robots[1].car.wheelbase = 0.8;
  robots[1].car.max_curvature = 0.9;
  robots[1].car.body.offset = 0.3;
  robots[1].car.body.radius = 0.6;
  robots[1].car.reverse = true;
  robots[1].car.acceleration_set = AVO_ACCELERATION_SET_EXACT;
  robots[2].position = at(-8.0, 2.0);
  robots[2].goal = at(8.0, 4.0);
  robots[2].max_speed = robots[2].preferred_speed = 1.2;
  robots[2].model = AVO_MODEL_DIFFERENTIAL_DRIVE;
  robots[2].drive.track = 0.5;
  robots[2].drive.offset = 0.25;
  robots[2].drive.wheel_speed = 1.5;
  robots[2].drive.wheel_acceleration = 2.5;
  robots[3].position = at(-12.0, 8.0);
  robots[3].goal = at(12.0, 6.0);
  robots[3].radius = 0.7;
  robots[3].behavior = AVO_BEHAVIOR_COOPERATES;
  robots[4].position = robots[4].goal = at(3.0, 7.0);
  robots[4].behavior = AVO_BEHAVIOR_PARKED;
  robots[5].position = at(8.0, 5.0);
  robots[5].goal = at(-8.0, 3.0);
  robots[5].max_braking = 0.8;
  robots[5].layers = 4;
  robots[5].avoids = 0xff;
}

static avo_simulation_id make_yard(void) {
  static const avo_vec2 path[] = {{12.0, 10.0}, {-12.0, 10.0}, {0.0, 12.0}};
  static const avo_vec2 square[] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
  static const avo_vec2 line[] = {{-4.0, 0.0}, {-4.0, 1.0}};
  static const avo_vec2 disc[] = {{4.0, 0.0}};
  const avo_chain solid[] = {{square, 4, true}}, thin[] = {{line, 2, false}, {disc, 1, false}};
  avo_robot_def robots[6];
  avo_moving_obstacle_def movers[2];
  avo_obstacle_def obstacles[2];
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id simulation;
  define_robots(robots);
  for (int k = 0; k < 2; ++k) {
    movers[k] = avo_default_moving_obstacle_def();
    obstacles[k] = avo_default_obstacle_def();
  }
  movers[0].position = at(0.0, -12.0);
  movers[0].velocity = at(0.0, 0.5);
  movers[0].radius = 0.4;
  movers[1].position = at(12.0, 10.0);
  movers[1].radius = 0.3;
  movers[1].max_deviation = 0.5;
  movers[1].max_speed = 1.0;
  movers[1].path = path;
  movers[1].path_count = 3;
  obstacles[0].chains = solid;
  obstacles[0].chain_count = 1;
  obstacles[0].radius = 0.1;
  obstacles[0].fill = AVO_FILL_SOLID;
  obstacles[1].chains = thin;
  obstacles[1].chain_count = 2;
  obstacles[1].radius = 0.2;

  def.sensing_radius = 20.0;
  def.max_neighbors = 8;
  def.control_time = 1.5;
  def.response_time = 0.2, def.margin = 0.1;
  def.comfort_acceleration = 0.6, def.comfort_jerk = 2.0;
  def.never_swerves = true;
  def.seed = 7;
  def.right_of_way = AVO_RIGHT_OF_WAY_NONE;
  def.sensing.noise.position = 0.01;
  def.sensing.noise.velocity = 0.02;
  def.sensing.noise.distribution = AVO_NOISE_UNIFORM;
  def.robots = robots;
  def.robot_count = 6;
  def.moving_obstacles = movers;
  def.moving_obstacle_count = 2;
  def.obstacles = obstacles;
  def.obstacle_count = 2;
  REQUIRE(avo_create_simulation(&def, &simulation));
  return simulation;
}

static void edit(avo_simulation_id simulation) {
  static const avo_vec2 line[] = {{-20.0, -20.0}, {-18.0, -20.0}};
  const avo_chain chain = {line, 2, false};
  const avo_robot_id first = {1};
  avo_robot_id robot = {0};
  avo_obstacle_id obstacle = {0}, there[4];
  size_t count = 0;
  avo_vec2 position;
  avo_robot_def added = avo_default_robot_def();
  avo_obstacle_def wall = avo_default_obstacle_def();
  added.position = at(-14.0, -14.0);
  added.goal = at(14.0, -14.0);
  wall.chains = &chain;
  wall.chain_count = 1;
  REQUIRE(avo_simulation_remove_robot(simulation, first));
  REFUSES(avo_simulation_remove_robot(simulation, first), AVO_ERROR_INVALID_ID, "robot: found 1");
  REFUSES(avo_simulation_get_position(simulation, first, &position), AVO_ERROR_INVALID_ID,
          "robot: found 1");
  REQUIRE(avo_simulation_add_robot(simulation, &added, &robot));
  CHECK(robot.value == 7);
  REQUIRE(avo_simulation_set_goal(simulation, robot, at(14.0, -13.0)));
  REQUIRE(avo_simulation_move_robot(simulation, robot, at(-13.0, -14.0)));
  REQUIRE(avo_simulation_get_position(simulation, robot, &position));
  CHECK(position.x == -13.0 && position.y == -14.0);
  REFUSES(avo_simulation_move_robot(simulation, first, at(0.0, 0.0)), AVO_ERROR_INVALID_ID,
          "robot: found 1");
  REQUIRE(avo_simulation_add_obstacle(simulation, &wall, &obstacle));
  CHECK(obstacle.value == 3);
  there[0].value = 1;
  REQUIRE(avo_simulation_remove_obstacle(simulation, there[0]));
  REFUSES(avo_simulation_remove_obstacle(simulation, there[0]), AVO_ERROR_INVALID_ID,
          "obstacle: found 1");
  REQUIRE(avo_simulation_obstacles(simulation, there, 4, &count));
  CHECK(count == 2 && there[0].value == 2 && there[1].value == 3);
  REFUSES(avo_simulation_obstacles(simulation, there, 1, &count), AVO_ERROR_BUFFER_TOO_SMALL,
          "capacity: found 1, must be >= 2");
}

/* What the getters say of each robot is what the columns say. */
static void check_columns(avo_simulation_id simulation) {
  avo_columns columns;
  avo_moving_obstacle_columns movers;
  size_t robots = 0;
  REQUIRE(avo_simulation_get_robot_count(simulation, &robots));
  REQUIRE(avo_simulation_columns(simulation, &columns));
  CHECK(columns.count == robots);
  for (size_t k = 0; k < columns.count; ++k) {
    const avo_robot_id robot = columns.id[k];
    avo_vec2 position, velocity, goal;
    avo_plan plan;
    avo_robot_def def = avo_default_robot_def();
    double heading = 0.0, acceleration = 0.0;
    size_t index = 0;
    CHECK(robot.value > (k == 0 ? 0 : columns.id[k - 1].value));
    REQUIRE(avo_simulation_index_of(simulation, robot, &index));
    REQUIRE(avo_simulation_get_position(simulation, robot, &position));
    REQUIRE(avo_simulation_get_velocity(simulation, robot, &velocity));
    REQUIRE(avo_simulation_get_goal(simulation, robot, &goal));
    REQUIRE(avo_simulation_get_heading(simulation, robot, &heading));
    REQUIRE(avo_simulation_get_plan(simulation, robot, &plan));
    REQUIRE(avo_simulation_get_applied_acceleration(simulation, robot, &acceleration));
    REQUIRE(avo_simulation_get_robot_def(simulation, robot, &def));
    CHECK(index == k && heading == columns.heading[k]);
    CHECK(memcmp(&position, &columns.position[k], sizeof position) == 0);
    CHECK(memcmp(&velocity, &columns.velocity[k], sizeof velocity) == 0);
    CHECK(memcmp(&goal, &columns.goal[k], sizeof goal) == 0);
    CHECK(plan.status == columns.plan[k].status && plan.violation == columns.plan[k].violation);
    CHECK(memcmp(&plan.new_velocity, &columns.plan[k].new_velocity, sizeof(avo_vec2)) == 0);
    CHECK(acceleration == columns.applied_acceleration[k]);
    CHECK(memcmp(&def.position, &position, sizeof position) == 0);
  }
  REQUIRE(avo_simulation_moving_obstacles(simulation, &movers));
  CHECK(movers.count == 2 && movers.position[0].x == 0.0 && movers.velocity[0].y == 0.5);
}

/* The definitions that a simulation tells are those that made it. */
static void check_definitions(avo_simulation_id simulation) {
  avo_robot_def made[6], told = avo_default_robot_def();
  define_robots(made);
  for (size_t k = 0; k < 6; ++k) {
    const avo_robot_id robot = {k + 1};
    REQUIRE(avo_simulation_get_robot_def(simulation, robot, &told));
    CHECK(told.model == made[k].model && told.behavior == made[k].behavior);
    CHECK(told.radius == made[k].radius && told.max_speed == made[k].max_speed);
    CHECK(told.layers == made[k].layers && told.avoids == made[k].avoids);
    CHECK(told.priority == made[k].priority && told.max_braking == made[k].max_braking);
    CHECK(told.car.body.radius == made[k].car.body.radius);
    CHECK(told.car.max_curvature == made[k].car.max_curvature);
    CHECK(told.car.reverse == made[k].car.reverse);
    CHECK(told.drive.offset == made[k].drive.offset);
  }
}

/* Half of the smaller one of its radius and track, unless it is given. */
static void check_offset_of_a_small_drive(void) {
  avo_simulation_def def = avo_default_simulation_def();
  avo_robot_def robots[2], told = {.size = sizeof told};
  avo_simulation_id simulation;
  for (size_t k = 0; k < 2; ++k) {
    robots[k] = avo_default_robot_def();
    CHECK(robots[k].drive.offset == 0.0);
    robots[k].position = robots[k].goal = at(0.0, 2.0 * (double)k);
    robots[k].radius = 0.1;
    robots[k].max_speed = robots[k].max_acceleration = 0.5;
    robots[k].model = AVO_MODEL_DIFFERENTIAL_DRIVE;
    robots[k].drive.track = 0.16;
  }
  robots[1].drive.offset = 0.2;
  def.robots = robots;
  def.robot_count = 2;
  REQUIRE(avo_create_simulation(&def, &simulation));
  const avo_robot_id first = {1}, second = {2};
  REQUIRE(avo_simulation_get_robot_def(simulation, first, &told));
  CHECK(told.drive.offset == 0.05);
  REQUIRE(avo_simulation_get_robot_def(simulation, second, &told));
  CHECK(told.drive.offset == 0.2);
  REQUIRE(avo_destroy_simulation(simulation));
}

static void check_clocks_and_goals(avo_simulation_id simulation) {
  const avo_robot_id moving = {2}, parked = {5};
  double time = -1.0, next = -1.0;
  int64_t steps = -1;
  bool at_goal = false, decided = false;
  size_t count = 99;
  REQUIRE(avo_simulation_get_time(simulation, &time));
  REQUIRE(avo_simulation_get_steps(simulation, &steps));
  CHECK(steps == 40 && fabs(time - 4.0) < 1e-9);
  REQUIRE(avo_simulation_get_next_decision(simulation, moving, &next));
  CHECK(next == time);
  REQUIRE(avo_simulation_get_next_decision(simulation, parked, &next));
  CHECK(isinf(next));
  REQUIRE(avo_simulation_is_at_goal(simulation, parked, &at_goal));
  REQUIRE(avo_simulation_decided(simulation, moving, &decided));
  CHECK(at_goal && decided);
  REQUIRE(avo_simulation_all_at_goal(simulation, &at_goal));
  CHECK(!at_goal);
  REQUIRE(avo_simulation_unreachable(simulation, NULL, 0, &count));
  CHECK(count == 0);
  REQUIRE(avo_simulation_get_distance_left(simulation, moving, &next));
  CHECK(next == 0.0);
  avo_route route;
  avo_vec2 place, goal;
  REQUIRE(avo_simulation_get_route(simulation, moving, &route));
  REQUIRE(avo_simulation_get_position(simulation, moving, &place));
  REQUIRE(avo_simulation_get_goal(simulation, moving, &goal));
  CHECK(route.length >= hypot(goal.x - place.x, goal.y - place.y) && route.distance_left == 0.0);
  CHECK(hypot(route.next.x - place.x, route.next.y - place.y) <= route.length);
  avo_wait wait = {true, {0.0, 0.0}, {9}, true, {0.0, 0.0}, {0.0, 0.0}};
  REQUIRE(avo_simulation_get_wait(simulation, moving, &wait));
  CHECK(!wait.waits);
  char words[256];
  REQUIRE(avo_simulation_explain(simulation, moving, NULL, 0, &count));
  CHECK(count > 20 && count <= sizeof words);
  CHECK(avo_simulation_explain(simulation, moving, words, count - 1, &count) ==
        AVO_ERROR_BUFFER_TOO_SMALL);
  REQUIRE(avo_simulation_explain(simulation, moving, words, sizeof words, &count));
  CHECK(strlen(words) + 1 == count && strncmp(words, "Robot ", 6) == 0);
  CHECK(avo_simulation_explain(simulation, parked, words, sizeof words, &count) ==
        AVO_ERROR_INVALID_VALUE);
}

/* Two airplanes: the first leaves at its goal, and its id is that of none then. */
static void check_sky(void) {
  const avo_robot_id first = {1}, second = {2};
  avo_robot_def robots[2], told = avo_default_robot_def();
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id simulation;
  avo_columns columns;
  size_t index = 9;
  for (int k = 0; k < 2; ++k) {
    robots[k] = avo_default_robot_def();
    robots[k].model = AVO_MODEL_AIRPLANE;
    robots[k].airplane.min_speed = 1.0;
    robots[k].airplane.lateral_acceleration = 0.9;
  }
  robots[0].position = at(-30.0, 20.0);
  robots[0].goal = at(30.0, 20.0);
  robots[0].velocity = at(1.5, 0.0);
  robots[0].airplane.after_goal = AVO_AFTER_GOAL_LEAVE;
  robots[1].position = at(30.0, 19.5);
  robots[1].goal = at(-30.0, 19.5);
  robots[1].heading = 3.0;
  def.sensing_radius = 80.0;
  def.robots = robots;
  def.robot_count = 2;
  REQUIRE(avo_create_simulation(&def, &simulation));
  steps_of(simulation, 200);
  CHECK(hash_of(simulation) == cpp_sky_hash(200));
  REQUIRE(avo_simulation_get_robot_def(simulation, first, &told));
  CHECK(told.model == AVO_MODEL_AIRPLANE && told.airplane.after_goal == AVO_AFTER_GOAL_LEAVE);
  CHECK(told.airplane.lateral_acceleration == 0.9);
  REQUIRE(avo_simulation_columns(simulation, &columns));
  CHECK(columns.count == 2);
  steps_of(simulation, 300);
  CHECK(hash_of(simulation) == cpp_sky_hash(500));
  REFUSES(avo_simulation_index_of(simulation, first, &index), AVO_ERROR_INVALID_ID,
          "robot: found 1");
  REQUIRE(avo_simulation_index_of(simulation, second, &index));
  REQUIRE(avo_simulation_columns(simulation, &columns));
  CHECK(index == 0 && columns.count == 1 && columns.id[0].value == 2);
  REQUIRE(avo_destroy_simulation(simulation));
}

int main(void) {
  uint64_t expected[3];
  avo_simulation_id simulation = make_yard(), copy;
  char *saved, zero[8] = {0};
  size_t size = 0, written = 0;
  check_sky();
  cpp_yard_hashes(expected);
  check_definitions(simulation);
  steps_of(simulation, 40);
  CHECK(hash_of(simulation) == expected[0]);
  check_clocks_and_goals(simulation);
  check_columns(simulation);
  edit(simulation);
  check_columns(simulation);
  steps_of(simulation, 40);
  CHECK(hash_of(simulation) == expected[1]);

  REQUIRE(avo_simulation_save(simulation, NULL, 0, &size));
  saved = malloc(size);
  CHECK(saved != NULL && size > 500);
  REFUSES(avo_simulation_save(simulation, zero, 8, &written), AVO_ERROR_BUFFER_TOO_SMALL,
          "capacity: found 8, must be >= ");
  CHECK(written == size && zero[0] == 0);
  REQUIRE(avo_simulation_save(simulation, saved, size, &written));
  CHECK(written == size);
  steps_of(simulation, 40);
  CHECK(hash_of(simulation) == expected[2]);
  REQUIRE(avo_simulation_restore(simulation, saved, size));
  CHECK(hash_of(simulation) == expected[1]);
  check_columns(simulation);
  steps_of(simulation, 40);
  CHECK(hash_of(simulation) == expected[2]);
  REQUIRE(avo_create_simulation_from_saved(saved, size, NULL, &copy));
  steps_of(copy, 40);
  CHECK(hash_of(copy) == expected[2]);

  /* bytes that were cut off or changed change nothing */
  CHECK(avo_simulation_restore(copy, saved, size - 1) == AVO_ERROR_INVALID_VALUE);
  saved[size / 2] = (char)(saved[size / 2] ^ 1);
  CHECK(avo_simulation_restore(copy, saved, size) == AVO_ERROR_INVALID_VALUE);
  CHECK(avo_create_simulation_from_saved(saved, size, NULL, &copy) == AVO_ERROR_INVALID_VALUE);
  CHECK(hash_of(copy) == expected[2]);
  free(saved);
  REQUIRE(avo_destroy_simulation(copy));
  REQUIRE(avo_destroy_simulation(simulation));
  check_offset_of_a_small_drive();
  return 0;
}
