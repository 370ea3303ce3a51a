// SPDX-License-Identifier: Apache-2.0
// Admission by braking trajectories and stopping lengths against slow references, for both motions.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "certificate/certificate.h"
#include "planner/stages/certify.h"
#include "rows.h"
#include "support/certificates.h"

namespace avo {
namespace {

Robot robot_of(const json& row) {
  return {vec(row.at("position")),
          vec(row.at("velocity")),
          {},
          row.at("radius").get<double>(),
          row.at("max_acceleration").get<double>(),
          row.at("max_speed").get<double>()};
}

CertificateLaw law_of(const json& row) {
  PlannerOptions options;
  options.time_step = row.at("time_step").get<double>();
  if (row.contains("control_time")) {
    options.motion = Motion::exponential;
    options.control_time = row.at("control_time").get<double>();
  }
  return certificate_law(Planner(options));
}

// What the constraints say of a candidate, in the reference's terms: contact not inflated, and with
// the first two coefficients of the step itself, which no candidate changes.
double smallest_coefficient(const TrajectoryConstraints& constraints, const CandidatePath& path,
                            const Robot& robot, const BrakingPair& pair, const StepLaw& law) {
  double smallest = test::worst_of_all(constraints, path, law).coefficient;
  for (const TrajectoryConstraint& constraint : test::all_constraints(constraints)) {
    if (constraint.interval > 0) continue;
    smallest = std::min({smallest, constraint.offset[0],
                         law.lag * dot(constraint.normal, robot.velocity) + constraint.offset[1]});
  }
  return smallest + pair.share * (pair.inflated - pair.contact);
}

// Whether full acceleration towards each other for one step, then braking, leaves a gap.
bool is_out_of_reach(const Robot& a, const Robot& b, const StepLaw& law) {
  double gap = norm(a.position - b.position) - a.radius - b.radius;
  for (const Robot* robot : {&a, &b}) {
    const double u = robot->max_acceleration * law.braking_time, speed = norm(robot->velocity);
    gap -= law.lag * speed + (law.time_step - law.lag) * (speed + u);
    for (double next = speed + u; next > 0.0; next -= u) {
      gap -= law.lag * next + (law.time_step - law.lag) * std::max(next - u, 0.0);
    }
  }
  return gap > 0.0;
}

// Compares every case but those of pairs that cannot come to meet, whatever both do: the rule would
// refuse some candidates there as well, to no purpose. What no candidate of the pair could use up
// belongs to no constraint. Returns how many are refused.
int compare(const json& rows) {
  int refused = 0;
  for (const json& row : rows) {
    SCOPED_TRACE(row.dump());
    const CertificateLaw law = law_of(row);
    const Robot a = robot_of(row.at("a")), b = robot_of(row.at("b"));
    const std::vector<Neighbor> neighbors{
        {b.position, b.velocity, b.radius, b.max_acceleration, {}}};
    CertificateConstraints constraints;
    collect_constraints(a, neighbors, law, constraints);
    const Vec2 next = a.velocity + law.step.braking_time * vec(row.at("candidate"));
    const bool admitted = admits(a, next, law, constraints, Asked::all);
    const Braking braking = braking_of(a.velocity, a.max_acceleration, law.step);
    const BrakingPair pair = braking_pair(a, neighbors[0], braking, law.step);
    if (is_out_of_reach(a, b, law.step)) {
      EXPECT_TRUE(admitted);
      continue;
    }
    const double expected = row.at("smallest_coefficient").get<double>();
    EXPECT_EQ(admitted, row.at("admitted").get<bool>());
    refused += admitted ? 0 : 1;
    const double found =
        smallest_coefficient(constraints.trajectories, constraints.path, a, pair, law.step);
    const double tolerance = 1e-9 * std::max(1.0, std::abs(expected));
    EXPECT_GE(found, expected - tolerance);
    EXPECT_LE(row.at("invariant_slack").get<double>(), constraints.invariant.slack + 1e-9);
    if (expected < 0.0) {
      EXPECT_NEAR(found, expected, tolerance);
    }
  }
  return refused;
}

TEST(CertificateGolden, braking_trajectories) {
  const json rows = cases("braking_trajectories.json");
  ASSERT_EQ(rows.size(), 400U);
  EXPECT_GE(compare(rows), 150);
}

TEST(CertificateGolden, braking_trajectories_of_exponential_motion) {
  const json rows = cases("braking_trajectories_exponential.json");
  ASSERT_EQ(rows.size(), 400U);
  EXPECT_GE(compare(rows), 150);
}

void compare_lengths(const json& rows) {
  for (const json& row : rows) {
    SCOPED_TRACE(row.dump());
    const StepLaw law = law_of(row).step;
    const double found =
        stopping_length(row.at("speed").get<double>(),
                        braking_decrement(row.at("max_acceleration").get<double>(), law), law);
    const double expected = row.at("length").get<double>();
    EXPECT_NEAR(found, expected, 1e-12 * std::max(1.0, expected));
  }
}

TEST(CertificateGolden, stopping_lengths) {
  const json rows = cases("stopping_lengths.json");
  ASSERT_EQ(rows.size(), 100U);
  compare_lengths(rows);
}

TEST(CertificateGolden, stopping_lengths_of_exponential_motion) {
  const json rows = cases("stopping_lengths_exponential.json");
  ASSERT_EQ(rows.size(), 100U);
  compare_lengths(rows);
}

}  // namespace
}  // namespace avo
