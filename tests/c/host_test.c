/* SPDX-License-Identifier: Apache-2.0 */
/* The host changes robots, leads them, moves a player and asks what is where. */
#include <math.h>

#include "check.h"

static avo_simulation_id lanes(void) {
  avo_robot_def robots[4];
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id simulation;
  for (int k = 0; k < 4; ++k) {
    robots[k] = avo_default_robot_def();
    robots[k].position.x = -20.0, robots[k].goal.x = 20.0;
    robots[k].position.y = robots[k].goal.y = 4.0 * k;
  }
  def.robots = robots, def.robot_count = 4;
  REQUIRE(avo_create_simulation(&def, &simulation));
  return simulation;
}

static void check_robots(void) {
  const avo_simulation_id simulation = lanes();
  const avo_vec2 up = {0.0, 0.5}, fast = {0.0, 1.5};
  const avo_robot_id second = {2}, gone = {77};
  avo_robot_def def = avo_default_robot_def();
  avo_vec2 position, velocity, given = {9.0, 9.0};
  bool is_there = true, is_set = true;
  REQUIRE(avo_simulation_get_robot_def(simulation, second, &def));
  def.max_speed = def.preferred_speed = 0.5;
  def.goal.x = 99.0; /* not read */
  REQUIRE(avo_simulation_change_robot(simulation, second, &def));
  REQUIRE(avo_simulation_get_robot_def(simulation, second, &def));
  CHECK(def.max_speed == 0.5 && def.goal.x == 20.0);
  def.radius = -1.0;
  REFUSES(avo_simulation_change_robot(simulation, second, &def), AVO_ERROR_INVALID_VALUE,
          "robot 1: radius: found -1, must be > 0 m");
  REFUSES(avo_simulation_change_robot(simulation, gone, &def), AVO_ERROR_INVALID_ID, "robot");
  REQUIRE(avo_simulation_get_preferred_velocity(simulation, second, &given, &is_set));
  CHECK(!is_set && given.x == 9.0);
  REQUIRE(avo_simulation_set_preferred_velocity(simulation, second, &up));
  REQUIRE(avo_simulation_get_preferred_velocity(simulation, second, &given, &is_set));
  CHECK(is_set && given.x == 0.0 && given.y == 0.5);
  REFUSES(avo_simulation_get_preferred_velocity(simulation, gone, &given, &is_set),
          AVO_ERROR_INVALID_ID, "robot");
  REFUSES(avo_simulation_get_preferred_velocity(simulation, second, NULL, &is_set),
          AVO_ERROR_INVALID_ARGUMENT, "velocity");
  for (int k = 0; k < 100; ++k) REQUIRE(avo_simulation_step(simulation));
  REQUIRE(avo_simulation_get_position(simulation, second, &position));
  CHECK(position.x < -19.0 && position.y > 7.0);
  REQUIRE(avo_simulation_is_at_goal(simulation, second, &is_there));
  CHECK(!is_there);
  REQUIRE(avo_simulation_set_preferred_velocity(simulation, second, NULL));
  REQUIRE(avo_simulation_set_velocity(simulation, second, &up));
  REQUIRE(avo_simulation_step(simulation));
  REQUIRE(avo_simulation_get_velocity(simulation, second, &velocity));
  CHECK(velocity.x == 0.0 && velocity.y == 0.5);
  REQUIRE(avo_simulation_get_host_velocity(simulation, second, &given, &is_set));
  CHECK(is_set && given.y == 0.5);
  REQUIRE(avo_simulation_get_preferred_velocity(simulation, second, &given, &is_set));
  CHECK(!is_set);
  REFUSES(avo_simulation_set_velocity(simulation, second, &fast), AVO_ERROR_INVALID_VALUE,
          "robot 1: velocity: found 1.5 m/s, must be at most its max_speed, 0.5 m/s");
  REQUIRE(avo_simulation_set_velocity(simulation, second, NULL));
  for (int k = 0; k < 1200; ++k) REQUIRE(avo_simulation_step(simulation));
  REQUIRE(avo_simulation_is_at_goal(simulation, second, &is_there));
  CHECK(is_there);
  REQUIRE(avo_destroy_simulation(simulation));
}

