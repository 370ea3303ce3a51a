// SPDX-License-Identifier: Apache-2.0
// These tests check what must not matter to a decision. This is the place, the scale, the
// orientation, which robot is which, and the order of neighbors.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "lp/linear_program.h"
#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::Crowd;
using test::Random;

// A multiple of 2^-20 m: sums with 1e7 m are exact.
Vec2 on_grid(Vec2 p) {
  return {std::round(p.x * 0x1p20) * 0x1p-20, std::round(p.y * 0x1p20) * 0x1p-20};
}

template <typename Change>
Crowd mapped(Crowd crowd, Change&& change) {
  Robot& A = crowd.robot;
  for (Vec2* vector : {&A.position, &A.velocity, &A.preferred_velocity}) *vector = change(*vector);
  for (Neighbor& B : crowd.neighbors) {
    for (Vec2* vector : {&B.position, &B.velocity, &B.acceleration}) *vector = change(*vector);
  }
  return crowd;
}

Plan among(const Crowd& crowd) {
  PlanWorkspace workspace;
  return Planner(crowd.options).plan_among_movers(crowd.robot, crowd.neighbors, workspace);
}

void expect_same(const Plan& a, const Plan& b, const Crowd& crowd) {
  EXPECT_EQ(a.new_velocity, b.new_velocity) << crowd;
  EXPECT_EQ(a.status, b.status) << crowd;
  EXPECT_EQ(a.violation, b.violation) << crowd;
}

TEST(Symmetry, P6_translation_by_1e7_m_changes_no_bit) {
  Random random(6);
  for (int k = 0; k < 40'000 && !testing::Test::HasFailure(); ++k) {
    Crowd here = test::random_crowd(random, -0.5);
    // certificates cover the rounding of positions, which grows with them
    if (k % 2 == 0) here = test::by_avo(random, here, Certificate::none);
    here.robot.position = on_grid(here.robot.position);
    for (Neighbor& B : here.neighbors) B.position = on_grid(B.position);
    Crowd there = here;
    const Vec2 way{1e7, -1e7};
    there.robot.position = there.robot.position + way;
    for (Neighbor& B : there.neighbors) B.position = B.position + way;
    expect_same(test::plan_of(here), test::plan_of(there), here);
    if (k % 20 == 0) expect_same(among(here), among(there), here);
  }
}

Crowd scaled(const Crowd& crowd, double length) {
  Crowd result = mapped(crowd, [&](Vec2 a) { return length * a; });
  result.robot.radius *= length;
  result.robot.max_acceleration *= length;
  result.robot.max_speed *= length;
  result.robot.distance_to_goal *= length;
  result.options.arrival_distance *= length;
  for (Neighbor& B : result.neighbors) {
    B.radius *= length;
    B.max_acceleration *= length;
  }
  return result;
}

TEST(Symmetry, P6_lengths_times_a_power_of_two_scale_every_bit) {
  Random random(7);
  for (int k = 0; k < 25'000 && !testing::Test::HasFailure(); ++k) {
    const Crowd crowd = test::any_crowd(random, k, -0.5);
    const double length = std::ldexp(1.0, k % 49 - 24);
    const Crowd other = scaled(crowd, length);
    Plan plan = test::plan_of(crowd);
    plan.new_velocity = length * plan.new_velocity;
    plan.violation *= length;
    expect_same(plan, test::plan_of(other), crowd);
    if (k % 20 != 0) continue;
    plan = among(crowd);
    plan.new_velocity = length * plan.new_velocity;
    plan.violation *= length;
    expect_same(plan, among(other), crowd);
  }
}

Crowd slowed(Crowd crowd, double time) {
  PlannerOptions& options = crowd.options;
  for (double* each : {&options.control_time, &options.time_horizon, &options.time_step}) {
    *each *= time;
  }
  Robot& A = crowd.robot;
  A.velocity = A.velocity / time;
  A.preferred_velocity = A.preferred_velocity / time;
  A.max_speed /= time;
  A.max_acceleration /= time * time;
  for (Neighbor& B : crowd.neighbors) {
    B.velocity = B.velocity / time;
    B.acceleration = B.acceleration / (time * time);
    B.max_acceleration /= time * time;
  }
  return crowd;
}

