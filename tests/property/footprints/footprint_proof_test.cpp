// SPDX-License-Identifier: Apache-2.0
// Every part of the proof in docs/certificate/footprints.md is needed: without it, two robots that
// choose the worst admitted velocities overlap, and with it the same search finds no overlap. The
// judge has its own geometry.
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "avo/checked.h"
#include "certificate/discs.h"
#include "planner/stages/disc_pairs.h"
#include "robots/model.h"
#include "support/certificates.h"

namespace avo::test {
namespace {

// Returns whether A may have that velocity beside B.
using Rule = std::function<bool(const Robot& a, const Neighbor& b, Vec2 next_velocity)>;

CertificateLaw law() {
  return law_of(options_of(Certificate::braking_trajectories, Motion::held, 0.2, 2.0));
}

Neighbor sensed(const Robot& robot) {
  Neighbor other = seen(robot);
  const BrakingPose pose = braking_pose(robot, law().step);
  other.footprint = footprint_of(robot.model);
  other.ahead = pose.ahead, other.spread = pose.spread;
  return other;
}

bool admitted(const Robot& a, const Neighbor& b, Vec2 next_velocity) {
  CertificateConstraints constraints;
  collect_constraints(a, {&b, 1}, law(), constraints);
  return admits(a, next_velocity, law(), constraints);
}

// One disc of the robot, as a robot that moves as it does, and turns about its own center.
Robot alone(const Robot& robot, int k) {
  Robot disc = disc_of(robot, braking_pose(robot, law().step), k);
  if (Car* car = std::get_if<Car>(&disc.model)) car->footprint = {};
  if (auto* drive = std::get_if<DifferentialDrive>(&disc.model)) drive->footprint = {};
  return disc;
}

bool all_alone(const Robot& a, const Neighbor& b, Vec2 next_velocity) {
  for (int k = 0; k < footprint_of(a.model).discs; ++k)
    if (!admitted(alone(a, k), b, next_velocity)) return false;
  return true;
}

struct Body {
  Robot robot;
  RobotSetup setup() const {
    RobotSetup setup;
    setup.position = robot.position - disc_center(robot.model, {}, robot.heading);
    setup.heading = robot.heading, setup.model = robot.model;
    setup.max_speed = robot.max_speed, setup.max_acceleration = robot.max_acceleration;
    return setup;
  }
  CheckedState row(std::int64_t number) const {
    const Vec2 ahead{std::cos(robot.heading), std::sin(robot.heading)};
    return {number, setup().position, robot.velocity,
            CheckedHeading{robot.heading, dot(ahead, robot.velocity)}};
  }
  MotionStep after(Vec2 next_velocity) const {
    return advance(robot.model, {robot.max_acceleration, robot.max_speed},
                   {robot.position, robot.velocity, robot.heading},
                   plan_to(robot, next_velocity, law().step), law().step.time_step);
  }
  void take(const MotionStep& step) {
    robot.position = step.next.position, robot.velocity = step.next.velocity;
    robot.heading = step.next.heading;
  }
};

struct Search {
  std::function<MotionModel(Random&)> model;
  bool from_rest = false;
  int trials = 40, steps = 20;
};

// The gap of the two nearest discs after the step, and after braking as far as that leads nearer.
double gap_after(const Body& a, const MotionStep& step, const Robot& b) {
  Body next = a;
  next.take(step);
  const double now = nearest_discs(discs_of(next.robot, law().step), sensed(b)).gap;
  next.robot.position = next.robot.position + 0.5 * next.robot.velocity;
  return std::min(now, nearest_discs(discs_of(next.robot, law().step), sensed(b)).gap);
}

// The worst of some admitted velocities, or braking.
MotionStep worst_choice(const Body& a, const Body& b, const Rule& rule, Random& random) {
  const Neighbor other = sensed(b.robot);
  const double u = a.robot.max_acceleration * law().step.time_step;
  MotionStep worst = a.after(backup_velocity(a.robot, law()));
  double least = gap_after(a, worst, b.robot);
  for (int k = 0; k < 8; ++k) {
    Vec2 next = a.robot.velocity + u * (k < 4 ? random.direction() : in_disc(random, 1.0));
    if (norm(next) > a.robot.max_speed) continue;
    next = within_own_limits(a.robot, law().step.time_step, next);
    const MotionStep step = a.after(next);
    const double gap = gap_after(a, step, b.robot);
    if (gap < least && rule(a.robot, other, next)) worst = step, least = gap;
  }
  return worst;
}

std::optional<std::array<Body, 2>> start_of(const Search& search, Random& random) {
  std::array<Body, 2> bodies;
  for (Body& body : bodies) {
    Robot& robot = body.robot;
    robot.model = search.model(random);
    robot.radius = bounding_radius(footprint_of(robot.model));
    robot.max_acceleration = random.log_uniform(0.5, 2.0);
    robot.heading = random.uniform(-std::numbers::pi, std::numbers::pi);
    robot.max_speed = 3.0;
    if (auto* drive = std::get_if<DifferentialDrive>(&robot.model))
      robot.max_acceleration = 0.3 * most_acceleration(*drive), robot.max_speed = 1.5;
    const double speed = search.from_rest ? 0.0 : random.uniform(0.0, 1.5);
    robot.velocity = speed * Vec2{std::cos(robot.heading), std::sin(robot.heading)};
  }
  bodies[1].robot.position = random.uniform(0.5, 6.0) * random.direction();
  const Neighbor other = sensed(bodies[1].robot);
  CertificateConstraints constraints;
  collect_constraints(bodies[0].robot, {&other, 1}, law(), constraints);
  const Invariant& invariant = constraints.invariant;
  if (invariant.doubtful || invariant.broken.any() || !(invariant.slack < 1.0)) return {};
  return bodies;
}

// m: the deepest overlap that the search finds.
double deepest_overlap(const Rule& rule, const Search& search) {
  Random random(7);
  double deepest = 0.0;
  for (int trial = 0; trial < search.trials;) {
    auto start = start_of(search, random);
    if (!start) continue;
    ++trial;
    std::array<Body, 2>& bodies = *start;
    Check check({checked_robot(bodies[0].setup()), checked_robot(bodies[1].setup())});
    const auto add = [&](int step) {
      check.add(step * law().step.time_step,
                std::vector<CheckedState>{bodies[0].row(0), bodies[1].row(1)});
    };
    add(0);
    for (int step = 1; step <= search.steps; ++step) {
      const MotionStep a = worst_choice(bodies[0], bodies[1], rule, random),
                       b = worst_choice(bodies[1], bodies[0], rule, random);
      bodies[0].take(a), bodies[1].take(b);
      add(step);
    }
    deepest = std::max(deepest, check.report().overlaps.worst);
  }
  return deepest;
}

Footprint row_of_discs(Random& random) {
  return cover_rectangle(random.uniform(2.0, 4.0), 1.0, random.uniform(0.0, 1.2), 0.3);
}

MotionModel truck(Random& random) {
  Car car{.wheelbase = 1.5, .max_curvature = 0.6, .reverse = random.below(2) == 0};
  car.footprint = row_of_discs(random);
  return car;
}

MotionModel turner(Random& random) {
  Car car{.wheelbase = 1.5, .reverse = true};
  car.footprint = row_of_discs(random);
  return car;
}

MotionModel drive(Random& random) {
  DifferentialDrive drive{.track = 0.6,
                          .offset = random.uniform(0.3, 0.6),
                          .wheel_speed = 2.0,
                          .wheel_acceleration = 4.0};
  drive.footprint = row_of_discs(random);
  drive.footprint.first -= 0.5;
  return drive;
}

constexpr double kRounding = 1e-9;

void expect_needed(const Rule& broken, const Search& search, double depth) {
  EXPECT_GE(deepest_overlap(broken, search), depth);
  EXPECT_LE(deepest_overlap(admitted, search), kRounding);
}

TEST(FootprintProof, discs_that_do_not_turn) {
  expect_needed(all_alone, {truck}, 0.02);
}

TEST(FootprintProof, turns_in_place_untested) {
  const Rule broken = [](const Robot& a, const Neighbor& b, Vec2 next_velocity) {
    const bool turns = a.velocity == Vec2{} && Body{a}.after(next_velocity).next.velocity == Vec2{};
    return turns || admitted(a, b, next_velocity);
  };
  expect_needed(broken, {turner, true}, 0.1);
}

TEST(FootprintProof, one_disc_alone) {
  const Rule broken = [](const Robot& a, const Neighbor& b, Vec2 next_velocity) {
    return admitted(alone(a, 0), b, next_velocity);
  };
  expect_needed(broken, {truck}, 0.3);
}

TEST(FootprintProof, drives_whose_discs_do_not_turn) {
  expect_needed(all_alone, {drive}, 0.02);
}

TEST(FootprintProof, drives_that_do_not_turn_while_they_brake) {
  const Rule broken = [](const Robot& a, const Neighbor& b, Vec2 next_velocity) {
    Neighbor straight = b;
    straight.spread = 0.0;
    return admitted(a, straight, next_velocity);
  };
  expect_needed(broken, {drive}, 1e-3);
}

TEST(FootprintProof, seen_too_late) {
  const Rule broken = [](const Robot& a, const Neighbor& b, Vec2 next_velocity) {
    const bool is_near = norm(a.position - b.position) <=
                         2.0 * footprint_of(a.model).radius + norm(a.velocity) + norm(b.velocity);
    return !is_near || admitted(a, b, next_velocity);
  };
  expect_needed(broken, {truck}, 0.1);
}

}  // namespace
}  // namespace avo::test