static void check_bulk(void) {
  const avo_simulation_id simulation = lanes();
  const avo_robot_id some[2] = {{1}, {3}};
  const avo_vec2 goals[2] = {{0.0, -9.0}, {0.0, 19.0}}, velocities[2] = {{1.0, 0.0}, {0.5, 0.5}};
  avo_robot_def defs[2];
  avo_robot_id ids[2];
  avo_vec2 goal;
  uint64_t roster[2];
  for (int k = 0; k < 2; ++k) {
    defs[k] = avo_default_robot_def();
    defs[k].position.x = defs[k].goal.x = 50.0 + 3.0 * k;
  }
  REQUIRE(avo_simulation_set_goals(simulation, some, goals, 2));
  REQUIRE(avo_simulation_get_goal(simulation, some[1], &goal));
  CHECK(goal.y == 19.0);
  REQUIRE(avo_simulation_set_preferred_velocities(simulation, some, velocities, 2));
  REQUIRE(avo_simulation_get_roster(simulation, &roster[0]));
  REQUIRE(avo_simulation_add_robots(simulation, defs, 2, ids));
  REQUIRE(avo_simulation_get_roster(simulation, &roster[1]));
  CHECK(roster[0] != roster[1]);
  CHECK(ids[0].value == 5 && ids[1].value == 6);
  REFUSES(avo_simulation_add_robots(simulation, defs, 2, ids), AVO_ERROR_INVALID_VALUE, "robot 6");
  REQUIRE(avo_simulation_remove_robots(simulation, ids, 2));
  REFUSES(avo_simulation_remove_robots(simulation, ids, 2), AVO_ERROR_INVALID_ID, "robot");
  REFUSES(avo_simulation_set_goals(simulation, some, NULL, 2), AVO_ERROR_INVALID_ARGUMENT,
          "values");
  REQUIRE(avo_simulation_set_goals(simulation, NULL, NULL, 0));
  REQUIRE(avo_destroy_simulation(simulation));
}

static void check_player_and_queries(void) {
  const avo_simulation_id simulation = lanes();
  const avo_vec2 origin = {0.0, 0.0}, left = {-30.0, 0.0}, above = {0.0, 30.0};
  avo_moving_obstacle_def player = avo_default_moving_obstacle_def();
  avo_moving_obstacle_id id, listed[2];
  avo_robot_id near[4];
  avo_moving_obstacle_columns columns;
  avo_hit hit;
  size_t count = 0;
  bool is_free = false;
  player.position.x = 5.0;
  player.max_deviation = 2.0, player.max_speed = 1.5;
  REQUIRE(avo_simulation_add_moving_obstacle(simulation, &player, &id));
  CHECK(id.value == 1);
  player.velocity.y = 1.0;
  REQUIRE(avo_simulation_change_moving_obstacle(simulation, id, &player));
  REQUIRE(avo_simulation_step(simulation));
  REQUIRE(avo_simulation_moving_obstacles(simulation, &columns));
  CHECK(columns.count == 1 && fabs(columns.position[0].y - 0.1) < 1e-12);
  REQUIRE(avo_simulation_moving_obstacle_ids(simulation, listed, 2, &count));
  CHECK(count == 1 && listed[0].value == 1);
  REQUIRE(avo_simulation_nearest_robots(simulation, left, near, 2, &count));
  CHECK(count == 2 && near[0].value == 1 && near[1].value == 2);
  REQUIRE(avo_simulation_robots_within(simulation, left, 10.5, near, 4, &count));
  CHECK(count == 2);
  REQUIRE(avo_simulation_is_free(simulation, origin, 1.0, AVO_ALL_LAYERS, &is_free));
  CHECK(is_free);
  REQUIRE(avo_simulation_cast_ray(simulation, origin, left, 0.0, AVO_ALL_LAYERS, &hit));
  CHECK(hit.robot.value == 1 && hit.moving_obstacle.value == 0 && hit.obstacle.value == 0);
  REQUIRE(avo_simulation_cast_ray(simulation, origin, above, 0.0, AVO_ALL_LAYERS, &hit));
  CHECK(hit.robot.value == 0 && hit.distance == 30.0);
  REFUSES(avo_simulation_is_free(simulation, origin, 0.0, AVO_ALL_LAYERS, &is_free),
          AVO_ERROR_INVALID_VALUE, "is_free: radius: found 0, must be > 0 m");
  REQUIRE(avo_simulation_remove_moving_obstacle(simulation, id));
  REFUSES(avo_simulation_remove_moving_obstacle(simulation, id), AVO_ERROR_INVALID_ID,
          "obstacle: found 1");
  REQUIRE(avo_destroy_simulation(simulation));
}

