// SPDX-License-Identifier: Apache-2.0
// No decision leaves D(v_A, δ a_max) or D(0, v_max), however crowded (Eqs. 21-23).
#include <algorithm>
#include <gtest/gtest.h>
#include <map>

#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::Crowd;
using test::Random;

constexpr double kRelative = 1.0 + 1e-12;

void expect_within_limits(const Crowd& crowd, const Plan& plan) {
  const Robot& A = crowd.robot;
  const double delta = crowd.options.control_time;
  EXPECT_LE(norm(plan.new_velocity - A.velocity), delta * A.max_acceleration * kRelative) << crowd;
  EXPECT_LE(norm(plan.acceleration), A.max_acceleration * kRelative) << crowd;
  if (plan.status != PlanStatus::braking) {
    EXPECT_LE(norm(plan.new_velocity), A.max_speed * kRelative) << crowd;
  }
  EXPECT_GE(plan.violation, 0.0);
  switch (plan.status) {
    case PlanStatus::optimal:
      EXPECT_EQ(plan.violation, 0.0) << crowd;
      break;
    case PlanStatus::least_unsafe:
    case PlanStatus::braking:
      EXPECT_GT(plan.violation, 0.0) << crowd;
      break;
    default:
      break;
  }
}

// Speeds up to v_max + 1.2 δ a_max in one case of eight.
Crowd possibly_too_fast(Random& random) {
  Crowd crowd = test::random_crowd(random, -0.9);
  if (random.below(8) > 0) return crowd;
  Robot& A = crowd.robot;
  const double beyond = random.uniform(0.0, 1.2) * crowd.options.control_time * A.max_acceleration;
  A.velocity = (A.max_speed + beyond) * random.direction();
  return crowd;
}

