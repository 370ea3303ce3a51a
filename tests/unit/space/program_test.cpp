// SPDX-License-Identifier: Apache-2.0
// The program in R^3 against many nearby points: none is better.
#include "space/program.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "unit/space/draws.h"

namespace avo::space::tests {
namespace {

constexpr double kError = 1e-7;  // m/s

struct Problem {
  std::vector<HalfSpace> half_spaces;
  std::array<Ball, 2> balls;
  Vec3 wish;

  bool is_in_balls(Vec3 a) const {
    return std::all_of(balls.begin(), balls.end(), [&](const Ball& ball) {
      return norm(a - ball.center) <= ball.radius + 1e-9;
    });
  }
  double violation_of(Vec3 a) const {
    double most = -1e9;
    for (const HalfSpace& half_space : half_spaces) most = std::max(most, violation(half_space, a));
    return most;
  }
};

Problem draw(Draws& draws, int count, double tightest) {
  Problem problem;
  problem.balls = {Ball{draws.within(2.0), 1.5}, Ball{{}, 2.0}};
  problem.wish = draws.within(3.0);
  for (int k = 0; k < count; ++k)
    problem.half_spaces.push_back({draws.direction(), draws.between(-2.0, tightest)});
  return problem;
}

TEST(SpaceProgram, no_point_nearby_is_better) {
  Draws draws(1);
  SpaceProgramWorkspace workspace;
  int optimal = 0, unsafe = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const Problem problem = draw(draws, 1 + trial % 14, trial % 3 == 0 ? 1.5 : 0.6);
    const SpaceProgramResult result =
        nearest_point(problem.half_spaces, problem.balls, problem.wish, workspace);
    ASSERT_NE(result.state, SpaceProgramState::balls_disjoint);
    ASSERT_TRUE(problem.is_in_balls(result.point));
    const bool is_optimal = result.state == SpaceProgramState::optimal;
    ++(is_optimal ? optimal : unsafe);
    if (is_optimal) {
      ASSERT_LE(problem.violation_of(result.point), kError);
    }
    const double best = is_optimal ? norm(result.point - problem.wish) : result.violation;
    for (int k = 0; k < 300; ++k) {
      const Vec3 other =
          result.point + std::pow(10.0, -draws.between(0.0, 5.0)) * draws.direction();
      if (!problem.is_in_balls(other)) continue;
      if (!is_optimal) {
        ASSERT_GE(problem.violation_of(other), best - kError);
      } else if (problem.violation_of(other) <= 0.0) {
        ASSERT_GE(norm(other - problem.wish), best - kError);
      }
    }
  }
  EXPECT_GT(optimal, 500);
  EXPECT_GT(unsafe, 300);
}

TEST(SpaceProgram, balls_that_do_not_meet_have_no_point) {
  SpaceProgramWorkspace workspace;
  const std::array<Ball, 2> balls{Ball{{5, 0, 0}, 1}, Ball{{}, 2}};
  EXPECT_EQ(nearest_point({}, balls, {}, workspace).state, SpaceProgramState::balls_disjoint);
}

}  // namespace
}  // namespace avo::space::tests
