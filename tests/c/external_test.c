/* SPDX-License-Identifier: Apache-2.0 */
/* Methods of the host's own: the example's potential field touches alone, and not behind the
 * certificate. */
#include "check.h"

int32_t avo_choose(void* context, const avo_method_batch* batch, avo_vec2* velocities);

enum { ROBOTS = 40, STEPS = 600 };

static avo_simulation_def scene(const char* const* overrides, size_t count, avo_scene_id* scene) {
  avo_simulation_def def = avo_default_simulation_def();
  REQUIRE(avo_load_scene("circle-40", overrides, count, scene));
  REQUIRE(avo_scene_get_def(*scene, &def));
  def.external = avo_choose;
  def.metrics = true;
  return def;
}

static int64_t pairs_that_touch(const avo_simulation_def* def) {
  avo_simulation_id simulation;
  avo_summary summary = avo_default_summary();
  REQUIRE(avo_create_simulation(def, &simulation));
  steps_of(simulation, STEPS);
  REQUIRE(avo_simulation_summary(simulation, &summary));
  REQUIRE(avo_destroy_simulation(simulation));
  return summary.collision_pairs;
}

static void touches_alone_and_not_behind_the_certificate(void) {
  const char* const mine[] = {"method=external_clamped", "external_method=field"};
  avo_scene_id own;
  avo_simulation_def def = scene(mine, 2, &own);
  CHECK(strcmp(def.external_method, "field") == 0);
  CHECK(pairs_that_touch(&def) > 0);
  def.certificate = AVO_CERTIFICATE_BRAKING_TRAJECTORIES;
  CHECK(pairs_that_touch(&def) == 0);
  REQUIRE(avo_destroy_scene(own));
}

typedef struct seen {
  int calls;
  int32_t result;
  avo_simulation_id simulation;  // null, or the one that asks
} seen;

static int32_t look(void* context, const avo_method_batch* batch, avo_vec2* velocities) {
  seen* own = context;
  ++own->calls;
  CHECK(batch->size == sizeof *batch && batch->robot_count == ROBOTS);
  for (size_t i = 0; i < batch->robot_count; ++i) {
    CHECK(batch->id[i].value == i + 1);
    CHECK(velocities[i].x == batch->preferred_velocity[i].x);
    CHECK(batch->first_neighbor[i] < batch->first_neighbor[i + 1]);
    CHECK(batch->neighbor_behavior[batch->first_neighbor[i]] == AVO_BEHAVIOR_DECIDES);
  }
  CHECK(batch->first_neighbor[ROBOTS] == batch->neighbor_count && batch->wall_count == 0);
  if (own->simulation.index != 0)
    REFUSES(avo_destroy_simulation(own->simulation), AVO_ERROR_INVALID_VALUE,
            "found a change within the step that asks it");
  return own->result;
}

static void is_told_of_failure_and_given_again(void) {
  const char* const mine[] = {"method=external", "external_method=mine"};
  avo_scene_id own;
  avo_simulation_id simulation;
  seen all = {0, 0, {0, 0}};
  avo_simulation_def def = scene(mine, 2, &own);
  def.external = look;
  def.external_context = &all;
  REQUIRE(avo_create_simulation(&def, &simulation));
  steps_of(simulation, 2);
  all.simulation = simulation;
  steps_of(simulation, 1);
  CHECK(all.calls == 3 && avo_simulation_is_valid(simulation));
  const uint64_t before = hash_of(simulation);
  all.result = 7;
  REFUSES(avo_simulation_step(simulation), AVO_ERROR_INVALID_VALUE,
          "external method: found the result 7, must be 0");
  CHECK(hash_of(simulation) == before);
  REQUIRE(avo_simulation_set_external(simulation, NULL, NULL));
  REFUSES(avo_simulation_step(simulation), AVO_ERROR_INVALID_VALUE, "found no function");
  REQUIRE(avo_simulation_set_external(simulation, avo_choose, NULL));
  steps_of(simulation, 1);
  CHECK(hash_of(simulation) != before);
  REQUIRE(avo_destroy_simulation(simulation));
  REQUIRE(avo_destroy_scene(own));
}

int main(void) {
  touches_alone_and_not_behind_the_certificate();
  is_told_of_failure_and_given_again();
  return 0;
}
