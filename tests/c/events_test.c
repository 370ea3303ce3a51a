/* SPDX-License-Identifier: Apache-2.0 */
/* What happened in a step, from C. */
#include "check.h"

static avo_vec2 at(double x, double y) {
  const avo_vec2 v = {x, y};
  return v;
}

/* Two robots side by side, and one behind a robot that hardly moves in a corridor. */
static avo_simulation_id make_fleet(void) {
  static const avo_vec2 above[] = {{-20.0, 0.8}, {20.0, 0.8}},
                        below[] = {{-20.0, -0.8}, {20.0, -0.8}};
  static const avo_vec2 ends[] = {{-20.0, -0.8}, {-20.0, 0.8}};
  const avo_chain chains[] = {{above, 2, false}, {below, 2, false}, {ends, 2, false}};
  avo_obstacle_def walls = avo_default_obstacle_def();
  avo_simulation_def def = avo_default_simulation_def();
  avo_robot_def robots[4];
  avo_simulation_id simulation;
  for (int k = 0; k < 4; ++k) robots[k] = avo_default_robot_def();
  robots[0].position = at(0.0, 10.0);
  robots[0].goal = at(6.0, 10.0);
  robots[1].position = robots[1].goal = at(0.0, 15.0);
  robots[2].position = robots[2].goal = at(0.0, 0.0);
  robots[2].max_speed = robots[2].preferred_speed = 1e-3;
  robots[3].position = at(-10.0, 0.0);
  robots[3].goal = at(12.0, 0.0);
  walls.chains = chains;
  walls.chain_count = 3;
  def.sensing_radius = 40.0;
  def.threads = 1;
  def.robots = robots;
  def.robot_count = 4;
  def.obstacles = &walls;
  def.obstacle_count = 1;
  REQUIRE(avo_create_simulation(&def, &simulation));
  return simulation;
}

static size_t events_of(avo_simulation_id simulation, avo_event* events, size_t capacity) {
  size_t count = 99, again = 99;
  REQUIRE(avo_simulation_events(simulation, NULL, 0, &count));
  REQUIRE(avo_simulation_events(simulation, events, capacity, &again));
  CHECK(count == again);
  return count;
}

/* Steps until something happens. */
static size_t next_events(avo_simulation_id simulation, avo_event* events, size_t capacity) {
  for (int k = 0; k < 500; ++k) {
    REQUIRE(avo_simulation_step(simulation));
    const size_t count = events_of(simulation, events, capacity);
    if (count > 0) return count;
  }
  return 0;
}

static void check_refusals(avo_simulation_id simulation) {
  avo_event event;
  char words[8];
  size_t count = 99;
  REFUSES(avo_simulation_events(simulation, &event, 1, &count), AVO_ERROR_UNSUPPORTED,
          "avo_simulation_watch()");
  REFUSES(avo_simulation_event_sentence(simulation, 0, words, 8, &count), AVO_ERROR_UNSUPPORTED,
          "avo_simulation_watch()");
  REFUSES(avo_simulation_watch(simulation, -1.0), AVO_ERROR_INVALID_VALUE,
          "stuck_after: found -1, must be > 0 s");
  REFUSES(avo_simulation_events(simulation, &event, 1, &count), AVO_ERROR_UNSUPPORTED, "watch");
}

static void check_stuck(avo_simulation_id simulation) {
  char words[512], told[512];
  size_t size = 0, again = 0;
  const avo_robot_id waiting = {4};
  REQUIRE(avo_simulation_event_sentence(simulation, 0, NULL, 0, &size));
  CHECK(size > 20 && size <= sizeof words);
  REFUSES(avo_simulation_event_sentence(simulation, 0, words, size - 1, &size),
          AVO_ERROR_BUFFER_TOO_SMALL, "capacity");
  REQUIRE(avo_simulation_event_sentence(simulation, 0, words, sizeof words, &size));
  REQUIRE(avo_simulation_explain(simulation, waiting, told, sizeof told, &again));
  CHECK(size == again && strcmp(words, told) == 0);
  REFUSES(avo_simulation_event_sentence(simulation, 1, words, sizeof words, &size),
          AVO_ERROR_INVALID_VALUE, "event: found 1, must be less than the number of events, 1");
}

/* Two robots want through a corridor of one lane: one waits, and the other one is named by its id.
 */
