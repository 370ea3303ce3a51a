// SPDX-License-Identifier: Apache-2.0
// Car-like robots (paper §V): the arc of Eq. (24) against fine integration, and the rules at rest.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>
#include <vector>

#include "avo/simulation.h"
#include "robots/model.h"
#include "support/generators.h"
#include "support/wheels.h"

namespace avo {
namespace {

using test::angle_between;
using test::Random;

struct CarState {
  double x, y, heading, speed;
};

// Eq. (24) with held controls.
CarState derivative(const CarState& s, double linear, double curvature) {
  return {s.speed * std::cos(s.heading), s.speed * std::sin(s.heading), s.speed * curvature,
          linear};
}

CarState moved(const CarState& s, double h, const CarState& d) {
  return {s.x + h * d.x, s.y + h * d.y, s.heading + h * d.heading, s.speed + h * d.speed};
}

// Runge-Kutta of order four over `time`.
CarState integrated(CarState s, double linear, double curvature, double time, int steps) {
  const double h = time / steps;
  for (int k = 0; k < steps; ++k) {
    const CarState a = derivative(s, linear, curvature);
    const CarState b = derivative(moved(s, h / 2, a), linear, curvature);
    const CarState c = derivative(moved(s, h / 2, b), linear, curvature);
    const CarState d = derivative(moved(s, h, c), linear, curvature);
    s = moved(moved(moved(moved(s, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
  }
  return s;
}

constexpr MotionLimits kLimits{.planned_braking = 1.0, .max_speed = 2.0};
constexpr double kWheelbase = 0.8;

MotionStep advance_car(const MotionState& state, const Plan& plan, double time_step) {
  return advance(Car{.wheelbase = kWheelbase}, kLimits, state, plan, time_step);
}

struct Drive {
  MotionState state;
  double speed;
  Plan plan;
};

// Any plan within the limits of a car of v_max 2, a_max 1 with δ = 4.
Drive random_drive(Random& random, double least_speed) {
  Drive drive;
  drive.state.position = test::in_disc(random, 10.0);
  drive.state.heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  drive.speed = random.uniform(least_speed, 2.0);
  drive.state.velocity =
      drive.speed * Vec2{std::cos(drive.state.heading), std::sin(drive.state.heading)};
  do {
    drive.plan.new_velocity = test::in_disc(random, 2.0);
    drive.plan.acceleration = (drive.plan.new_velocity - drive.state.velocity) / 4.0;
  } while (norm(drive.plan.acceleration) > 1.0);
  return drive;
}

TEST(Car, drives_the_arc_of_Eq_24_with_the_controls_of_Eq_25) {
  Random random(24);
  int turns = 0;
  for (int k = 0; k < 3'000 && !HasFailure(); ++k) {
    const Drive drive = random_drive(random, 0.3);
    const Vec2 ahead{std::cos(drive.state.heading), std::sin(drive.state.heading)};
    const double dt = 0.1;
    const double linear = dot(ahead, drive.plan.acceleration);
    const double top = std::max(drive.speed, drive.speed + linear * dt);
    const double curvature = cross(ahead, drive.plan.acceleration) / (top * top);
    const CarState expected = integrated(
        {drive.state.position.x, drive.state.position.y, drive.state.heading, drive.speed}, linear,
        curvature, dt, 50);
    const MotionStep step = advance_car(drive.state, drive.plan, dt);
    EXPECT_NEAR(step.next.position.x, expected.x, 2e-5);
    EXPECT_NEAR(step.next.position.y, expected.y, 2e-5);
    EXPECT_LT(angle_between(step.next.heading, expected.heading), 1e-10);
    EXPECT_NEAR(norm(step.next.velocity), expected.speed, 1e-12);
    if (std::abs(curvature) > 0.1) ++turns;
  }
  EXPECT_GT(turns, 1'000);
}

// With a constant speed the path is a circle, in closed form.
TEST(Car, constant_speed_is_a_circle) {
  MotionState state{{0, 0}, {1.5, 0}, 0.0};
  Plan plan;
  plan.acceleration = {0, 0.9};  // κ = 0.4 / m
  plan.new_velocity = {1.5, 3.6};
  const MotionStep step = advance_car(state, plan, 0.1);
  const double angle = 0.4 * 1.5 * 0.1;
  EXPECT_NEAR(step.next.position.x, std::sin(angle) / 0.4, 1e-15);
  EXPECT_NEAR(step.next.position.y, (1.0 - std::cos(angle)) / 0.4, 1e-15);
  EXPECT_NEAR(step.next.heading, angle, 1e-15);
  EXPECT_NEAR(step.acceleration, 0.9, 1e-15);
}

// The struct has a car of any kind, and one of its decisions.
struct AnyDrive {
  Car car;
  MotionState state;   // of the disc
  double speed = 0.0;  // signed
  Plan plan;
};

AnyDrive any_drive(Random& random) {
  AnyDrive any;
  any.car.wheelbase = 1.0;
  any.car.reverse = random.below(2) == 0;
  any.car.body = CarBody{random.uniform(-1.5, 1.5), 1.0};
  if (random.below(4) != 0) any.car.max_curvature = random.log_uniform(0.1, 2.0);
  const Drive drive = random_drive(random, 0.0);
  any.state = drive.state, any.plan = drive.plan, any.speed = drive.speed;
  if (any.car.reverse && random.below(2) == 0) {
    any.state.velocity = -any.state.velocity, any.speed = -any.speed;
    any.plan.new_velocity = any.state.velocity + 4.0 * any.plan.acceleration;
  }
  return any;
}

// Where a disc ahead of the axle is, from fine integration of Eq. (24) for the axle.
TEST(Car, bend_bounds_the_way_of_a_disc_ahead_of_the_axle) {
  Random random(31);
  int turns = 0, backwards = 0;
  double tightest = 0.0;
  const double dt = 0.1;
  for (int k = 0; k < 5'000 && !HasFailure(); ++k) {
    const AnyDrive any = any_drive(random);
    const double e = any.car.body->offset;
    const MotionStep step = advance(any.car, kLimits, any.state, any.plan, dt);
    const Vec2 h{std::cos(any.state.heading), std::sin(any.state.heading)};
    const double next =
        dot(step.next.velocity, {std::cos(step.next.heading), std::sin(step.next.heading)});
    const double way = 0.5 * (any.speed + next) * dt;
    const double turn =
        std::remainder(step.next.heading - any.state.heading, 2.0 * std::numbers::pi);
    if (std::abs(way) < 1e-6) continue;  // turns in place, or stands
    const Vec2 axle = any.state.position - e * h;
    const Vec2 first = any.state.velocity + step.swing;
    const Vec2 rest = step.next.position - any.state.position - dt * first;
    const double linear = (next - any.speed) / dt, curvature = turn / way;
    double length = 0.0;
    Vec2 last = any.state.position;
    for (int part = 1; part <= 10; ++part) {
      const double t = 0.1 * part * dt;
      const CarState s =
          integrated({axle.x, axle.y, any.state.heading, any.speed}, linear, curvature, t, 20);
      const Vec2 disc = Vec2{s.x, s.y} + e * Vec2{std::cos(s.heading), std::sin(s.heading)};
      const Vec2 parabola = any.state.position + t * first + (t / dt) * (t / dt) * rest;
      const double allowed = step.bend * (t / dt) * (t / dt);
      EXPECT_LE(norm(disc - parabola), allowed + 1e-12);
      tightest = std::max(tightest, norm(disc - parabola) / (allowed + 1e-9));
      length += norm(disc - last);
      last = disc;
    }
    EXPECT_LE(length, step.length + 1e-12);
    EXPECT_LT(norm(last - step.next.position), 1e-9);
    EXPECT_LE(std::abs(curvature), any.car.max_curvature.value_or(1e9) + 1e-6);
    EXPECT_TRUE(any.car.reverse || next >= -1e-15);
    EXPECT_GE(next * any.speed, -1e-15) << "turns back within a step";
    turns += std::abs(turn) > 1e-3 ? 1 : 0, backwards += any.speed < 0.0 ? 1 : 0;
  }
  EXPECT_GT(turns, 1'000);
  EXPECT_GT(backwards, 500);
  EXPECT_GT(tightest, 0.3);
}

// Seen from its rear, a car that drives backwards drives forward.
TEST(Car, drives_backwards_as_it_drives_forward) {
  Random random(32);
  for (int k = 0; k < 2'000 && !HasFailure(); ++k) {
    const Drive drive = random_drive(random, 0.2);
    Car car{.wheelbase = 1.0, .max_curvature = 0.7, .body = CarBody{0.6, 1.0}, .reverse = true};
    const MotionStep forward = advance(car, kLimits, drive.state, drive.plan, 0.1);
    MotionState turned = drive.state;
    turned.heading = std::remainder(turned.heading + std::numbers::pi, 2.0 * std::numbers::pi);
    car.body->offset = -0.6;
    const MotionStep backward = advance(car, kLimits, turned, drive.plan, 0.1);
    EXPECT_LT(norm(forward.next.position - backward.next.position), 1e-14);
    EXPECT_LT(norm(forward.next.velocity - backward.next.velocity), 1e-14);
    EXPECT_NEAR(angle_between(forward.next.heading, backward.next.heading), std::numbers::pi,
                1e-12);
    EXPECT_LT(norm(forward.swing - backward.swing), 1e-14);
  }
}

// Fig. 6(b): what the half-planes of the exact set admit is what Eq. (25) can be solved for.
TEST(Car, own_half_planes_are_the_square_of_Eq_25) {
  Random random(33);
  const double time = 0.1;
  int within = 0, beyond_the_disc = 0;
  for (int k = 0; k < 20'000; ++k) {
    const double curvature = random.log_uniform(0.1, 2.0);
    Robot robot;
    robot.model = Car{.max_curvature = curvature, .acceleration_set = AccelerationSet::exact};
    robot.heading = random.uniform(-3.0, 3.0);
    const Vec2 h{std::cos(robot.heading), std::sin(robot.heading)};
    const double speed = random.uniform(0.0, 2.0);
    robot.velocity = speed * h;
    const Vec2 a = test::in_disc(random, 2.0);
    std::vector<HalfPlane> planes;
    append_own_half_planes(robot, time, planes);
    ASSERT_EQ(planes.size(), 4u);
    const bool admitted = std::all_of(planes.begin(), planes.end(), [&](const HalfPlane& plane) {
      return violation(plane, robot.velocity + time * a) <= 0.0;
    });
    const double across = std::min(1.0, speed * speed * curvature);
    EXPECT_EQ(admitted, std::abs(dot(h, a)) <= 1.0 && std::abs(cross(h, a)) <= across);
    within += admitted ? 1 : 0, beyond_the_disc += admitted && norm(a) > 1.0 ? 1 : 0;
  }
  EXPECT_GT(within, 1'000);
  EXPECT_GT(beyond_the_disc, 100);
}

TEST(Car, limits_hold_all_through_the_step) {
  Random random(25);
  for (int k = 0; k < 50'000 && !HasFailure(); ++k) {
    const Drive drive = random_drive(random, 0.0);
    const double dt = random.log_uniform(0.01, 1.0);
    const MotionStep step = advance_car(drive.state, drive.plan, dt);
    EXPECT_LE(step.acceleration, 1.0 + 1e-12);
    const double speed = norm(step.next.velocity);
    EXPECT_LE(speed, 2.0 + 1e-12);
    EXPECT_LE(std::abs(speed - drive.speed), 1.0 * dt + 1e-12);
    // forwards, along the heading
    const Vec2 ahead{std::cos(step.next.heading), std::sin(step.next.heading)};
    EXPECT_NEAR(dot(ahead, step.next.velocity), speed, 1e-14);
    EXPECT_LE(std::abs(step.next.heading), std::numbers::pi);
    // |v² κ| follows from what happened: it is the angle turned over the path driven
    const double way = norm(step.next.position - drive.state.position);
    const double turned = angle_between(step.next.heading, drive.state.heading);
    const double top = std::max(speed, drive.speed);
    if (way > 1e-6 && turned < 2.0) {
      const double arc = turned > 1e-6 ? way * (turned / 2) / std::sin(turned / 2) : way;
      const double lateral = top * top * turned / arc;
      EXPECT_LE(lateral, 1.0 + 1e-6);
      EXPECT_NEAR(std::max(lateral, std::abs(speed - drive.speed) / dt), 0.0,
                  step.acceleration + 1e-6);
    }
  }
}

TEST(Car, stops_within_the_step_and_does_not_reverse) {
  MotionState state{{1, 2}, {0, 0.05}, std::numbers::pi / 2};
  Plan plan;
  plan.acceleration = {0, -1};
  plan.new_velocity = {0, -3.95};
  const MotionStep step = advance_car(state, plan, 0.1);
  EXPECT_EQ(norm(step.next.velocity), 0.0);
  EXPECT_EQ(step.next.heading, state.heading);
  EXPECT_GE(step.next.position.y, 2.0);
  EXPECT_LE(step.next.position.y, 2.0 + 0.05 * 0.1);
  EXPECT_LE(step.acceleration, 1.0);
}

// Only commands beyond what it needs get there: it brakes until the end of the step.
TEST(Car, stops_at_the_end_of_a_step_at_the_earliest) {
  MotionState state{{0, 0}, {0.15, 0}, 0.0};
  Plan plan;
  plan.acceleration = {-3, 0};
  plan.new_velocity = {-0.15, 0};
  const MotionStep step = advance_car(state, plan, 0.1);
  EXPECT_NEAR(step.next.position.x, 0.5 * 0.15 * 0.1, 1e-15);
  EXPECT_EQ(norm(step.next.velocity), 0.0);
  EXPECT_NEAR(step.acceleration, 1.5, 1e-12);
}

// It has to turn by more than kTurnInPlace, and is slower than one step of braking takes away.
TEST(Car, that_has_to_turn_in_place_stops_first) {
  for (const double angle : {0.4, 1.5, 3.0, -0.4, -1.5, -3.0}) {
    for (const double speed : {1e-3, 0.02, 0.06}) {
      const Vec2 heading{std::cos(1.0), std::sin(1.0)};
      const MotionState state{{4, 5}, speed * heading, 1.0};
      Plan plan;
      plan.new_velocity = 1.2 * Vec2{std::cos(1.0 + angle), std::sin(1.0 + angle)};
      plan.acceleration = 0.25 * (plan.new_velocity - state.velocity);
      const MotionStep step = advance_car(state, plan, 0.1);
      EXPECT_EQ(step.next.velocity, Vec2{});
      EXPECT_EQ(step.next.heading, 1.0) << "it stands before it turns";
      EXPECT_LT(norm(step.next.position - (state.position + (0.05 * speed) * heading)), 1e-12);
      EXPECT_LE(step.acceleration, 1.0);
    }
  }
}

TEST(Car, at_rest_turns_in_place_at_a_bounded_rate) {
  for (const double angle : {0.5, 1.5, 3.0, -0.5, -1.5, -3.0}) {
    MotionState state{{4, 5}, {0, 0}, 1.0};
    Plan plan;
    plan.new_velocity = 1.2 * Vec2{std::cos(1.0 + angle), std::sin(1.0 + angle)};
    plan.acceleration = 0.25 * plan.new_velocity;
    const double most = 2.0 / 0.8 * 0.1;  // front axle at v_max, a wheelbase ahead
    int steps = 0;
    while (angle_between(state.heading, 1.0 + angle) > 0.25 && steps < 100) {
      const MotionStep step = advance_car(state, plan, 0.1);
      EXPECT_EQ(step.next.position, state.position);
      EXPECT_EQ(step.next.velocity, Vec2{});
      EXPECT_EQ(step.acceleration, 0.0);
      const double turned = std::remainder(step.next.heading - state.heading, 2 * std::numbers::pi);
      EXPECT_LE(std::abs(turned), most * (1.0 + 1e-12));
      EXPECT_GT(turned * angle, 0.0) << "the short way round";
      state = step.next;
      ++steps;
    }
    EXPECT_LE(steps, static_cast<int>(std::abs(angle) / most) + 1);
  }
}

TEST(Car, at_rest_without_a_wish_stays_as_it_is) {
  const MotionState state{{4, 5}, {0, 0}, 1.0};
  const MotionStep step = advance_car(state, Plan{}, 0.1);
  EXPECT_EQ(step.next.position, state.position);
  EXPECT_EQ(step.next.heading, state.heading);
  EXPECT_EQ(step.next.velocity, Vec2{});
}

// What is left of a speed by rounding is halved by rounding in each step, for ever. The sign of
// this rest would say in which direction the car drives.
TEST(Car, that_brakes_to_rest_has_no_speed_left) {
  Random random(41);
  for (int k = 0; k < 20'000; ++k) {
    const double heading = random.uniform(-4.0, 4.0), speed = random.log_uniform(1e-12, 0.1);
    const Vec2 along{std::cos(heading), std::sin(heading)};
    const Car car{.wheelbase = kWheelbase,
                  .max_curvature = random.below(2) == 0 ? std::optional(0.8) : std::nullopt,
                  .reverse = random.below(2) == 0};
    const Vec2 v = (car.reverse && random.below(2) == 0 ? -speed : speed) * along;
    const double control_time = random.log_uniform(0.1, 4.0);
    const Vec2 target = v - (control_time / 0.1) * v;  // Eq. (7): rest at the end of the step
    const Plan plan{.new_velocity = target, .acceleration = (target - v) / control_time};
    const MotionStep step = advance(car, kLimits, {{}, v, heading}, plan, 0.1);
    ASSERT_EQ(step.next.velocity, Vec2{}) << speed;
    ASSERT_LE(step.acceleration, 1.0);
  }
}

// Nor does a decision of no more than rounding move or turn it.
TEST(Car, at_rest_stays_at_rest_where_nothing_is_decided) {
  for (const double angle : {0.0, 0.1, 2.0, 3.1}) {
    const Vec2 wish{std::cos(angle), std::sin(angle)};
    for (const bool reverse : {false, true}) {
      for (const double speed : {1e-163, 1e-30, 1e-15, 1e-12}) {
        const Car car{.wheelbase = kWheelbase, .reverse = reverse};
        const Plan plan{.new_velocity = (2.0 * speed) * wish, .acceleration = speed * wish};
        const MotionState rest{{3.0, 4.0}, {}, 0.0};
        const MotionStep step = advance(car, kLimits, rest, plan, 0.1);
        EXPECT_EQ(step.next.velocity, Vec2{});
        EXPECT_EQ(step.next.position, rest.position);
        EXPECT_EQ(step.next.heading, 0.0);
      }
    }
  }
}

// No car creeps: a car that is slower than a decision means is at rest. No car at rest at its goal
// turns for ever.
TEST(Car, in_a_crowd_comes_to_rest_or_moves) {
  const CarBody ahead{0.4, 0.5};
  for (const Car& car : {Car{.wheelbase = 1.0}, Car{.wheelbase = 1.0, .body = ahead},
                         Car{.wheelbase = 1.0, .max_curvature = 0.8},
                         Car{.wheelbase = 1.0, .max_curvature = 0.8, .body = ahead},
                         Car{.wheelbase = 1.0, .max_curvature = 0.8, .reverse = true},
                         Car{.wheelbase = 1.0,
                         .max_curvature = 0.8,
                         .body = ahead,
                         .reverse = true,
                         .acceleration_set = AccelerationSet::exact}}) {
    Random random(7);
    Scenario scene;
    scene.sensing_radius = 12.0;
    for (int k = 0; k < 25; ++k) {
      RobotSetup robot;
      robot.position = {2.6 * (k % 5), 2.6 * static_cast<double>(k / 5)};
      const int goal = (7 * k + 3) % 25;
      robot.goal = {2.6 * (goal % 5), 2.6 * static_cast<double>(goal / 5)};
      robot.model = car, robot.heading = random.uniform(-3.0, 3.0);
      scene.robots.push_back(robot);
    }
    Simulation simulation(scene, 1);
    int turning = 0, creeping = 0;
    std::vector<bool> crept(25, false);
    for (int step = 0; step < 1500; ++step) {
      const auto before = simulation.fleet();
      const std::vector<double> heading(before.heading.begin(), before.heading.end());
      simulation.step();
      for (std::size_t i = 0; i < heading.size(); ++i) {
        const Vec2 v = simulation.fleet().velocity[i];
        const double speed = std::hypot(v.x, v.y);
        const bool creeps = speed > 0.0 && speed < 5e-11;
        creeping += creeps && crept[i] ? 1 : 0;
        crept[i] = creeps;
        const bool rests = speed == 0.0 && simulation.is_at_goal({i}) && step >= 1250;
        turning += rests && simulation.fleet().heading[i] != heading[i] ? 1 : 0;
      }
    }
    EXPECT_EQ(creeping, 0);
    EXPECT_LE(turning, 40) << "of 6250";
  }
}

Scenario lone_car(Vec2 goal, double heading, double speed) {
  Scenario scenario;
  scenario.method = Method::avo_paper;
  RobotSetup setup;
  setup.model = Car{kWheelbase}, setup.heading = heading;
  setup.velocity = {speed, 0};
  setup.goal = goal;
  scenario.robots = {setup};
  return scenario;
}

TEST(Car, reaches_goals_behind_and_beside_it_and_rests_there) {
  for (const double speed : {0.0, 1.0, 2.0}) {
    for (const Vec2 goal : {Vec2{-10, 0}, Vec2{0, 8}, Vec2{-6, -6}, Vec2{15, 1}, Vec2{0.7, 2}}) {
      for (const double delta : {0.5, 4.0}) {
        Scenario scenario = lone_car(goal, 0.0, speed);
        scenario.control_time = delta;
        Simulation simulation(scenario, 1);
        double nearest = norm(goal);
        for (int k = 0; k < 1500; ++k) {
          simulation.step();
          nearest = std::min(nearest, norm(simulation.fleet().position[0] - goal));
          ASSERT_LE(simulation.fleet().applied_acceleration[0], 1.0 + 1e-9);
          ASSERT_LE(norm(simulation.fleet().velocity[0]), 2.0 + 1e-9);
        }
        EXPECT_LT(nearest, scenario.arrival_distance)
            << "goal " << goal.x << " " << goal.y << " speed " << speed << " delta " << delta;
        EXPECT_TRUE(simulation.all_at_goal())
            << "goal " << goal.x << " " << goal.y << " speed " << speed << " delta " << delta;
        EXPECT_LT(norm(simulation.fleet().velocity[0]), 1e-6);
      }
    }
  }
}

// Cars of all kinds; brakes down to a hundredth of a_max, and steps of up to 10 s.
TEST(Car, the_ends_of_a_step_tell_the_way_between) {
  Random random(17);
  int sharp = 0;
  for (int i = 0; i < 20'000; ++i) {
    Car car;
    if (random.below(2) == 0) car.body = CarBody{random.uniform(-0.8, 0.8), 0.5};
    if (random.below(3) == 0) car.max_curvature = random.log_uniform(0.1, 10.0);
    car.reverse = random.below(2) == 0;
    const double time_step = random.log_uniform(0.02, 10.0), a_max = 1.0;
    const MotionLimits limits{random.log_uniform(0.01, 1.0), 3.0};
    MotionState from;
    from.heading = random.uniform(-3.1, 3.1);
    const Vec2 ahead{std::cos(from.heading), std::sin(from.heading)};
    const double sign = car.reverse && random.below(2) == 0 ? -1.0 : 1.0;
    const double speed = random.below(4) == 0 ? 0.0 : random.log_uniform(1e-3, 3.0);
    from.velocity = sign * speed * ahead;
    Plan plan;
    plan.acceleration = test::in_disc(random, a_max);
    plan.new_velocity = from.velocity + time_step * plan.acceleration;
    const MotionStep step = advance(car, limits, from, plan, time_step);
    const MotionState& to = step.next;
    const double turn = std::remainder(to.heading - from.heading, 2.0 * std::numbers::pi);
    EXPECT_LE(std::abs(turn), 3.0 + 1e-9);
    sharp += std::abs(turn) > 2.99 ? 1 : 0;
    // the car comes to the end of the step, on a path no longer than the step says
    const MotionState end = within(car, from, to, time_step * (1.0 - 1e-12), time_step);
    const double scale = 1.0 + step.length;
    ASSERT_NEAR(norm(end.position - to.position), 0.0, 1e-9 * scale) << "car " << i;
    ASSERT_NEAR(norm(end.velocity - to.velocity), 0.0, 1e-9 * scale) << "car " << i;
    double way = 0.0;
    MotionState before = from;
    for (int k = 1; k < 64; ++k) {
      const MotionState now = within(car, from, to, time_step * k / 64.0, time_step);
      way += norm(now.position - before.position);
      before = now;
    }
    ASSERT_LE(way, step.length * (1.0 + 1e-9) + 1e-12) << "car " << i;
  }
  EXPECT_GT(sharp, 200);
}

}  // namespace
}  // namespace avo
