/* SPDX-License-Identifier: Apache-2.0 */
/* A robot on board: around a wall to its goal, along a route, and what is refused. */
#include <math.h>

#include "check.h"

static avo_navigator_id before_a_wall(void) {
  const avo_vec2 ends[2] = {{4.0, -3.0}, {4.0, 3.0}};
  avo_chain chain = {0};
  avo_obstacle_def wall = avo_default_obstacle_def();
  const avo_planner_def planner = avo_default_planner_def(AVO_METHOD_AVO);
  const avo_navigator_def def = avo_default_navigator_def();
  avo_navigator_id navigator;
  chain.points = ends, chain.point_count = 2;
  wall.chains = &chain, wall.chain_count = 1;
  REQUIRE(avo_create_navigator(&planner, &def, &wall, 1, &navigator));
  return navigator;
}

/* The base does as it is told; returns the number of steps until the goal is reached. */
static int drive(avo_navigator_id navigator, avo_robot* robot, int most) {
  avo_navigator_decision decision;
  static double time = 0.0;
  for (int k = 0; k < most; ++k, time += 0.1) {
    REQUIRE(avo_navigator_step(navigator, robot, NULL, 0, time, &decision));
    if (decision.status == AVO_NAVIGATOR_REACHED) return k;
    CHECK(decision.plan.status != AVO_PLAN_INVALID_INPUT && decision.waits_for == -1);
    robot->position.x += 0.05 * (robot->velocity.x + decision.plan.next_velocity.x);
    robot->position.y += 0.05 * (robot->velocity.y + decision.plan.next_velocity.y);
    robot->velocity = decision.plan.next_velocity;
  }
  return most;
}

static void check_goal(void) {
  const avo_navigator_id navigator = before_a_wall();
  const avo_vec2 goal = {8.0, 0.0};
  avo_robot robot = avo_default_robot();
  avo_navigator_decision decision;
  avo_vec2 route[8];
  char words[300];
  size_t count = 0, size = 0;
  REQUIRE(avo_navigator_step(navigator, &robot, NULL, 0, 0.0, &decision));
  CHECK(decision.status == AVO_NAVIGATOR_IDLE);
  REQUIRE(avo_navigator_set_goal(navigator, goal, NAN, false));
  REQUIRE(avo_navigator_step(navigator, &robot, NULL, 0, 0.0, &decision));
  CHECK(decision.status == AVO_NAVIGATOR_UNDER_WAY && decision.guide == AVO_GUIDE_ROUTE);
  CHECK(decision.route_left > 10.0 && decision.distance_left == 0.0);
  REQUIRE(avo_navigator_route(navigator, NULL, 0, &count));
  CHECK(count > 1 && count <= 8);
  REFUSES(avo_navigator_route(navigator, route, 1, &count), AVO_ERROR_BUFFER_TOO_SMALL, "capacity");
  REQUIRE(avo_navigator_route(navigator, route, 8, &count));
  CHECK(route[count - 1].x == 8.0 && fabs(route[0].y) > 3.0);
  REQUIRE(avo_navigator_explain(navigator, &robot, NULL, 0, words, sizeof words, &size));
  CHECK(strstr(words, "Robot 0 starts") == words && size == strlen(words) + 1);
  CHECK(drive(navigator, &robot, 200) < 120);
  REQUIRE(avo_destroy_navigator(navigator));
  CHECK(!avo_navigator_is_valid(navigator));
}

static void check_routes(void) {
  const avo_navigator_id navigator = before_a_wall();
  const avo_vec2 points[3] = {{0.0, 0.0}, {0.0, 6.0}, {9.0, 6.0}};
  const avo_stage stages[2] = {{{9.0, 9.0}, 1.0}, {{0.0, 9.0}, 0.0}};
  avo_robot robot = avo_default_robot();
  REQUIRE(avo_navigator_set_route(navigator, points, 3, NAN));
  CHECK(drive(navigator, &robot, 200) < 130);
  REQUIRE(avo_navigator_set_stages(navigator, stages, 2, NAN));
  CHECK(drive(navigator, &robot, 300) < 200);
  CHECK(fabs(robot.position.x) < 0.6);
  REQUIRE(avo_navigator_go_on(navigator));
  REQUIRE(avo_navigator_set_obstacles(navigator, NULL, 0, 2));
  REQUIRE(avo_navigator_clear_goal(navigator));
  REFUSES(avo_navigator_set_route(navigator, points, 1, NAN), AVO_ERROR_INVALID_VALUE,
          "route: found 1 points, must be >= 2 points");
  REQUIRE(avo_destroy_navigator(navigator));
  REFUSES(avo_navigator_go_on(navigator), AVO_ERROR_INVALID_ID, "navigator");
}

