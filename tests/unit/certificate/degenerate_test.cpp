// SPDX-License-Identifier: Apache-2.0
// With degenerate input, numbers stay numbers, braking stays admitted and no robot freezes.
#include <cfenv>
#include <gtest/gtest.h>
#include <string>

#include "situations.h"

namespace avo::test {
namespace {

struct Case {
  std::string name;
  Robot a, b;
  bool sound = true;  // the invariant holds with room to spare
};

std::vector<Case> cases() {
  const Robot rest{{}, {}, {1.0, 0.0}, 0.5, 1.0, 2.0};
  const auto at = [&](Vec2 position, Vec2 velocity) {
    Robot robot = rest;
    robot.position = position;
    robot.velocity = velocity;
    return robot;
  };
  std::vector<Case> all{
      {"at rest", rest, at({1.5, 0.0}, {})},
      {"touching at rest", rest, at({1.0, 0.0}, {}), false},
      {"touching in parallel", at({}, {0.0, 1.0}), at({1.0, 0.0}, {0.0, 1.0}), false},
      {"touching and closing", at({}, {1.0, 0.0}), at({1.0, 0.0}, {-1.0, 0.0}), false},
      {"one place, at rest", rest, rest, false},
      {"one place, one velocity", at({}, {1.0, 1.0}), at({}, {1.0, 1.0}), false},
      {"one place, against each other", at({}, {1.0, 0.0}), at({}, {-1.0, 0.0}), false},
      {"denormal speeds", at({}, {1e-165, 0.0}), at({1.5, 0.0}, {0.0, -1e-165})},
      {"speeds with squares that vanish", at({}, {1e-200, 1e-200}), at({1.5, 0.0}, {-1e-200, 0.0})},
      {"least number", at({}, {5e-324, 0.0}), at({1.5, 0.0}, {5e-324, 0.0})},
      {"far off", at({1e7, -1e7}, {1.0, 0.0}), at({1e7 + 7.0, -1e7}, {-1.0, 0.0})},
      {"head-on", at({}, {1.0, 0.0}), at({6.0, 0.0}, {-1.0, 0.0})},
      {"in line, same velocity", at({}, {1.0, 0.0}), at({3.5, 0.0}, {1.0, 0.0})},
      {"huge speeds", at({}, {1e6, 0.0}), at({10.0, 0.0}, {-1e6, 0.0}), false},
      {"huge speeds apart", at({}, {-1e6, 0.0}), at({10.0, 0.0}, {1e6, 0.0}), false},
  };
  Case feeble{"one that hardly brakes", rest, at({3.0, 0.0}, {-1.0, 0.0}), false};
  feeble.b.max_acceleration = 1e-300;
  all.push_back(feeble);
  Case tiny{"lengths of 1e-6 m", at({}, {1e-6, 0.0}), at({8e-6, 0.0}, {-1e-6, 0.0})};
  tiny.a.radius = tiny.b.radius = 5e-7;
  all.push_back(tiny);
  return all;
}

// Unit normals (or none, of one place), and offsets that are numbers: infinite where the share of
// one that hardly brakes vanishes.
bool is_sane(Vec2 normal, double offset) {
  const double length = norm(normal);
  return !std::isnan(offset) && (length == 0.0 || std::abs(length - 1.0) < 1e-15);
}

bool are_sane(const CertificateConstraints& constraints) {
  bool sane = !std::isnan(constraints.invariant.slack);
  for (const TrajectoryConstraint& constraint : all_constraints(constraints.trajectories)) {
    for (const double offset : constraint.offset) sane = sane && is_sane(constraint.normal, offset);
  }
  for (const LoiterLine& line : constraints.loiterers)
    sane = sane && is_sane(line.normal, line.offset);
  return sane;
}

constexpr std::pair<Certificate, Motion> kLaws[] = {
    {Certificate::braking_trajectories, Motion::held},
    {Certificate::braking_trajectories, Motion::exponential}};

TEST(DegenerateCertificate, constraints_are_sane_and_braking_is_admitted) {
  for (const auto& [kind, motion] : kLaws) {
    const CertificateLaw law = law_of(options_of(kind, motion, 0.1, 2.0));
    for (const Case& each : cases()) {
      for (const auto& [self, other] : {std::pair(each.a, each.b), std::pair(each.b, each.a)}) {
        SCOPED_TRACE(each.name + ", kind " + std::to_string(static_cast<int>(kind)));
        std::feclearexcept(FE_ALL_EXCEPT);
        CertificateConstraints constraints;
        collect_constraints(self, std::vector<Neighbor>{seen(other)}, law, constraints);
        EXPECT_TRUE(are_sane(constraints));
        EXPECT_FALSE(std::fetestexcept(FE_INVALID));
        const Vec2 backup = backup_velocity(self, law);
        EXPECT_TRUE(is_finite(backup));
        const bool admitted = admits(self, backup, law, constraints);
        if (each.sound) {
          EXPECT_GT(constraints.invariant.slack, 0.0);
          EXPECT_TRUE(admitted);
        }
        EXPECT_FALSE(std::fetestexcept(FE_INVALID));
      }
    }
  }
}

TEST(DegenerateCertificate, decisions_are_finite_and_within_the_limits) {
  for (const auto& [kind, motion] : kLaws) {
    const Planner planner(options_of(kind, motion, 0.1, 2.0));
    PlanWorkspace workspace;
    for (const Case& each : cases()) {
      for (const auto& [self, other] : {std::pair(each.a, each.b), std::pair(each.b, each.a)}) {
        SCOPED_TRACE(each.name + ", kind " + std::to_string(static_cast<int>(kind)));
        const Plan plan = planner.plan(self, std::vector<Neighbor>{seen(other)}, workspace);
        EXPECT_TRUE(is_finite(plan.new_velocity));
        EXPECT_TRUE(is_finite(plan.acceleration));
        EXPECT_FALSE(std::isnan(plan.violation));
        // rounding of huge speeds is all that may be seen beyond a_max
        const double rounding = 1e-15 * norm(self.velocity) / planner.options().time_step;
        EXPECT_LE(norm(plan.acceleration), self.max_acceleration * (1.0 + 1e-9) + rounding);
      }
    }
  }
}

TEST(DegenerateCertificate, more_intervals_than_anyone_looks_at_are_braked_for) {
  const CertificateLaw law =
      law_of(options_of(Certificate::braking_trajectories, Motion::held, 0.1, 2.0));
  Robot self{{}, {1.0, 0.0}, {}, 0.5, 1.0, 2.0}, other{{4.0, 0.0}, {-1.0, 0.0}, {}, 0.5, 1.0, 2.0};
  CertificateConstraints constraints;
  for (const double steps : {0.9 * kMostIntervals, 1.1 * kMostIntervals}) {
    other.max_acceleration = 1.0 / (0.1 * steps);
    collect_constraints(self, std::vector<Neighbor>{seen(other)}, law, constraints);
    EXPECT_EQ(constraints.invariant.unknown, steps > kMostIntervals);
    if (steps > kMostIntervals) {
      EXPECT_FALSE(admits(self, self.velocity, law, constraints));
    }
  }
}

TEST(DegenerateCertificate, robots_at_rest_side_by_side_are_not_frozen) {
  for (const auto& [kind, motion] : kLaws) {
    const CertificateLaw law = law_of(options_of(kind, motion, 0.1, 2.0));
    const double u = braking_decrement(1.0, law.step);
    for (const double speed : {0.0, 1e-165, 1e-17}) {
      for (const double gap : {1e-6, 1e-3}) {
        const Robot self{{}, {0.0, speed}, {}, 0.5, 1.0, 2.0};
        std::vector<Neighbor> neighbors;
        for (const Vec2 side : {Vec2{1.0, 0.0}, Vec2{-1.0, 0.0}, Vec2{0.0, 1.0}}) {
          neighbors.push_back({(1.0 + gap) * side, {0.0, -speed}, 0.5, 1.0, {}});
        }
        CertificateConstraints constraints;
        collect_constraints(self, neighbors, law, constraints);
        EXPECT_TRUE(admits(self, {0.0, -u}, law, constraints));  // away from all of them
        EXPECT_FALSE(admits(self, {0.0, u}, law, constraints));
      }
    }
  }
}

}  // namespace
}  // namespace avo::test
