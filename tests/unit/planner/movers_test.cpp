// SPDX-License-Identifier: Apache-2.0
// Movers that do not decide: the whole share, and their observed acceleration (§III-C).
#include <gtest/gtest.h>
#include <vector>

#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::Random;

Neighbor mover(Vec2 position, Vec2 velocity, Vec2 acceleration) {
  return {.position = position,
          .velocity = velocity,
          .behavior = Behavior::moves_on,
          .acceleration = acceleration};
}

// Distance over (0, τ] if A heads for v_new_A and B for v_B + δ a_B, both by Eqs. (8), (9).
double distance_ahead(const PlannerOptions& options, const Robot& A, Vec2 v_new_A,
                      const Neighbor& B) {
  const Pair pair{A.position - B.position, A.velocity - B.velocity, A.radius + B.radius};
  const Obstacle obstacle{pair, Response::proportional(options.control_time), options.time_horizon};
  return closest_approach(obstacle, v_new_A - B.velocity - options.control_time * B.acceleration)
      .distance;
}

// B stands still and pulls out across A's course: only B's acceleration tells this.
TEST(Movers, observed_acceleration_is_avoided_by_both_ways_of_planning) {
  const PlannerOptions options = test::paper_options();
  const Planner planner(options);
  const Robot A = test::paper_robot({}, {1.5, 0}, {1.5, 0});
  const Neighbor seen = mover({7, -1.5}, {}, {0, 0.1});
  const Neighbor unseen = mover({7, -1.5}, {}, {});
  PlanWorkspace workspace;
  for (const bool alone : {true, false}) {
    const auto plan = [&](const Neighbor& B) {
      const std::vector<Neighbor> others{B};
      return alone ? planner.plan_among_movers(A, others, workspace)
                   : planner.plan(A, others, workspace);
    };
    const Plan blind = plan(unseen), aware = plan(seen);
    ASSERT_EQ(blind.status, PlanStatus::optimal);
    ASSERT_EQ(aware.status, PlanStatus::optimal);
    EXPECT_EQ(blind.new_velocity, A.preferred_velocity);
    EXPECT_LT(distance_ahead(options, A, blind.new_velocity, seen), 0.9);
    EXPECT_GE(distance_ahead(options, A, aware.new_velocity, seen), 1.0 - 1e-9);
  }
}

// An overlap by a millionth asks for no more than one step can mend, alone or not. Rounding may
// feign so little: nothing is said of it.
TEST(Movers, a_hardly_overlapping_one_is_left_gently) {
  PlannerOptions options = test::paper_options();
  options.control_time = 0.5;
  const Planner planner(options);
  const Robot A = test::paper_robot({}, {}, {});
  const std::vector<Neighbor> others{mover({1.0 - 1e-6, 0}, {}, {})};
  PlanWorkspace workspace;
  const Plan alone = planner.plan_among_movers(A, others, workspace);
  const Plan by_plane = planner.plan(A, others, workspace);
  EXPECT_NE(alone.status, PlanStatus::overlapping);
  EXPECT_NE(by_plane.status, PlanStatus::overlapping);
  EXPECT_NEAR(norm(alone.new_velocity - by_plane.new_velocity), 0.0, 1e-12);
  EXPECT_GT(norm(alone.new_velocity), 0.0);
  EXPECT_LT(norm(alone.new_velocity), 1e-3);
}

TEST(Movers, observed_acceleration_of_those_that_decide_is_not_read) {
  const Planner planner(test::paper_options());
  const Robot A = test::paper_robot({}, {1.5, 0}, {1.5, 0});
  const Neighbor B{.position = {5, 0.3}, .velocity = {-1, 0}};
  Neighbor accelerating = B;
  accelerating.acceleration = {0.3, -0.7};
  PlanWorkspace workspace;
  for (const bool alone : {true, false}) {
    const auto plan = [&](const Neighbor& other) {
      const std::vector<Neighbor> others{other};
      return alone ? planner.plan_among_movers(A, others, workspace)
                   : planner.plan(A, others, workspace);
    };
    EXPECT_EQ(plan(B).new_velocity, plan(accelerating).new_velocity);
  }
}

