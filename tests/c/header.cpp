/* SPDX-License-Identifier: Apache-2.0 */
/* The header stands alone, in C++. */
#include <avo_c/avo.h>
#include <avo_c/space.h>

int avo_header_in_cpp() {
  const avo_robot_id null_robot = {};
  const avo_simulation_def def = {};
  return (int)null_robot.value + (int)def.size + AVO_OK;
}
