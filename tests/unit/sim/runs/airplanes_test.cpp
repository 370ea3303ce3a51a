// SPDX-License-Identifier: Apache-2.0
// Airplanes in a simulation: arriving in passing, leaving, loitering, crowds, saving, refusals.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

#include "avo/assumptions.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "support/generators.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::Random;
using test::refusal;

RobotSetup plane(Vec2 position, double heading, Vec2 goal, AfterGoal after) {
  RobotSetup setup;
  setup.position = position, setup.goal = goal, setup.heading = heading;
  setup.model = Airplane{1.0, 1.0, after};
  return setup;
}

Scenario scene_of(std::vector<RobotSetup> robots) {
  Scenario scene;
  scene.robots = std::move(robots);
  scene.sensing_radius = 40.0;
  return scene;
}

TEST(Airplanes, one_arrives_between_two_steps_and_is_gone_in_the_next) {
  // 0.2 m a step: neither before nor after any step it is within 0.05 m of the goal
  Scenario scene = scene_of({plane({0, 0}, 0.0, {2.1, 0}, AfterGoal::leave),
                             plane({0, 50}, 0.0, {90, 50}, AfterGoal::leave)});
  scene.arrival_distance = 0.05;
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  for (int k = 0; k < 11; ++k) {
    EXPECT_FALSE(simulation.is_at_goal({0})) << k;
    simulation.step();
    metrics.observe(simulation);
  }
  ASSERT_EQ(simulation.fleet().id.size(), 2U);
  EXPECT_TRUE(simulation.is_at_goal({0}));
  EXPECT_GT(norm(simulation.fleet().position[0] - scene.robots[0].goal), 0.05);
  simulation.step();
  metrics.observe(simulation);
  ASSERT_EQ(simulation.fleet().id.size(), 1U);
  EXPECT_EQ(simulation.fleet().id[0], RobotId{1});
  EXPECT_EQ(simulation.index_of({0}), std::nullopt);
  EXPECT_EQ(simulation.index_of({1}), 0U);
  EXPECT_EQ(metrics.summary().arrived, 1);
  EXPECT_EQ(metrics.summary().acceleration_excess, 0.0);
}

TEST(Airplanes, one_that_stays_circles_for_ever_and_flies_on_to_another_goal) {
  Simulation simulation(scene_of({plane({0, 0}, 0.0, {4, 0}, AfterGoal::loiter)}), 1);
  for (int k = 0; k < 40; ++k) simulation.step();
  ASSERT_TRUE(simulation.is_at_goal({0}));
  const Vec2 there = simulation.fleet().position[0];
  for (int k = 0; k < 10'000; ++k) {
    simulation.step();
    ASSERT_LE(norm(simulation.fleet().position[0] - there), 8.0 * (1.0 + 2e-6));  // 2 ρ
    ASSERT_TRUE(simulation.is_at_goal({0}));
  }
  simulation.set_goal(simulation.fleet().id[0], {60, 0});
  EXPECT_FALSE(simulation.is_at_goal({0}));
  for (int k = 0; k < 400 && !simulation.is_at_goal({0}); ++k) simulation.step();
  EXPECT_TRUE(simulation.is_at_goal({0}));
}

TEST(Airplanes, goals_all_around_are_passed) {
  for (int k = 0; k < 24; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 24;
    for (const double away : {1.0, 3.0, 9.0, 30.0}) {
      const Vec2 goal{away * std::cos(angle), away * std::sin(angle)};
      Simulation simulation(scene_of({plane({0, 0}, 0.0, goal, AfterGoal::loiter)}), 1);
      for (int i = 0; i < 600 && !simulation.is_at_goal({0}); ++i) simulation.step();
      EXPECT_TRUE(simulation.is_at_goal({0})) << k << " " << away;
    }
  }
}

// Airplanes, or robots of all kinds, sent to one place after the other.
Scenario crowd(std::uint64_t seed, int robots, bool mixed) {
  Random random(seed);
  Scenario scene = scene_of({});
  for (int tries = 0; static_cast<int>(scene.robots.size()) < robots && tries < 100'000; ++tries) {
    RobotSetup setup;
    setup.position = setup.goal = test::in_disc(random, 30.0);
    setup.radius = random.uniform(0.2, 0.8);
    setup.max_acceleration = random.log_uniform(0.5, 2.0);
    setup.priority = random.below(2) == 0 ? 1.0 : random.log_uniform(0.01, 100.0);
    setup.heading = random.uniform(-3.0, 3.0);
    const int kind = mixed ? random.below(4) : 0;
    if (kind == 0) {
      const double slow = random.uniform(0.5, 1.5);
      setup.model = Airplane{slow, random.uniform(1.0, 3.0), AfterGoal::loiter};
      setup.velocity = {slow, 0.0};
    } else if (kind == 1) {
      setup.model = Car{.max_curvature = 0.8,
                        .body = CarBody{random.uniform(-0.3, 0.5), setup.radius},
                        .reverse = true};
    } else if (kind == 2) {
      setup.model = DifferentialDrive{.offset = random.uniform(0.1, 0.4)};
      setup.max_acceleration = 0.5 * most_acceleration(std::get<DifferentialDrive>(setup.model));
    }
    if (kind != 0 && random.below(2) == 0)
      setup.max_braking = random.log_uniform(0.3, kind == 2 ? 1.9 : 3.0) * setup.max_acceleration;
    scene.robots.push_back(setup);
    if (broken_assumptions(scene).start_count > 0) scene.robots.pop_back();
  }
  return scene;
}

