// SPDX-License-Identifier: Apache-2.0
// Recordings of a few lines for the judge.
#pragma once
#include <utility>
#include <vector>

#include "avo/check.h"
#include "support/refusal.h"

namespace avo::test {

/// All rows of one time.
struct Moment {
  double time = 0.0;
  std::vector<CheckedState> rows;
};

inline CheckReport report_of(const std::vector<CheckedRobot>& robots,
                             const std::vector<Moment>& recording,
                             std::vector<CheckedMover> obstacles = {},
                             const CheckOptions& options = {}) {
  Check check(robots, std::move(obstacles), options);
  for (const Moment& moment : recording) check.add(moment.time, moment.rows);
  return check.report();
}

/// Without limits on acceleration and speed.
inline CheckedRobot free_robot(double radius = 0.5) {
  CheckedRobot robot;
  robot.radius = radius;
  robot.max_acceleration = robot.max_speed = 1.0 / 0.0;
  return robot;
}

}  // namespace avo::test
