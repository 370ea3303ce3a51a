// SPDX-License-Identifier: Apache-2.0
// How a decision was made: every status, bad options (paper §IV-D and beyond).
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/error.h"
#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::as_neighbor;
using test::kInfinity;
using test::kNaN;
using test::paper_robot;

Plan decide(const PlannerOptions& options, const Robot& robot,
            const std::vector<Neighbor>& neighbors) {
  PlanWorkspace workspace;
  return Planner(options).plan(robot, neighbors, workspace);
}

bool finite(const Plan& plan) {
  return is_finite(plan.new_velocity) && is_finite(plan.acceleration) &&
         std::isfinite(plan.violation);
}

TEST(Status, optimal_takes_the_preferred_velocity_where_nothing_is_near) {
  const Robot robot = paper_robot({3, 4}, {0.3, -0.1}, {1.1, 0.7});
  const Plan plan = decide(test::paper_options(), robot, {});
  EXPECT_EQ(plan.status, PlanStatus::optimal);
  EXPECT_EQ(plan.new_velocity, robot.preferred_velocity);
  EXPECT_EQ(plan.violation, 0.0);
  const Vec2 expected = (robot.preferred_velocity - robot.velocity) / 4.0;  // Eq. (7)
  EXPECT_EQ(plan.acceleration, expected);
}

TEST(Status, at_rest_among_robots_at_rest_is_finite_and_optimal) {
  std::vector<Neighbor> neighbors;
  for (const Vec2 p : {Vec2{3, 0}, Vec2{-3, 0}, Vec2{0, 3}, Vec2{0, -3}}) {
    neighbors.push_back(as_neighbor(paper_robot(p, {}, {})));
  }
  const Plan plan = decide(test::paper_options(), paper_robot({}, {}, {}), neighbors);
  EXPECT_TRUE(finite(plan));
  EXPECT_EQ(plan.status, PlanStatus::optimal);
  EXPECT_EQ(plan.new_velocity, Vec2{});
}

TEST(Status, least_unsafe_where_all_come_at_once) {
  std::vector<Neighbor> neighbors;
  for (const Vec2 n : {Vec2{1, 0}, Vec2{-0.6, 0.8}, Vec2{-0.6, -0.8}}) {
    neighbors.push_back(as_neighbor(paper_robot(2.0 * n, -2.0 * n, {})));
  }
  const Robot robot = paper_robot({}, {}, {1, 0});
  const Plan plan = decide(test::paper_options(), robot, neighbors);
  EXPECT_EQ(plan.status, PlanStatus::least_unsafe);
  EXPECT_GT(plan.violation, 0.1);

  // the violation is that of the worst half-plane
  const Planner planner(test::paper_options());
  PlanWorkspace workspace;
  HalfPlanes half_planes;
  planner.collect_half_planes(robot, neighbors, workspace, half_planes);
  ASSERT_EQ(half_planes.planes.size(), 3u);
  double worst = 0.0;
  for (const NeighborPlane& each : half_planes.planes) {
    worst = std::max(worst, violation(each.plane, plan.new_velocity) + each.excess);
  }
  EXPECT_NEAR(plan.violation, worst, 1e-12);
}

// One neighbor, so near and fast that braking comes too late: the half-plane touches what A may
// choose in one point, which the program finds; CA_A is empty all the same.
TEST(Status, least_unsafe_where_a_collision_cannot_be_avoided) {
  const Robot robot = paper_robot({}, {1.5, 0}, {2, 0});
  const std::vector<Neighbor> neighbors{as_neighbor(paper_robot({1.2, 0.3}, {-1.5, 0}, {}))};
  const Plan plan = decide(test::paper_options(), robot, neighbors);
  EXPECT_EQ(plan.status, PlanStatus::least_unsafe);
  const Planner planner(test::paper_options());
  PlanWorkspace workspace;
  HalfPlanes half_planes;
  planner.collect_half_planes(robot, neighbors, workspace, half_planes);
  ASSERT_EQ(half_planes.planes.size(), 1u);
  const NeighborPlane& only = half_planes.planes[0];
  EXPECT_GT(only.excess, 0.0);
  // h* = reach, of which A's half is δ a_A
  EXPECT_NEAR(only.plane.offset, dot(only.plane.normal, robot.velocity) + 4.0, 1e-12);
  EXPECT_GE(plan.violation, only.excess);
}

TEST(Status, overlapping_separates) {
  const Robot robot = paper_robot({}, {0.5, 0}, {1, 0});
  const Neighbor other = as_neighbor(paper_robot({0.9, 0.1}, {-0.5, 0}, {}));
  for (const double delta : {0.2, 4.0}) {
    PlannerOptions options = test::paper_options();
    options.control_time = delta;
    const Plan plan = decide(options, robot, {other});
    EXPECT_EQ(plan.status, PlanStatus::overlapping);
    EXPECT_LT(dot(plan.new_velocity - robot.velocity, other.position), 0.0);
  }
}

