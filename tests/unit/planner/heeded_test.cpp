// SPDX-License-Identifier: Apache-2.0
// What a trace says of the rules for arriving.
#include <array>
#include <gtest/gtest.h>

#include "avo/planner.h"

namespace avo::test {
namespace {

// A is at its goal, and B and C pass on both sides. B is nearer, but yields to A; A yields to C.
TEST(Heeded, is_the_neighbor_that_pushes_most_by_the_priorities_too) {
  const auto heeded_by = [](double priority_of_b, double priority_of_c) {
    const Planner planner(PlannerOptions{});
    PlanWorkspace workspace;
    const Robot a{.position = {0.0, 0.0}, .velocity = {}, .distance_to_goal = 0.1};
    const std::array<Neighbor, 2> others{
        Neighbor{.position = {0.0, 1.05}, .velocity = {1.0, 0.0}, .priority = priority_of_b},
        Neighbor{.position = {0.0, -1.10}, .velocity = {1.0, 0.0}, .priority = priority_of_c}};
    Detour detour;
    const DecisionTrace trace = planner.explain(a, others, workspace, &detour);
    EXPECT_EQ(trace.rule, WishRule::yields);
    return trace.heeded;
  };
  EXPECT_EQ(heeded_by(1.0, 1.0), 0);
  EXPECT_EQ(heeded_by(0.01, 100.0), 1);
  EXPECT_EQ(heeded_by(100.0, 0.01), 0);
}

}  // namespace
}  // namespace avo::test
