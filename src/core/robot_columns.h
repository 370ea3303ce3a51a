// SPDX-License-Identifier: Apache-2.0
// Robots that decide together, in columns: their state is written here once a step, and every
// kernel reads it here.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/robot.h"
#include "core/neighbor_columns.h"

namespace avo::inline core {

/// Allocates only while it grows. Columns have room for kSpareNeighbors extra entries, which are
/// read but do not count.
struct RobotColumns {
  using Column = std::vector<double>;
  std::size_t count = 0;
  Column x, y, v_x, v_y;               // m, m/s
  Column preferred_x, preferred_y;     // m/s
  Column distance_to_goal, radius;     // m
  Column max_acceleration, max_speed;  // m/s², m/s
  Column max_braking;                  // m/s²
  Column heading;                      // rad; read where there is a model
  Column priority;
  std::vector<const MotionModel*> model;    // null for holonomic robots
  bool has_models = false;                  // some are not holonomic
  std::vector<Neighbors> neighbors;         // that each robot senses, nearest first
  std::vector<const LoiterCircle*> loiter;  // of robots that fly; empty where there are none
  std::vector<double> lookahead;            // m; empty where no robot has a footprint

  void reserve(std::size_t robots);
  void clear() {
    count = 0;
    model.clear();
    has_models = false;
    neighbors.clear();
    loiter.clear();
    lookahead.clear();
  }
  /// robot.model and robot.loiter must stay at their addresses.
  void add(const Robot& robot, const Neighbors& sensed);
  Robot robot(std::size_t i) const;
  /// Exchanges two robots.
  void swap(std::size_t i, std::size_t k);

  Vec2 position(std::size_t i) const { return {x[i], y[i]}; }
  Vec2 velocity(std::size_t i) const { return {v_x[i], v_y[i]}; }
};

}  // namespace avo::inline core
