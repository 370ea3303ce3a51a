// SPDX-License-Identifier: Apache-2.0
// Robots in columns do, bit for bit, what each does alone, on every instruction set.
#include "sim/columns/moving_columns.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "core/simd_target.h"
#include "support/brute_force.h"

namespace avo {
namespace {

using test::Random;

class Moving : public testing::Test {
 protected:
  ~Moving() override { use_simd_target(before_); }
  const std::string before_ = simd_target();
};

struct Mover {
  Vec2 position, velocity, goal;
  RobotTraits traits;
};

// The robot is far from its goal, on the last of its route, or there. It is at rest, or as fast as
// it may be and beyond.
Mover random_mover(Random& random) {
  Mover m;
  m.traits.max_speed = random.log_uniform(0.1, 10.0);
  m.traits.max_acceleration = random.log_uniform(0.05, 20.0);
  m.traits.max_braking = random.log_uniform(0.5, 3.0) * m.traits.max_acceleration;
  m.traits.preferred_speed = random.uniform(0.0, 1.0) * m.traits.max_speed;
  m.position = test::in_disc(random, 100.0);
  const double left = random.below(8) == 0 ? 0.0 : random.log_uniform(1e-17, 1e3);
  m.goal = m.position + left * random.direction();
  const double speed = random.below(4) == 0 ? 0.0 : random.uniform(0.0, 1.1) * m.traits.max_speed;
  m.velocity = speed * random.direction();
  return m;
}

PlannerOptions random_options(Random& random, Method method) {
  PlannerOptions options = default_options(method);
  options.motion = random.below(2) == 0 ? Motion::held : Motion::exponential;
  options.control_time = random.log_uniform(0.1, 8.0);
  options.time_step = options.control_time * random.log_uniform(1e-3, 1.0);
  options.time_horizon = 10.0;
  return options;
}

struct Moved {
  RobotColumns robots;
  MovingColumns moving;
};

// What is left over behind them is fast, and wants to go on.
Moved columns_of(const std::vector<Mover>& movers) {
  Moved columns;
  columns.robots.reserve(kTileRobots);
  std::fill(columns.robots.v_x.begin(), columns.robots.v_x.end(), 1e9);
  columns.moving.goal_y.fill(1e9), columns.moving.new_x.fill(1e9);
  for (std::size_t k = 0; k < movers.size(); ++k) {
    Robot robot;
    robot.position = movers[k].position, robot.velocity = movers[k].velocity;
    robot.max_acceleration = movers[k].traits.max_acceleration;
    robot.max_braking = movers[k].traits.max_braking;
    robot.max_speed = movers[k].traits.max_speed;
    columns.robots.add(robot, {});
    columns.moving.goal_x[k] = movers[k].goal.x, columns.moving.goal_y[k] = movers[k].goal.y;
    columns.moving.preferred_speed[k] = movers[k].traits.preferred_speed;
  }
  return columns;
}

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same(Vec2 a, Vec2 b) {
  return same(a.x, b.x) && same(a.y, b.y);
}

template <typename Check>
void for_random_tiles(const Check& check) {
  for (const char* target : simd_targets()) {
    ASSERT_TRUE(use_simd_target(target));
    Random random(2011);
    for (const Method method : {Method::avo, Method::avo_paper, Method::orca}) {
      for (int n = 0; n < 200; ++n) {
        const Planner planner(random_options(random, method));
        std::vector<Mover> movers(static_cast<std::size_t>(random.below(kTileRobots + 1)));
        for (Mover& m : movers) m = random_mover(random);
        SCOPED_TRACE(std::string(target) + ", " + to_string(method) + ", tile " +
                     std::to_string(n));
        check(planner, movers, random);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST_F(Moving, ways_are_those_of_each_robot) {
  std::size_t at_speed = 0, all = 0;
  for_random_tiles([&](const Planner& planner, const std::vector<Mover>& movers, Random&) {
    const StepResponse step = step_response(planner);
    Moved columns = columns_of(movers);
    choose_preferred(step, columns.moving, columns.robots);
    for (std::size_t k = 0; k < movers.size(); ++k) {
      const auto& [p, v, goal, traits] = movers[k];
      const Vec2 found{columns.robots.preferred_x[k], columns.robots.preferred_y[k]};
      ASSERT_TRUE(same(columns.robots.distance_to_goal[k], norm(goal - p)));
      ASSERT_TRUE(same(found, preferred_velocity(p, v, traits, goal, step)));
      const Vec2 straight = (traits.preferred_speed / norm(goal - p)) * (goal - p);
      at_speed += norm(found - straight) < 1e-12 * traits.preferred_speed ? 1 : 0, ++all;
    }
  });
  EXPECT_GT(at_speed, all / 8);
  EXPECT_LT(at_speed, all * 3 / 4);
}

TEST_F(Moving, steps_are_those_of_each_robot) {
  std::size_t fast = 0, all = 0;
  for_random_tiles([&](const Planner& planner, const std::vector<Mover>& movers, Random& random) {
    const StepResponse response = step_response(planner);
    Moved columns = columns_of(movers);
    std::vector<MotionStep> steps;
    for (std::size_t k = 0; k < movers.size(); ++k) {
      const auto& [p, v, goal, traits] = movers[k];
      Plan plan;
      plan.new_velocity = random.uniform(0.0, 1.2 * traits.max_speed) * random.direction();
      if (random.below(4) == 0) plan.new_velocity = v - v / response.rate;  // rests
      columns.moving.new_x[k] = plan.new_velocity.x, columns.moving.new_y[k] = plan.new_velocity.y;
      steps.push_back(advance({p, v}, plan, response));
    }
    const std::uint64_t found = advance(response, columns.moving, columns.robots);
    ASSERT_LE(static_cast<std::size_t>(std::bit_width(found)), movers.size());
    for (std::size_t k = 0; k < movers.size(); ++k) {
      const MotionState& next = steps[k].next;
      ASSERT_TRUE(same(columns.robots.position(k), next.position));
      ASSERT_TRUE(same(columns.robots.velocity(k), next.velocity));
      ASSERT_TRUE(same(columns.moving.acceleration[k], steps[k].acceleration));
      const bool exceeds = norm(next.velocity) > (1.0 + 1e-9) * movers[k].traits.max_speed;
      ASSERT_EQ((found >> k) & 1U, exceeds ? 1U : 0U);
      fast += exceeds ? 1 : 0, ++all;
    }
  });
  EXPECT_GT(fast, all / 20);
  EXPECT_LT(fast, all / 2);
}

TEST_F(Moving, who_moves_as_no_number_is_fast) {
  for (const char* target : simd_targets()) {
    ASSERT_TRUE(use_simd_target(target));
    Random random(7);
    Moved columns = columns_of({random_mover(random), random_mover(random)});
    columns.robots.v_x[1] = std::numeric_limits<double>::quiet_NaN();
    columns.robots.v_x[0] = columns.robots.v_y[0] = columns.moving.new_x[0] =
        columns.moving.new_y[0] = 0.0;
    EXPECT_EQ(advance(step_response(Planner({})), columns.moving, columns.robots), 2U) << target;
  }
}

}  // namespace
}  // namespace avo
