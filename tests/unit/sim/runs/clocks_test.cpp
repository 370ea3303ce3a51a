// SPDX-License-Identifier: Apache-2.0
// Robots with clocks of their own: when they decide, what they do in between, and that a run is the
// same however it is made.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "avo/assumptions.h"
#include "avo/check.h"
#include "avo/checked.h"
#include "avo/error.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "robots/model.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::Random;
using test::refusal;
using test::robot_at;

// On a circle, to the places opposite; every third of them decides more often.
Scenario crossing(int robots, std::uint64_t seed = 1) {
  Scenario scene;
  scene.clock = Clock::free;
  scene.seed = seed;
  const double radius = std::max(4.0, 0.4 * robots);
  for (int k = 0; k < robots; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / robots;
    const Vec2 place{radius * std::cos(angle), radius * std::sin(angle)};
    scene.robots.push_back(robot_at(place, -1.0 * place));
    if (k % 3 == 0) scene.robots.back().time_step = 0.04;
  }
  return scene;
}

double step_of(const Scenario& scene, std::size_t robot) {
  return time_step_of(scene, scene.robots[robot]);
}

std::vector<CheckedState> rows_of(const Simulation& simulation) {
  return checked_states(simulation.fleet());
}

CheckReport judged(const Scenario& scene, double duration) {
  std::vector<CheckedRobot> robots;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    robots.push_back(checked_robot(scene.robots[i]));
    robots.back().time_step = step_of(scene, i);
  }
  Check check(robots);
  Simulation simulation(scene, 1);
  check.add(0.0, rows_of(simulation));
  while (simulation.can_step_by(duration)) {
    simulation.step();
    check.add(simulation.time(), rows_of(simulation));
  }
  return check.report();
}

TEST(Clocks, phases_are_different_and_follow_from_the_seed) {
  const auto phases = [](std::uint64_t seed) {
    const Scenario scene = crossing(30, seed);
    const Simulation simulation(scene, 1);
    std::vector<double> all;
    for (std::size_t i = 0; i < 30; ++i) {
      all.push_back(simulation.next_decision({i}));
      EXPECT_GE(all.back(), 0.0);
      EXPECT_LT(all.back(), step_of(scene, i));
    }
    return all;
  };
  const std::vector<double> one = phases(1);
  EXPECT_EQ(std::set<double>(one.begin(), one.end()).size(), 30u);
  EXPECT_GT(*std::max_element(one.begin(), one.end()), 0.08);
  EXPECT_EQ(one, phases(1));
  EXPECT_NE(one, phases(2));
}

TEST(Clocks, each_robot_decides_its_own_time_step_apart) {
  const Scenario scene = crossing(9);
  Simulation simulation(scene, 1);
  std::vector<std::vector<double>> times(9);
  while (simulation.can_step_by(2.0)) {
    const double now = simulation.time();
    std::vector<double> next;
    for (std::size_t i = 0; i < 9; ++i) next.push_back(simulation.next_decision({i}));
    const double nearest = *std::min_element(next.begin(), next.end());
    simulation.step();
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_EQ(simulation.decided({i}), next[i] == now);
      if (simulation.decided({i})) times[i].push_back(now);
    }
    if (nearest > now) {
      EXPECT_EQ(simulation.time(), nearest) << "somebody was passed over";
    }
  }
  for (std::size_t i = 0; i < 9; ++i) {
    const double step = step_of(scene, i);
    ASSERT_GE(static_cast<double>(times[i].size()), 2.0 / step - 1.0) << i;
    for (std::size_t k = 0; k < times[i].size(); ++k)
      EXPECT_NEAR(times[i][k], times[i][0] + static_cast<double>(k) * step, 1e-15) << i;
  }
}

// Three nanoseconds have room for three instants, however many robots there are.
TEST(Clocks, who_decides_at_the_same_instant_decides_in_one_step) {
  Scenario scene = crossing(12);
  for (RobotSetup& robot : scene.robots) robot.time_step = 3e-9;
  scene.duration = 0.1;
  scene.time_step = 3e-9;
  scene.certificate = Certificate::none;  // which looks at braking step by step
  Simulation simulation(scene, 1);
  int steps = 0, decisions = 0;
  while (simulation.can_step_by(300e-9)) {
    simulation.step(), ++steps;
    for (std::size_t i = 0; i < 12; ++i) decisions += simulation.decided({i}) ? 1 : 0;
  }
  EXPECT_EQ(steps, 300);
  EXPECT_GE(decisions, 12 * 99);
}