static void check_wait(void) {
  static const avo_vec2 corners[] = {{-19, -8}, {-5, -8}, {-5, -0.8}, {5, -0.8}, {5, -8}, {19, -8},
                                     {19, 8},   {5, 8},   {5, 0.8},   {-5, 0.8}, {-5, 8}, {-19, 8}};
  const avo_chain chain = {corners, 12, true};
  const avo_robot_id second = {2};
  avo_obstacle_def walls = avo_default_obstacle_def();
  avo_robot_def robots[2] = {avo_default_robot_def(), avo_default_robot_def()};
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id simulation;
  avo_wait wait = {0};
  walls.chains = &chain, walls.chain_count = 1;
  robots[0].position = at(-7.0, 0.0), robots[0].goal = at(10.0, 3.0);
  robots[1].position = at(12.0, 0.0), robots[1].goal = at(-10.0, 3.0);
  def.robots = robots, def.robot_count = 2;
  def.obstacles = &walls, def.obstacle_count = 1;
  REQUIRE(avo_create_simulation(&def, &simulation));
  for (int k = 0; k < 100 && !wait.waits; ++k) {
    REQUIRE(avo_simulation_step(simulation));
    REQUIRE(avo_simulation_get_wait(simulation, second, &wait));
  }
  CHECK(wait.waits && wait.robot.value == 1);
  REQUIRE(avo_destroy_simulation(simulation));
}

/* A player of the host runs into a robot that stands. */
static void check_player(void) {
  const avo_vec2 right = {1.0, 0.0};
  const avo_robot_id player = {1};
  avo_robot_def robots[2] = {avo_default_robot_def(), avo_default_robot_def()};
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id simulation;
  avo_event events[4];
  robots[1].position = robots[1].goal = at(3.0, 0.0);
  robots[0].max_acceleration = 10.0;
  robots[1].max_speed = robots[1].preferred_speed = 1e-3;
  def.robots = robots, def.robot_count = 2;
  REQUIRE(avo_create_simulation(&def, &simulation));
  REQUIRE(avo_simulation_watch(simulation, 0.0));
  REQUIRE(avo_simulation_set_velocity(simulation, player, &right));
  CHECK(next_events(simulation, events, 4) == 1);
  CHECK(events[0].kind == AVO_EVENT_LEFT && events[0].robot.value == 1);
  CHECK(events[0].moved_robot.value == 0);
  CHECK(next_events(simulation, events, 4) == 1);
  CHECK(events[0].kind == AVO_EVENT_CONTACT && events[0].robot.value == 2);
  CHECK(events[0].moved_robot.value == 1 && events[0].moving_obstacle.value == 0);
  REQUIRE(avo_destroy_simulation(simulation));
}

int main(void) {
  const avo_robot_id first = {1}, second = {2};
  avo_simulation_id simulation = make_fleet();
  avo_moving_obstacle_def mover = avo_default_moving_obstacle_def();
  avo_moving_obstacle_id obstacle;
  avo_event events[8];
  size_t count = 0, size = 0;
  char words[8];
  check_wait();
  check_player();
  check_refusals(simulation);
  REQUIRE(avo_simulation_watch(simulation, 0.0));
  CHECK(events_of(simulation, events, 8) == 0);

  CHECK(next_events(simulation, events, 8) == 1);
  CHECK(events[0].kind == AVO_EVENT_ARRIVED && events[0].robot.value == 1);
  CHECK(events[0].moving_obstacle.value == 0 && !events[0].at_rest);
  REQUIRE(avo_simulation_event_sentence(simulation, 0, words, sizeof words, &size));
  CHECK(size == 1 && words[0] == 0);
  CHECK(next_events(simulation, events, 8) == 1);
  CHECK(events[0].kind == AVO_EVENT_STUCK && events[0].robot.value == 4);
  check_stuck(simulation);

  /* the host moves a player on a robot that stands, and takes another robot away */
  mover.position = at(0.0, 22.0);
  REQUIRE(avo_simulation_add_moving_obstacle(simulation, &mover, &obstacle));
  REQUIRE(avo_simulation_step(simulation));
  mover.position = at(0.0, 15.2);
  REQUIRE(avo_simulation_change_moving_obstacle(simulation, obstacle, &mover));
  REQUIRE(avo_simulation_remove_robot(simulation, first));
  REQUIRE(avo_simulation_step(simulation));
  REFUSES(avo_simulation_events(simulation, events, 1, &count), AVO_ERROR_BUFFER_TOO_SMALL,
          "capacity: found 1, must be >= 2");
  CHECK(count == 2 && events_of(simulation, events, 8) == 2);
  CHECK(events[0].kind == AVO_EVENT_GONE && events[0].robot.value == 1);
  CHECK(events[1].kind == AVO_EVENT_CONTACT && events[1].robot.value == second.value);
  CHECK(events[1].moving_obstacle.value == obstacle.value);

  REQUIRE(avo_simulation_watch(simulation, 1.0)); /* anew */
  CHECK(events_of(simulation, events, 8) == 0);
  REQUIRE(avo_destroy_simulation(simulation));
  return 0;
}
