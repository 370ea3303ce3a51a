// SPDX-License-Identifier: Apache-2.0
// The certificate's promise where neighbors were last sensed some steps ago, each of another age,
// and were carried on since; and that it is the age that keeps it.
#include <cmath>
#include <gtest/gtest.h>

#include "property/sensing_adversary.h"
#include "support/certificates.h"

namespace avo::test {
namespace {

constexpr int kOldest = 4;  // steps

// Robots that meet head-on, or nearly so, at up to 1 m/s, and can just brake; or one after the
// other, where they brake by other limits than they accelerate by.
std::vector<Body> meeting(int robots, bool brake_otherwise, Random& random) {
  for (;;) {
    std::vector<Body> bodies(static_cast<std::size_t>(robots));
    std::vector<Robot> all;
    for (Body& body : bodies) {
      Robot& robot = body.robot;
      robot.max_speed = 1.5;
      robot.max_acceleration = random.uniform(0.5, 2.0);
      robot.position = random.uniform(0.8, 2.5) * random.direction();
      robot.velocity = -random.uniform(0.0, 1.0) * unit(robot.position + in_disc(random, 0.3));
      if (brake_otherwise) {
        robot.max_braking = random.log_uniform(0.5, 6.0) * robot.max_acceleration;
        robot.velocity = {random.uniform(0.0, 1.5), 0.0};
      }
      all.push_back(robot);
    }
    if (invariant_holds(all, held_law({}))) return bodies;
  }
}

int overlapping_runs(int robots, const Senses& senses, int runs, bool brake_otherwise = false) {
  int count = 0;
  for (int run = 0; run < runs; ++run) {
    Random random(static_cast<std::uint64_t>(518 + run));
    const std::vector<Body> bodies = meeting(robots, brake_otherwise, random);
    const CheckReport report = run_adversary(bodies, senses, 120, 2 + run % 5, random);
    EXPECT_EQ(report.accelerations.count + report.speeds.count, 0);
    count += report.overlaps.count > 0 ? 1 : 0;
  }
  return count;
}

TEST(Age, robots_stay_apart_whenever_they_were_last_sensed) {
  EXPECT_EQ(overlapping_runs(2, {{}, {}, false, kOldest}, 150), 0);
  EXPECT_EQ(overlapping_runs(3, {{}, {}, false, kOldest}, 20), 0);
}

TEST(Age, adds_to_the_declared_errors_of_what_was_sensed) {
  const SensingError error{0.02, 0.1};
  EXPECT_EQ(overlapping_runs(2, {error, error, false, kOldest}, 100), 0);
  EXPECT_EQ(overlapping_runs(2, {error, error, true, kOldest}, 100), 0);
}

// What one did that was not seen for some steps may have been braking.
TEST(Age, counts_on_braking_that_is_stronger_than_acceleration) {
  const SensingError error{0.02, 0.1};
  EXPECT_EQ(overlapping_runs(2, {{}, {}, false, kOldest}, 200, true), 0);
  EXPECT_EQ(overlapping_runs(3, {{}, {}, false, kOldest}, 20, true), 0);
  EXPECT_EQ(overlapping_runs(2, {error, error, false, kOldest}, 100, true), 0);
}

TEST(Age, that_is_not_told_lets_the_same_robots_collide) {
  EXPECT_EQ(overlapping_runs(2, {{}, {}, false, 0}, 30), 0);
  EXPECT_GT(overlapping_runs(2, {{}, {}, false, kOldest, false}, 30), 5);
}

// A robot at rest and a mover that keeps its acceleration.
int runs_touched_in_motion(const Senses& senses) {
  int count = 0;
  for (int run = 0; run < 200; ++run) {
    Random random(static_cast<std::uint64_t>(77 + run));
    std::vector<Body> bodies(2);
    Body& mover = bodies[1];
    mover.decides = false;
    mover.robot.position = random.uniform(1.6, 6.0) * random.direction();
    mover.robot.velocity =
        random.uniform(0.1, 2.0) * unit(in_disc(random, 1.5) - mover.robot.position);
    mover.acceleration = in_disc(random, 0.5);
    const CheckReport report = run_adversary(bodies, senses, 150, 2 + run % 5, random);
    count += report.mover_contacts_moving.count > 0 ? 1 : 0;
  }
  return count;
}

TEST(Age, movers_are_touched_at_rest_only_whenever_they_were_last_sensed) {
  const SensingError error{0.0, 0.1};
  EXPECT_EQ(runs_touched_in_motion({error, error, false, kOldest}), 0);
  EXPECT_GT(runs_touched_in_motion({error, error, false, kOldest, false}), 0);
}

// By interval.
std::vector<CertificateConstraint> demanded(const SensingError& declared,
                                            const Neighbor& neighbor) {
  PlannerOptions options;
  options.sensing_error = declared;
  PlanWorkspace workspace;
  std::vector<CertificateConstraint> constraints;
  const Robot robot{.velocity = {1.0, 0.2}};
  Planner(options).collect_certificate(robot, std::span(&neighbor, 1), workspace, constraints);
  return constraints;
}

TEST(Age, is_an_error_of_that_neighbor) {
  Neighbor neighbor{.position = {2.4, 0.1}, .velocity = {-0.7, 0.0}, .max_acceleration = 1.5};
  const double time = 0.3;
  const auto older =
      demanded({0.02 + time * 0.1 + 0.5 * 1.5 * time * time, 0.1 + 1.5 * time}, neighbor);
  neighbor.age = 3;
  const auto aged = demanded({0.02, 0.1}, neighbor);
  const std::size_t both = std::min(older.size(), aged.size());
  ASSERT_GT(both, 3);
  for (std::size_t k = 0; k < both; ++k) {
    EXPECT_EQ(aged[k].interval, older[k].interval);
    EXPECT_NEAR(aged[k].offset, older[k].offset, 1e-12) << k;
  }
}

// Without an age too.
TEST(Age, is_not_asked_of_one_whose_position_alone_is_less_sure) {
  Neighbor neighbor{.position = {1.9, 0.1}, .velocity = {-0.7, 0.0}};
  const auto farther_off = demanded({0.02 + 0.03, 0.1}, neighbor);
  neighbor.position_error = 0.03;
  const auto less_sure = demanded({0.02, 0.1}, neighbor);
  ASSERT_EQ(less_sure.size(), farther_off.size());
  ASSERT_GT(less_sure.size(), 3);
  for (std::size_t k = 0; k < less_sure.size(); ++k)
    EXPECT_NEAR(less_sure[k].offset, farther_off[k].offset, 1e-12) << k;
}

// The neighbor is like a car with the exact set: its velocity changes by more than its a_max.
TEST(Age, counts_the_acceleration_that_it_may_have_had) {
  StepLaw law;
  law.time_step = 0.1;
  Neighbor late{.max_acceleration = 1.0, .age = 3};
  EXPECT_DOUBLE_EQ(error_against(late, law).velocity, 0.3);
  late.max_deviation = 0.5;  // it has its a_max at least
  EXPECT_DOUBLE_EQ(error_against(late, law).velocity, 0.3);
  late.max_deviation = 1.4;
  EXPECT_DOUBLE_EQ(error_against(late, law).velocity, 0.42);
  EXPECT_DOUBLE_EQ(error_against(late, law).position, 0.5 * 1.4 * 0.09);
  late.position_error = 0.05;
  EXPECT_DOUBLE_EQ(error_against(late, law).velocity, 0.42);
  EXPECT_DOUBLE_EQ(error_against(late, law).position, 0.05 + 0.5 * 1.4 * 0.09);
  NeighborColumns columns;
  columns.reserve(1);
  columns.add(late);
  EXPECT_EQ(columns[0].max_deviation, 1.4);
  EXPECT_EQ(columns[0].position_error, 0.05);
}

TEST(Age, out_of_range_is_invalid) {
  const Planner planner{PlannerOptions{}};
  PlanWorkspace workspace;
  Neighbor neighbor{.position = {3.0, 0.0}};
  for (const int age : {0, 7, kMostAge}) {
    neighbor.age = age;
    EXPECT_NE(planner.plan({}, std::span(&neighbor, 1), workspace).status,
              PlanStatus::invalid_input);
  }
  for (const int age : {-1, kMostAge + 1}) {
    neighbor.age = age;
    EXPECT_EQ(planner.plan({}, std::span(&neighbor, 1), workspace).status,
              PlanStatus::invalid_input);
  }
  neighbor.age = 0;
  for (const double error : {-0.1, std::nan("")}) {
    neighbor.position_error = error;
    EXPECT_EQ(planner.plan({}, std::span(&neighbor, 1), workspace).status,
              PlanStatus::invalid_input);
  }
}

}  // namespace
}  // namespace avo::test
