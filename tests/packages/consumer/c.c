/* SPDX-License-Identifier: Apache-2.0 */
/* Uses the C interface as a user would: fails unless a robot of a built-in scene moves, and unless
 * what is wrong is said. */
#include <avo_c/avo.h>
#include <stdio.h>
#include <string.h>

int main(void) {
  avo_scene_id scene;
  avo_simulation_id simulation;
  avo_simulation_def def = avo_default_simulation_def();
  const avo_robot_id robot = {1}, none = {0};
  avo_vec2 velocity = {0.0, 0.0};
  if (avo_load_scene("circle-10", NULL, 0, &scene) != AVO_OK ||
      avo_scene_get_def(scene, &def) != AVO_OK ||
      avo_create_simulation(&def, &simulation) != AVO_OK ||
      avo_simulation_step(simulation) != AVO_OK ||
      avo_simulation_get_velocity(simulation, robot, &velocity) != AVO_OK) {
    fprintf(stderr, "%s\n", avo_last_error());
    return 1;
  }
  printf("avo %s in C: velocity %.3f, %.3f m/s\n", avo_version(), velocity.x, velocity.y);
  return velocity.x * velocity.x + velocity.y * velocity.y > 0.0 &&
                 avo_simulation_get_velocity(simulation, none, &velocity) == AVO_ERROR_INVALID_ID &&
                 strstr(avo_last_error(), "null id") != NULL
             ? 0
             : 1;
}
