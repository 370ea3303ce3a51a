// SPDX-License-Identifier: Apache-2.0
// Every step of the proofs in docs/certificate.md is needed: without it a directed search finds
// robots that overlap, and with it the same search finds none. Robots of 0.3 to 0.6 m; the depths
// found are up to twice those demanded.
#include "unit/certificate/broken_proof.h"

#include <gtest/gtest.h>

namespace avo::test {
namespace {

// What rounding may cost: the plain rules here are not inflated.
constexpr double kRounding = 1e-9;

// Expects overlaps of `depth` m at least without the step, none with it.
void expect_needed(const Rule& broken, const Rule& whole, const Search& search, double depth) {
  EXPECT_GE(deepest_overlap(broken, search), depth);
  EXPECT_LE(deepest_overlap(whole, search), kRounding);
}

Robot body(Random& random, double least_a, double most_a, double v_max) {
  Robot robot;
  robot.radius = random.uniform(0.3, 0.6);
  robot.max_acceleration = random.log_uniform(least_a, most_a);
  robot.max_speed = v_max;
  robot.velocity = random.below(4) == 0 ? Vec2{} : in_disc(random, v_max);
  return robot;
}

// The robots are close together, and their joint braking avoids contact.
auto crowd(int count, double least_a, double most_a, double v_max, double extent) {
  return [=](Random& random, const PlannerOptions& options) {
    const CertificateLaw law = law_of(options);
    std::vector<Robot> robots;
    double side = extent;
    while (static_cast<int>(robots.size()) < count) {
      side *= 1.02;
      Robot robot = body(random, least_a, most_a, v_max);
      robot.position = in_disc(random, side);
      const bool clear = std::all_of(robots.begin(), robots.end(), [&](const Robot& other) {
        return norm(other.position - robot.position) > 1.0001 * (other.radius + robot.radius);
      });
      if (!clear) continue;
      robots.push_back(robot);
      if (!invariant_holds(robots, law)) robots.pop_back();
    }
    return robots;
  };
}

Search search_of(double time_step, int trials, int steps,
                 std::function<std::vector<Robot>(Random&, const PlannerOptions&)> start) {
  return {std::move(start), options_of(kTrajectories, Motion::held, time_step, 2.0), trials, steps};
}

TEST(BrokenProof, middle_coefficient) {
  TrajectoryRule broken;
  broken.middle_coefficient = false;
  expect_needed(broken, TrajectoryRule{}, search_of(0.4, 400, 12, crowd(2, 1.0, 4.0, 4.0, 2.0)),
                5e-3);
}

TEST(BrokenProof, sampled_times) {
  TrajectoryRule broken;
  broken.whole_intervals = false;
  expect_needed(broken, TrajectoryRule{}, search_of(0.4, 400, 12, crowd(2, 1.0, 4.0, 4.0, 2.0)),
                0.05);
}

TEST(BrokenProof, own_stop) {
  TrajectoryRule broken;
  broken.until_both_rest = false;
  expect_needed(broken, TrajectoryRule{}, search_of(0.1, 200, 30, crowd(2, 0.3, 3.0, 2.0, 2.0)),
                0.3);
}

TEST(BrokenProof, unequal_interval_counts) {
  TrajectoryRule broken;
  broken.same_number = false;
  expect_needed(broken, TrajectoryRule{}, search_of(0.1, 200, 30, crowd(2, 0.3, 3.0, 2.0, 2.0)),
                0.2);
}

TEST(BrokenProof, different_normals) {
  TrajectoryRule broken;
  broken.same_normals = false;
  expect_needed(broken, TrajectoryRule{}, search_of(0.4, 400, 12, crowd(2, 1.0, 4.0, 4.0, 2.0)),
                0.05);
}

TEST(BrokenProof, capped_neighbors) {
  TrajectoryRule broken;
  broken.most_neighbors = 2;
  expect_needed(broken, TrajectoryRule{}, search_of(0.1, 6, 30, crowd(8, 0.5, 2.0, 2.0, 2.5)), 0.5);
}

}  // namespace
}  // namespace avo::test
