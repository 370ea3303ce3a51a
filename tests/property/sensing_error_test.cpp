// SPDX-License-Identifier: Apache-2.0
// The certificate's promise where neighbors are sensed wrongly, within the declared bounds, and by
// robots that choose the worst they are allowed; and that the declared bounds are what keeps it.
#include <gtest/gtest.h>

#include "property/sensing_adversary.h"
#include "support/certificates.h"

namespace avo::test {
namespace {

constexpr SensingError kExact{};
constexpr SensingError kPosition{0.01, 0.0};
constexpr SensingError kBoth{0.05, 0.05};
constexpr SensingError kVelocity{0.0, 0.1};

// The first two with the share of the gap given, the others with any; all at rest, far enough apart
// for any of the bounds.
std::vector<Body> group(int robots, double share, Random& random) {
  std::vector<Body> bodies(static_cast<std::size_t>(robots));
  const double a = random.uniform(0.5, 1.5);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    Robot& robot = bodies[k].robot;
    robot.radius = random.uniform(0.2, 0.6);
    robot.max_speed = random.uniform(0.5, 2.0);
    robot.max_acceleration = k == 0   ? a
                             : k == 1 ? a * (1.0 - share) / share
                                      : random.uniform(0.5, 3.0);
    const double x = 1.6 * static_cast<double>(k / 2), y = 1.6 * static_cast<double>(k % 2);
    robot.position = Vec2{x, y} + in_disc(random, 0.1);
  }
  return bodies;
}

// How many of so many runs had robots overlap.
int overlapping_runs(int robots, const Senses& senses, int runs, int steps) {
  constexpr std::array<double, 5> kShares{0.1, 0.3, 0.5, 0.7, 0.9};
  int count = 0;
  for (int run = 0; run < runs; ++run) {
    Random random(static_cast<std::uint64_t>(2011 + run));
    const std::vector<Body> bodies =
        group(robots, kShares[static_cast<std::size_t>(run) % kShares.size()], random);
    const CheckReport report = run_adversary(bodies, senses, steps, 2 + run % 5, random);
    EXPECT_EQ(report.accelerations.count + report.speeds.count, 0);
    count += report.overlaps.count > 0 ? 1 : 0;
  }
  return count;
}

TEST(SensingError, pairs_stay_apart_whatever_they_see_within_the_bounds) {
  for (const SensingError& bound : {kPosition, kBoth, kVelocity}) {
    EXPECT_EQ(overlapping_runs(2, {bound, bound}, 60, 400), 0);
  }
}

TEST(SensingError, groups_stay_apart_whatever_they_see_within_the_bounds) {
  EXPECT_EQ(overlapping_runs(3, {kBoth, kBoth}, 10, 200), 0);
  EXPECT_EQ(overlapping_runs(4, {kPosition, kPosition}, 10, 200), 0);
}

TEST(SensingError, undeclared_errors_let_the_same_robots_collide) {
  EXPECT_EQ(overlapping_runs(2, {kExact, kExact}, 10, 300), 0);
  for (const SensingError& error : {kPosition, kBoth, kVelocity}) {
    EXPECT_GT(overlapping_runs(2, {kExact, error}, 10, 300), 5);
  }
}

TEST(SensingError, each_robot_declares_its_own_bounds) {
  const std::vector<SensingError> bounds{kExact, kPosition, kBoth, kVelocity};
  for (int run = 0; run < 60; ++run) {
    Random random(static_cast<std::uint64_t>(run));
    const std::vector<Body> bodies = group(2, 0.1 + 0.2 * (run % 5), random);
    std::vector<Senses> senses;
    for (int k = 0; k < 2; ++k) {
      const SensingError& bound = bounds[static_cast<std::size_t>(random.below(4))];
      senses.push_back({bound, bound});
    }
    EXPECT_EQ(run_adversary(bodies, senses, 300, 2 + run % 5, random).overlaps.count, 0) << run;
  }
}

// A strong robot A at rest or slow, and a weak one that comes towards it and stops just before:
// it may look at rest, so that A counts far fewer intervals than it brakes for.
std::vector<Body> weak_one_comes(double error, Random& random) {
  for (;;) {
    std::vector<Body> bodies(2);
    Robot &a = bodies[0].robot, &b = bodies[1].robot;
    a.max_acceleration = random.log_uniform(0.3, 4.0);
    a.velocity = random.below(2) == 0 ? Vec2{} : in_disc(random, 0.3);
    b.max_acceleration = random.log_uniform(0.05, 0.4);
    b.velocity = random.uniform(0.3, 1.6) * error * random.direction();
    const StepLaw law = held_law({}).step;
    const double l = stopping_length(norm(b.velocity), 0.1 * b.max_acceleration, law);
    b.position =
        (-1.0 - l - random.log_uniform(1e-3, 0.1)) * unit(b.velocity) + in_disc(random, 0.3);
    if (invariant_holds({a, b}, held_law({}))) return bodies;
  }
}

TEST(SensingError, unequal_counts_of_intervals_cost_no_contact) {
  int differing = 0;
  for (int run = 0; run < 400; ++run) {
    Random random(static_cast<std::uint64_t>(run));
    const double error = random.uniform(0.1, 0.5);
    const std::vector<Body> bodies = weak_one_comes(error, random);
    const Senses senses{{0.0, error}, {0.0, error}, true};
    const Robot& weak = bodies[1].robot;
    const Neighbor slower = sensed(bodies, 0, senses, 1, 1, random)[0];
    const StepLaw law = held_law(senses.declared).step;
    const double own = braking_of(weak.velocity, weak.max_acceleration, law).intervals;
    differing += own > braking_of(slower.velocity, weak.max_acceleration, law).intervals ? 1 : 0;
    EXPECT_EQ(run_adversary(bodies, senses, 30, 20, random).overlaps.count, 0) << run;
  }
  EXPECT_GT(differing, 300);
}

// A robot at rest and a mover that comes by, speeds up, slows down or stands.
std::vector<Body> robot_and_mover(int kind, Random& random) {
  std::vector<Body> bodies(2);
  bodies[0].robot.max_acceleration = random.uniform(0.5, 2.0);
  Body& mover = bodies[1];
  mover.decides = false;
  mover.robot.position = random.uniform(1.3, 6.0) * random.direction();
  if (kind > 0) {
    const Vec2 aim = in_disc(random, 1.5);
    mover.robot.velocity = random.uniform(0.1, 2.0) * unit(aim - mover.robot.position);
  }
  if (kind > 1) mover.acceleration = in_disc(random, 0.5);
  return bodies;
}

int runs_touched_in_motion(const Senses& senses, int runs) {
  int count = 0;
  for (int run = 0; run < runs; ++run) {
    Random random(static_cast<std::uint64_t>(1948 + run));
    const std::vector<Body> bodies = robot_and_mover(run % 3, random);
    const CheckReport report = run_adversary(bodies, senses, 150, 2 + run % 5, random);
    count += report.mover_contacts_moving.count > 0 ? 1 : 0;
  }
  return count;
}

TEST(SensingError, no_mover_is_touched_in_motion) {
  for (const SensingError& bound : {kPosition, kBoth, kVelocity}) {
    EXPECT_EQ(runs_touched_in_motion({bound, bound}, 300), 0);
  }
}

TEST(SensingError, undeclared_errors_let_movers_be_touched_in_motion) {
  EXPECT_EQ(runs_touched_in_motion({kExact, kExact}, 30), 0);
  EXPECT_GT(runs_touched_in_motion({kExact, kBoth}, 30), 10);
}

TEST(SensingError, does_not_flee_from_a_mover_that_reaches_it_in_motion) {
  Robot robot;
  const Neighbor mover{
      .position = {1.3, 0.0}, .velocity = {-2.0, 0.0}, .behavior = Behavior::moves_on};
  for (const SensingError& bound : {kExact, kPosition, kBoth}) {
    const CertificateLaw law = held_law(bound);
    CertificateConstraints constraints;
    collect_constraints(robot, {&mover, 1}, law, constraints);
    EXPECT_TRUE(admits(robot, {}, law, constraints));
    EXPECT_FALSE(admits(robot, {-0.1, 0.0}, law, constraints));
    EXPECT_FALSE(admits(robot, {-0.01, 0.0}, law, constraints));
  }
}

// From what it sees, as fast towards (1) or away from (-1) the other as it is allowed to.
Vec2 heading_for(const std::vector<Body>& bodies, std::size_t self, double way,
                 const SensingError& bound, int shape, Random& random) {
  const Robot& robot = bodies[self].robot;
  const CertificateLaw law = held_law(bound);
  const double u = braking_decrement(robot.max_acceleration, law.step);
  const std::vector<Neighbor> neighbors =
      sensed(bodies, self, {bound, bound}, shape, shape, random);
  CertificateConstraints constraints;
  collect_constraints(robot, neighbors, law, constraints);
  Vec2 wanted = robot.velocity + (way * u) * unit(neighbors[0].position - robot.position);
  if (norm(wanted) > robot.max_speed) wanted = (robot.max_speed / norm(wanted)) * wanted;
  return farthest_admitted(robot, wanted, law, constraints);
}

// Both, or a robot and a mover at rest, for 20 s towards each other and 4 s away. A `shape` of
// errors is kept up all the time.
void meet_and_part(std::vector<Body> bodies, const SensingError& bound, int shape) {
  Random random(7);
  double nearest = 0.0;
  std::vector<Vec2> next(bodies.size());
  for (int step = 0; step < 240; ++step) {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      if (!bodies[k].decides) continue;
      next[k] = heading_for(bodies, k, step < 200 ? 1.0 : -1.0, bound, shape, random);
    }
    move(bodies, next, 0.1);
    const double gap = norm(bodies[1].robot.position - bodies[0].robot.position) - 1.0;
    ASSERT_GT(gap, 0.0) << "shape " << shape << " step " << step;
    if (step == 199) {
      nearest = gap;
      EXPECT_LT(norm(bodies[0].robot.velocity), 0.1) << "shape " << shape;
    }
    if (step == 239) {
      EXPECT_GT(gap, nearest + 3.0) << "shape " << shape << ", from " << nearest;
    }
  }
}

