// SPDX-License-Identifier: Apache-2.0
// What robots perceive, and what they do then.
#pragma once
#include <cstddef>
#include <gtest/gtest.h>
#include <vector>

#include "avo/simulation.h"

namespace avo::test {

/// Takes a step, and demands that each robot does in it what it would by what it perceives before.
/// Calls look(perception) for each.
template <typename Look>
void step_as_perceived(Simulation& simulation, const Look& look) {
  PlanWorkspace workspace;
  std::vector<Plan> expected;
  const auto ids = simulation.fleet().id;
  for (const RobotId robot : std::vector<RobotId>(ids.begin(), ids.end())) {
    Simulation::Perception seen = simulation.perceive(robot);
    look(seen);
    const Plan planned =
        simulation.planner().plan(seen.robot, seen.neighbors, workspace, &seen.detour, seen.walls);
    expected.push_back(seen.stop.value_or(planned));
  }
  simulation.step();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Plan done = simulation.fleet().plan[i];
    ASSERT_EQ(done.new_velocity, expected[i].new_velocity) << simulation.time() << ", " << i;
    ASSERT_EQ(done.next_velocity, expected[i].next_velocity) << simulation.time() << ", " << i;
  }
}

}  // namespace avo::test
