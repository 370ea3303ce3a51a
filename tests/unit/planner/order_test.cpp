// SPDX-License-Identifier: Apache-2.0
// Neighbors may come in any order.
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

#include "unit/planner/crowds.h"

namespace avo {
namespace {

bool same(const Plan& a, const Plan& b) {
  return a.new_velocity == b.new_velocity && a.acceleration == b.acceleration &&
         a.status == b.status && a.violation == b.violation;
}

template <typename T>
void shuffle(std::vector<T>& list, test::Random& random) {
  for (std::size_t k = list.size(); k > 1; --k) {
    std::swap(list[k - 1], list[static_cast<std::size_t>(random.below(static_cast<int>(k)))]);
  }
}

TEST(Order, of_the_neighbors_changes_no_bit_of_a_plan) {
  test::Random random(41);
  int changed_by_the_nearest = 0;
  for (int k = 0; k < 6000 && !testing::Test::HasFailure(); ++k) {
    test::Crowd crowd =
        k % 2 == 0 ? test::any_crowd(random, k / 2, 0.0) : test::random_crowd(random, 0.0);
    if (k % 3 != 0) crowd.options.max_neighbors = 1 + random.below(3);
    if (crowd.neighbors.size() < 2) continue;
    const Planner planner(crowd.options);
    PlanWorkspace workspace;
    Detour detour{0.3F, 0.5F}, sorted_detour = detour;
    std::stable_sort(crowd.neighbors.begin(), crowd.neighbors.end(),
                     [&](const Neighbor& a, const Neighbor& b) {
                       return norm_squared(a.position - crowd.robot.position) <
                              norm_squared(b.position - crowd.robot.position);
                     });
    const Plan plan = planner.plan(crowd.robot, crowd.neighbors, workspace, &sorted_detour);
    std::vector<Neighbor> shuffled = crowd.neighbors;
    shuffle(shuffled, random);
    EXPECT_TRUE(same(planner.plan(crowd.robot, shuffled, workspace, &detour), plan)) << crowd;
    EXPECT_EQ(detour.angle, sorted_detour.angle);
    EXPECT_EQ(detour.beside, sorted_detour.beside);
    // The nearest neighbor matters.
    const std::vector<Neighbor> rest(crowd.neighbors.begin() + 1, crowd.neighbors.end());
    changed_by_the_nearest += same(planner.plan(crowd.robot, rest, workspace), plan) ? 0 : 1;
  }
  EXPECT_GT(changed_by_the_nearest, 1000);
}

// A robot that comes straight at A, behind ten that do not matter.
TEST(Order, the_nearest_of_max_neighbors_get_the_half_planes) {
  PlannerOptions options = default_options(Method::avo_paper);
  options.max_neighbors = 2;
  const Planner planner(options);
  PlanWorkspace workspace;
  HalfPlanes half_planes;
  const Robot A{.velocity = {2.0, 0.0}, .preferred_velocity = {2.0, 0.0}};
  std::vector<Neighbor> neighbors(10, Neighbor{.position = {-12.0, 5.0}, .velocity = {-1.0, 0.0}});
  neighbors.push_back({.position = {6.0, 0.1}, .velocity = {-2.0, 0.0}});
  const Plan plan = planner.plan(A, neighbors, workspace);
  EXPECT_GT(norm(plan.new_velocity - A.preferred_velocity), 0.1);
  planner.collect_half_planes(A, neighbors, workspace, half_planes);
  ASSERT_EQ(half_planes.planes.size(), 2U);
  EXPECT_EQ(half_planes.planes[0].neighbor, 0);
  EXPECT_EQ(half_planes.planes[1].neighbor, 10);  // as given
}

}  // namespace
}  // namespace avo
