// SPDX-License-Identifier: Apache-2.0
// How far a robot may come is what others count on: |v| and what a_max adds in a step, and braking.
#include <gtest/gtest.h>
#include <numbers>

#include "certificate/certificate.h"
#include "robots/model.h"
#include "support/certificates.h"

namespace avo::test {
namespace {

constexpr double kStep = 0.1;  // s

// m, of a speed that falls by u in every step of held acceleration.
double braking_length(double speed, double u) {
  double length = 0.0;
  for (; speed > 0.0; speed -= u) length += 0.5 * kStep * (speed + std::max(speed - u, 0.0));
  return length;
}

// Most of the disc is ahead of the axle, and sweeps aside while the car turns.
Robot random_car(Random& random) {
  Robot robot{.radius = 0.5, .max_acceleration = random.uniform(0.5, 2.0), .max_speed = 2.0};
  robot.heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  robot.velocity =
      random.uniform(0.0, 1.9) * Vec2{std::cos(robot.heading), std::sin(robot.heading)};
  Car car{.body = CarBody{random.uniform(0.2, 1.0), 0.5}};
  if (random.below(2) == 0) car.max_curvature = random.uniform(0.2, 1.5);
  if (random.below(2) == 0) car.acceleration_set = AccelerationSet::exact;
  robot.model = car;
  return robot;
}

TEST(Reach, a_disc_ahead_of_the_axle_comes_no_farther_than_others_count_on) {
  Random random(11);
  const CertificateLaw law =
      law_of(options_of(Certificate::braking_trajectories, Motion::held, kStep, 2.0));
  CertificateConstraints constraints;
  int admitted = 0, refused = 0;
  for (int k = 0; k < 20000; ++k) {
    const Robot robot = random_car(random);
    const double u = robot.max_acceleration * kStep, speed = norm(robot.velocity);
    const Vec2 next = robot.velocity + (1.4 * u * random.uniform(0.0, 1.0)) * random.direction();
    collect_constraints(robot, {}, law, constraints);
    if (!admits(robot, next, law, constraints)) {
      ++refused;
      continue;
    }
    ++admitted;
    const MotionStep step =
        advance(robot.model, {robot.max_acceleration, robot.max_speed},
                {{}, robot.velocity, robot.heading}, plan_to(robot, next, law.step), kStep);
    const Vec2 v = step.next.velocity;
    const Vec2 direction = v == Vec2{} ? Vec2{} : v / norm(v);
    const Vec2 rest = step.next.position + braking_length(norm(v), u) * direction;
    const double counted_on = 0.5 * kStep * (2.0 * speed + u);
    EXPECT_LE(norm(rest), (counted_on + braking_length(speed + u, u)) * (1.0 + 1e-12));
  }
  EXPECT_GT(admitted, 1000);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace avo::test