/* The definitions of what is there, of the scene and of edits. */
static void check_obstacles(void) {
  const avo_simulation_id simulation = lanes();
  const avo_vec2 path[2] = {{5.0, -9.0}, {5.0, 9.0}},
                 ends[3] = {{1.0, 20.0}, {2.0, 20.0}, {2.0, 21.0}};
  const avo_chain chains[2] = {{ends, 3, true}, {path, 2, false}};
  avo_moving_obstacle_def walker = avo_default_moving_obstacle_def(), found = walker;
  avo_moving_obstacle_columns columns;
  avo_moving_obstacle_id mover;
  avo_obstacle_def wall = avo_default_obstacle_def(), given = wall, again = wall;
  avo_obstacle_id id;
  walker.position.x = 5.0, walker.max_deviation = 2.0, walker.max_speed = 1.5, walker.radius = 0.3;
  walker.path = path, walker.path_count = 2;
  REQUIRE(avo_simulation_add_moving_obstacle(simulation, &walker, &mover));
  steps_of(simulation, 100);
  REQUIRE(avo_simulation_moving_obstacles(simulation, &columns));
  REQUIRE(avo_simulation_get_moving_obstacle_def(simulation, mover, &found));
  CHECK(found.position.y == columns.position[0].y && found.velocity.y == columns.velocity[0].y);
  CHECK(found.position.y < -1.0 && columns.next_point[0] < 2);
  CHECK(found.radius == 0.3 && found.path_count == 2 && found.path[1].y == 9.0);
  REQUIRE(avo_simulation_change_moving_obstacle(simulation, mover, &found));
  wall.chains = chains, wall.chain_count = 1, wall.fill = AVO_FILL_SOLID, wall.layers = 6;
  REQUIRE(avo_simulation_add_obstacle(simulation, &wall, &id));
  REQUIRE(avo_simulation_get_obstacle_def(simulation, id, &given));
  REQUIRE(avo_simulation_get_obstacle_def(simulation, id, &again));
  CHECK(given.chain_count == 1 && given.chains == again.chains && given.chains[0].closed);
  CHECK(given.chains[0].point_count == 3 && given.chains[0].points[2].y == 21.0);
  CHECK(given.fill == AVO_FILL_SOLID && given.layers == 6 && given.radius == 0.0);
  REQUIRE(avo_simulation_add_obstacle(simulation, &given, &id));
  CHECK(id.value == 2);
  REQUIRE(avo_simulation_remove_obstacle(simulation, id));
  REFUSES(avo_simulation_get_obstacle_def(simulation, id, &given), AVO_ERROR_INVALID_ID,
          "obstacle: found 2");
  REQUIRE(avo_simulation_remove_moving_obstacle(simulation, mover));
  REFUSES(avo_simulation_get_moving_obstacle_def(simulation, mover, &found), AVO_ERROR_INVALID_ID,
          "obstacle: found 1");
  REQUIRE(avo_destroy_simulation(simulation));
}

/* A wall of another floor. */
static void check_floors(void) {
  const avo_simulation_id simulation = lanes();
  const avo_vec2 ends[2] = {{1.0, -20.0}, {1.0, 20.0}}, origin = {0.0, 0.0}, right = {2.0, 0.0};
  const avo_chain chain = {ends, 2, false};
  avo_obstacle_def wall = avo_default_obstacle_def();
  avo_obstacle_id id;
  avo_robot_def robot = avo_default_robot_def();
  avo_robot_id guest;
  avo_hit hit;
  bool sees = false;
  CHECK(wall.layers == AVO_ALL_LAYERS);
  wall.chains = &chain, wall.chain_count = 1, wall.layers = 2;
  REQUIRE(avo_simulation_add_obstacle(simulation, &wall, &id));
  REQUIRE(avo_simulation_is_in_sight(simulation, origin, right, 0.0, 1, &sees));
  CHECK(sees);
  REQUIRE(avo_simulation_is_in_sight(simulation, origin, right, 0.0, 2, &sees));
  CHECK(!sees);
  REQUIRE(avo_simulation_cast_ray(simulation, origin, right, 0.0, 2, &hit));
  CHECK(hit.obstacle.value == id.value && fabs(hit.distance - 1.0) < 1e-6);
  robot.position = ends[1], robot.position.y = 0.0, robot.goal = robot.position;
  REQUIRE(avo_simulation_add_robot(simulation, &robot, &guest));
  robot.layers = 2, robot.position.y = robot.goal.y = 18.0;
  REFUSES(avo_simulation_add_robot(simulation, &robot, &guest), AVO_ERROR_INVALID_VALUE,
          "obstacle");
  REQUIRE(avo_destroy_simulation(simulation));
}

int main(void) {
  check_floors();
  check_robots();
  check_bulk();
  check_obstacles();
  check_player_and_queries();
  return 0;
}