// The judge finds changes of acceleration at other times by itself.
TEST(Clocks, robots_hold_what_they_have_decided_and_keep_clear) {
  Scenario scene = crossing(12);
  const CheckReport report = judged(scene, 12.0);
  EXPECT_TRUE(report.safe()) << report.changes.count << ' ' << report.overlaps.count;
  EXPECT_GT(report.robot_steps, 12 * 12 * 120);
  for (RobotSetup& robot : scene.robots) robot.time_step = 1.25 * robot.time_step.value_or(0.1);
  EXPECT_TRUE(judged(scene, 12.0).safe());
}

TEST(Clocks, the_judge_would_notice_another_time_step) {
  const Scenario scene = crossing(12);
  std::vector<CheckedRobot> robots(12);
  for (CheckedRobot& robot : robots) robot.time_step = 0.07;
  Check check(robots);
  Simulation simulation(scene, 1);
  check.add(0.0, rows_of(simulation));
  while (simulation.can_step_by(3.0)) {
    simulation.step();
    check.add(simulation.time(), rows_of(simulation));
  }
  EXPECT_GT(check.report().changes.count, 50);
}

TEST(Clocks, cars_hold_their_arcs) {
  Scenario scene = crossing(10);
  for (std::size_t i = 0; i < 10; i += 2) {
    const Vec2 way = scene.robots[i].goal - scene.robots[i].position;
    scene.robots[i].model = Car{.wheelbase = 0.7};
    scene.robots[i].heading = std::atan2(way.y, way.x) + 0.6;
  }
  const CheckReport report = judged(scene, 12.0);
  EXPECT_TRUE(report.safe()) << report.changes.count << ' ' << report.overlaps.count;
  EXPECT_LT(report.interpolation_error, 1e-3);
}

// A robot that starts in motion brakes until its phase, however late that is.
TEST(Clocks, a_start_in_motion_keeps_the_limits) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Scenario scene = crossing(8, seed);
    for (RobotSetup& robot : scene.robots) robot.velocity = -0.2 * robot.position;
    ASSERT_TRUE(broken_assumptions(scene).none());
    Simulation simulation(scene, 1);
    while (simulation.next_decision({1}) > simulation.time()) simulation.step();
    EXPECT_LT(norm(simulation.fleet().velocity[1]), norm(scene.robots[1].velocity));
    EXPECT_TRUE(judged(scene, 6.0).safe()) << seed;
  }
}

// A drive turns meanwhile: by how much the judge knows.
TEST(Clocks, a_start_brakes_as_hard_as_others_expect) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Scenario scene = crossing(8, seed);
    for (RobotSetup& robot : scene.robots) {
      const bool drives = seed % 2 == 0;
      robot.velocity = Vec2{0.0, 0.4}, robot.max_braking = 0.3;
      scene.sensing_radius = 16.0;
      if (drives) robot.heading = 0.5 * std::numbers::pi;
      if (drives) robot.model = DifferentialDrive{.wheel_speed = 2.0, .wheel_acceleration = 4.0};
    }
    Simulation simulation(scene, 1);
    while (simulation.next_decision({1}) > simulation.time()) simulation.step();
    EXPECT_NEAR(norm(simulation.fleet().velocity[1]), 0.4 - 0.3 * simulation.time(), 1e-12);
    EXPECT_TRUE(judged(scene, 6.0).safe()) << seed;
  }
}

// Two that would stop just short of each other, had they all of their braking at once.
TEST(Clocks, a_start_has_to_allow_for_a_short_first_step) {
  Scenario scene;
  scene.robots = {robot_at({0, 0}, {0, 0}), robot_at({3.1, 0}, {3.1, 0})};
  scene.robots[0].velocity = {1.45, 0}, scene.robots[1].velocity = {-1.45, 0};
  const double way = 1.45 * 1.45 / 2.0;  // m, and what steps add to it
  const auto apart = [&](double gap) {
    scene.robots[1].position.x = 1.0 + 2.0 * way + gap;
    return broken_assumptions(scene).none();
  };
  EXPECT_TRUE(apart(0.003));
  scene.clock = Clock::free;
  EXPECT_FALSE(apart(0.003));
  EXPECT_TRUE(apart(0.006));
}