TEST(Status, overlapping_with_equal_centers_and_velocities_is_finite) {
  const Robot robot = paper_robot({1, 2}, {0.5, 0}, {1, 0});
  for (const Method method :
       {Method::avo_paper, Method::velocity_obstacle, Method::orca, Method::orca_clamped,
        Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    PlannerOptions options = default_options(method);
    const Plan plan = decide(options, robot, {as_neighbor(robot)});
    EXPECT_EQ(plan.status, PlanStatus::overlapping);
    EXPECT_TRUE(finite(plan));
    // no direction can be told: no plane, rather than one that is not a number
    PlanWorkspace workspace;
    HalfPlanes half_planes;
    Planner(options).collect_half_planes(robot, std::vector<Neighbor>{as_neighbor(robot)},
                                         workspace, half_planes);
    EXPECT_TRUE(half_planes.planes.empty());
    EXPECT_TRUE(half_planes.overlapping);
  }
}

// |v| beyond v_max + δ a_max: no velocity keeps both limits.
TEST(Status, braking_where_the_speed_limit_is_out_of_reach) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    PlannerOptions options = test::paper_options();
    options.motion = motion;
    options.control_time = 2.0;
    const Robot robot = paper_robot({}, {0, -5}, {0, -2});  // v_max 2, δ a_max 2
    const Plan plan = decide(options, robot, {});
    EXPECT_EQ(plan.status, PlanStatus::braking);
    EXPECT_NEAR(plan.violation, 1.0, 1e-12);
    EXPECT_NEAR(plan.acceleration.y, 1.0, 1e-12);
    EXPECT_EQ(plan.acceleration.x, 0.0);
    const Robot within = paper_robot({}, {0, -3.999}, {0, -2});
    EXPECT_EQ(decide(options, within, {}).status, PlanStatus::optimal);
  }
}

// A robot that knows nothing useful of itself: the command is a stop, and a number.
TEST(Status, invalid_velocity_or_limits_command_rest) {
  Robot robot = paper_robot({}, {kNaN, 1}, {1, 0});
  const Plan plan = decide(test::paper_options(), robot, {});
  EXPECT_EQ(plan.new_velocity, Vec2{});
  EXPECT_EQ(plan.acceleration, Vec2{});
}

TEST(Status, braking_comes_to_rest_within_the_step_where_it_can) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    PlannerOptions options = test::paper_options();
    options.motion = motion;
    const Planner planner(options);
    Robot robot = paper_robot({kNaN, 0}, {0.03, 0.04}, {1, 0});
    PlanWorkspace workspace;
    const Plan plan = planner.plan(robot, {}, workspace);
    const Vec2 next = robot.velocity + planner.step_rate() * (plan.new_velocity - robot.velocity);
    EXPECT_NEAR(norm(next), 0.0, 1e-15);
  }
}

TEST(Status, names) {
  EXPECT_STREQ(to_string(PlanStatus::optimal), "optimal");
  EXPECT_STREQ(to_string(PlanStatus::least_unsafe), "least_unsafe");
  EXPECT_STREQ(to_string(PlanStatus::refused), "refused");
  EXPECT_STREQ(to_string(PlanStatus::detour), "detour");
  EXPECT_STREQ(to_string(PlanStatus::overlapping), "overlapping");
  EXPECT_STREQ(to_string(PlanStatus::braking), "braking");
  EXPECT_STREQ(to_string(PlanStatus::invalid_input), "invalid_input");
}

TEST(Status, a_detour_that_is_no_number_is_forgotten) {
  const Neighbor near{.position = {2.0, 0.1}, .velocity = {-1.0, 0.0}};
  const Neighbor mover{.position = {2.0, 0.1}, .behavior = Behavior::moves_on};
  const Neighbor invalid{.position = {kNaN, 0.0}};
  for (const Method method :
       {Method::avo, Method::avo_paper, Method::orca, Method::velocity_obstacle,
        Method::orca_clamped, Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    const Planner planner(default_options(method));
    PlanWorkspace workspace;
    const Robot robot{.velocity = {1.0, 0.0}, .preferred_velocity = {2.0, 0.0}};
    for (const double bad : {kNaN, kInfinity, -1.0, 1e9}) {
      const auto part = static_cast<float>(bad);
      for (const Detour& detour :
           {Detour{part}, Detour{0.0F, part}, Detour{part, part}, Detour{0.0F, 0.0F, part}}) {
        for (const std::vector<Neighbor>& neighbors :
             {std::vector<Neighbor>{}, {near}, {mover}, {near, invalid}}) {
          Detour bad_detour = detour, none;
          const Plan plan = planner.plan(robot, neighbors, workspace, &bad_detour);
          EXPECT_EQ(plan.new_velocity,
                    planner.plan(robot, neighbors, workspace, &none).new_velocity);
          EXPECT_EQ(bad_detour.angle, none.angle);
          EXPECT_EQ(bad_detour.beside, none.beside);
          EXPECT_EQ(bad_detour.congestion, none.congestion);
        }
      }
    }
  }
}

}  // namespace
}  // namespace avo
