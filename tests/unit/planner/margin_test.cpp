// SPDX-License-Identifier: Apache-2.0
// A clearance that is wished for beyond the radius, and where it fades.
#include "planner/rules/margin.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <optional>
#include <span>

#include "avo/planner.h"
#include "crowds.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::Random;

constexpr double kWished = 0.25;  // m

Planner planner_wishing(double margin) {
  return Planner(PlannerOptions{.margin = margin});
}

TEST(Margin, fades_towards_the_goal) {
  const double far = std::numeric_limits<double>::infinity();
  EXPECT_EQ(margin_on_route(kWished, 0.5, far), kWished);
  EXPECT_EQ(margin_on_route(kWished, 0.5, 4.0), kWished);        // 8 radii
  EXPECT_EQ(margin_on_route(kWished, 0.5, 3.0), 0.5 * kWished);  // 6 radii
  for (const double near : {2.0, 1.0, 0.0}) EXPECT_EQ(margin_on_route(kWished, 0.5, near), 0.0);
}

TEST(Margin, takes_half_of_the_gap_at_most) {
  EXPECT_EQ(margin_in_gap(kWished, 9.0), kWished);
  EXPECT_EQ(margin_in_gap(kWished, 0.5), kWished);
  EXPECT_EQ(margin_in_gap(kWished, 0.25), 0.125);
  EXPECT_EQ(margin_in_gap(kWished, 0.0), 0.0);
  EXPECT_EQ(margin_in_gap(kWished, -1.0), 0.0);
}

std::optional<HalfPlane> plane_with(double margin, const Robot& robot, const Neighbor& neighbor) {
  PlanWorkspace workspace;
  HalfPlanes planes;
  planner_wishing(margin).collect_half_planes(robot, std::span(&neighbor, 1), workspace, planes);
  if (planes.planes.empty()) return {};
  return planes.planes[0].plane;
}

// The half-plane of a neighbor that is so much larger.
void expect_as_if_larger(double by, const Robot& robot, const Neighbor& neighbor) {
  Neighbor larger = neighbor;
  larger.radius += by;
  const auto wished = plane_with(kWished, robot, neighbor),
             expected = plane_with(0.0, robot, larger);
  ASSERT_TRUE(wished && expected);
  EXPECT_NEAR(norm(wished->normal - expected->normal), 0.0, 1e-9);
  EXPECT_NEAR(wished->offset, expected->offset, 1e-9);
}

TEST(Margin, is_kept_as_if_the_neighbor_were_larger) {
  Robot robot{.velocity = {1.5, 0}, .preferred_velocity = {1.5, 0}};
  Neighbor neighbor{.position = {4, 0.2}, .velocity = {-1.5, 0}};
  expect_as_if_larger(kWished, robot, neighbor);
  neighbor.position = {1.2, 0.0}, neighbor.velocity = {-0.1, 0};
  expect_as_if_larger(0.1, robot, neighbor);
  robot.distance_to_goal = 2.0;
  expect_as_if_larger(0.0, robot, neighbor);
}

// All standing still keeps to every half-plane that it keeps to without a margin.
TEST(Margin, makes_nobody_at_rest_move) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random random(seed);
    const Robot robot{.velocity = {}, .preferred_velocity = random.direction()};
    const Neighbor neighbor{.position = random.uniform(1.0, 3.0) * random.direction()};
    const auto plane = plane_with(random.log_uniform(0.01, 10.0), robot, neighbor);
    if (!plane) continue;
    EXPECT_LE(plane->offset, 0.0) << "0 is in it";
  }
}

}  // namespace
}  // namespace avo