TEST(Symmetry, P6_times_times_a_power_of_two_scale_every_bit) {
  Random random(18);
  for (int k = 0; k < 25'000 && !testing::Test::HasFailure(); ++k) {
    const Crowd crowd = test::any_crowd(random, k, -0.5);
    const double time = std::ldexp(1.0, k % 25 - 12);
    Plan plan = test::plan_of(crowd);
    plan.new_velocity = plan.new_velocity / time;
    plan.violation /= time;
    expect_same(plan, test::plan_of(slowed(crowd, time)), crowd);
    if (k % 20 != 0) continue;
    plan = among(crowd);
    plan.new_velocity = plan.new_velocity / time;
    plan.violation /= time;
    expect_same(plan, among(slowed(crowd, time)), crowd);
  }
}

TEST(Symmetry, P7_point_reflection_negates_every_bit) {
  Random random(8);
  for (int k = 0; k < 40'000 && !testing::Test::HasFailure(); ++k) {
    const Crowd crowd = test::any_crowd(random, k, -0.5);
    Plan plan = test::plan_of(crowd);
    plan.new_velocity = -plan.new_velocity;
    expect_same(plan, test::plan_of(mapped(crowd, [](Vec2 a) { return -a; })), crowd);
  }
}

TEST(Symmetry, P6_quarter_turns_turn_every_bit) {
  Random random(9);
  for (int k = 0; k < 40'000 && !testing::Test::HasFailure(); ++k) {
    const Crowd crowd = test::any_crowd(random, k, -0.5);
    Plan plan = test::plan_of(crowd);
    plan.new_velocity = perpendicular(plan.new_velocity);
    expect_same(plan, test::plan_of(mapped(crowd, [](Vec2 a) { return perpendicular(a); })), crowd);
  }
}