TEST(Limits, P12_hold_for_every_decision_of_plan) {
  Random random(12);
  std::map<PlanStatus, int> seen;
  for (int k = 0; k < 120'000 && !testing::Test::HasFailure(); ++k) {
    const Crowd crowd = possibly_too_fast(random);
    const Plan plan = test::plan_of(crowd);
    expect_within_limits(crowd, plan);
    ++seen[plan.status];
  }
  // the situations are hard enough to matter
  EXPECT_GT(seen[PlanStatus::optimal], 10'000);
  EXPECT_GT(seen[PlanStatus::least_unsafe], 10'000);
  EXPECT_GT(seen[PlanStatus::overlapping], 10'000);
  EXPECT_GT(seen[PlanStatus::braking], 500);
  EXPECT_EQ(seen[PlanStatus::invalid_input], 0);
}

TEST(Limits, P12_hold_for_every_decision_among_movers) {
  Random random(13);
  std::map<PlanStatus, int> seen;
  for (int k = 0; k < 2'000 && !testing::Test::HasFailure(); ++k) {
    Crowd crowd = possibly_too_fast(random);
    if (crowd.neighbors.size() > 5) crowd.neighbors.resize(5);
    PlanWorkspace workspace;
    const Plan plan =
        Planner(crowd.options).plan_among_movers(crowd.robot, crowd.neighbors, workspace);
    expect_within_limits(crowd, plan);
    ++seen[plan.status];
  }
  EXPECT_GT(seen[PlanStatus::optimal], 200);
  EXPECT_GT(seen[PlanStatus::least_unsafe], 50);
}

// What avo decides on is the velocity after the step: v' only leads there, and may be any.
void expect_step_within_limits(const Crowd& crowd, const Plan& plan) {
  const Robot& A = crowd.robot;
  const double rate = Planner(crowd.options).step_rate();
  const double u = rate * crowd.options.control_time * A.max_acceleration;
  const Vec2 change = rate * (plan.new_velocity - A.velocity);
  EXPECT_LE(norm(plan.acceleration), A.max_acceleration * kRelative) << crowd;
  EXPECT_LE(norm(change), u * kRelative) << crowd;
  // from beyond v_max it comes down as fast as it can
  const double most = std::max(A.max_speed, norm(A.velocity) - u);
  EXPECT_LE(norm(A.velocity + change), most * kRelative) << crowd;
  EXPECT_GE(plan.violation, 0.0);
  if (plan.status == PlanStatus::optimal) {
    EXPECT_EQ(plan.violation, 0.0) << crowd;
  } else if (plan.status == PlanStatus::least_unsafe) {
    EXPECT_GT(plan.violation, 0.0) << crowd;
  }
}

TEST(Limits, P12_hold_for_every_decision_of_avo) {
  Random random(17);
  for (const Certificate certificate : test::kCertificates) {
    std::map<PlanStatus, int> seen;
    for (int k = 0; k < 20'000 && !testing::Test::HasFailure(); ++k) {
      Crowd crowd = test::by_avo(random, possibly_too_fast(random), certificate);
      if (k % 2 == 0) crowd.options.motion = Motion::exponential;
      const Plan plan = test::plan_of(crowd);
      expect_step_within_limits(crowd, plan);
      ++seen[plan.status];
      if (k % 40 > 0) continue;
      if (crowd.neighbors.size() > 5) crowd.neighbors.resize(5);
      PlanWorkspace workspace;
      expect_step_within_limits(
          crowd, Planner(crowd.options).plan_among_movers(crowd.robot, crowd.neighbors, workspace));
    }
    EXPECT_GT(seen[PlanStatus::optimal], 1'000);
    EXPECT_GT(seen[PlanStatus::least_unsafe] + seen[PlanStatus::refused], 100);
    EXPECT_GT(seen[PlanStatus::braking], 50);
    EXPECT_GT(seen[PlanStatus::overlapping], 1'000);
    EXPECT_EQ(seen[PlanStatus::invalid_input], 0);
  }
}

TEST(Limits, orca_and_velocity_obstacle_keep_the_speed_limit) {
  Random random(14);
  for (const Method method :
       {Method::orca, Method::velocity_obstacle, Method::reciprocal_velocity_obstacle}) {
    for (int k = 0; k < 1'000; ++k) {
      Crowd crowd = possibly_too_fast(random);
      crowd.options.method = method;
      if (crowd.neighbors.size() > 5) crowd.neighbors.resize(5);
      const Plan plan = test::plan_of(crowd);
      EXPECT_LE(norm(plan.new_velocity), crowd.robot.max_speed * kRelative) << crowd;
      // adopted at once: the acceleration says so
      const Vec2 a = (plan.new_velocity - crowd.robot.velocity) / crowd.options.time_step;
      EXPECT_EQ(plan.acceleration, a);
    }
  }
}

// The limit is a disc, not a pair of lines or a square: it is reached in every direction.
TEST(Limits, the_speed_disc_is_round) {
  PlannerOptions options = test::paper_options();
  options.control_time = 8.0;
  for (int k = 0; k < 64; ++k) {
    const double angle = 0.1 * k;
    const Vec2 direction{std::cos(angle), std::sin(angle)};
    const Robot robot = test::paper_robot({}, {0.4, -0.2}, 5.0 * direction);
    PlanWorkspace workspace;
    const Plan plan = Planner(options).plan(robot, {}, workspace);
    EXPECT_NEAR(norm(plan.new_velocity - 2.0 * direction), 0.0, 1e-12);
  }
}

// The square of a preferred velocity of v_max rounds up here, and its length does not. Without a
// guard one decision in fifty takes a corner of the discs instead, 0.1 m/s to 2 m/s aside.
TEST(Limits, at_the_speed_limit_rounding_does_not_turn_the_robot) {
  for (const double delta : {0.1, 4.0}) {
    PlannerOptions options = test::paper_options();
    options.control_time = delta;
    const Planner planner(options);
    PlanWorkspace workspace;
    for (int k = 0; k < 20'000; ++k) {
      const double angle = 3e-4 * k;
      const double rounded = 2.0 * (1.0 + 0x1p-53 * (k % 5 - 2));
      const Vec2 direction{std::cos(angle), std::sin(angle)};
      const Robot robot =
          test::paper_robot({}, 2.0 * (1.0 - 1e-3 * (k % 7)) * direction, rounded * direction);
      const Plan plan = planner.plan(robot, {}, workspace);
      ASSERT_NEAR(norm(plan.new_velocity - robot.preferred_velocity), 0.0, 1e-12) << angle;
      const Plan alone = planner.plan_among_movers(robot, {}, workspace);
      ASSERT_NEAR(norm(alone.new_velocity - robot.preferred_velocity), 0.0, 1e-12) << angle;
    }
  }
}

TEST(Limits, the_acceleration_disc_is_round) {
  PlannerOptions options = test::paper_options();
  options.control_time = 0.5;
  for (int k = 0; k < 64; ++k) {
    const double angle = 0.1 * k;
    const Vec2 direction{std::cos(angle), std::sin(angle)};
    const Robot robot = test::paper_robot({}, {0.4, -0.2}, Vec2{0.4, -0.2} + 1.1 * direction);
    PlanWorkspace workspace;
    const Plan plan = Planner(options).plan(robot, {}, workspace);
    EXPECT_NEAR(norm(plan.new_velocity - robot.velocity - 0.5 * direction), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace avo
