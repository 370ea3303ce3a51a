// SPDX-License-Identifier: Apache-2.0
// Preferred velocities far from a goal, which are known without a landing, and the tempo of a
// robot.
#include "space/goals.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "guidance/goals_kernel.h"
#include "space/own_space.h"
#include "unit/space/draws.h"

namespace avo::space::tests {
namespace {

using Number = scalar::Pack<double>;

// m/s: the landing itself, at every distance.
double landing_speed(const Robot& robot, Vec3 goal, double preferred_speed,
                     const Landing& landing) {
  const ResponseLaw& law = landing.law;
  const Vec3 direction = (goal - robot.position) / norm(goal - robot.position);
  const double left = norm(goal - robot.position) - landing.lag * dot(robot.velocity, direction);
  const Number used = scalar::used_of(Number(planned_braking(robot)), Number(robot.max_speed), law);
  const Number time =
      scalar::response_time(Number(robot.max_speed), Number(robot.max_acceleration), used, law);
  const double braking = used.value / norm(direction);
  const Number soft =
      scalar::soft_speed(Number(left), Number(braking * landing.braking_time / law.time_step), time,
                         Number(law.time_step));
  return std::min(soft.value, std::min(preferred_speed, robot.max_speed / norm(direction)));
}

TEST(SpaceGoals, far_away_are_approached_at_full_speed_exactly_where_a_landing_allows_it) {
  Draws draws(61);
  int fast = 0, slower = 0;
  for (int k = 0; k < 20000; ++k) {
    Robot robot;
    robot.position = draws.within(30.0);
    robot.max_speed = draws.between(0.5, 3.0);
    robot.max_acceleration = draws.between(0.5, 3.0);
    if (draws.below(3) == 0) robot.max_braking = draws.between(0.3, 2.0);
    robot.velocity = draws.within(robot.max_speed);
    const Vec3 goal = robot.position + draws.within(12.0);
    const double speed = draws.between(0.3, 3.0);
    PlannerOptions options;
    const Landing landing{response_law(options), 0.05, 0.1};
    const Vec3 preferred =
        preferred_velocity(robot, goal, speed, landing, tempo_of(robot, landing));
    const double expected = landing_speed(robot, goal, speed, landing);
    ASSERT_NEAR(norm(preferred), expected, 1e-12) << k;
    (expected < std::min(speed, robot.max_speed) * (1.0 - 1e-9) ? slower : fast) += 1;
  }
  EXPECT_GT(fast, 3000);
  EXPECT_GT(slower, 1000);
}

TEST(SpaceGoals, at_the_place_of_a_robot_as_far_as_rounding_tells_are_reached) {
  Robot robot;
  robot.position = {1e6, -2e6, 3e5};
  const Landing landing{response_law(PlannerOptions{}), 0.05, 0.1};
  const Tempo tempo = tempo_of(robot, landing);
  const auto preferred = [&](double off) {
    return preferred_velocity(robot, robot.position + Vec3{off, 0, 0}, 1.0, landing, tempo);
  };
  EXPECT_EQ(preferred(0.0), Vec3{});
  // 2^-46 of the lengths of both places
  const double rounding = 0x1p-45 * norm(robot.position);
  EXPECT_EQ(preferred(0.9 * rounding), Vec3{});
  EXPECT_GT(norm(preferred(1.1 * rounding)), 0.0);
}

TEST(Tempo, is_that_of_the_rules_at_every_distance) {
  Draws draws(62);
  for (int k = 0; k < 2000; ++k) {
    Robot robot;
    robot.radius = draws.between(0.1, 1.0);
    robot.max_speed = draws.between(0.5, 3.0);
    robot.max_acceleration = draws.between(0.5, 3.0);
    if (draws.below(2) == 0) robot.max_braking = draws.between(0.3, 2.0);
    robot.distance_to_goal = draws.between(0.0, 10.0);
    PlannerOptions options;
    if (draws.below(3) == 0) options.comfort_acceleration = draws.between(0.2, 1.0);
    if (draws.below(3) == 0) options.comfort_jerk = draws.between(0.2, 4.0);
    if (draws.below(3) == 0) options.response_time = 0.0;
    const Landing landing{response_law(options), 0.05, 0.1};
    const Execution execution{landing.law, landing.braking_time, draws.below(2) == 0};
    const Tempo tempo = tempo_of(robot, landing);
    const avo::Robot same = numbers_of(robot);
    const Haste expected = haste_of(same, execution);
    const Haste haste = haste_at(tempo, robot.distance_to_goal, execution.remembers);
    ASSERT_EQ(haste.gain, expected.gain);
    ASSERT_EQ(haste.most, expected.most);
    ASSERT_EQ(haste.jerk, expected.jerk);
    ASSERT_EQ(robot.distance_to_goal < tempo.landing, is_landing(same, expected, execution));
    ASSERT_EQ(tempo.unhurried, std::min(unhurried_part(same, execution), 1.0));
  }
}

}  // namespace
}  // namespace avo::space::tests
