// SPDX-License-Identifier: Apache-2.0
// Converts values of space between C and C++.
#pragma once
#include "avo/space/scenario.h"
#include "avo_c/space.h"

namespace avo_c {

inline avo::Vec3 from_c(avo_vec3 v) {
  return {v.x, v.y, v.z};
}
inline avo_vec3 to_c(avo::Vec3 v) {
  return {v.x, v.y, v.z};
}
inline avo::space::Box from_c(const avo_space_box& box) {
  return {from_c(box.min), from_c(box.max), box.heading, box.radius};
}

/// Settings, robots and boxes; without the threads.
avo::space::Scenario scenario_of(const avo_space_simulation_def& def);

}  // namespace avo_c
