// SPDX-License-Identifier: Apache-2.0
// The tests check the certificate's promise by itself: a robot that chooses anything admitted never
// touches another robot.
#include <gtest/gtest.h>
#include <string>
#include <tuple>

#include "certificate_fleets.h"

namespace avo::test {
namespace {

constexpr int kFleets = 400;
constexpr int kSteps = 90;

class Certified : public testing::TestWithParam<std::tuple<Certificate, Motion>> {};

std::string name_of(const testing::TestParamInfo<Certified::ParamType>& info) {
  const auto [kind, motion] = info.param;
  return std::string(to_string(kind)) + (motion == Motion::held ? "_held" : "_exponential");
}

// Every robot picks by a whim of its own; all move; the distance within the step is looked at.
Witness step(Random& random, Fleet& fleet, const CertificateLaw& law,
             CertificateConstraints& constraints) {
  Witness witness;
  std::vector<TrueStep> steps;
  for (std::size_t k = 0; k < fleet.robots.size(); ++k) {
    const Robot& robot = fleet.robots[k];
    const std::vector<Neighbor> neighbors = others(fleet.robots, k);
    collect_constraints(robot, neighbors, law, constraints);
    const Vec2 backup = backup_velocity(robot, law);
    // beyond all inflation: 10^-9 of the place, 10^-9 m
    const double scale = 1e-9 * (1.0 + norm(robot.position));
    if (constraints.invariant.slack > scale && !admits(robot, backup, law, constraints)) {
      witness.backup_refused = true;
    }
    const Vec2 next = adverse_velocity(random, robot, static_cast<Whim>(random.below(5)), neighbors,
                                       law, constraints);
    steps.push_back({robot.position, robot.velocity, next});
    witness.most_change = std::max(witness.most_change, part_of_ability(robot, next, law));
    witness.most_speed = std::max(witness.most_speed, norm(next) / robot.max_speed);
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double contact = fleet.robots[i].radius + fleet.robots[j].radius;
      witness.least_gap =
          std::min(witness.least_gap, least_distance(steps[i], steps[j], fleet.options) - contact);
    }
  }
  for (std::size_t k = 0; k < steps.size(); ++k) {
    fleet.robots[k].position = steps[k].at(law.step.time_step, fleet.options);
    fleet.robots[k].velocity = steps[k].next_velocity;
  }
  return witness;
}

TEST_P(Certified, nobody_touches_whatever_admitted_velocity_all_choose) {
  const auto [kind, motion] = GetParam();
  double least_gap = 1.0 / 0.0;
  CertificateConstraints constraints;
  for (int seed = 1; seed <= kFleets; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Fleet fleet = random_fleet(random, kind, motion);
    const CertificateLaw law = law_of(fleet.options);
    for (int k = 0; k < kSteps; ++k) {
      const Witness witness = step(random, fleet, law, constraints);
      ASSERT_GE(witness.least_gap, 0.0) << "seed " << seed << " step " << k;
      ASSERT_LE(witness.most_change, 1.0 + 1e-9) << "seed " << seed << " step " << k;
      ASSERT_LE(witness.most_speed, 1.0 + 1e-9) << "seed " << seed << " step " << k;
      ASSERT_FALSE(witness.backup_refused) << "seed " << seed << " step " << k;
      least_gap = std::min(least_gap, witness.least_gap);
    }
  }
  EXPECT_LT(least_gap, 1e-4);  // they did try
}

// Two robots at rest, 10^7 m off: a position is rounded by 10^-9 m there.
Fleet far_pair(Random& random, Certificate kind, Motion motion) {
  Fleet fleet;
  fleet.options = random_options(random, kind, motion);
  const Vec2 place = 1e7 * random.direction();
  fleet.robots = {random_robot(random), random_robot(random)};
  const double apart = fleet.robots[0].radius + fleet.robots[1].radius + random.uniform(0.01, 0.5);
  fleet.robots[0].position = place;
  fleet.robots[1].position = place + apart * random.direction();
  return fleet;
}

TEST_P(Certified, rounding_is_covered_by_the_margin) {
  const auto [kind, motion] = GetParam();
  CertificateConstraints constraints;
  for (int seed = 1; seed <= 60; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Fleet fleet = far_pair(random, kind, motion);
    const CertificateLaw law = law_of(fleet.options);
    for (int k = 0; k < 150; ++k) {
      std::vector<TrueStep> steps;
      for (std::size_t i = 0; i < 2; ++i) {
        const Robot &robot = fleet.robots[i], &other = fleet.robots[1 - i];
        collect_constraints(robot, others(fleet.robots, i), law, constraints);
        const Vec2 towards = other.position - robot.position;
        const double u = increment(robot.max_acceleration, law.step);
        const Vec2 push = within_speed(robot, (u / norm(towards)) * towards);
        // to the last bit that is admitted, and now and then nothing but braking
        const Vec2 next = random.below(10) == 0
                              ? backup_velocity(robot, law)
                              : farthest_admitted(robot, push, law, constraints, 60);
        steps.push_back({robot.position, robot.velocity, next});
      }
      const double contact = fleet.robots[0].radius + fleet.robots[1].radius;
      ASSERT_GE(least_distance(steps[0], steps[1], fleet.options), contact)
          << "seed " << seed << " step " << k;
      for (std::size_t i = 0; i < 2; ++i) {
        fleet.robots[i].position = steps[i].at(law.step.time_step, fleet.options);
        fleet.robots[i].velocity = steps[i].next_velocity;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    , Certified,
    testing::Values(std::tuple(Certificate::braking_trajectories, Motion::held),
                    std::tuple(Certificate::braking_trajectories, Motion::exponential)),
    name_of);

}  // namespace
}  // namespace avo::test