static void check_ranges(void) {
  const avo_planner_def planner = avo_default_planner_def(AVO_METHOD_AVO);
  const avo_robot robot = avo_default_robot();
  double walls = 0.0, others = 0.0;
  REQUIRE(avo_wall_range(&planner, &robot, &walls));
  CHECK(fabs(walls - 2.7) < 0.02);
  REQUIRE(avo_sensing_range(&planner, &robot, &robot, 1, false, &others));
  CHECK(others > 2.0 * walls - 0.1 && others < 10.0);
}

/* A base that obeys 0.1 s late: by the commands that it has not executed yet. */
static void check_execution(void) {
  const avo_vec2 goal = {4.0, 0.0};
  const avo_execution_model model = {.dead_time = 0.1, .deadband = 0.02};
  const avo_planner_def planner = avo_default_planner_def(AVO_METHOD_AVO);
  avo_navigator_def def = avo_default_navigator_def();
  avo_navigator_id navigator;
  avo_robot body = avo_default_robot();
  avo_navigator_decision decision = {0};
  avo_execution_error most;
  int steps = 0;
  def.execution = &model;
  REQUIRE(avo_create_navigator(&planner, &def, NULL, 0, &navigator));
  REQUIRE(avo_find_execution_error(&model, &body, 0.1, &most));
  CHECK(most.position > 0.005 && most.position < 0.02 && most.command > 2.0);
  REQUIRE(avo_navigator_set_goal(navigator, goal, NAN, false));
  for (; steps < 100 && decision.status != AVO_NAVIGATOR_REACHED; ++steps) {
    const avo_vec2 acting = decision.command.velocity;
    REQUIRE(avo_navigator_step(navigator, &body, NULL, 0, 0.1 * steps, &decision));
    CHECK(decision.has_command && !decision.command.has_left);
    CHECK(decision.command.deviation <= most.position);
    body.position.x += 0.1 * acting.x, body.position.y += 0.1 * acting.y;
    body.velocity = acting;
  }
  CHECK(steps < 100 && fabs(body.position.x - 4.0) < 0.5);
  REQUIRE(avo_destroy_navigator(navigator));
}

/* The same base beside a planner, without a navigator. */
static void check_tracker(void) {
  const avo_execution_model model = {.time_constant = 0.2};
  const avo_planner_def def = avo_default_planner_def(AVO_METHOD_AVO);
  avo_planner_id planner;
  avo_reference_tracker_id tracker;
  avo_robot body = avo_default_robot(), led = body;
  avo_execution_error most;
  avo_plan plan;
  avo_base_command command;
  body.preferred_velocity.x = 1.0;
  REQUIRE(avo_create_planner(&def, &planner));
  REQUIRE(avo_create_reference_tracker(&model, planner, &tracker));
  REQUIRE(avo_reference_tracker_error(tracker, &body, &most));
  REQUIRE(avo_reference_tracker_reference(tracker, &body, &led));
  CHECK(led.radius == body.radius + most.position && led.preferred_velocity.x == 1.0);
  REQUIRE(avo_planner_plan(planner, &led, NULL, 0, NULL, 0, NULL, &plan));
  REQUIRE(avo_destroy_planner(planner));
  REQUIRE(avo_reference_tracker_follow(tracker, &body, &plan, &command));
  CHECK(command.next_velocity.x == plan.next_velocity.x);
  CHECK(command.velocity.x > plan.next_velocity.x && !command.has_left);
  body.position = command.next_reference, body.position.y = 0.5 * most.position;
  REQUIRE(avo_reference_tracker_reference(tracker, &body, &led));
  CHECK(led.position.y == command.next_reference.y);
  REQUIRE(avo_reference_tracker_forget(tracker));
  REQUIRE(avo_reference_tracker_reference(tracker, &body, &led));
  CHECK(led.position.y == body.position.y);
  REQUIRE(avo_destroy_reference_tracker(tracker));
  CHECK(!avo_reference_tracker_is_valid(tracker));
  REFUSES(avo_reference_tracker_forget(tracker), AVO_ERROR_INVALID_ID, "reference_tracker");
}

static avo_neighbor seen_of(const avo_robot* robot) {
  avo_neighbor neighbor = avo_default_neighbor();
  neighbor.position = robot->position, neighbor.velocity = robot->velocity;
  return neighbor;
}

