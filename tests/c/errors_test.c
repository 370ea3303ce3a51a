/* SPDX-License-Identifier: Apache-2.0 */
/* Whatever is wrong with a call gives a result and a message, and no crash. */
#include <math.h>
#include <pthread.h>

#include "check.h"

static uint64_t next_word(uint64_t* state) {
  *state = *state * 6364136223846793005u + 1442695040888963407u;
  return *state >> 16;
}

/* Its robots stay valid until the next call. */
static avo_simulation_def two_robots(void) {
  static avo_robot_def robots[2];
  avo_simulation_def def = avo_default_simulation_def();
  for (int k = 0; k < 2; ++k) {
    robots[k] = avo_default_robot_def();
    robots[k].position.x = 10.0 * k;
    robots[k].goal.x = 10.0 - 10.0 * k;
    robots[k].goal.y = 0.1;
  }
  def.robots = robots;
  def.robot_count = 2;
  return def;
}

static avo_simulation_id make(void) {
  const avo_simulation_def def = two_robots();
  avo_simulation_id simulation;
  REQUIRE(avo_create_simulation(&def, &simulation));
  return simulation;
}

static void check_ids(void) {
  const avo_simulation_id none = {0, 0}, wild = {77777777, 1}, past = {UINT32_MAX, UINT32_MAX};
  const avo_robot_id no_robot = {0}, other = {3}, far = {UINT64_MAX};
  avo_simulation_id simulation = make(), next;
  avo_vec2 position = {5.0, 5.0};
  CHECK(avo_simulation_is_valid(simulation) && !avo_simulation_is_valid(none));
  REFUSES(avo_simulation_step(none), AVO_ERROR_INVALID_ID, "simulation: found a null id");
  REFUSES(avo_simulation_step(wild), AVO_ERROR_INVALID_ID, "simulation: found an id of none");
  CHECK(avo_simulation_step(past) == AVO_ERROR_INVALID_ID);
  REFUSES(avo_simulation_get_position(simulation, no_robot, &position), AVO_ERROR_INVALID_ID,
          "robot: found a null id");
  REFUSES(avo_simulation_get_position(simulation, other, &position), AVO_ERROR_INVALID_ID,
          "robot: found 3, must be the id of one that is there");
  CHECK(avo_simulation_get_position(simulation, far, &position) == AVO_ERROR_INVALID_ID);
  CHECK(avo_simulation_remove_robot(simulation, no_robot) == AVO_ERROR_INVALID_ID);
  CHECK(position.x == 5.0 && position.y == 5.0);
  REQUIRE(avo_destroy_simulation(simulation));
  CHECK(!avo_simulation_is_valid(simulation));
  CHECK(avo_simulation_step(simulation) == AVO_ERROR_INVALID_ID);
  CHECK(avo_destroy_simulation(simulation) == AVO_ERROR_INVALID_ID);
  next = make(); /* at the same place, and another id */
  CHECK(next.index == simulation.index && next.generation != simulation.generation);
  CHECK(avo_simulation_step(simulation) == AVO_ERROR_INVALID_ID);
  REQUIRE(avo_destroy_simulation(next));
}

/* Robots are found by their ids whoever has gone, and those that have gone are not. */
static void check_robots_that_go(void) {
  enum { COUNT = 60 };
  static avo_robot_def robots[COUNT];
  bool is_there[COUNT + 5] = {false};
  uint64_t random = 5;
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id simulation;
  for (int k = 0; k < COUNT; ++k) {
    robots[k] = avo_default_robot_def();
    robots[k].position.x = robots[k].goal.x = 3.0 * k;
    is_there[k + 1] = true;
  }
  def.robots = robots;
  def.robot_count = COUNT;
  REQUIRE(avo_create_simulation(&def, &simulation));
  for (int left = COUNT; left > 0; --left) {
    avo_columns columns;
    avo_robot_id robot = {0};
    size_t index = 0, place = 0;
    REQUIRE(avo_simulation_columns(simulation, &columns));
    CHECK(columns.count == (size_t)left);
    for (robot.value = 1; robot.value < COUNT + 5; ++robot.value) {
      const avo_result result = avo_simulation_index_of(simulation, robot, &index);
      CHECK(result == (is_there[robot.value] ? AVO_OK : AVO_ERROR_INVALID_ID));
      if (result == AVO_OK) CHECK(index == place && columns.id[place++].value == robot.value);
    }
    robot = columns.id[next_word(&random) % columns.count];
    REQUIRE(avo_simulation_remove_robot(simulation, robot));
    is_there[robot.value] = false;
  }
  REQUIRE(avo_destroy_simulation(simulation));
}