// A and B see the same line from both sides, and it splits: P7 through the planner.
TEST(Symmetry, P7_two_robots_get_opposite_planes) {
  Random random(10);
  int both = 0;
  for (int k = 0; k < 50'000 && !testing::Test::HasFailure(); ++k) {
    Crowd crowd = test::random_crowd(random, -0.5);
    Robot A = crowd.robot;
    const Neighbor random_B = test::random_neighbor(random, A, -0.5);
    Robot B{random_B.position, random_B.velocity, {}, random_B.radius, A.max_acceleration, 5.0};
    if (random_B.behavior == Behavior::decides) B.max_acceleration = random_B.max_acceleration;
    if (k % 3 == 0) B.velocity = A.velocity;  // ties
    const Planner planner(crowd.options);
    PlanWorkspace workspace;
    HalfPlanes of_A, of_B;
    planner.collect_half_planes(A, std::vector<Neighbor>{test::as_neighbor(B)}, workspace, of_A);
    planner.collect_half_planes(B, std::vector<Neighbor>{test::as_neighbor(A)}, workspace, of_B);
    if (of_A.planes.empty() || of_B.planes.empty()) continue;
    ++both;
    EXPECT_EQ(of_A.planes[0].plane.normal, -of_B.planes[0].plane.normal);
  }
  EXPECT_GT(both, 10'000);
}

TEST(Symmetry, P10_order_of_the_half_planes_changes_rounding_only) {
  Random random(11);
  PlanWorkspace workspace;
  HalfPlanes half_planes;
  ProgramRows scratch;
  int infeasible = 0;
  for (int k = 0; k < 20'000 && !testing::Test::HasFailure(); ++k) {
    const Crowd crowd = test::random_crowd(random, -0.5);
    const Planner planner(crowd.options);
    planner.collect_half_planes(crowd.robot, crowd.neighbors, workspace, half_planes);
    std::vector<HalfPlane> planes;
    for (const NeighborPlane& own : half_planes.planes) planes.push_back(own.plane);
    const auto solve = [&] {
      return nearest_point(planes, planner.acceleration_disc(crowd.robot), crowd.robot.max_speed,
                           crowd.robot.preferred_velocity, scratch);
    };
    const ProgramResult result = solve();
    for (std::size_t i = planes.size(); i > 1; --i) {
      std::swap(planes[i - 1], planes[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    }
    const ProgramResult other = solve();
    const double speed = crowd.robot.max_speed;
    if (result.state != other.state) {  // on the edge of being empty
      EXPECT_LT(std::max(result.violation, other.violation), 1e-12 * speed) << crowd;
      continue;
    }
    infeasible += result.violation > 0.0 ? 1 : 0;
    EXPECT_NEAR(result.violation, other.violation, 1e-10 * speed) << crowd;
    EXPECT_NEAR(norm(result.point - crowd.robot.preferred_velocity),
                norm(other.point - crowd.robot.preferred_velocity), 1e-7 * speed)
        << crowd;
    EXPECT_NEAR(norm(result.point - other.point), 0.0, 1e-5 * speed) << crowd;
  }
  EXPECT_GT(infeasible, 1000);
}

// Galilean boost: all seen from something that moves. The half-planes move along.
TEST(Symmetry, P6_a_boost_moves_the_half_planes) {
  Random random(16);
  PlanWorkspace workspace;
  HalfPlanes still, moving;
  int planes = 0;
  for (int k = 0; k < 5'000 && !testing::Test::HasFailure(); ++k) {
    Crowd crowd = test::random_crowd(random, 0.01);
    crowd.options.method = Method::avo_paper;
    crowd.robot.max_speed *= 1e3;  // so that no half-plane is dropped for the sake of the limit
    const Planner planner(crowd.options);
    planner.collect_half_planes(crowd.robot, crowd.neighbors, workspace, still);
    const double speed =
        norm(crowd.robot.velocity) + crowd.options.control_time * crowd.robot.max_acceleration;
    const Vec2 boost = speed * random.direction();
    crowd.robot.velocity = crowd.robot.velocity + boost;
    for (Neighbor& each : crowd.neighbors) each.velocity = each.velocity + boost;
    planner.collect_half_planes(crowd.robot, crowd.neighbors, workspace, moving);
    for (const NeighborPlane& one : still.planes) {
      for (const NeighborPlane& other : moving.planes) {
        if (one.neighbor != other.neighbor) continue;
        ++planes;
        const double scale = speed + std::abs(one.plane.offset);
        // how far the same velocity violates both; n itself is less sharp than its support
        for (const double side : {-0.5, 0.5}) {
          const Vec2 v = crowd.robot.velocity - boost +
                         std::min(0.1 * speed, scale) * side * perpendicular(one.plane.normal);
          EXPECT_NEAR(violation(one.plane, v), violation(other.plane, v + boost), 1e-5 * scale)
              << crowd;
        }
      }
    }
  }
  EXPECT_GT(planes, 5'000);
}

// A decision depends on nothing but its arguments: not on what the workspace was used for before.
TEST(Symmetry, the_workspace_carries_nothing_over) {
  Random random(12);
  PlanWorkspace used;
  for (int k = 0; k < 10'000 && !testing::Test::HasFailure(); ++k) {
    const Crowd crowd = test::any_crowd(random, k, -0.5);
    const Planner planner(crowd.options);
    const Plan again = planner.plan(crowd.robot, crowd.neighbors, used);
    expect_same(test::plan_of(crowd), again, crowd);
    if (k % 10 == 0) {
      expect_same(among(crowd), planner.plan_among_movers(crowd.robot, crowd.neighbors, used),
                  crowd);
    }
  }
}

}  // namespace
}  // namespace avo
