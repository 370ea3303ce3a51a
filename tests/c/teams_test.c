/* SPDX-License-Identifier: Apache-2.0 */
/* Teams: of a scene, led by the host, and formations. */
#include <math.h>

#include "check.h"

static const char* kScene =
    "version: 1\n"
    "groups:\n"
    "  - {number: 3, radius: 0.3, placement: {grid: {spacing: 2, columns: 3}}, goals: {offset: "
    "{by: [9, 9]}},\n"
    "     task: {queue: {line: [[8, 0], [0, 0]], service: 3}}}\n"
    "  - {number: 3, radius: 0.3, placement: {grid: {corner: [0, 30], spacing: 2, columns: 3}},\n"
    "     goals: {offset: {by: [20, 0]}}, task: follow}\n";

/* A team of a scene goes through its definition; the host leads as the scene does. */
static void check_scene(void) {
  avo_scene_id scene;
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id led, hosted;
  avo_team_id teams[2];
  REQUIRE(avo_parse_scene(kScene, strlen(kScene), "teams.yaml", NULL, 0, &scene));
  REQUIRE(avo_scene_get_def(scene, &def));
  CHECK(def.team_count == 2);
  CHECK(def.teams[0].task == AVO_TASK_QUEUE && def.teams[0].service == 3.0);
  CHECK(def.teams[0].point_count == 2 && def.teams[0].points[0].x == 8.0);
  CHECK(def.teams[1].task == AVO_TASK_FOLLOW && def.teams[1].robot_count == 3);
  CHECK(def.teams[1].robots[0].value == 4);
  REQUIRE(avo_create_simulation(&def, &led));
  for (int k = 0; k < 2; ++k) REQUIRE(avo_create_team(&def.teams[k], &teams[k]));
  def.teams = NULL, def.team_count = 0;
  REQUIRE(avo_create_simulation(&def, &hosted));
  for (int step = 0; step < 300; ++step) {
    REQUIRE(avo_simulation_step(led));
    for (int k = 0; k < 2; ++k) REQUIRE(avo_team_lead(teams[k], hosted));
    REQUIRE(avo_simulation_step(hosted));
    CHECK(hash_of(led) == hash_of(hosted));
  }
  REQUIRE(avo_destroy_simulation(led));
  REQUIRE(avo_destroy_simulation(hosted));
  REQUIRE(avo_destroy_scene(scene));
  REQUIRE(avo_destroy_team(teams[0]));
  CHECK(!avo_team_is_valid(teams[0]) && avo_team_is_valid(teams[1]));
  REFUSES(avo_team_lead(teams[0], led), AVO_ERROR_INVALID_ID, "team: found an id of none");
}

/* The teams of a scene are reached by their number. */
static void check_led(void) {
  avo_scene_id scene;
  avo_simulation_def def = avo_default_simulation_def();
  avo_team_def task = avo_default_team_def(), patrol = avo_default_team_def();
  avo_simulation_id led, other;
  avo_team_id queue, row, none;
  avo_robot_id served, members[8];
  const avo_robot_id fourth = {4};
  const avo_vec2 points[2] = {{0.0, 30.0}, {9.0, 30.0}};
  size_t count = 0;
  REQUIRE(avo_parse_scene(kScene, strlen(kScene), "teams.yaml", NULL, 0, &scene));
  REQUIRE(avo_scene_get_def(scene, &def));
  REQUIRE(avo_create_simulation(&def, &led));
  REQUIRE(avo_create_simulation(&def, &other));
  REQUIRE(avo_simulation_team_count(led, &count));
  CHECK(count == 2);
  REQUIRE(avo_simulation_team(led, 0, &queue));
  REQUIRE(avo_simulation_team(led, 1, &row));
  REFUSES(avo_simulation_team(led, 2, &none), AVO_ERROR_INVALID_VALUE,
          "number: found 2, must be less than 2, the teams that it leads");
  REQUIRE(avo_team_get_task(queue, &task));
  CHECK(task.task == AVO_TASK_QUEUE && task.point_count == 2 && task.service == 3.0);
  REQUIRE(avo_team_serve(queue, led, &served));
  REQUIRE(avo_team_robots(queue, members, 8, &count));
  CHECK(served.value != 0 && count == 2);
  REQUIRE(avo_team_remove(row, fourth));
  REFUSES(avo_team_remove(row, fourth), AVO_ERROR_INVALID_ID,
          "robot: found 4, must be one of the team");
  REQUIRE(avo_team_add(queue, fourth));
  REFUSES(avo_team_add(queue, fourth), AVO_ERROR_INVALID_VALUE,
          "robot: found 4, which is in the team, must be another one");
  patrol.task = AVO_TASK_PATROL, patrol.points = points, patrol.point_count = 2;
  REQUIRE(avo_team_set_task(row, led, &patrol));
  REQUIRE(avo_simulation_step(led));
  REQUIRE(avo_team_get_task(row, &task));
  CHECK(task.task == AVO_TASK_PATROL && task.points[1].x == 9.0);
  REFUSES(avo_team_lead(queue, other), AVO_ERROR_INVALID_ID,
          "team: found a team of another simulation, must be of this one");
  patrol.point_count = 0;
  REFUSES(avo_team_set_task(row, led, &patrol), AVO_ERROR_INVALID_VALUE, "points: found 0 points");
  REQUIRE(avo_destroy_simulation(led));
  REFUSES(avo_team_robots(queue, members, 8, &count), AVO_ERROR_INVALID_ID, "simulation: found");
  REQUIRE(avo_destroy_team(queue));
  REQUIRE(avo_destroy_simulation(other));
  REQUIRE(avo_destroy_scene(scene));
}

