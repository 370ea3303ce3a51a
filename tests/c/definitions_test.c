/* SPDX-License-Identifier: Apache-2.0 */
/* Definitions are taken by the sizes that were released, and by no other. */
#include "check.h"

/* The call refuses every size of `def` but that which avo_default_*() has set, and with that does
 * what it is asked for. */
#define TAKES_ITS_SIZE_ALONE(def, where, call)                                               \
  do {                                                                                       \
    const size_t present = (def).size;                                                       \
    const size_t others[] = {0,           8,           present / 2,     present - 8,         \
                             present - 1, present + 1, present + 8,     2 * present,         \
                             (size_t)-1,  (size_t)-8,  present / 16 * 8};                    \
    CHECK(present == sizeof(def));                                                           \
    for (size_t k = 0; k < sizeof others / sizeof *others; ++k) {                            \
      char text[100];                                                                        \
      snprintf(text, sizeof text, "%s.size: found %zu, must be what avo_default_*() sets, ", \
               where, others[k]);                                                            \
      (def).size = others[k];                                                                \
      REFUSES(call, AVO_ERROR_INVALID_DEFINITION, text);                                     \
    }                                                                                        \
    (def).size = present;                                                                    \
    REQUIRE(call);                                                                           \
  } while (0)

static void check_planner(void) {
  avo_planner_def options = avo_default_planner_def(AVO_METHOD_AVO);
  avo_robot robot = avo_default_robot();
  avo_neighbor neighbor = avo_default_neighbor();
  avo_planner_id planner;
  avo_plan plan;
  neighbor.position.x = 5.0;
  TAKES_ITS_SIZE_ALONE(options, "def", avo_create_planner(&options, &planner));
  TAKES_ITS_SIZE_ALONE(robot, "robot",
                       avo_planner_plan(planner, &robot, NULL, 0, NULL, 0, NULL, &plan));
  TAKES_ITS_SIZE_ALONE(neighbor, "neighbors.0",
                       avo_planner_plan(planner, &robot, &neighbor, 1, NULL, 0, NULL, &plan));
  REQUIRE(avo_destroy_planner(planner));
}

static void check_scene(void) {
  static const avo_vec2 points[2] = {{100.0, 0.0}, {100.0, 5.0}};
  const avo_chain chain = {points, 2, false};
  avo_robot_def robot = avo_default_robot_def();
  avo_moving_obstacle_def mover = avo_default_moving_obstacle_def();
  avo_obstacle_def wall = avo_default_obstacle_def();
  avo_simulation_def def = avo_default_simulation_def();
  avo_summary summary = avo_default_summary();
  avo_simulation_id simulation;
  avo_robot_id id;
  avo_obstacle_id door;
  mover.position.x = 50.0;
  wall.chains = &chain;
  wall.chain_count = 1;
  def.robots = &robot;
  def.robot_count = 1;
  def.moving_obstacles = &mover;
  def.moving_obstacle_count = 1;
  def.obstacles = &wall;
  def.obstacle_count = 1;
  def.metrics = true;
  TAKES_ITS_SIZE_ALONE(robot, "robots.0", avo_create_simulation(&def, &simulation));
  TAKES_ITS_SIZE_ALONE(mover, "moving_obstacles.0", avo_create_simulation(&def, &simulation));
  TAKES_ITS_SIZE_ALONE(wall, "obstacles.0", avo_create_simulation(&def, &simulation));
  TAKES_ITS_SIZE_ALONE(def, "def", avo_create_simulation(&def, &simulation));
  robot.position.x = robot.goal.x = 10.0;
  TAKES_ITS_SIZE_ALONE(robot, "def", avo_simulation_add_robot(simulation, &robot, &id));
  TAKES_ITS_SIZE_ALONE(robot, "def", avo_simulation_get_robot_def(simulation, id, &robot));
  TAKES_ITS_SIZE_ALONE(wall, "def", avo_simulation_add_obstacle(simulation, &wall, &door));
  TAKES_ITS_SIZE_ALONE(summary, "summary", avo_simulation_summary(simulation, &summary));
}

/* Definitions that the library writes, and those of which it reads a part. */
static void check_loaded(void) {
  avo_scene_id scene = {0, 0};
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id simulation, copy;
  char saved[4096];
  size_t size = 0;
  CHECK(avo_scene_get_def(scene, &def) == AVO_ERROR_INVALID_ID);
  REQUIRE(avo_load_scene("circle-2", NULL, 0, &scene));
  TAKES_ITS_SIZE_ALONE(def, "def", avo_scene_get_def(scene, &def));
  REQUIRE(avo_create_simulation(&def, &simulation));
  REQUIRE(avo_simulation_save(simulation, saved, sizeof saved, &size));
  TAKES_ITS_SIZE_ALONE(def, "def", avo_create_simulation_from_saved(saved, size, &def, &copy));
  REQUIRE(avo_destroy_scene(scene));
}

