// SPDX-License-Identifier: Apache-2.0
// P1: one step of a holonomic robot against Eqs. (7)-(9) written out in long double.
#include <cmath>
#include <gtest/gtest.h>

#include "robots/motion.h"
#include "support/brute_force.h"

namespace avo {
namespace {

using test::Random;

struct Case {
  PlannerOptions options = default_options(Method::avo_paper);
  MotionState state;
  Plan plan;
};

Case random_case(Random& random, Motion motion) {
  Case c;
  c.options.motion = motion;
  c.options.control_time = random.log_uniform(0.05, 50.0);
  c.options.time_step = c.options.control_time * random.log_uniform(1e-4, 1.0);
  c.options.time_horizon = 50.0;
  c.state.position = test::in_disc(random, 10.0);
  c.state.velocity = test::in_disc(random, 3.0);
  c.plan.new_velocity = test::in_disc(random, 3.0);
  return c;
}

// x(t) = p + t v + g(t) (v' - v) and its derivative: Eqs. (8), (9).
MotionState exponential(const Case& c, double t) {
  const long double delta = c.options.control_time;
  const auto gain = static_cast<double>(test::slow_gain(t, delta));
  const auto rate = static_cast<double>(-std::expm1(-static_cast<long double>(t) / delta));
  const Vec2 w = c.plan.new_velocity - c.state.velocity;
  return {c.state.position + t * c.state.velocity + gain * w, c.state.velocity + rate * w, 0.0};
}

MotionState held(const Case& c, double t) {
  const Vec2 a = (c.plan.new_velocity - c.state.velocity) / c.options.control_time;  // Eq. (7)
  return {c.state.position + t * c.state.velocity + (0.5 * t * t) * a, c.state.velocity + t * a,
          0.0};
}

void expect_near(const MotionState& found, const MotionState& expected) {
  EXPECT_NEAR(norm(found.position - expected.position), 0.0, 1e-12 * (1 + norm(expected.position)));
  EXPECT_NEAR(norm(found.velocity - expected.velocity), 0.0, 1e-13);
}

TEST(Holonomic, P1_one_step_is_that_of_the_equations) {
  Random random(1);
  for (int k = 0; k < 20'000 && !HasFailure(); ++k) {
    const bool is_held = k % 2 == 0;
    const Case c = random_case(random, is_held ? Motion::held : Motion::exponential);
    const StepResponse response = step_response(Planner(c.options));
    const MotionStep step = advance(c.state, c.plan, response);
    const double dt = c.options.time_step;
    expect_near(step.next, is_held ? held(c, dt) : exponential(c, dt));
    const double a = norm(c.plan.new_velocity - c.state.velocity) / c.options.control_time;
    EXPECT_NEAR(step.acceleration, a, 1e-13 * a);
  }
}

// The displacement itself, not the place: no cancellation however small the step.
TEST(Holonomic, P1_short_steps_keep_their_digits) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    for (const double part : {1e-2, 1e-4, 1e-6, 1e-8}) {
      Case c;
      c.options.motion = motion;
      c.options.control_time = 4.0;
      c.options.time_step = part * c.options.control_time;
      c.plan.new_velocity = {2, 1};
      const MotionStep step = advance(c.state, c.plan, step_response(Planner(c.options)));
      const MotionState expected = motion == Motion::held ? held(c, c.options.time_step)
                                                          : exponential(c, c.options.time_step);
      EXPECT_NEAR(step.next.position.x / expected.position.x, 1.0, 1e-14);
      EXPECT_NEAR(step.next.velocity.x / expected.velocity.x, 1.0, 1e-14);
    }
  }
}

TEST(Holonomic, P1_two_half_steps_are_one_exponential_step) {
  Random random(2);
  for (int k = 0; k < 5'000 && !HasFailure(); ++k) {
    const Case c = random_case(random, Motion::exponential);
    const MotionStep whole = advance(c.state, c.plan, step_response(Planner(c.options)));
    PlannerOptions half = c.options;
    half.time_step *= 0.5;
    const StepResponse response = step_response(Planner(half));
    const MotionStep first = advance(c.state, c.plan, response);
    expect_near(advance(first.next, c.plan, response).next, whole.next);
  }
}

// Held: v_{k+1} - v' = (1 - Δt/δ)(v_k - v'), step by step.
TEST(Holonomic, P1_held_steps_close_in_on_the_new_velocity) {
  Case c;
  c.options.control_time = 0.8;
  c.plan.new_velocity = {1, -2};
  const StepResponse response = step_response(Planner(c.options));
  double left = norm(c.plan.new_velocity);
  for (int k = 0; k < 50; ++k) {
    c.state = advance(c.state, c.plan, response).next;
    left *= 1.0 - 0.1 / 0.8;
    EXPECT_NEAR(norm(c.state.velocity - c.plan.new_velocity), left, 1e-14);
  }
}

TEST(Holonomic, methods_that_adopt_at_once_move_straight) {
  for (const Method method :
       {Method::orca, Method::velocity_obstacle, Method::reciprocal_velocity_obstacle}) {
    Case c;
    c.options = default_options(method);
    c.state = {{1, 2}, {2, 0}, 0.0};
    c.plan.new_velocity = {0, -1};
    const MotionStep step = advance(c.state, c.plan, step_response(Planner(c.options)));
    EXPECT_NEAR(norm(step.next.position - Vec2{1, 1.9}), 0.0, 1e-15);
    EXPECT_EQ(step.next.velocity, c.plan.new_velocity);
    EXPECT_NEAR(step.acceleration, std::sqrt(5.0) / 0.1, 1e-12);
  }
}

}  // namespace
}  // namespace avo