static void check_host(void) {
  avo_simulation_def def = avo_default_simulation_def();
  avo_robot_def robots[3];
  avo_simulation_id simulation;
  avo_team_def team_def = avo_default_team_def();
  avo_team_id team;
  const avo_robot_id two[2] = {{1}, {2}}, twice[2] = {{3}, {3}}, third = {3};
  const avo_vec2 line[2] = {{10.0, 0.0}, {0.0, 0.0}};
  avo_robot_id served, members[3];
  avo_vec2 goal;
  size_t count = 0;
  for (int k = 0; k < 3; ++k) {
    robots[k] = avo_default_robot_def();
    robots[k].position.x = -3.0 * k, robots[k].goal.y = 20.0 + 3.0 * k;
  }
  def.robots = robots, def.robot_count = 3;
  REQUIRE(avo_create_simulation(&def, &simulation));
  team_def.robots = two, team_def.robot_count = 2;
  team_def.points = line, team_def.point_count = 2;
  REQUIRE(avo_create_team(&team_def, &team));
  REQUIRE(avo_team_add(team, third));
  REQUIRE(avo_team_lead(team, simulation));
  REQUIRE(avo_simulation_get_goal(simulation, third, &goal));
  CHECK(goal.x == 7.0 && goal.y == 0.0);
  REQUIRE(avo_team_serve(team, simulation, &served));
  CHECK(served.value == 1);
  REFUSES(avo_team_robots(team, members, 1, &count), AVO_ERROR_BUFFER_TOO_SMALL, "must be >= 2");
  REQUIRE(avo_team_robots(team, members, 3, &count));
  CHECK(count == 2 && members[0].value == 2 && members[1].value == 3);
  REQUIRE(avo_simulation_get_goal(simulation, third, &goal));
  CHECK(goal.x == 8.5);
  REQUIRE(avo_team_disband(team, simulation));
  REQUIRE(avo_simulation_get_goal(simulation, third, &goal));
  CHECK(goal.y == 26.0);
  team_def.task = 7;
  REFUSES(avo_create_team(&team_def, &team), AVO_ERROR_INVALID_VALUE,
          "def.task: found 7, must be 0 to 3");
  team_def.task = AVO_TASK_FLOW, team_def.point_count = 1;
  REFUSES(avo_create_team(&team_def, &team), AVO_ERROR_INVALID_VALUE, "exits: found 1 points");
  team_def = avo_default_team_def();
  team_def.robots = twice, team_def.robot_count = 2;
  team_def.points = line, team_def.point_count = 2;
  REFUSES(avo_create_team(&team_def, &team), AVO_ERROR_INVALID_VALUE,
          "team: found robot 2 twice, must be each robot once");
  REQUIRE(avo_destroy_simulation(simulation));
}

static void check_formations(void) {
  const avo_vec2 center = {5.0, 1.0}, starts[3] = {{0.0, 0.0}, {0.0, 2.0}, {0.0, 4.0}};
  avo_vec2 slots[3];
  size_t chosen[3];
  REQUIRE(avo_formation_slots(AVO_FORMATION_LINE, 3, 2.0, center, 0.0, slots));
  CHECK(fabs(slots[0].x - 5.0) < 1e-12 && fabs(slots[0].y - 3.0) < 1e-12);
  REQUIRE(avo_assign_slots(starts, 3, slots, 3, chosen));
  CHECK(chosen[0] == 2 && chosen[1] == 1 && chosen[2] == 0);
  REQUIRE(avo_place_slots(starts, 3, center, 1.5707963267948966, slots));
  CHECK(fabs(slots[2].x - 1.0) < 1e-12 && fabs(slots[2].y - 1.0) < 1e-12);
  REQUIRE(avo_place_slots(slots, 3, center, 0.0, slots));
  CHECK(fabs(slots[2].x - 6.0) < 1e-12 && fabs(slots[2].y - 2.0) < 1e-12);
  REFUSES(avo_place_slots(starts, 3, center, NAN, slots), AVO_ERROR_INVALID_VALUE, "heading");
  REFUSES(avo_assign_slots(starts, 3, slots, 2, chosen), AVO_ERROR_INVALID_VALUE, "at least 3");
  REFUSES(avo_formation_slots(9, 3, 2.0, center, 0.0, slots), AVO_ERROR_INVALID_VALUE, "0 to 4");
  REFUSES(avo_formation_slots(AVO_FORMATION_LINE, 3, 0.0, center, 0.0, slots),
          AVO_ERROR_INVALID_VALUE, "spacing: found 0, must be > 0 m");
}

int main(void) {
  check_scene();
  check_led();
  check_host();
  check_formations();
  return 0;
}
