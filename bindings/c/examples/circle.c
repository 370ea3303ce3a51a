/* SPDX-License-Identifier: Apache-2.0 */
/* Circle-100 from C: prints how many arrive, and the state hash at the end. */
#include <avo_c/avo.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

/* Ends the program where a call failed. */
static void require(avo_result result) {
  if (result == AVO_OK) return;
  fprintf(stderr, "%s: %s\n", avo_result_text(result), avo_last_error());
  exit(1);
}

int main(void) {
  avo_scene_id scene;
  avo_simulation_def def = avo_default_simulation_def();
  require(avo_load_scene("circle-100", NULL, 0, &scene));
  require(avo_scene_get_def(scene, &def));
  def.metrics = true;

  avo_simulation_id simulation;
  require(avo_create_simulation(&def, &simulation));
  bool goes_on = true;
  while (goes_on) {
    require(avo_simulation_step(simulation));
    require(avo_simulation_can_step_by(simulation, def.duration, &goes_on));
  }

  avo_summary summary = avo_default_summary();
  uint64_t hash = 0;
  require(avo_simulation_summary(simulation, &summary));
  require(avo_simulation_get_state_hash(simulation, &hash));
  printf("%" PRId64 " of %" PRId64 " arrived, %" PRId64 " collisions, state hash 0x%016" PRIx64
         "\n",
         summary.arrived, summary.robots, summary.collision_pairs, hash);
  require(avo_destroy_simulation(simulation));
  require(avo_destroy_scene(scene));
  return 0;
}