TEST(SensingError, robots_that_have_met_can_part) {
  for (const SensingError& bound : {kPosition, kBoth, kVelocity}) {
    for (int shape = 0; shape < kShapes; ++shape) {
      std::vector<Body> bodies(2);
      bodies[1].robot.position = {4.0, 1.0};
      meet_and_part(bodies, bound, shape);
    }
  }
}

TEST(SensingError, robots_closer_than_the_margin_can_part) {
  for (const SensingError& bound : {kPosition, kBoth, kVelocity}) {
    for (int shape = 0; shape < kShapes; ++shape) {
      Random random(11);
      std::vector<Body> bodies(2);
      bodies[1].robot.position = {1.001, 0.0};
      const Vec2 in = heading_for(bodies, 0, 1.0, bound, 6, random);
      EXPECT_LT(norm(in), 0.05);  // of 0.1: closer is refused
      std::vector<Vec2> next(2);
      for (int step = 0; step < 40; ++step) {
        for (std::size_t k = 0; k < 2; ++k) {
          next[k] = heading_for(bodies, k, -1.0, bound, shape, random);
        }
        move(bodies, next, 0.1);
      }
      EXPECT_GT(bodies[1].robot.position.x - bodies[0].robot.position.x, 5.0) << "shape " << shape;
    }
  }
}

TEST(SensingError, leaves_a_resting_obstacle_that_it_has_come_to) {
  for (const SensingError& bound : {kPosition, kBoth}) {
    for (int shape = 0; shape < 4; ++shape) {
      std::vector<Body> bodies(2);
      bodies[1].decides = false;
      bodies[1].robot.position = {4.0, 1.0};
      meet_and_part(bodies, bound, shape);
    }
  }
}

}  // namespace
}  // namespace avo::test
