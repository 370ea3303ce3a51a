// SPDX-License-Identifier: Apache-2.0
// Eqs. (7)-(9): the responses against long double, and as solutions of what they are meant to
// solve.
#include "avo/response.h"

#include <cmath>
#include <gtest/gtest.h>

#include "avo/horizon.h"
#include "support/brute_force.h"
#include "support/cases.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::Random;

constexpr double kUlp = 0x1p-52;

struct Instant {
  double delta, t;
};

// t/δ over 13 decades.
Instant instant(Random& random) {
  const double delta = random.log_uniform(1e-3, 1e3);
  return {delta, delta * random.log_uniform(1e-10, 1e3)};
}

TEST(Response, P1_proportional_is_exact_to_a_few_ulp) {
  test::in_all_cases([](Random& random) {
    const auto [delta, t] = instant(random);
    const Response response = Response::proportional(delta);
    const long double gain = test::slow_gain(t, delta);
    const long double rate = -std::expm1(-static_cast<long double>(t) / delta);
    const auto relative = [](double found, long double expected) {
      return static_cast<double>(std::abs(found - expected) / expected);
    };
    ASSERT_TRUE(relative(response.gain(t), gain) <= 4 * kUlp);
    ASSERT_TRUE(relative(response.rate(t), rate) <= 4 * kUlp);
    // the lag is what is left of t: its error is that of t
    ASSERT_TRUE(std::abs(response.lag(t) - static_cast<double>(t - gain / rate)) <= 8 * kUlp * t);
  });
}

TEST(Response, P1_table_agrees_with_the_formula) {
  test::in_all_cases([](Random& random) {
    const auto [delta, t] = instant(random);
    const double tau = delta * random.log_uniform(0.05, 100.0);
    const ResponseAt at = Horizon(delta, tau, 0.01 * tau).at(std::min(t, tau));
    const Response response = Response::proportional(delta);
    ASSERT_TRUE(std::abs(at.gain - response.gain(at.time)) <= 8 * kUlp * at.gain);
    ASSERT_TRUE(std::abs(at.rate - response.rate(at.time)) <= 8 * kUlp * at.rate);
    ASSERT_TRUE(std::abs(at.lag - response.lag(at.time)) <= 32 * kUlp * at.time);
  });
}

// Eq. (7): the speed gained is what is left of w, divided by δ; checked as a difference quotient.
TEST(Response, P1_acceleration_is_proportional_to_what_is_left) {
  test::in_all_cases([](Random& random) {
    const double delta = random.log_uniform(1e-3, 1e3);
    const double t = delta * random.uniform(1e-2, 8.0);
    const Response response = Response::proportional(delta);
    const double step = 1e-5 * delta;
    const double acceleration = (response.rate(t + step) - response.rate(t - step)) / (2.0 * step);
    ASSERT_TRUE(std::abs(acceleration - (1.0 - response.rate(t)) / delta) <= 1e-7 / delta);
    const double speed = (response.gain(t + step) - response.gain(t - step)) / (2.0 * step);
    ASSERT_TRUE(std::abs(speed - response.rate(t)) <= 1e-7);
  });
}

// Approaching v' for s and then, from there, for t more is approaching it for s + t.
TEST(Response, P1_two_steps_are_one) {
  test::in_all_cases([](Random& random) {
    const double delta = random.log_uniform(1e-3, 1e3);
    const double s = delta * random.log_uniform(1e-6, 20.0);
    const double t = delta * random.log_uniform(1e-6, 20.0);
    const Response response = Response::proportional(delta);
    const double left = 1.0 - response.rate(s);  // of w after s
    const double rate = response.rate(s) + left * response.rate(t);
    const double gain = response.gain(s) + t * response.rate(s) + left * response.gain(t);
    ASSERT_TRUE(std::abs(rate - response.rate(s + t)) <= 8 * kUlp);
    ASSERT_TRUE(std::abs(gain - response.gain(s + t)) <= 8 * kUlp * (s + t));
  });
}

TEST(Response, other_responses_are_their_formulas) {
  EXPECT_EQ(Response::velocity().gain(3.0), 3.0);
  EXPECT_EQ(Response::velocity().rate(3.0), 1.0);
  EXPECT_EQ(Response::velocity().lag(3.0), 0.0);
  EXPECT_EQ(Response::acceleration().gain(3.0), 4.5);
  EXPECT_EQ(Response::acceleration().rate(3.0), 3.0);
  EXPECT_EQ(Response::acceleration().lag(3.0), 1.5);
  EXPECT_TRUE(Response::acceleration().is_acceleration());
  EXPECT_EQ(Response::held(2.0).gain(3.0), 2.25);
  EXPECT_EQ(Response::held(2.0).rate(3.0), 1.5);
  EXPECT_EQ(Response::held(2.0).lag(3.0), 1.5);
  EXPECT_EQ(Response::proportional(2.0).gain(0.0), 0.0);
  EXPECT_EQ(Response::proportional(2.0).lag(0.0), 0.0);
}

}  // namespace
}  // namespace avo