// The robot ahead brakes at once: no robot may count on the step for which it would hold its
// velocity.
TEST(Clocks, a_start_behind_one_that_drives_ahead_is_that_of_joint_braking) {
  Scenario scene;
  scene.time_step = 0.5;
  scene.robots = {robot_at({0, 0}, {9, 0}), robot_at({2.3, 0}, {2.3, 0})};
  scene.robots[0].velocity = {2, 0}, scene.robots[1].velocity = {1, 0};
  EXPECT_FALSE(broken_assumptions(scene).none());
  scene.clock = Clock::free;
  EXPECT_FALSE(broken_assumptions(scene).none());
  scene.robots[1].position.x = 2.9;
  ASSERT_TRUE(broken_assumptions(scene).none());
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    scene.seed = seed;
    EXPECT_TRUE(judged(scene, 4.0).safe()) << seed;
  }
}

TEST(Clocks, what_cars_may_add_within_a_step_has_to_be_declared) {
  Scenario scene = crossing(4);
  scene.robots[1].model = Car{.max_curvature = 0.8, .body = CarBody{0.5, 0.9}};
  scene.sensing_error = SensingError{};
  EXPECT_EQ(refusal(scene).rfind("sensing_error.position: found 0, must be >= 0.0", 0), 0u)
      << refusal(scene);
  scene.sensing_error = planner_options(crossing(4)).sensing_error;
  scene.sensing_error->position = 0.1;
  EXPECT_EQ(refusal(scene), "");
  scene.robots[1].model = Car{.acceleration_set = AccelerationSet::exact};
  EXPECT_EQ(refusal(scene).rfind("sensing_error.velocity: found 0, must be >= 0.0", 0), 0u)
      << refusal(scene);
  scene.clock = Clock::common;
  for (RobotSetup& robot : scene.robots) robot.time_step.reset();
  EXPECT_EQ(refusal(scene), "");
}

TEST(Clocks, every_number_of_threads_gives_the_same_bits) {
  const Scenario scene = crossing(300);
  Simulation one(scene, 1), two(scene, 2), three(scene, 3);
  for (int k = 0; k < 700; ++k) {
    one.step(), two.step(), three.step();
    if (k % 50 != 0) continue;
    ASSERT_EQ(one.state_hash(), two.state_hash()) << k;
    ASSERT_EQ(one.state_hash(), three.state_hash()) << k;
  }
}

TEST(Clocks, a_saved_run_goes_on_with_every_phase_and_every_step_begun) {
  Scenario scene = crossing(12);
  scene.robots[4].model = Car{.wheelbase = 0.7};
  scene.robots[4].heading = 1.0;
  for (const int steps : {0, 1, 7, 61}) {
    Simulation original(scene, 1), other(scene, 1);
    for (int k = 0; k < steps; ++k) original.step();
    for (int k = 0; k < 33; ++k) other.step();
    const std::vector<std::byte> saved = original.save();
    Simulation alone(saved, 1);
    other.restore(saved);
    EXPECT_EQ(other.time(), original.time());
    EXPECT_FALSE(other.decided({0}));
    for (int k = 0; k < 200; ++k) {
      for (std::size_t i = 0; i < 12; ++i)
        ASSERT_EQ(alone.next_decision({i}), original.next_decision({i})) << steps << ' ' << k;
      ASSERT_EQ(alone.state_hash(), original.state_hash()) << steps << ' ' << k;
      ASSERT_EQ(other.state_hash(), original.state_hash()) << steps << ' ' << k;
      original.step(), other.step(), alone.step();
    }
    EXPECT_EQ(alone.save(), original.save());
  }
}

// Where all are is a part of the state only between decisions if what they hold is one too.
TEST(Clocks, the_hash_tells_what_is_held) {
  Simulation simulation(crossing(6), 1);
  simulation.step();
  const std::uint64_t before = simulation.state_hash();
  Scenario later = crossing(6);
  later.seed = 2;
  Simulation another(later, 1);
  another.step();
  EXPECT_NE(another.state_hash(), before);
}

TEST(Clocks, robots_come_and_go) {
  Scenario scene = crossing(9);
  scene.longest_step = 0.1;
  Simulation simulation(scene, 1);
  for (int k = 0; k < 40; ++k) simulation.step();
  RobotSetup setup = robot_at({30, 0}, {40, 0});
  setup.time_step = 0.025;
  const RobotId robot = simulation.add_robot(setup);
  EXPECT_LT(simulation.next_decision({9}) - simulation.time(), 0.025);
  simulation.remove_robot({3});
  while (simulation.can_step_by(20.0)) simulation.step();
  EXPECT_TRUE(simulation.is_at_goal({9}));
  EXPECT_EQ(simulation.fleet().id[8], robot);
  EXPECT_EQ(simulation.planner({9}).options().time_step, 0.025);
  EXPECT_EQ(simulation.planner({9}).options().longest_step, 0.1);
}

