// SPDX-License-Identifier: Apache-2.0
// Robots that want contact: each takes the worst velocity that the certificate admits.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "avo/space/check.h"
#include "avo/space/planner.h"
#include "unit/space/draws.h"

namespace avo::space::tests {

/// What the judge knows of these robots.
std::vector<CheckedRobot> bodies_of(std::span<const Robot> robots);
/// m/s: as much of that direction as the limits of the robot let one step have, s.
Vec3 towards(const Robot& robot, Vec3 direction, double time_step);

class Crush {
 public:
  /// most_age: steps, of what robots sense of others.
  Crush(std::vector<Robot> robots, std::vector<Box> boxes, const PlannerOptions& options,
        Draws draws, int most_age = 0);

  void step();
  const std::vector<Robot>& robots() const { return robots_; }
  CheckReport report() const { return check_.report(); }

 private:
  Neighbor sensed(std::size_t k);
  std::vector<Box> seen_boxes();
  Vec3 choose(std::size_t k);
  void observe();

  std::vector<Robot> robots_;
  std::vector<std::vector<Robot>> past_;  // the robots before each step, the last step last
  int most_age_;
  std::vector<Box> boxes_;
  Draws draws_;
  Planner planner_;
  Horizon horizon_;
  PlanWorkspace workspace_;
  Check check_;
  double time_ = 0.0;
};

}  // namespace avo::space::tests