/* More than one block of places, in any order. */
static void check_many(void) {
  enum { COUNT = 700 };
  static avo_planner_id planners[COUNT];
  const avo_planner_def def = avo_default_planner_def(AVO_METHOD_AVO);
  for (int k = 0; k < COUNT; ++k) REQUIRE(avo_create_planner(&def, &planners[k]));
  for (int k = 0; k < COUNT; k += 2) REQUIRE(avo_destroy_planner(planners[k]));
  for (int k = 0; k < COUNT; ++k) CHECK(avo_planner_is_valid(planners[k]) == (k % 2 == 1));
  for (int k = 1; k < COUNT; k += 2) REQUIRE(avo_destroy_planner(planners[k]));
}

static void check_values(void) {
  avo_simulation_def def = two_robots();
  avo_simulation_id simulation = {0, 0};
  avo_robot_def robots[2];
  avo_planner_def options = avo_default_planner_def(AVO_METHOD_ORCA);
  avo_planner_id planner = {0, 0};
  memcpy(robots, def.robots, sizeof robots);
  def.robots = robots;
  robots[1].radius = -0.2;
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "robots.1.radius: found -0.2, must be > 0 m");
  robots[1].radius = NAN;
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "robots.1.radius: found nan, must be a finite number");
  robots[1].radius = 0.5;
  robots[1].max_braking = NAN; /* not unset */
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "robots.1.max_braking: found nan");
  robots[1].max_braking = 0.0;
  robots[1].unused = true; /* parked of earlier headers */
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "robots.1.parked: found true, must be false: behavior is AVO_BEHAVIOR_PARKED");
  robots[1].unused = false;
  robots[1].behavior = 4;
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "robots.1.behavior: found 4, must be 0 to 3");
  robots[1].behavior = AVO_BEHAVIOR_DECIDES;
  robots[1].model = 9;
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "robots.1.model: found 9, must be 0 to 3");
  robots[1].model = AVO_MODEL_HOLONOMIC;
  def.method = -3;
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "method: found -3, must be 0 to 8");
  def.method = AVO_METHOD_AVO;
  def.certificate = 1; /* of earlier headers */
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "certificate: found 1 (stopping_capsules), must be braking_trajectories: ");
  def.certificate = AVO_UNSET;
  def.right_of_way = 2; /* of earlier headers */
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "right_of_way: found 2 (told), must be seen: told was removed");
  def.right_of_way = AVO_RIGHT_OF_WAY_SEEN;
  def.unused = 25; /* samples of earlier headers */
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "samples: found 25, must be 0: all half-planes are exact");
  def.unused = 0;
  def.max_neighbors = -1;
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE,
          "max_neighbors: found -1");
  def.max_neighbors = 0;
  def.threads = 5000;
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE, "threads: found 5000");
  def.threads = 1;
  def.sensing_error.position = 0.1; /* and no velocity */
  CHECK(avo_create_simulation(&def, &simulation) == AVO_ERROR_INVALID_VALUE);
  options.time_horizon = -1.0;
  REFUSES(avo_create_planner(&options, &planner), AVO_ERROR_INVALID_VALUE,
          "time_horizon: found -1");
  CHECK(simulation.index == 0 && planner.index == 0);
}