/* Those of an array have one size, and nothing has been made where they have not. */
static void check_arrays(void) {
  avo_robot_def robots[2] = {avo_default_robot_def(), avo_default_robot_def()};
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id simulation = {0, 0};
  robots[1].position.x = robots[1].goal.x = 10.0;
  def.robots = robots;
  def.robot_count = 2;
  TAKES_ITS_SIZE_ALONE(robots[1], "robots.1", avo_create_simulation(&def, &simulation));
  robots[1].size = 0;
  simulation.index = simulation.generation = 0;
  CHECK(avo_create_simulation(&def, &simulation) == AVO_ERROR_INVALID_DEFINITION);
  CHECK(simulation.index == 0 && simulation.generation == 0);
}

/* A robot may have a method of its own, and what moves by times is where they say. */
static void check_methods_and_trajectories(void) {
  static const avo_timed_place places[2] = {{0.0, {20.0, 3.0}}, {2.0, {20.0, 1.0}}};
  avo_robot_def robot = avo_default_robot_def();
  avo_moving_obstacle_def mover = avo_default_moving_obstacle_def();
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id simulation;
  avo_robot_id id;
  CHECK(robot.method == AVO_UNSET && robot.time_horizon == 0.0);
  CHECK(robot.arrival_distance == 0.0);
  robot.method = AVO_METHOD_ORCA;
  robot.time_horizon = 5.0;
  robot.arrival_distance = 0.25;
  mover.trajectory = places;
  mover.trajectory_count = 2;
  def.robots = &robot;
  def.robot_count = 1;
  def.moving_obstacles = &mover;
  def.moving_obstacle_count = 1;
  REQUIRE(avo_create_simulation(&def, &simulation));
  robot.position.x = robot.goal.x = 10.0;
  robot.method = AVO_UNSET;
  robot.time_horizon = robot.arrival_distance = 0.0;
  REQUIRE(avo_simulation_add_robot(simulation, &robot, &id));
  REQUIRE(avo_simulation_get_robot_def(simulation, id, &robot));
  CHECK(robot.method == AVO_UNSET && robot.time_horizon == 0.0);
  CHECK(robot.arrival_distance == 0.0);
  id.value = 1;
  REQUIRE(avo_simulation_get_robot_def(simulation, id, &robot));
  CHECK(robot.method == AVO_METHOD_ORCA && robot.time_horizon == 5.0);
  CHECK(robot.arrival_distance == 0.25);
  REQUIRE(avo_destroy_simulation(simulation));
  robot.method = 9;
  def.robots = &robot;
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "robots.0.method: found 9, must be 0 to 8");
}

/* 0 stands for what the robots need, also of those that come later. */
static void check_sensing_radius(void) {
  avo_robot_def robots[2] = {avo_default_robot_def(), avo_default_robot_def()};
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id simulation;
  avo_robot_id id;
  double radius = 0.0;
  robots[1].position.x = robots[1].goal.x = 10.0;
  def.robots = robots;
  def.robot_count = 2;
  CHECK(def.sensing_radius == 0.0);
  TAKES_ITS_SIZE_ALONE(def, "def", avo_needed_sensing_radius(&def, &radius));
  CHECK(radius == 9.0);
  REQUIRE(avo_create_simulation(&def, &simulation));
  REQUIRE(avo_simulation_get_sensing_radius(simulation, &radius));
  CHECK(radius == 9.0);
  robots[0].position.y = 50.0;
  robots[0].max_speed = 4.0;
  REQUIRE(avo_simulation_add_robot(simulation, &robots[0], &id));
  REQUIRE(avo_simulation_get_sensing_radius(simulation, &radius));
  CHECK(radius == 24.0);
  REQUIRE(avo_destroy_simulation(simulation));

  def.sensing_radius = 7.0;
  REQUIRE(avo_needed_sensing_radius(&def, &radius));
  CHECK(radius == 24.0);
  REFUSES(avo_needed_sensing_radius(&def, NULL), AVO_ERROR_INVALID_ARGUMENT, "radius: found null");
  def.sensing_radius = -1.0;
  REFUSES(avo_needed_sensing_radius(&def, &radius), AVO_ERROR_INVALID_VALUE,
          "sensing_radius: found -1");
}

int main(void) {
  check_methods_and_trajectories();
  check_sensing_radius();
  check_planner();
  check_scene();
  check_loaded();
  check_arrays();
  return 0;
}