// A robot in the midst of a step cannot brake before it ends.
TEST(Clocks, under_a_certificate_no_door_closes) {
  const StaticObstacle door{{{{{30, -1}, {30, 1}}, false}}};
  Scenario scene = crossing(4);
  scene.obstacles = {door};
  Simulation simulation(scene, 1);
  simulation.step();
  EXPECT_THROW(simulation.add_obstacle(door), Error);
  RobotSetup parked = robot_at({50, 0}, {50, 0});
  parked.behavior = Behavior::parked;
  EXPECT_THROW(simulation.add_robot(parked), Error);
  simulation.remove_obstacle({0});
  simulation.step();
  scene.certificate = Certificate::none;
  EXPECT_EQ(Simulation(scene, 1).add_obstacle(door).value, 1u);
}

TEST(Clocks, what_no_clock_can_be_is_refused) {
  Scenario scene = crossing(4);
  EXPECT_EQ(refusal(scene), "");
  const auto with = [&](auto change) {
    Scenario changed = scene;
    change(changed);
    return refusal(changed);
  };
  EXPECT_EQ(with([](Scenario& s) { s.clock = Clock::common; }),
            "robots.0.time_step: found 0.04, must be left out where clock is common");
  EXPECT_EQ(with([](Scenario& s) { s.robots[1].time_step = 1.0 / 30.0; }),
            "robots.1.time_step: found 0.03333333333333333, must be a whole number of nanoseconds "
            "where clock is free, such as 0.033333333 s");
  EXPECT_EQ(with([](Scenario& s) { s.robots[1].time_step = -0.1; }),
            "robots.1.time_step: found -0.1, must be > 0 s");
  EXPECT_EQ(with([](Scenario& s) { s.robots[1].time_step = 2.5; }),
            "robots.1.time_step: found 2.5, must be <= control_time = 2 s where motion is held");
  EXPECT_EQ(with([](Scenario& s) { s.longest_step = 0.05; }),
            "robots.1.time_step: found 0.1, must be <= longest_step = 0.05 s");
  EXPECT_EQ(with([](Scenario& s) { s.motion = Motion::exponential; }),
            "clock: found free, must be common where motion is exponential");
  EXPECT_EQ(with([](Scenario& s) { s.robots[1].model = Car{.body = CarBody{0.5, 0.9}}; }), "");
  EXPECT_EQ(with([](Scenario& s) {
              s.robots[1].model = Airplane{.min_speed = 1.0, .lateral_acceleration = 1.0};
            }),
            "clock: found free, must be common in a scene with airplanes");
  EXPECT_EQ(with([](Scenario& s) { s.sensing = {.delay = 1, .dropped = 0.1, .occlusion = true}; }),
            "");
  EXPECT_EQ(with([](Scenario& s) {
              s.robots[0].behavior = Behavior::parked;
              s.robots[0].goal = s.robots[0].position;
            }),
            "robots.0.time_step: found 0.04, must be left out: it is parked");
  Simulation simulation(scene, 1);
  RobotSetup slow = robot_at({90, 0}, {90, 0});
  slow.time_step = 0.2;
  EXPECT_THROW(simulation.add_robot(slow), Error);
}

