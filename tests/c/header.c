/* SPDX-License-Identifier: Apache-2.0 */
/* The header stands alone, in C99 without extensions. */
#include <avo_c/avo.h>
#include <avo_c/space.h>

int avo_header_in_c(void) {
  const avo_robot_id null_robot = {0};
  const avo_simulation_def def = {0};
  return (int)null_robot.value + (int)def.size + AVO_OK;
}
