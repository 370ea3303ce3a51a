// SPDX-License-Identifier: Apache-2.0
// Braking trajectories: both robots of a pair see the same constraints, none that can refuse is
// left out, and tangents are tangent.
#include <gtest/gtest.h>
#include <limits>

#include "avo/half_plane.h"
#include "situations.h"

namespace avo::test {
namespace {

TEST(Constraints, of_a_pair_are_mirror_images_bit_for_bit) {
  for (const Motion motion : kMotions) {
    Random random(21);
    int compared = 0, broken = 0;
    for (int i = 0; i < 3000; ++i) {
      const PairSituation s = random_pair(random, kTrajectories, motion, i % 2 == 0);
      const CertificateConstraints of_A = constraints_of(s.a, s.b, s.law),
                                   of_B = constraints_of(s.b, s.a, s.law);
      const std::vector<TrajectoryConstraint> a = all_constraints(of_A.trajectories);
      const std::vector<TrajectoryConstraint> b = all_constraints(of_B.trajectories);
      // where braking leaves too little, both hold what it leaves
      if (std::min(of_A.invariant.slack, of_B.invariant.slack) < 0.0) {
        EXPECT_EQ(of_A.invariant.slack, of_B.invariant.slack);
        ++broken;
      }
      for (std::size_t j = 0, k = 0; j < a.size() && k < b.size();) {
        if (a[j].interval != b[k].interval) {
          (a[j].interval < b[k].interval ? j : k) += 1;  // one of the two has no use for it
          continue;
        }
        ASSERT_EQ(a[j].normal.x, -b[k].normal.x);
        ASSERT_EQ(a[j].normal.y, -b[k].normal.y);
        ++compared, ++j, ++k;
      }
    }
    EXPECT_GT(compared, 5000);
    EXPECT_GT(broken, 100);
  }
}

TEST(Constraints, shares_of_a_pair_add_up_to_the_gap) {
  for (const Motion motion : kMotions) {
    Random random(22);
    for (int i = 0; i < 1000; ++i) {
      const PairSituation s = sound_pair(random, kTrajectories, motion, i % 2 == 0);
      const auto of_A = all_constraints(constraints_of(s.a, s.b, s.law).trajectories);
      const auto of_B = all_constraints(constraints_of(s.b, s.a, s.law).trajectories);
      if (of_A.empty() || of_B.empty() || of_A[0].interval != 0 || of_B[0].interval != 0) continue;
      // at the start of the step itself both paths begin where the robots are
      const double gap = dot(of_A[0].normal, s.a.position - s.b.position) - s.a.radius - s.b.radius;
      // beside the margin for rounding, which grows with 1/share
      EXPECT_NEAR(of_A[0].offset[0] + of_B[0].offset[0], gap, i % 2 == 0 ? 4e-8 : 1e-9);
    }
  }
}

// Smallest coefficient of the rule as docs/certificate.md has it, all constraints, nothing left
// out.
double plain_coefficient(const PairSituation& s, Vec2 next) {
  const StepLaw& law = s.law.step;
  const auto steps = [&](const Robot& robot) {
    const double most = norm(robot.velocity) + increment(robot.max_acceleration, law);
    return 3 + static_cast<int>(most / decrement_of(robot, law));
  };
  const int count = std::max(steps(s.a), steps(s.b));
  const auto x_A = stepped_braking(s.a, law, count), x_B = stepped_braking(s.b, law, count);
  const auto y_A = stepped_path(s.a, next, law, count);
  const double contact = s.a.radius + s.b.radius;
  const double share =
      room_share(s.a.max_acceleration, s.b.max_acceleration, s.a.priority, s.b.priority);
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < x_A.size(); ++m) {
    const Points q{x_A[m][0] - x_B[m][0], x_A[m][1] - x_B[m][1], x_A[m][2] - x_B[m][2]};
    Vec2 nearest = q[0];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 from = q[k], along = q[(k + 1) % 3] - from;
      const double squared = norm_squared(along);
      const double part =
          squared > 0.0 ? std::min(1.0, std::max(0.0, -dot(from, along) / squared)) : 0.0;
      if (norm(from + part * along) < norm(nearest)) nearest = from + part * along;
    }
    const Vec2 n = nearest / norm(nearest);
    for (std::size_t k = 0; k < 3; ++k) {
      smallest =
          std::min(smallest, dot(n, y_A[m][k] - x_A[m][k]) + share * (dot(n, q[k]) - contact));
    }
  }
  return smallest;
}