TEST(Movers, likely_deviation_of_those_that_decide_is_not_read) {
  const Planner planner(default_options(Method::avo));
  const Robot A{.velocity = {2, 0}, .preferred_velocity = {2, 0}};
  PlanWorkspace workspace;
  const auto plan = [&](Behavior behavior, double likely) {
    const Neighbor B{.position = {3, 2.5},
                     .velocity = {0, -0.5},
                     .behavior = behavior,
                     .likely_deviation = likely};
    return planner.plan_among_movers(A, std::vector{B}, workspace);
  };
  EXPECT_NE(plan(Behavior::moves_on, 0.6).acceleration, plan(Behavior::moves_on, 0).acceleration);
  EXPECT_EQ(plan(Behavior::decides, 0.6).acceleration, plan(Behavior::decides, 0).acceleration);
}

TEST(Movers, an_optimal_choice_keeps_clear_of_all_of_them) {
  Random random(3);
  int optimal = 0, busy = 0;
  for (int k = 0; k < 4'000 && !testing::Test::HasFailure(); ++k) {
    test::Crowd crowd = test::random_crowd(random, 0.001);
    if (crowd.neighbors.size() > 4) crowd.neighbors.resize(4);
    for (Neighbor& B : crowd.neighbors) {
      B.behavior = Behavior::moves_on;
      if (k % 2 == 0) B.acceleration = test::in_disc(random, 0.3);
    }
    const Planner planner(crowd.options);
    PlanWorkspace workspace;
    for (const bool alone : {true, false}) {
      if (alone && k % 4 > 0) continue;
      const Plan plan = alone ? planner.plan_among_movers(crowd.robot, crowd.neighbors, workspace)
                              : planner.plan(crowd.robot, crowd.neighbors, workspace);
      if (plan.status != PlanStatus::optimal) continue;
      ++optimal;
      if (!(plan.new_velocity == crowd.robot.preferred_velocity)) ++busy;
      for (const Neighbor& B : crowd.neighbors) {
        EXPECT_GE(distance_ahead(crowd.options, crowd.robot, plan.new_velocity, B),
                  (crowd.robot.radius + B.radius) * (1.0 - 1e-9))
            << (alone ? "alone\n" : "by half-planes\n") << crowd;
      }
    }
  }
  EXPECT_GT(optimal, 2'000);
  EXPECT_GT(busy, 1'000);
}

// The union of obstacles is larger than what half-planes leave: never a longer detour alone.
TEST(Movers, the_exact_set_is_no_worse_than_half_planes) {
  Random random(4);
  int better = 0;
  for (int k = 0; k < 1'000 && !testing::Test::HasFailure(); ++k) {
    test::Crowd crowd = test::random_crowd(random, 0.001);
    if (crowd.neighbors.size() > 3) crowd.neighbors.resize(3);
    for (Neighbor& B : crowd.neighbors) B.behavior = Behavior::moves_on;
    const Planner planner(crowd.options);
    PlanWorkspace workspace;
    const Plan exact = planner.plan_among_movers(crowd.robot, crowd.neighbors, workspace);
    if (!crowd.neighbors.empty()) {
      EXPECT_EQ(planner.plan(crowd.robot, crowd.neighbors, workspace).new_velocity,
                exact.new_velocity);
    }
    // Beside a robot that decides, however far away, half-planes are what is shared out.
    crowd.neighbors.push_back({.position = crowd.robot.position + Vec2{1e6, 0.0}});
    const Plan planes = planner.plan(crowd.robot, crowd.neighbors, workspace);
    if (planes.status != PlanStatus::optimal) continue;
    ASSERT_EQ(exact.status, PlanStatus::optimal) << crowd;
    const double detour = norm(exact.new_velocity - crowd.robot.preferred_velocity);
    const double detour_of_planes = norm(planes.new_velocity - crowd.robot.preferred_velocity);
    EXPECT_LE(detour, detour_of_planes + 1e-9 * crowd.robot.max_speed) << crowd;
    if (detour < detour_of_planes - 1e-3) ++better;
  }
  EXPECT_GT(better, 50);
}

// Method velocity_obstacle: outside the cone of every neighbor at its present velocity (§III-A).
TEST(Movers, velocity_obstacle_adopts_a_velocity_outside_the_cones) {
  Random random(5);
  int optimal = 0;
  for (int k = 0; k < 1'000; ++k) {
    test::Crowd crowd = test::random_crowd(random, 0.001);
    crowd.options.method = Method::velocity_obstacle;
    if (crowd.neighbors.size() > 4) crowd.neighbors.resize(4);
    const Plan plan = test::plan_of(crowd);
    if (plan.status != PlanStatus::optimal) continue;
    ++optimal;
    for (const Neighbor& B : crowd.neighbors) {
      const Pair pair{crowd.robot.position - B.position, crowd.robot.velocity - B.velocity,
                      crowd.robot.radius + B.radius};
      const Obstacle cone{pair, Response::velocity(), crowd.options.time_horizon};
      EXPECT_GE(closest_approach(cone, plan.new_velocity - B.velocity).distance,
                pair.radius * (1.0 - 1e-9))
          << crowd;
    }
  }
  EXPECT_GT(optimal, 300);
}

// Movers have no max_acceleration that counts, and others must have one.
TEST(Movers, behavior_says_who_decides) {
  Random random(21);
  int different = 0;
  for (int k = 0; k < 2000 && !testing::Test::HasFailure(); ++k) {
    test::Crowd crowd = test::any_crowd(random, k, -0.2);
    Neighbor added = test::random_neighbor(random, crowd.robot, 0.01);
    added.behavior = Behavior::moves_on;
    added.max_acceleration = 0.0;
    crowd.neighbors.push_back(added);
    const Plan plan = test::plan_of(crowd);
    EXPECT_NE(plan.status, PlanStatus::invalid_input) << crowd;
    Neighbor& last = crowd.neighbors.back();
    for (const double unread : {1.0, 1e300, -1.0, std::nan("")}) {
      last.max_acceleration = unread;
      const Plan same = test::plan_of(crowd);
      EXPECT_EQ(same.new_velocity, plan.new_velocity) << crowd;
      EXPECT_EQ(same.status, plan.status) << crowd;
      EXPECT_EQ(same.violation, plan.violation) << crowd;
    }
    last.behavior = Behavior::decides;
    last.max_acceleration = 1.0;
    different += test::plan_of(crowd).new_velocity == plan.new_velocity ? 0 : 1;
    last.max_acceleration = 0.0;
    EXPECT_EQ(test::plan_of(crowd).status, PlanStatus::invalid_input) << crowd;
  }
  EXPECT_GT(different, 100);
}

TEST(Movers, a_parked_one_moves_on_and_stands) {
  Random random(22);
  int different = 0;
  for (int k = 0; k < 2000 && !testing::Test::HasFailure(); ++k) {
    test::Crowd crowd = test::any_crowd(random, k, -0.2);
    if (k % 2 == 0) crowd.options = default_options(Method::avo);
    Neighbor& other = crowd.neighbors.emplace_back(
        test::random_neighbor(random, crowd.robot, k % 4 == 0 ? -0.2 : 0.01));
    other.velocity = other.acceleration = {}, other.max_deviation = other.likely_deviation = 0.0;
    const auto plan = [&](Behavior behavior) {
      other.behavior = behavior;
      return test::plan_of(crowd);
    };
    const Plan one = plan(Behavior::moves_on), same = plan(Behavior::parked);
    EXPECT_NE(one.status, PlanStatus::invalid_input) << crowd;
    EXPECT_TRUE(same.next_velocity == one.next_velocity && same.status == one.status &&
                same.state == one.state && same.neighbor == one.neighbor &&
                same.violation == one.violation)
        << crowd;
    different += plan(Behavior::decides).next_velocity == one.next_velocity ? 0 : 1;
  }
  EXPECT_GT(different, 100);
}

TEST(Movers, a_parked_one_that_moves_is_invalid) {
  const std::vector<TimedPlace> places{{0.0, {3, 2}}, {1.0, {3, 3}}};
  const Trajectory there(places);
  const auto status = [&](auto change) {
    Neighbor parked{.position = {3, 2}, .behavior = Behavior::parked};
    change(parked);
    PlanWorkspace workspace;
    return Planner(default_options(Method::avo)).plan({}, std::vector{parked}, workspace).status;
  };
  EXPECT_EQ(status([](Neighbor&) {}), PlanStatus::optimal);
  EXPECT_EQ(status([](Neighbor& b) { b.velocity.x = 1e-9; }), PlanStatus::invalid_input);
  EXPECT_EQ(status([](Neighbor& b) { b.acceleration.y = 0.1; }), PlanStatus::invalid_input);
  EXPECT_EQ(status([](Neighbor& b) { b.max_deviation = 0.1; }), PlanStatus::invalid_input);
  EXPECT_EQ(status([](Neighbor& b) { b.likely_deviation = 0.1; }), PlanStatus::invalid_input);
  EXPECT_EQ(status([&](Neighbor& b) { b.trajectory = &there; }), PlanStatus::invalid_input);
  EXPECT_EQ(status([](Neighbor& b) { b.loiter.emplace(); }), PlanStatus::invalid_input);
}

}  // namespace
}  // namespace avo