static void check_pointers(void) {
  avo_simulation_def def = two_robots();
  avo_simulation_id simulation = make();
  avo_columns columns;
  avo_planner_id planner;
  avo_plan plan;
  const avo_planner_def options = avo_default_planner_def(AVO_METHOD_AVO);
  const avo_robot robot = avo_default_robot();
  const avo_robot_id first = {1};
  REFUSES(avo_create_simulation(NULL, &simulation), AVO_ERROR_INVALID_ARGUMENT, "def: found null");
  CHECK(avo_create_simulation(&def, NULL) == AVO_ERROR_INVALID_ARGUMENT);
  def.robots = NULL;
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_ARGUMENT,
          "robots: found null, must point to 2");
  CHECK(avo_simulation_columns(simulation, NULL) == AVO_ERROR_INVALID_ARGUMENT);
  CHECK(avo_simulation_get_position(simulation, first, NULL) == AVO_ERROR_INVALID_ARGUMENT);
  CHECK(avo_simulation_save(simulation, NULL, 0, NULL) == AVO_ERROR_INVALID_ARGUMENT);
  CHECK(avo_simulation_restore(simulation, NULL, 4) == AVO_ERROR_INVALID_ARGUMENT);
  CHECK(avo_simulation_restore(simulation, NULL, 0) == AVO_ERROR_INVALID_VALUE);
  CHECK(avo_simulation_add_robot(simulation, NULL, NULL) == AVO_ERROR_INVALID_ARGUMENT);
  REQUIRE(avo_simulation_columns(simulation, &columns));
  CHECK(columns.count == 2 && columns.id[1].value == 2);
  REQUIRE(avo_create_planner(&options, &planner));
  REFUSES(avo_planner_plan(planner, &robot, NULL, 1, NULL, 0, NULL, &plan),
          AVO_ERROR_INVALID_ARGUMENT, "neighbors: found null, must point to 1");
  REFUSES(avo_planner_plan(planner, &robot, NULL, 0, NULL, 3, NULL, &plan),
          AVO_ERROR_INVALID_ARGUMENT, "walls: found null, must point to 3");
  CHECK(avo_planner_plan(planner, NULL, NULL, 0, NULL, 0, NULL, &plan) ==
        AVO_ERROR_INVALID_ARGUMENT);
  CHECK(avo_planner_plan(planner, &robot, NULL, 0, NULL, 0, NULL, NULL) ==
        AVO_ERROR_INVALID_ARGUMENT);
  REQUIRE(avo_planner_plan(planner, &robot, NULL, 0, NULL, 0, NULL, &plan));
  REQUIRE(avo_destroy_planner(planner));
  CHECK(avo_planner_plan(planner, &robot, NULL, 0, NULL, 0, NULL, &plan) == AVO_ERROR_INVALID_ID);
  REQUIRE(avo_destroy_simulation(simulation));
}

static void check_scenes(void) {
  static const char text[] = "version: 1\nrobotz: []\n";
  const char* const override = "robots.0.radius=-1";
  const char* const none[] = {NULL};
  avo_scene_id scene = {0, 0};
  REFUSES(avo_load_scene("circle-ten", NULL, 0, &scene), AVO_ERROR_FILE, "circle-ten");
  REFUSES(avo_load_scene("circle-10", &override, 1, &scene), AVO_ERROR_INVALID_SCENE,
          "robots.0.radius");
  CHECK(avo_load_scene("circle-10", none, 1, &scene) == AVO_ERROR_INVALID_ARGUMENT);
  CHECK(avo_load_scene(NULL, NULL, 0, &scene) == AVO_ERROR_INVALID_ARGUMENT);
  REFUSES(avo_load_scene("-", NULL, 0, &scene), AVO_ERROR_INVALID_SCENE, "found \"-\"");
  REFUSES(avo_parse_scene(text, sizeof text - 1, "mine.yaml", NULL, 0, &scene),
          AVO_ERROR_INVALID_SCENE, "mine.yaml:2:1: ");
  REQUIRE(avo_load_scene("circle-10", NULL, 0, &scene));
  REQUIRE(avo_destroy_scene(scene));
  CHECK(!avo_scene_is_valid(scene) && avo_destroy_scene(scene) == AVO_ERROR_INVALID_ID);
}

static void check_unsupported(void) {
  avo_simulation_id simulation = make(), copy;
  avo_summary summary = avo_default_summary();
  avo_simulation_def def = avo_default_simulation_def();
  char saved[4096];
  size_t size = 0;
  REFUSES(avo_simulation_summary(simulation, &summary), AVO_ERROR_UNSUPPORTED, "metrics: found");
  REQUIRE(avo_simulation_save(simulation, saved, sizeof saved, &size));
  def.metrics = true;
  CHECK(avo_create_simulation_from_saved(saved, size, &def, &copy) == AVO_ERROR_UNSUPPORTED);
  REQUIRE(avo_destroy_simulation(simulation));
}

