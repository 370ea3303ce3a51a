// SPDX-License-Identifier: Apache-2.0
// Converts values of space between C and C++.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/space/planner.h"
#include "avo/space/scenario.h"
#include "avo_c/space.h"
#include "definitions.h"

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

inline void read_boxes(const avo_space_box* boxes, std::size_t count,
                       std::vector<avo::space::Box>& to) {
  require_array(boxes, count, "boxes");
  to.clear();
  for (std::size_t k = 0; k < count; ++k) to.push_back(from_c(boxes[k]));
}

inline avo_space_plan to_c(const avo::space::Plan& plan) {
  return {to_c(plan.new_velocity),
          to_c(plan.next_velocity),
          to_c(plan.acceleration),
          static_cast<avo_plan_status>(plan.status),
          static_cast<avo_safety_state>(plan.state),
          plan.neighbor,
          plan.box,
          plan.mover,
          plan.depth,
          plan.violation,
          plan.evading};
}

avo::space::MovingObstacle obstacle_of(const avo_space_moving_obstacle_def& def,
                                       const Where& where);

/// Settings, robots, moving obstacles and boxes; without the threads.
avo::space::Scenario scenario_of(const avo_space_simulation_def& def);

}  // namespace avo_c
