// SPDX-License-Identifier: Apache-2.0
// A navigator of a base that does not execute exactly: cycles that are left out, values that are
// out of range, and robots that it cannot have.
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "avo/error.h"
#include "avo/navigator.h"

namespace avo {
namespace {

Navigator late_navigator() {
  NavigatorOptions options;
  options.execution = ExecutionModel{.dead_time = 0.1};
  Navigator navigator(options);
  navigator.set_goal({20, 0});
  return navigator;
}

// The body does what was commanded the cycle before.
struct LateBody {
  Robot robot;
  Vec2 acting = {};

  void execute(const NavigatorDecision& decision) {
    robot.position = robot.position + 0.1 * acting;
    robot.velocity = acting;
    acting = decision.command->velocity;
  }
};

void drive(Navigator& navigator, LateBody& body, int cycles, double& time) {
  for (int k = 0; k < cycles; ++k, time += 0.1) {
    const NavigatorDecision decision = navigator.step(body.robot, {}, time);
    ASSERT_TRUE(decision.command);
    EXPECT_FALSE(decision.command->has_left);
    body.execute(decision);
  }
}

TEST(BaseNavigator, decides_from_the_reference_and_not_from_the_body) {
  Navigator navigator = late_navigator();
  LateBody body;
  double time = 0.0;
  drive(navigator, body, 10, time);
  const NavigatorDecision decision = navigator.step(body.robot, {}, time);
  EXPECT_GT(decision.command->deviation, 1e-4);
  const Vec2 mean = 10.0 * (decision.command->next_reference - body.robot.position);
  EXPECT_GT(norm(mean - 0.5 * (body.robot.velocity + decision.plan.next_velocity)), 1e-3);
  EXPECT_EQ(decision.command->next_velocity, decision.plan.next_velocity);
}

TEST(BaseNavigator, cycle_that_is_left_out_begins_anew_at_the_body) {
  Navigator navigator = late_navigator();
  LateBody body;
  double time = 0.0;
  drive(navigator, body, 10, time);
  const NavigatorDecision decision = navigator.step(body.robot, {}, time + 0.1);
  EXPECT_TRUE(decision.command->has_left);
  const Vec2 mean = 0.5 * (body.robot.velocity + decision.plan.next_velocity);
  EXPECT_NEAR(norm(decision.command->next_reference - body.robot.position - 0.1 * mean), 0.0, 1e-9);
}

TEST(BaseNavigator, neighbor_that_is_out_of_range_makes_the_reference_brake) {
  Navigator navigator = late_navigator();
  LateBody body;
  double time = 0.0;
  drive(navigator, body, 15, time);
  const std::vector<Neighbor> wrong{{.position = {5, 5}, .radius = -1.0}};
  double speed = norm(body.robot.velocity);
  for (int k = 0; k < 3; ++k, time += 0.1) {
    const NavigatorDecision decision = navigator.step(body.robot, wrong, time);
    EXPECT_EQ(decision.plan.status, PlanStatus::invalid_input);
    EXPECT_FALSE(decision.command->has_left);
    EXPECT_LT(norm(decision.command->next_velocity), speed + 0.25 - 0.1 * k);
    body.execute(decision);
  }
  drive(navigator, body, 5, time);
}

TEST(BaseNavigator, body_that_is_not_known_brakes_and_begins_anew) {
  Navigator navigator = late_navigator();
  LateBody body;
  double time = 0.0;
  drive(navigator, body, 10, time);
  Robot lost = body.robot;
  lost.position.x = std::numeric_limits<double>::quiet_NaN();
  const NavigatorDecision decision = navigator.step(lost, {}, time);
  EXPECT_EQ(decision.plan.status, PlanStatus::invalid_input);
  EXPECT_TRUE(decision.command->has_left);
  EXPECT_EQ(decision.command->velocity, decision.plan.next_velocity);
  EXPECT_TRUE(navigator.step(body.robot, {}, time + 0.1).command->has_left);
}

TEST(BaseNavigator, exact_base_has_no_command_and_cars_are_refused) {
  Navigator exact{NavigatorOptions{}};
  EXPECT_FALSE(exact.step({}, {}, 0.0).command);
  Robot car;
  car.model = Car{};
  Navigator late = late_navigator();
  EXPECT_THROW(late.step(car, {}, 0.0), Error);
}

}  // namespace
}  // namespace avo