static void* fail_elsewhere(void* seen) {
  const avo_planner_id none = {0, 0};
  const bool was_empty = avo_last_error()[0] == '\0';
  const bool failed = avo_destroy_planner(none) == AVO_ERROR_INVALID_ID;
  *(bool*)seen = was_empty && failed && strstr(avo_last_error(), "planner: ") != NULL;
  return NULL;
}

static void check_threads_have_messages_of_their_own(void) {
  const avo_simulation_id none = {0, 0};
  pthread_t thread;
  bool seen = false;
  CHECK(avo_simulation_step(none) == AVO_ERROR_INVALID_ID);
  CHECK(pthread_create(&thread, NULL, fail_elsewhere, &seen) == 0);
  CHECK(pthread_join(thread, NULL) == 0);
  CHECK(seen && strstr(avo_last_error(), "simulation: ") != NULL);
}

/* Definitions and saved states of arbitrary bytes; of the pointers only those that are null. */
static void check_arbitrary_bytes(void) {
  uint64_t random = 1;
  avo_simulation_id simulation = make(), made;
  char saved[4096];
  size_t size = 0;
  REQUIRE(avo_simulation_save(simulation, saved, sizeof saved, &size));
  for (int k = 0; k < 20000; ++k) {
    avo_simulation_def def = two_robots();
    avo_robot_def robots[2];
    avo_result result;
    memcpy(robots, def.robots, sizeof robots);
    if (k % 2 == 0) {
      const size_t place = next_word(&random) % (sizeof robots - 4);
      const uint32_t word = (uint32_t)next_word(&random);
      /* a bool of other bytes than 0 and 1 is none of C */
      if (place % sizeof *robots > offsetof(avo_robot_def, model)) continue;
      if (place % sizeof *robots > offsetof(avo_robot_def, car) - 4 &&
          place % sizeof *robots < offsetof(avo_robot_def, drive))
        continue;
      memcpy((char*)robots + place, &word, sizeof word);
    } else {
      def.time_step = (double)(next_word(&random) % 7) - 1.0;
      def.unused = (int32_t)(next_word(&random) % 4 / 3);
      def.clock = (int32_t)(next_word(&random) % 4) - 1;
      def.max_neighbors = (int32_t)(next_word(&random) % 5) - 2;
      def.certificate = (int32_t)(next_word(&random) % 6) - 2;
      def.seed = next_word(&random);
    }
    def.robots = robots;
    def.threads = 1;
    result = avo_create_simulation(&def, &made);
    CHECK(result == AVO_OK || strlen(avo_last_error()) > 5);
    if (result == AVO_OK)
      REQUIRE(avo_destroy_simulation(made));
    else
      CHECK(result == AVO_ERROR_INVALID_VALUE || result == AVO_ERROR_INVALID_DEFINITION);
    if (k % 10 == 0) {
      char bytes[4096];
      memcpy(bytes, saved, size);
      bytes[next_word(&random) % size] ^= (char)(1 + next_word(&random) % 255);
      CHECK(avo_simulation_restore(simulation, bytes, size) == AVO_ERROR_INVALID_VALUE);
    }
  }
  REQUIRE(avo_destroy_simulation(simulation));
}

int main(void) {
  CHECK(avo_last_error()[0] == '\0');
  CHECK(strcmp(avo_result_text(AVO_OK), "ok") == 0);
  CHECK(strcmp(avo_result_text(AVO_ERROR_INTERNAL), "internal error") == 0);
  CHECK(strcmp(avo_result_text(-1), "unknown result") == 0);
  CHECK(strcmp(avo_result_text(11), "unknown result") == 0);
  CHECK(strchr(avo_version(), '.') != NULL);
  check_ids();
  check_robots_that_go();
  check_many();
  check_values();
  check_pointers();
  check_scenes();
  check_unsupported();
  check_threads_have_messages_of_their_own();
  check_arbitrary_bytes();
  return 0;
}