TEST(Constraints, left_out_could_refuse_nothing) {
  for (const Motion motion : kMotions) {
    Random random(23);
    int refused = 0, admitted = 0;
    for (int i = 0; i < 5000; ++i) {
      const PairSituation s = sound_pair(random, kTrajectories, motion, i % 2 == 0);
      CertificateConstraints constraints = constraints_of(s.a, s.b, s.law);
      for (int k = 0; k < 8; ++k) {
        const Vec2 next = random_choice(random, s);
        const double coefficient = plain_coefficient(s, next);
        if (std::abs(coefficient) < 1e-9) continue;
        const bool is_admitted = admits(s.a, next, s.law, constraints);
        if (out_of_reach(s)) {
          EXPECT_TRUE(is_admitted);
          continue;
        }
        EXPECT_EQ(is_admitted, coefficient > 0.0) << "pair " << i << ": " << coefficient;
        (is_admitted ? admitted : refused) += 1;
      }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_GT(admitted, 2000);
  }
}

// normal . y_i + offset of one constraint's point, from the path alone.
double coefficient_of(const PairSituation& s, const TrajectoryConstraint& constraint, int point,
                      Vec2 next) {
  const auto path = stepped_path(s.a, next, s.law.step, constraint.interval + 1);
  const auto m = static_cast<std::size_t>(constraint.interval), i = static_cast<std::size_t>(point);
  return dot(constraint.normal, path[m][i] - s.a.position) + constraint.offset[i];
}

TEST(Constraints, tangent_is_the_derivative) {
  for (const Motion motion : kMotions) {
    Random random(24);
    int compared = 0;
    while (compared < 1000) {
      const PairSituation s = sound_pair(random, kTrajectories, motion, compared % 2 == 0);
      CertificateConstraints constraints = constraints_of(s.a, s.b, s.law);
      const Vec2 next = random_choice(random, s);
      const double u = decrement_of(s.a, s.law.step);
      const double steps = norm(next) / u;
      // the braking path has kinks where a step more begins
      if (admits(s.a, next, s.law, constraints, Asked::all) ||
          std::abs(steps - std::round(steps)) < 1e-3)
        continue;
      const WorstConstraint worst =
          worst_of_all(constraints.trajectories, constraints.path, s.law.step);
      const double value = coefficient_of(s, worst.constraint, worst.point, next);
      EXPECT_NEAR(value, worst.coefficient, 1e-11);
      const double h = 1e-5 * u;
      const auto slope = [&](Vec2 direction) {
        return (coefficient_of(s, worst.constraint, worst.point, next + h * direction) -
                coefficient_of(s, worst.constraint, worst.point, next - h * direction)) /
               (2.0 * h);
      };
      const Vec2 gradient{slope({1.0, 0.0}), slope({0.0, 1.0})};
      const HalfPlane plane = tangent(worst, constraints.path, s.law.step);
      EXPECT_LE(norm(plane.normal - gradient / norm(gradient)), 1e-5);
      EXPECT_NEAR(violation(plane, next) * norm(gradient), -value, 1e-5 * std::abs(value) + 1e-12);
      EXPECT_GT(violation(plane, next), 0.0);  // what is refused is cut off
      ++compared;
    }
  }
}

TEST(Constraints, bound_is_sufficient_for_the_deviation_from_braking) {
  Random random(25);
  for (int i = 0; i < 300; ++i) {
    const PairSituation s = sound_pair(random, kTrajectories, Motion::held);
    const CertificateConstraints constraints = constraints_of(s.a, s.b, s.law);
    const double u = braking_decrement(s.a.max_acceleration, s.law.step);
    for (const TrajectoryConstraint& constraint : all_constraints(constraints.trajectories)) {
      EXPECT_LE(constraint.bound, 1e-9);
      const auto m = static_cast<std::size_t>(constraint.interval);
      const Vec2 next = braked(s.a.velocity, u);
      const auto x = stepped_path(s.a, next, s.law.step, constraint.interval + 1);
      for (std::size_t k = 0; k < 3; ++k) {
        // a path that deviates by just the bound along the normal keeps the constraint
        const Vec2 y = x[m][k] - s.a.position + constraint.bound * constraint.normal;
        EXPECT_GE(dot(constraint.normal, y) + constraint.offset[k], -1e-11);
      }
    }
  }
}

}  // namespace
}  // namespace avo::test
