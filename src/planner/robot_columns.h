// SPDX-License-Identifier: Apache-2.0
// Robots of method avo that decide together, in columns: what each does by itself, in lanes.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "certificate/braking_path.h"
#include "core/neighbor_columns.h"

namespace avo {

/// Scratch memory; allocates only while it grows. Columns have room for kSpareNeighbors more.
struct RobotColumns {
  using Column = std::vector<double>;
  std::size_t count = 0;
  Column v_x, v_y, preferred_x, preferred_y;             // m/s
  Column distance, radius, max_acceleration, max_speed;  // of the goal m; m, m/s², m/s

  Column range, ahead, push_x, push_y;  // m; by look_around(), see Traffic
  Column wish_x, wish_y;                // m/s, by keep_right(), and then by wish_of()
  Column target_x, target_y;            // m/s, what Eq. (23) made of the wish
  // by decide_freely(), [v_1] m/s: target and wish as far as one step leads to them
  Column next_x, next_y, unhindered_x, unhindered_y;
  Column new_x, new_y, a_x, a_y;  // m/s, m/s², likewise: the decision for it
  Column is_free;                 // likewise: 1 where neither limits nor being blocked object, or 0

  void reserve(std::size_t robots);
  void add(const Robot& robot) {
    v_x[count] = robot.velocity.x, v_y[count] = robot.velocity.y;
    preferred_x[count] = robot.preferred_velocity.x;
    preferred_y[count] = robot.preferred_velocity.y;
    distance[count] = robot.distance_to_goal, radius[count] = robot.radius;
    max_acceleration[count] = robot.max_acceleration, max_speed[count++] = robot.max_speed;
  }
};

/// What each sees of its traffic; the columns are those of the robots.
void look_around(std::span<const Sensing> robots, RobotColumns& columns);

/// The preferred velocity turned to the right by how congested the way ahead is; as it is on the
/// last of the way to the goal.
void keep_right(RobotColumns& columns);

/// From a wish, and the target that the program has made of it, to the plan of one to whom no
/// certificate objects.
void decide_freely(const StepLaw& law, RobotColumns& columns);

}  // namespace avo