/* Robots meet at a passage of one lane: the second waits for the first. */
static void check_wait(void) {
  const avo_vec2 above[4] = {{-3.0, 10.0}, {-3.0, 0.8}, {3.0, 0.8}, {3.0, 10.0}};
  const avo_vec2 below[4] = {{-3.0, -10.0}, {-3.0, -0.8}, {3.0, -0.8}, {3.0, -10.0}};
  const avo_chain chains[2] = {{above, 4, false}, {below, 4, false}};
  const avo_vec2 goals[2] = {{10.0, 3.0}, {-10.0, 3.0}};
  const avo_planner_def planner = avo_default_planner_def(AVO_METHOD_AVO);
  avo_obstacle_def walls = avo_default_obstacle_def();
  avo_navigator_id navigators[2];
  avo_robot robots[2];
  avo_navigator_decision decisions[2] = {{.waits_for = -1}, {.waits_for = -1}};
  avo_detour detour;
  walls.chains = chains, walls.chain_count = 2;
  for (int k = 0; k < 2; ++k) {
    avo_navigator_def def = avo_default_navigator_def();
    def.id = (uint64_t)k;
    robots[k] = avo_default_robot();
    robots[k].position.x = k == 0 ? -7.0 : 12.0;
    REQUIRE(avo_create_navigator(&planner, &def, &walls, 1, &navigators[k]));
    REQUIRE(avo_navigator_set_goal(navigators[k], goals[k], NAN, false));
  }
  for (int cycle = 0; cycle < 200 && decisions[1].waits_for < 0; ++cycle) {
    const avo_neighbor seen[2] = {seen_of(&robots[1]), seen_of(&robots[0])};
    for (int k = 0; k < 2; ++k)
      REQUIRE(
          avo_navigator_step(navigators[k], &robots[k], &seen[k], 1, 0.1 * cycle, &decisions[k]));
    for (int k = 0; k < 2; ++k) {
      const avo_vec2 next = decisions[k].plan.next_velocity;
      robots[k].position.x += 0.05 * (robots[k].velocity.x + next.x);
      robots[k].position.y += 0.05 * (robots[k].velocity.y + next.y);
      robots[k].velocity = next;
    }
  }
  CHECK(decisions[1].waits_for == 0 && !decisions[1].inside);
  CHECK(fabs(decisions[1].passage.x) < 3.0 && fabs(decisions[1].passage.y) < 1e-9);
  CHECK(fabs(decisions[1].a.y) == 0.8 && decisions[1].a.y == -decisions[1].b.y);
  REQUIRE(avo_navigator_get_detour(navigators[1], &detour));
  CHECK(!detour.has_arrived);
  for (int k = 0; k < 2; ++k) REQUIRE(avo_destroy_navigator(navigators[k]));
}

static void check_drive_command(void) {
  const avo_execution_model exact = {0};
  const avo_vec2 aside = {0.0, 0.1};
  avo_wheel_command command;
  avo_robot body = avo_default_robot();
  REFUSES(avo_drive_command(&exact, &body, aside, &command), AVO_ERROR_INVALID_VALUE,
          "must be a differential drive");
  body.model = AVO_MODEL_DIFFERENTIAL_DRIVE;
  body.drive.track = 0.4, body.drive.offset = 0.2;
  body.drive.wheel_speed = 1.0, body.drive.wheel_acceleration = 2.0;
  body.max_acceleration = 0.5, body.max_speed = 0.5;
  REQUIRE(avo_drive_command(&exact, &body, aside, &command));
  CHECK(fabs(command.speed) < 1e-12 && fabs(command.turning_rate - 0.5) < 1e-12);
}

static void check_refusals(void) {
  const avo_planner_def planner = avo_default_planner_def(AVO_METHOD_AVO);
  avo_navigator_def def = avo_default_navigator_def();
  avo_navigator_id navigator;
  def.required_movement_radius = -1.0;
  REFUSES(avo_create_navigator(&planner, &def, NULL, 0, &navigator), AVO_ERROR_INVALID_VALUE,
          "NavigatorOptions.required_movement_radius: found -1, must be > 0 m");
  def.size = 3;
  REFUSES(avo_create_navigator(&planner, &def, NULL, 0, &navigator), AVO_ERROR_INVALID_DEFINITION,
          "def.size");
}

int main(void) {
  check_goal();
  check_routes();
  check_ranges();
  check_execution();
  check_tracker();
  check_wait();
  check_drive_command();
  check_refusals();
  return 0;
}