void expect_no_contact(const Scenario& scene, int steps) {
  Simulation simulation(scene, 2);
  Metrics metrics(scene);
  Random random(5);
  for (int k = 0; k < steps; ++k) {
    if (k % 50 == 0) {
      const Vec2 rally = test::in_disc(random, 8.0);
      for (const RobotId robot :
           std::vector(simulation.fleet().id.begin(), simulation.fleet().id.end()))
        simulation.set_goal(robot, rally);
    }
    metrics.observe(simulation);
    simulation.step();
  }
  const RunSummary summary = metrics.summary();
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_GE(summary.min_clearance.value_or(-1.0), -1e-7);
  EXPECT_LT(summary.min_clearance.value_or(1.0), 0.05);  // they did meet
  EXPECT_EQ(summary.acceleration_excess, 0.0);
  EXPECT_EQ(summary.decisions.overlapping + summary.decisions.invalid_input, 0);
}

TEST(Airplanes, a_crush_of_them_does_not_touch) {
  for (const std::uint64_t seed : {1, 2}) expect_no_contact(crowd(seed, 40, false), 1'000);
}

TEST(Airplanes, a_crush_with_robots_of_all_other_kinds_does_not_touch) {
  for (const std::uint64_t seed : {3, 4}) expect_no_contact(crowd(seed, 60, true), 1'000);
}

TEST(Airplanes, a_saved_flight_goes_on_bit_by_bit) {
  const Scenario scene = crowd(7, 20, true);
  Simulation simulation(scene, 1);
  for (int k = 0; k < 30; ++k) simulation.step();  // some remember circles by now
  Simulation resumed(simulation.save(), 1);
  for (int k = 0; k < 200; ++k) {
    ASSERT_EQ(resumed.state_hash(), simulation.state_hash()) << k;
    simulation.step(), resumed.step();
  }
}

TEST(Airplanes, what_they_cannot_do_is_refused_in_one_line) {
  const Scenario scene = scene_of({plane({0, 0}, 0.0, {50, 0}, AfterGoal::leave)});
  EXPECT_EQ(refusal(scene), "");
  const auto with = [&](auto change) {
    Scenario changed = scene;
    change(changed);
    return refusal(changed);
  };
  const auto airplane = [](Scenario& s) -> Airplane& {
    return std::get<Airplane>(s.robots[0].model);
  };
  EXPECT_EQ(with([](Scenario& s) { s.motion = Motion::exponential; }),
            "motion: found exponential, must be held in a scene with airplanes");
  EXPECT_EQ(with([](Scenario& s) { s.sensing.dropped = 0.1; }),
            "sensing: found one that is not exact, must be left out in a scene with airplanes");
  EXPECT_EQ(
      with([](Scenario& s) { s.robots[0].behavior = Behavior::parked, s.robots[0].goal = {}; }),
      "robots.0.behavior: found parked, must be another one: it cannot stop");
  EXPECT_EQ(with([](Scenario& s) {
              s.robots.push_back(test::robot_at({50, 50}, {50, 50}));
              s.robots.back().behavior = Behavior::parked;
            }),
            "");
  EXPECT_EQ(with([](Scenario& s) { s.clock = Clock::free; }),
            "clock: found free, must be common in a scene with airplanes");
  EXPECT_EQ(with([](Scenario& s) { s.robots[0].max_braking = 0.5; }),
            "robots.0.max_braking: found 0.5, must be left out: it cannot brake");
  EXPECT_EQ(with([](Scenario& s) {
              s.robots[0].velocity = {0.5, 0.0};
            }),
            "robots.0.velocity: found 0.5 m/s, must be 1 to 2 m/s, or left out: preferred_speed");
  EXPECT_EQ(with([&](Scenario& s) { airplane(s).min_speed = 3.0; }),
            "robots.0.airplane.min_speed: found 3, must be <= max_speed = 2 m/s");
  EXPECT_EQ(with([&](Scenario& s) { airplane(s).lateral_acceleration = 40.0; }),
            "robots.0.airplane.lateral_acceleration: found 40, must be <= 30 m/s^2, 3 rad in a "
            "step at min_speed");
  EXPECT_EQ(
      with([](Scenario& s) {
        s.robots.push_back(s.robots[0]);
        s.robots[1].avoids = {};
      }),
      "robots.0.avoids: found robot 1, which does not avoid it, must be both or neither: one of "
      "them cannot stop");
}

}  // namespace
}  // namespace avo