// A step of 0.8 s is taken in parts. The axle is on the arc of the whole step, and its speed
// changes evenly. This holds forwards and backwards, and with a disc ahead of the axle.
TEST(Clocks, in_the_midst_of_a_step_a_car_is_on_its_arc) {
  constexpr double kLongStep = 0.8;
  Random random(3);
  for (int n = 0; n < 2000; ++n) {
    Car car{.wheelbase = 0.7};
    car.reverse = n % 2 == 1;
    const double offset = n % 3 == 0 ? 0.4 : 0.0;
    if (offset != 0.0) car.body = CarBody{offset, 0.6};
    const double heading = random.uniform(-3.0, 3.0);
    const double speed = n % 5 == 0 ? 0.0 : random.uniform(car.reverse ? -2.0 : 0.0, 2.0);
    const auto along = [](double angle) { return Vec2{std::cos(angle), std::sin(angle)}; };
    const MotionState from{{1.0, 2.0}, speed * along(heading), heading};
    Plan plan;
    plan.acceleration = test::in_disc(random, 1.0);
    plan.new_velocity = from.velocity + 2.0 * plan.acceleration;
    const MotionState to = advance(car, {1.0, 2.0}, from, plan, kLongStep).next;
    const auto axle = [&](const MotionState& at) {
      return at.position - offset * along(at.heading);
    };
    MotionState last = from;
    double turn = 0.0;
    for (int k = 1; k <= 64; ++k) {
      const double time = kLongStep * k / 64.0;
      const MotionState now = k == 64 ? to : within(MotionModel(car), from, to, time, kLongStep);
      turn += std::remainder(now.heading - last.heading, 2.0 * std::numbers::pi);
      const double speeds = norm(now.velocity) + norm(last.velocity);
      EXPECT_LE(norm(axle(now) - axle(last)), speeds * kLongStep / 128.0 + 1e-9) << n << ' ' << k;
      EXPECT_NEAR(cross(now.velocity, along(now.heading)), 0.0, 1e-9);
      EXPECT_LE(norm(now.velocity - last.velocity), 1.5 * kLongStep / 64.0 + 1e-9) << n << ' ' << k;
      last = now;
      if (norm(axle(to) - axle(from)) > 1e-12) continue;
      const double part = k / 64.0;  // its disc leaves at rest
      const double whole = std::remainder(to.heading - heading, 2.0 * std::numbers::pi);
      EXPECT_NEAR(turn, (offset != 0.0 ? part * part : part) * whole, 1e-9);
    }
    EXPECT_NEAR(turn, std::remainder(to.heading - heading, 2.0 * std::numbers::pi), 1e-9);
  }
}

// They decide what would turn them by more than half a turn within a step. Seen every 10 ms, they
// come no farther than their speeds lead.
TEST(Clocks, cars_with_weak_brakes_do_not_jump) {
  Random random(6);
  double sharpest = 0.0;  // rad, in a step
  for (int n = 0; n < 60; ++n) {
    Scenario scene;
    scene.clock = Clock::free;
    scene.time_step = 0.5;
    scene.seed = static_cast<std::uint64_t>(n);
    RobotSetup car = robot_at({}, {});
    car.model = Car{};
    car.max_acceleration = random.uniform(2.0, 6.0);
    car.max_braking = car.max_acceleration * random.uniform(0.05, 0.12);
    car.max_speed = car.preferred_speed = 0.5 * car.max_acceleration * random.uniform(0.3, 1.0);
    car.heading = random.uniform(-3.0, 3.0);
    car.goal = 20.0 * random.direction();
    const Vec2 ahead{std::cos(car.heading), std::sin(car.heading)};
    car.velocity = 0.5 * car.max_acceleration * random.uniform(0.05, 0.2) * ahead;
    RobotSetup observer = robot_at({500, 0}, {500, 0});
    observer.time_step = 0.01;
    scene.sensing_radius = 2000.0;
    scene.response_time = 0.0;  // the sharpest turns
    scene.robots = {car, observer};
    Simulation simulation(scene, 1);
    Vec2 place = car.position;
    double speed = norm(car.velocity), time = 0.0, turn = 0.0, heading = car.heading;
    for (int k = 0; k < 200; ++k) {
      simulation.step();
      const FleetView fleet = simulation.fleet();
      const double next_speed = norm(fleet.velocity[0]), elapsed = simulation.time() - time;
      ASSERT_LE(norm(fleet.position[0] - place),
                0.5 * (speed + next_speed) * elapsed * (1.0 + 1e-9) + 1e-9)
          << "car " << n << " at " << simulation.time() << " s";
      if (simulation.decided({0})) turn = 0.0;
      turn += std::remainder(fleet.heading[0] - heading, 2.0 * std::numbers::pi);
      sharpest = std::max(sharpest, std::abs(turn));
      heading = fleet.heading[0];
      place = fleet.position[0], speed = next_speed, time = simulation.time();
    }
  }
  EXPECT_GT(sharpest, 2.5);
}

TEST(Clocks, metrics_count_each_decision_once) {
  const Scenario scene = crossing(9);
  Simulation simulation(scene, 1);
  Metrics metrics(scene);
  metrics.observe(simulation);
  std::int64_t decided = 0;
  while (simulation.can_step_by(12.0)) {
    simulation.step();
    metrics.observe(simulation);
    for (std::size_t i = 0; i < 9; ++i) decided += simulation.decided({i}) ? 1 : 0;
  }
  const RunSummary summary = metrics.summary();
  const Decisions& d = summary.decisions;
  EXPECT_EQ(d.optimal + d.least_unsafe + d.refused + d.detour + d.braking + d.overlapping, decided);
  EXPECT_EQ(summary.arrived, 9);
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_LE(summary.max_acceleration, 1.0 + 1e-9);
}

}  // namespace
}  // namespace avo
