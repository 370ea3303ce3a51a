// SPDX-License-Identifier: Apache-2.0
#include "io/space/space_clearances.h"

#include <algorithm>
#include <limits>

namespace avo_io {

using avo::Vec3;

SpaceClearances::SpaceClearances(const avo::space::Scenario& scenario) {
  for (const avo::space::RobotSetup& setup : scenario.robots) {
    const avo::space::Robot robot = robot_of(setup);
    bodies_.push_back({robot.radius, robot.downwash});
    largest_ = std::max(largest_, robot.radius);
  }
}

void SpaceClearances::find(const BlockShape& shape, std::size_t time, RecordingBlock& block) {
  const double *x = block.row(shape, 0, time), *y = block.row(shape, 1, time),
               *z = block.row(shape, 2, time);
  float* const clearance = block.clearance.data() + time * shape.robots;
  std::fill_n(clearance, shape.robots, std::numeric_limits<float>::quiet_NaN());
  order_.clear();
  for (std::size_t i = 0; i < shape.robots; ++i)
    if (block.status[time * shape.robots + i] != kAbsent) order_.push_back(i);
  find_among(x, y, z, clearance);
}

void SpaceClearances::find(std::span<const avo::space::Robot> robots, std::span<float> clearance) {
  x_.clear(), y_.clear(), z_.clear(), order_.clear();
  for (const avo::space::Robot& robot : robots) {
    order_.push_back(x_.size());
    x_.push_back(robot.position.x);
    y_.push_back(robot.position.y);
    z_.push_back(robot.position.z);
  }
  find_among(x_.data(), y_.data(), z_.data(), clearance.data());
}

void SpaceClearances::find_among(const double* x, const double* y, const double* z,
                                 float* clearance) {
  std::sort(order_.begin(), order_.end(),
            [x](std::size_t a, std::size_t b) { return x[a] < x[b] || (x[a] == x[b] && a < b); });
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const std::size_t a = order_[k];
    const Body& body = bodies_[a];
    double least = std::numeric_limits<double>::infinity();
    // false where b and all robots beyond it are farther away along x alone
    const auto look_at = [&](std::size_t b, double along) {
      if (along - body.radius - largest_ >= least) return false;
      Vec3 p = {x[a] - x[b], y[a] - y[b], z[a] - z[b]};
      p.z -= std::clamp(p.z, -bodies_[b].downwash, body.downwash);
      least = std::min(least, norm(p) - body.radius - bodies_[b].radius);
      return true;
    };
    for (std::size_t m = k + 1; m < order_.size() && look_at(order_[m], x[order_[m]] - x[a]); ++m) {
    }
    for (std::size_t m = k; m > 0 && look_at(order_[m - 1], x[a] - x[order_[m - 1]]); --m) {
    }
    clearance[a] = static_cast<float>(least);
  }
}

}  // namespace avo_io
