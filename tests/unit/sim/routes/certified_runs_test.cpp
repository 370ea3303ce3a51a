// SPDX-License-Identifier: Apache-2.0
// The promise holds where nothing is broken, at the least sensing radius; with less it does not.
#include <cmath>
#include <gtest/gtest.h>

#include "avo/assumptions.h"
#include "support/generators.h"
#include "unit/sim/certified_scenes.h"

namespace avo {
namespace {

using test::head_on;
using test::Kind;
using test::kKinds;
using test::Random;

// Two at full speed that have not seen each other yet, by a hair.
Scenario unseen_until_the_last(double sensing_radius, Kind kind) {
  Scenario scene = head_on(sensing_radius * (1.0 + 1e-12), kind);
  scene.sensing_radius = sensing_radius;
  scene.allow_broken_assumptions = true;
  return scene;
}

TEST(SensingNeed, suffices_for_two_that_see_each_other_at_the_last_moment) {
  for (const Kind kind : kKinds) {
    const double range = sensing_need(head_on(100.0, kind))->range;
    const Scenario scene = unseen_until_the_last(range, kind);
    ASSERT_TRUE(broken_assumptions(scene).none());
    const CheckReport report = test::judged(scene, 200);
    EXPECT_TRUE(report.safe());
    EXPECT_LT(*report.least_clearance, 0.2) << "they do meet";
  }
}

TEST(SensingNeed, less_of_it_breaks_the_promise) {
  for (const Kind kind : kKinds) {
    const double range = sensing_need(head_on(100.0, kind))->range;
    for (const double less : {1e-3, 0.1, 0.3}) {
      const Scenario scene = unseen_until_the_last(range - less, kind);
      ASSERT_EQ(broken_assumptions(scene).start_count, 0) << "still braking in time";
      ASSERT_TRUE(broken_assumptions(scene).unseen);
      Simulation simulation(scene, 1);
      simulation.step();
      EXPECT_NE(simulation.fleet().plan[0].status, PlanStatus::overlapping) << "nobody seen";
      simulation.step();
      EXPECT_EQ(simulation.fleet().plan[0].status, PlanStatus::overlapping);
      EXPECT_EQ(simulation.fleet().plan[1].status, PlanStatus::overlapping);
    }
    EXPECT_EQ(test::judged(unseen_until_the_last(range - 0.3, kind), 60).overlaps.count, 1);
  }
}

// So many robots at speed that the start admits, each after the other.
Scenario crowd(Kind kind, std::uint64_t seed) {
  Random random(seed);
  Scenario scene = head_on(1.0, kind);
  scene.robots.clear();
  scene.sensing_radius = 1000.0;
  const double extent = random.uniform(6.0, 16.0);
  scene.duration = 20.0;
  for (int k = random.below(3); k > 0; --k) {
    const Vec2 place = 1.5 * extent * random.direction();
    const Vec2 v = (-random.uniform(0.2, 1.0) / norm(place)) * place;
    scene.moving_obstacles.push_back({place, v, test::in_disc(random, 0.03), 0.5});
  }
  for (int tries = 0; tries < 200 && scene.robots.size() < 16; ++tries) {
    RobotSetup robot;
    robot.radius = random.uniform(0.2, 0.6);
    robot.max_acceleration = random.log_uniform(0.5, 2.0);
    robot.max_speed = random.uniform(0.8, 3.0);
    robot.preferred_speed = robot.max_speed;
    robot.position = extent * Vec2{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    robot.velocity = random.below(2) == 0 ? test::in_disc(random, robot.max_speed)
                                          : robot.max_speed * random.direction();
    robot.goal = -1.0 * robot.position;
    scene.robots.push_back(robot);
    if (!broken_assumptions(scene).none()) scene.robots.pop_back();
  }
  scene.sensing_radius = sensing_need(scene)->range;
  return scene;
}

TEST(Assumptions, whoever_keeps_them_never_overlaps) {
  std::int64_t moving = 0;
  for (const Kind kind : kKinds) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const Scenario scene = crowd(kind, seed);
      ASSERT_TRUE(broken_assumptions(scene).none());
      ASSERT_GT(scene.robots.size(), 3U);
      const CheckReport report = test::judged(scene, last_step(scene, scene.duration));
      EXPECT_EQ(report.overlaps.count, 0) << seed;
      EXPECT_EQ(report.mover_contacts_moving.count, 0) << seed;
      EXPECT_TRUE(report.safe()) << seed;
      for (const RobotSetup& robot : scene.robots) moving += norm(robot.velocity) > 0.5 ? 1 : 0;
    }
  }
  EXPECT_GT(moving, 300);
}

}  // namespace
}  // namespace avo
