// SPDX-License-Identifier: Apache-2.0
// Robots of several methods in one fleet.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "avo/assumptions.h"
#include "avo/check.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "support/refusal.h"
#include "unit/sim/saving.h"

namespace avo {
namespace {

using test::Random;
using test::refusal;
using test::robot_at;

constexpr std::array kAllMethods{Method::avo,
                                 Method::avo_paper,
                                 Method::velocity_obstacle,
                                 Method::orca,
                                 Method::orca_clamped,
                                 Method::reciprocal_velocity_obstacle,
                                 Method::buffered_voronoi};

RobotSetup by(Method method, RobotSetup setup) {
  setup.method = method;
  return setup;
}

// Robots on a circle, off by chance, that exchange places; of these methods in turn.
Scenario circle_of(int robots, double radius, std::vector<Method> methods, std::uint64_t seed) {
  Random random(seed);
  Scenario scene;
  scene.max_neighbors = 10;
  scene.duration = 60.0;
  for (int k = 0; k < robots; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / robots;
    const Vec2 place = radius * Vec2{std::cos(angle), std::sin(angle)} + test::in_disc(random, 0.3);
    scene.robots.push_back(by(methods[static_cast<std::size_t>(k) % methods.size()],
                              robot_at(place, {-place.x, -place.y})));
  }
  return scene;
}

std::uint64_t hash_after(const Scenario& scene, int steps, int threads = 1) {
  Simulation simulation(scene, threads);
  for (int k = 0; k < steps; ++k) simulation.step();
  return simulation.state_hash();
}

TEST(Methods, that_all_robots_have_of_their_own_are_as_the_scenes) {
  for (const Method method : kAllMethods) {
    Scenario scene = test::holonomic_scene(36);
    scene.control_time.reset(), scene.time_horizon.reset();
    scene.method = method == Method::avo ? Method::orca : Method::avo;
    for (RobotSetup& robot : scene.robots) robot.method = method;
    Scenario usual = scene;
    usual.method = method;
    for (RobotSetup& robot : usual.robots) robot.method.reset();
    EXPECT_EQ(hash_after(scene, 20), hash_after(usual, 20)) << to_string(method);
    for (RobotSetup& robot : usual.robots) robot.method = method;  // said twice
    EXPECT_EQ(hash_after(scene, 20), hash_after(usual, 20)) << to_string(method);
    for (RobotSetup& robot : scene.robots) robot.time_horizon = usual_time_horizon(method);
    EXPECT_EQ(hash_after(scene, 20), hash_after(usual, 20)) << to_string(method);
  }
}

TEST(Methods, have_what_is_customary_for_them_and_not_what_the_scene_says_to_others) {
  Scenario scene;
  scene.control_time = 1.0, scene.time_horizon = 5.0, scene.comfort_acceleration = 0.5;
  scene.sensing_error = SensingError{0.1, 0.2};
  const RobotSetup own = robot_at({0, 0}, {9, 0});
  const PlannerOptions usual = planner_options(scene, own);
  EXPECT_EQ(usual.time_horizon, 5.0);
  EXPECT_EQ(usual.sensing_error, (SensingError{0.1, 0.2}));
  RobotSetup other = by(Method::orca, own);
  const PlannerOptions orca = planner_options(scene, other);
  EXPECT_EQ(orca.method, Method::orca);
  EXPECT_EQ(orca.time_horizon, 10.0);
  EXPECT_EQ(orca.certificate, Certificate::none);
  EXPECT_EQ(orca.comfort_acceleration, std::nullopt);
  EXPECT_EQ(orca.sensing_error, SensingError{});
  other.time_horizon = 2.0;
  EXPECT_EQ(planner_options(scene, other).time_horizon, 2.0);
  other.position = {0, 5};
  scene.robots = {own, other};
  Simulation simulation(scene, 1);
  EXPECT_EQ(simulation.planner({0}).options().time_horizon, 5.0);
  EXPECT_EQ(simulation.planner({1}).options().time_horizon, 2.0);
  EXPECT_EQ(simulation.fleet().setup[1].method, Method::orca);
  EXPECT_EQ(simulation.fleet().setup[1].time_horizon, 2.0);
}

// By what it says of itself, one of another method promises nothing to one that keeps a
// certificate.
TEST(Methods, of_others_promise_nothing) {
  Scenario scene;
  scene.robots = {robot_at({-4, 0}, {4, 0}), by(Method::orca, robot_at({4, 0.1}, {-4, 0.1})),
                  by(Method::orca_clamped, robot_at({0, 5}, {0, -5}))};
  scene.robots[1].velocity = {-2, 0};
  Simulation simulation(scene, 1);
  for (const Neighbor& seen : simulation.perceive({0}).neighbors) {
    EXPECT_EQ(seen.behavior, Behavior::moves_on);
    EXPECT_EQ(seen.max_deviation, 0.0);
    EXPECT_EQ(seen.acceleration, Vec2{});
  }
  scene.robots[1].avoids = {}, scene.robots[2].avoids = {};
  for (const Neighbor& seen : Simulation(scene, 1).perceive({0}).neighbors) {
    EXPECT_EQ(seen.behavior, Behavior::moves_on);
    EXPECT_EQ(seen.max_deviation, 0.0);  // nor within which limits it does as it likes
  }
  for (const std::size_t other : {1U, 2U})
    for (const Neighbor& seen : simulation.perceive({other}).neighbors)
      EXPECT_EQ(seen.behavior, Behavior::decides);
}

// One that looks ahead for one step only hardly reacts: the other one does it all.
TEST(Methods, are_evaded_by_those_who_keep_a_certificate) {
  Random random(3);
  for (int k = 0; k < 40; ++k) {
    Scenario scene;
    scene.robots = {robot_at({-8, 0}, {8, 0})};
    // they would meet after 5 s
    const double angle = (k % 2 == 0 ? 1.0 : -1.0) * random.uniform(0.6, 2.6);
    const double speed = random.uniform(0.8, 2.0);
    const Vec2 velocity = speed * Vec2{std::cos(angle), std::sin(angle)};
    RobotSetup other = by(Method::orca, robot_at(-5.0 * velocity, 20.0 * velocity));
    other.max_speed = other.preferred_speed = speed;
    other.velocity = velocity;
    other.time_horizon = scene.time_step;
    other.max_acceleration = 5.0;  // a robot that counted on it would leave most to this one
    other.radius = random.uniform(0.3, 0.6);
    scene.robots.push_back(other);
    Simulation simulation(scene, 1);
    Metrics metrics(scene, {.judged = {RobotId{0}}});
    metrics.observe(simulation);
    for (int step = 0; step < 200; ++step) simulation.step(), metrics.observe(simulation);
    EXPECT_EQ(metrics.summary().metrics.collision, 0.0) << k;
    EXPECT_TRUE(simulation.is_at_goal({0})) << k;
  }
}

// The certificate holds between the robots that keep it, whatever other robots are among them.
TEST(Methods, of_others_do_not_break_the_promise_that_robots_of_avo_give_each_other) {
  for (const Method other : {Method::orca, Method::avo_paper}) {
    for (const Clock clock : {Clock::common, Clock::free}) {
      Scenario scene = circle_of(24, 9.0, std::vector<Method>(8, Method::avo), 5);
      for (std::size_t k = 7; k < 24; k += 8) scene.robots[k].method = other;
      scene.clock = clock;
      std::vector<CheckedRobot> robots(24, {0.5, 1.0, 2.0});
      if (clock == Clock::free)
        for (CheckedRobot& robot : robots) robot.time_step = scene.time_step;
      Check check(robots);
      Simulation simulation(scene, 1);
      Random random(7);
      for (int step = 0; step < 700; ++step) {
        const FleetView fleet = simulation.fleet();
        std::vector<CheckedState> rows;
        for (std::size_t k = 0; k < 24; ++k)
          if (k % 8 != 7)
            rows.push_back({static_cast<std::int64_t>(k), fleet.position[k], fleet.velocity[k]});
        check.add(simulation.time(), rows);
        if (step % 60 == 0) {
          const Vec2 rally = test::in_disc(random, 2.0);
          for (std::uint64_t k = 0; k < 24; ++k) simulation.set_goal({k}, rally);
        }
        simulation.step();
      }
      EXPECT_TRUE(check.report().safe()) << to_string(other);
      EXPECT_LT(*check.report().least_clearance, 0.3);  // it was tight
    }
  }
}

TEST(Methods, of_all_kinds_mix_in_one_fleet_whatever_the_number_of_threads) {
  Scenario scene = circle_of(280, 90.0, {kAllMethods.begin(), kAllMethods.end()}, 1);
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    if (motion == Motion::exponential) {
      std::erase_if(scene.robots,
                    [](const RobotSetup& robot) { return reaches_within_step(*robot.method); });
    }
    scene.motion = motion;
    EXPECT_EQ(hash_after(scene, 40, 1), hash_after(scene, 40, 3));
  }
  const Scenario few = circle_of(14, 12.0, {kAllMethods.begin(), kAllMethods.end()}, 2);
  Simulation simulation(few, 1);
  Metrics metrics(few);
  metrics.observe(simulation);
  while (simulation.can_step_by(few.duration)) simulation.step(), metrics.observe(simulation);
  EXPECT_EQ(metrics.summary().arrived, 14);
  for (const Vec2 position : simulation.fleet().position)
    EXPECT_TRUE(std::isfinite(position.x) && std::isfinite(position.y));
}

TEST(Methods, are_saved_and_restored) {
  for (const Clock clock : {Clock::common, Clock::free}) {
    Scenario scene = circle_of(20, 9.0, {Method::avo, Method::orca, Method::orca_clamped}, 4);
    scene.clock = clock;
    for (std::size_t k = 0; k < 20; k += 3) scene.robots[k + 1].time_horizon = 5.0;
    Simulation simulation(scene, 1);
    for (int step = 0; step < 30; ++step) simulation.step();
    const auto saved = simulation.save();
    Simulation other(saved, 1);
    EXPECT_EQ(other.fleet().setup[1].method, Method::orca);
    EXPECT_EQ(other.fleet().setup[1].time_horizon, 5.0);
    for (int step = 0; step < 60; ++step) simulation.step(), other.step();
    EXPECT_EQ(simulation.state_hash(), other.state_hash());
    simulation.restore(saved);
    for (int step = 0; step < 60; ++step) simulation.step();
    EXPECT_EQ(simulation.state_hash(), other.state_hash());
  }
}

// Where the certificate is that of a few, what they have declared stays as well.
TEST(Methods, of_those_who_declare_an_error_may_come_and_go) {
  Scenario scene = circle_of(6, 9.0, {Method::orca}, 4);
  scene.method = Method::orca;
  scene.sensing.noise = {0.02, 0.05};
  scene.sensing_radius = 15.0;
  scene.robots[0].method = Method::avo;
  Simulation simulation(scene, 1);
  EXPECT_GT(simulation.planner({0}).options().sensing_error.position, 0.0);
  simulation.add_robot(robot_at({0, 0}, {0, 0}));
  const RobotId late = simulation.add_robot(by(Method::avo, robot_at({0, 20}, {0, -20})));
  EXPECT_EQ(simulation.planner({7}).options().sensing_error,
            simulation.planner({0}).options().sensing_error);
  simulation.remove_robot({0}), simulation.remove_robot(late);
  Simulation other(simulation.save(), 1);
  for (int step = 0; step < 20; ++step) simulation.step(), other.step();
  EXPECT_EQ(simulation.state_hash(), other.state_hash());
  for (RobotSetup& robot : scene.robots) robot.method.reset();
  scene.sensing_error = SensingError{0.1, 0.1};
  EXPECT_EQ(refusal(scene), "sensing_error: found one, must be none with certificate none");
  scene.robots[0].method = Method::avo;
  EXPECT_EQ(refusal(scene), "");
}

TEST(Methods, that_no_robot_can_have_are_refused) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {9, 0}), robot_at({5, 5}, {5, 5})};
  scene.robots[1].behavior = Behavior::parked;
  scene.robots[1].method = Method::orca;
  EXPECT_EQ(refusal(scene), "robots.1.method: found orca, must be left out: it is parked");
  scene.robots[1].method.reset(), scene.robots[1].time_horizon = 2.0;
  EXPECT_EQ(refusal(scene), "robots.1.time_horizon: found 2, must be left out: it is parked");
  scene.robots.pop_back();
  scene.robots[0].time_horizon = 0.05;
  EXPECT_EQ(refusal(scene), "robots.0.time_step: found 0.1, must be <= time_horizon = 0.05 s");
  scene.robots[0].time_horizon = -1.0;
  EXPECT_EQ(refusal(scene), "robots.0.time_horizon: found -1, must be > 0 s");
  scene.robots[0].time_horizon.reset(), scene.robots[0].method = Method::orca_clamped;
  scene.motion = Motion::exponential;
  EXPECT_EQ(refusal(scene),
            "robots.0.method: found orca_clamped, must be another one where motion is exponential");
  scene.motion = Motion::held;
  EXPECT_EQ(refusal(scene), "");
  scene.robots.push_back(robot_at({40, 0}, {90, 0}));
  scene.robots[1].model = Airplane{.min_speed = 1.0};
  EXPECT_EQ(refusal(scene),
            "robots.0.method: found orca_clamped, must be avo in a scene with airplanes");
  scene.robots[0].method.reset();
  ASSERT_EQ(refusal(scene), "");
  Simulation simulation(scene, 1);
  EXPECT_EQ(refusal([&] {
              simulation.add_robot(by(Method::orca, robot_at({0, 30}, {0, 60})));
            }),
            "robot 2: method: found orca, must be avo, of all robots, in a scene with airplanes");
}

// A start beside one that promises nothing is held against its velocity alone.
TEST(Methods, assumptions_are_those_of_whom_keeps_a_certificate) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {9, 0}), by(Method::orca, robot_at({3, 0}, {-9, 0}))};
  EXPECT_TRUE(broken_assumptions(scene).none());
  scene.robots[0].velocity = {2, 0};
  scene.robots[1].velocity = {-2, 0};
  EXPECT_EQ(broken_assumptions(scene).start_count, 1);
  scene.robots[0].method = Method::orca;
  EXPECT_TRUE(broken_assumptions(scene).none());
  scene.robots[1].velocity = {-5, 0};  // it is too fast, but it promises nothing
  EXPECT_TRUE(broken_assumptions(scene).none());
  EXPECT_FALSE(advice(scene).empty());
  // fast ones of others have to be seen from farther away
  scene.robots = {robot_at({0, 0}, {9, 0}), by(Method::orca, robot_at({30, 0}, {-9, 0}))};
  const double usual = needed_sensing_radius(scene);
  scene.robots[1].max_speed = scene.robots[1].preferred_speed = 8.0;
  EXPECT_GT(needed_sensing_radius(scene), usual + 5.0);
}

}  // namespace
}  // namespace avo
