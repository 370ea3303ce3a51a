// SPDX-License-Identifier: Apache-2.0
// The answers for these states are known by hand. A decision says of its state what the query says.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "avo/planner.h"
#include "avo/simulation.h"
#include "support/generators.h"

namespace avo {
namespace {

// Radius 0.5 m, 2 m/s to the right, 1 m/s²: it stops in 2 m.
Robot driving() {
  return {.velocity = {2.0, 0.0}, .preferred_velocity = {2.0, 0.0}};
}

// Towards it, the discs `gap` m apart.
Neighbor oncoming(double gap, double speed, Behavior behavior = Behavior::decides) {
  return {.position = {1.0 + gap, 0.0}, .velocity = {-speed, 0.0}, .behavior = behavior};
}

SafetyReport state_of(const Robot& robot, const std::vector<Neighbor>& neighbors,
                      const std::vector<Wall>& walls = {}, const PlannerOptions& options = {}) {
  PlanWorkspace workspace;
  return Planner(options).state(robot, neighbors, workspace, walls);
}

// The wall stands across the robot's course, `gap` m before its disc, and reaches `half_length` m
// to both sides.
Wall across(double gap, double half_length) {
  return {{0.5 + gap, -half_length}, {0.5 + gap, half_length}};
}

TEST(StateQuery, a_wall_dooms_who_cannot_brake_before_it) {
  EXPECT_EQ(state_of(driving(), {}, {across(2.001, 9.0)}).state, SafetyState::safe);
  const SafetyReport report = state_of(driving(), {}, {across(9.0, 9.0), across(1.99, 9.0)});
  EXPECT_EQ(report.state, SafetyState::doomed);
  EXPECT_EQ(report.wall, 1);
  EXPECT_EQ(report.neighbor, -1);
  EXPECT_NEAR(report.time, 2.0 - std::sqrt(4.0 - 2.0 * 1.99), 1e-6);
}

TEST(StateQuery, who_may_get_past_the_end_of_a_wall_is_not_doomed) {
  EXPECT_EQ(state_of(driving(), {}, {across(1.9, 4.0)}).state, SafetyState::doomed);
  EXPECT_EQ(state_of(driving(), {}, {across(1.9, 0.3)}).state, SafetyState::unknown);
  Robot oblique = driving();
  oblique.velocity = {1.6, 1.2};  // slides past the upper end before it comes to the wall
  EXPECT_EQ(state_of(oblique, {}, {{{1.4, -9.0}, {1.4, 9.0}}}).state, SafetyState::doomed);
  EXPECT_EQ(state_of(oblique, {}, {{{1.4, -9.0}, {1.4, 0.7}}}).state, SafetyState::unknown);
}

// At 2 m/s each, head-on: together they take off 2 m/s², and stop within 4 m.
TEST(StateQuery, one_that_decides_is_taken_to_do_its_best) {
  EXPECT_EQ(state_of(driving(), {oncoming(4.01, 2.0)}).state, SafetyState::safe);
  EXPECT_EQ(state_of(driving(), {oncoming(3.2, 2.0)}).state, SafetyState::unknown);  // aside
  const SafetyReport report = state_of(driving(), {oncoming(2.0, 2.0)});
  EXPECT_EQ(report.state, SafetyState::doomed);
  EXPECT_EQ(report.neighbor, 0);
  EXPECT_EQ(state_of(driving(), {oncoming(4.01, 2.0, Behavior::moves_on)}).state,
            SafetyState::doomed);
  EXPECT_EQ(state_of(driving(), {oncoming(5.5, 2.0, Behavior::moves_on)}).state,
            SafetyState::unknown);
}

TEST(StateQuery, one_that_may_do_something_else_dooms_more_rarely) {
  Neighbor person = oncoming(4.01, 2.0, Behavior::moves_on), exact = oncoming(2.7, 2.0);
  EXPECT_EQ(state_of(driving(), {person}).state, SafetyState::doomed);
  person.max_deviation = 3.0;  // it may stop, or step aside
  EXPECT_EQ(state_of(driving(), {person}).state, SafetyState::unknown);
  EXPECT_EQ(state_of(driving(), {exact}).state, SafetyState::doomed);
  exact.max_deviation = 1.5;
  EXPECT_EQ(state_of(driving(), {exact}).state, SafetyState::unknown);
}

Neighbor loitering_about(Vec2 center) {
  Neighbor airplane;
  airplane.position = center + Vec2{0.0, 1.0}, airplane.velocity = {1.0, 0.0};
  airplane.loiter = LoiterCircle{center, 1.0};
  return airplane;
}

TEST(StateQuery, nobody_is_safe_within_the_circle_of_an_airplane) {
  Robot robot;
  EXPECT_EQ(state_of(robot, {loitering_about({5.0, 0.0})}).state, SafetyState::safe);
  EXPECT_EQ(state_of(robot, {loitering_about({1.0, 0.0})}).state, SafetyState::unknown);
  PlannerOptions free;
  free.clock = Clock::free;  // which it cannot have among airplanes
  EXPECT_EQ(state_of(robot, {loitering_about({5.0, 0.0})}, {}, free).state, SafetyState::unknown);
}

// It turns faster than its acceleration says.
TEST(StateQuery, an_airplane_dooms_nobody_and_is_never_doomed) {
  EXPECT_EQ(state_of(Robot{}, {oncoming(-0.5, 0.0)}).state, SafetyState::doomed);
  EXPECT_EQ(state_of(Robot{}, {loitering_about({0.5, -1.0})}).state, SafetyState::unknown);
  Robot airplane = driving();
  airplane.model = Airplane{.min_speed = 1.0};
  EXPECT_EQ(state_of(airplane, {}).state, SafetyState::safe);
  EXPECT_EQ(state_of(airplane, {oncoming(-0.5, 0.0)}).state, SafetyState::unknown);
  EXPECT_EQ(state_of(airplane, {}, {across(0.1, 90.0)}).state, SafetyState::unknown);
}

// What no proof speaks of: one that is seen late, does as it likes, or is not on its circle.
TEST(StateQuery, an_airplane_that_cannot_be_one_is_invalid) {
  const Planner planner{PlannerOptions{}};
  PlanWorkspace workspace;
  const auto status = [&](auto change) {
    std::vector<Neighbor> seen{loitering_about({5.0, 0.0})};
    change(seen[0]);
    return planner.plan(Robot{}, seen, workspace).status;
  };
  EXPECT_NE(status([](Neighbor&) {}), PlanStatus::invalid_input);
  EXPECT_EQ(status([](Neighbor& n) { n.age = 1; }), PlanStatus::invalid_input);
  EXPECT_EQ(status([](Neighbor& n) { n.behavior = Behavior::moves_on; }),
            PlanStatus::invalid_input);
  EXPECT_EQ(status([](Neighbor& n) { n.loiter->center.x += 0.1; }), PlanStatus::invalid_input);
  EXPECT_EQ(status([](Neighbor& n) { n.velocity = -1.0 * n.velocity; }),
            PlanStatus::invalid_input);  // it turns left
  Robot airplane;
  airplane.model = Airplane{.min_speed = 1.0, .lateral_acceleration = 29.0};
  airplane.velocity = {1.0, 0.0}, airplane.max_speed = 2.0;
  EXPECT_NE(planner.plan(airplane, {}, workspace).status, PlanStatus::invalid_input);
  airplane.model = Airplane{.min_speed = 1.0, .lateral_acceleration = 60.0};  // 6 rad in a step
  EXPECT_EQ(planner.plan(airplane, {}, workspace).status, PlanStatus::invalid_input);
}

TEST(StateQuery, one_at_rest_is_doomed_where_it_cannot_get_away) {
  Robot slow;
  slow.max_speed = 0.3;
  const Neighbor truck = oncoming(6.0, 4.0, Behavior::moves_on);
  EXPECT_EQ(state_of(slow, {truck}).state, SafetyState::doomed);  // in motion nothing happens
  slow.max_speed = 2.0;
  EXPECT_EQ(state_of(slow, {truck}).state, SafetyState::safe);
  Neighbor turning = truck;
  turning.acceleration = {0.0, 2.0};
  slow.max_speed = 0.3;
  EXPECT_EQ(state_of(slow, {turning}).state, SafetyState::safe);
}

TEST(StateQuery, contact_is_doomed_at_once) {
  const SafetyReport report = state_of(driving(), {oncoming(5.0, 0.0), oncoming(-0.1, 0.0)});
  EXPECT_EQ(report.state, SafetyState::doomed);
  EXPECT_EQ(report.neighbor, 1);
  EXPECT_EQ(report.time, 0.0);
  EXPECT_EQ(state_of(driving(), {}, {across(-0.1, 1.0)}).time, 0.0);
}

TEST(StateQuery, the_contact_that_comes_first_is_named) {
  const SafetyReport later_first = state_of(driving(), {oncoming(2.0, 2.0), oncoming(1.0, 2.0)});
  EXPECT_EQ(later_first.neighbor, 1);
  EXPECT_LT(later_first.time, state_of(driving(), {oncoming(2.0, 2.0)}).time);
  EXPECT_EQ(state_of(driving(), {oncoming(1.0, 2.0), oncoming(-0.1, 2.0)}).neighbor, 1);
  EXPECT_EQ(state_of(driving(), {oncoming(-0.1, 2.0), oncoming(-0.1, 2.0)}).neighbor, 0);
}

TEST(StateQuery, errors_ages_and_free_clocks_leave_more_unknown) {
  const std::vector<Neighbor> near{oncoming(4.01, 2.0)}, lost{oncoming(2.0, 2.0)};
  PlannerOptions wrong, free;
  wrong.sensing_error = {0.3, 0.3};
  free.clock = Clock::free;
  EXPECT_EQ(state_of(driving(), near, {}, wrong).state, SafetyState::unknown);
  EXPECT_EQ(state_of(driving(), lost, {}, wrong).state, SafetyState::unknown);
  EXPECT_EQ(state_of(driving(), near, {}, free).state, SafetyState::unknown);
  EXPECT_EQ(state_of(driving(), lost, {}, free).state, SafetyState::doomed);
  Neighbor old = near[0];
  old.age = 2;
  EXPECT_EQ(state_of(driving(), {old}).state, SafetyState::unknown);
  EXPECT_EQ(state_of(driving(), {oncoming(9.0, 2.0)}, {}, wrong).state, SafetyState::safe);
}

TEST(StateQuery, any_method_is_held_against_braking) {
  for (const Method method :
       {Method::avo, Method::avo_paper, Method::orca, Method::velocity_obstacle,
        Method::orca_clamped, Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    const PlannerOptions options = default_options(method);
    EXPECT_EQ(state_of(driving(), {}, {across(2.001, 9.0)}, options).state, SafetyState::safe);
    EXPECT_EQ(state_of(driving(), {}, {across(1.999, 9.0)}, options).state, SafetyState::doomed);
  }
}

// The disc of such a car moves by more than the acceleration of its axle.
TEST(StateQuery, a_disc_ahead_of_the_axle_is_never_said_to_be_doomed) {
  Robot car = driving();
  car.model = Car{};
  EXPECT_EQ(state_of(car, {}, {across(1.99, 9.0)}).state, SafetyState::doomed);
  car.model = Car{.body = CarBody{0.5, 0.5}};
  EXPECT_EQ(state_of(car, {}, {across(1.99, 9.0)}).state, SafetyState::unknown);
  EXPECT_EQ(state_of(car, {}, {across(2.001, 9.0)}).state, SafetyState::safe);
  car.model = Car{.acceleration_set = AccelerationSet::exact};
  EXPECT_EQ(state_of(car, {}, {across(1.99, 9.0)}).state, SafetyState::unknown);
}

TEST(StateQuery, nothing_is_said_of_bad_numbers) {
  Robot robot = driving();
  robot.velocity.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(state_of(robot, {}).state, SafetyState::unknown);
  const Wall bad{{std::numeric_limits<double>::infinity(), 0.0}, {}};
  EXPECT_EQ(state_of(driving(), {}, {bad}).state, SafetyState::unknown);
  EXPECT_STREQ(to_string(SafetyState::doomed), "doomed");
}

// Robots anywhere, in each other as well, among movers and beside a wall.
Scenario disorder(std::uint64_t seed) {
  test::Random random(seed);
  Scenario scenario{.allow_broken_assumptions = true};
  scenario.seed = seed;
  for (int k = 0; k < 12; ++k) {
    RobotSetup robot;
    robot.position = test::in_disc(random, 5.0);
    robot.velocity = test::in_disc(random, robot.max_speed);
    robot.goal = test::in_disc(random, 5.0);
    scenario.robots.push_back(robot);
  }
  for (int k = 0; k < 3 && seed % 2 == 1; ++k) {
    MovingObstacle mover;
    mover.position = test::in_disc(random, 9.0);
    mover.velocity = -0.4 * mover.position;
    scenario.moving_obstacles.push_back(mover);
  }
  if (seed % 3 == 0) scenario.obstacles = {{{{{{-2.0, 1.0}, {3.0, 2.0}}}}}};
  if (seed % 5 == 0) scenario.sensing.noise = {0.01, 0.02, NoiseDistribution::uniform, {}};
  return scenario;
}

TEST(StateQuery, a_decision_says_the_same_of_its_state) {
  std::vector<int> counts(3);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Simulation simulation(disorder(seed));
    const std::size_t robots = simulation.fleet().id.size();
    for (int step = 0; step < 12; ++step) {
      std::vector<SafetyState> expected;
      PlanWorkspace workspace;
      for (std::size_t i = 0; i < robots; ++i) {
        const auto seen = simulation.perceive({i});
        expected.push_back(
            simulation.planner().state(seen.robot, seen.neighbors, workspace, seen.walls).state);
        Detour detour = seen.detour;
        const Plan plan =
            simulation.planner().plan(seen.robot, seen.neighbors, workspace, &detour, seen.walls);
        EXPECT_EQ(plan.state, expected[i]) << seed << " " << step << " " << i;
        ++counts[static_cast<std::size_t>(plan.state)];
      }
      simulation.step();
      for (std::size_t i = 0; i < robots; ++i)
        EXPECT_EQ(simulation.fleet().plan[i].state, expected[i]) << seed << " " << step << " " << i;
    }
  }
  for (const int count : counts) EXPECT_GT(count, 300);
}

// What the certificate promises.
TEST(StateQuery, a_certified_fleet_stays_safe) {
  Scenario scenario;
  for (int k = 0; k < 12; ++k) {
    RobotSetup robot;
    robot.position = {5.0 * std::cos(0.5236 * k), 5.0 * std::sin(0.5236 * k)};
    robot.goal = -robot.position;
    scenario.robots.push_back(robot);
  }
  for (const Certificate certificate : {Certificate::braking_trajectories, Certificate::none}) {
    scenario.certificate = certificate;
    const SafetyState expected =
        certificate == Certificate::none ? SafetyState::unknown : SafetyState::safe;
    Simulation simulation(scenario);
    for (int step = 0; step < 150; ++step) {
      simulation.step();
      for (const Plan& plan : simulation.fleet().plan) ASSERT_EQ(plan.state, expected) << step;
    }
  }
}

}  // namespace
}  // namespace avo
