// SPDX-License-Identifier: Apache-2.0
// Stopping capsules: the separating line, braking inside one's own capsule, half-planes that
// suffice.
#include <gtest/gtest.h>

#include "situations.h"

namespace avo::test {
namespace {

constexpr Certificate kCapsules = Certificate::stopping_capsules;

Vec2 stop_of(const Robot& robot, Vec2 position, Vec2 velocity, const StepLaw& law) {
  const double speed = norm(velocity);
  const double u = braking_decrement(robot.max_acceleration, law);
  return speed > 0.0 ? position + (stopping_length(speed, u, law) / speed) * velocity : position;
}

TEST(Capsules, lines_of_a_pair_are_mirror_images_bit_for_bit) {
  for (const Motion motion : kMotions) {
    Random random(31);
    int compared = 0;
    for (int i = 0; i < 3000; ++i) {
      const PairSituation s = random_pair(random, kCapsules, motion);
      const CertificateConstraints of_A = constraints_of(s.a, s.b, s.law),
                                   of_B = constraints_of(s.b, s.a, s.law);
      if (of_A.capsules.empty() || of_B.capsules.empty()) continue;
      ASSERT_EQ(of_A.capsules[0].normal.x, -of_B.capsules[0].normal.x);
      ASSERT_EQ(of_A.capsules[0].normal.y, -of_B.capsules[0].normal.y);
      EXPECT_EQ(of_A.invariant.slack, of_B.invariant.slack);
      ++compared;
    }
    EXPECT_GT(compared, 1000);
  }
}

TEST(Capsules, line_separates_and_shares_the_gap) {
  Random random(32);
  for (int i = 0; i < 2000; ++i) {
    const PairSituation s = sound_pair(random, kCapsules, Motion::held);
    const CertificateConstraints of_A = constraints_of(s.a, s.b, s.law),
                                 of_B = constraints_of(s.b, s.a, s.law);
    if (of_A.capsules.empty() || of_B.capsules.empty()) continue;
    const Vec2 n = of_A.capsules[0].normal;
    const double edge_A = dot(n, s.a.position) + of_A.capsules[0].offset;
    const double edge_B = dot(n, s.b.position) - of_B.capsules[0].offset;
    EXPECT_NEAR(edge_A - edge_B, s.a.radius + s.b.radius, 1e-9);
    for (const Vec2 x : {s.a.position, stop_of(s.a, s.a.position, s.a.velocity, s.law.step)}) {
      EXPECT_GE(dot(n, x), edge_A - 1e-9);
    }
    for (const Vec2 x : {s.b.position, stop_of(s.b, s.b.position, s.b.velocity, s.law.step)}) {
      EXPECT_LE(dot(n, x), edge_B + 1e-9);
    }
  }
}

TEST(Capsules, line_between_parallel_ones_is_unique) {
  const CertificateLaw law = law_of(options_of(kCapsules, Motion::held, 0.1, 2.0));
  Robot a{{0.0, 2.0}, {1.5, 0.0}, {}, 0.5, 1.0, 2.0}, b{{0.0, 0.0}, {1.5, 0.0}, {}, 0.5, 1.0, 2.0};
  for (const double ahead : {-1.0, -0.25, 0.0, 0.25, 1.0}) {
    for (const double sign : {-1.0, 1.0}) {  // the same way, and against each other
      a.position.x = ahead;
      a.velocity.x = sign * 1.5;
      const CertificateConstraints of_A = constraints_of(a, b, law);
      ASSERT_EQ(of_A.capsules.size(), 1U);
      if (sign > 0.0) {
        EXPECT_LE(norm(of_A.capsules[0].normal - Vec2{0.0, 1.0}), 1e-15);
      }
      EXPECT_EQ(of_A.capsules[0].normal, -constraints_of(b, a, law).capsules[0].normal);
    }
  }
}

TEST(Capsules, next_one_when_braking_lies_in_the_present_one) {
  for (const Motion motion : kMotions) {
    Random random(33);
    for (int i = 0; i < 2000; ++i) {
      const PairSituation s = random_pair(random, kCapsules, motion);
      const double u = braking_decrement(s.a.max_acceleration, s.law.step);
      const CandidatePath path = follow(s.a, braked(s.a.velocity, u), s.law.step);
      const Vec2 next = s.a.position + path.first;
      const Vec2 stop = stop_of(s.a, s.a.position, s.a.velocity, s.law.step);
      const Vec2 next_stop = stop_of(s.a, next, path.next_velocity, s.law.step);
      EXPECT_LE(norm(next_stop - stop), 1e-13 * (1.0 + norm(stop)));
      // and on the way there
      EXPECT_NEAR(norm(next - s.a.position) + norm(stop - next), norm(stop - s.a.position), 1e-12);
    }
  }
}

TEST(Capsules, braking_is_always_admitted) {
  for (const Motion motion : kMotions) {
    Random random(34);
    for (int i = 0; i < 2000; ++i) {
      const PairSituation s = sound_pair(random, kCapsules, motion);
      CertificateConstraints constraints = constraints_of(s.a, s.b, s.law);
      if (constraints.invariant.slack < 1e-9) continue;
      EXPECT_TRUE(admits(s.a, backup_velocity(s.a, s.law), s.law, constraints));
    }
  }
}

TEST(Capsules, next_capsule_and_step_are_what_is_tested) {
  for (const Motion motion : kMotions) {
    Random random(35);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
      const PairSituation s = sound_pair(random, kCapsules, motion);
      CertificateConstraints constraints = constraints_of(s.a, s.b, s.law);
      if (constraints.capsules.empty()) continue;
      const CapsuleConstraint& constraint = constraints.capsules[0];
      const Vec2 next = random_choice(random, s);
      const Vec2 moved = stepped_path(s.a, next, s.law.step, 1)[0][2];
      const Vec2 stop = stop_of(s.a, moved, next, s.law.step);
      const double margin = std::min(dot(constraint.normal, moved - s.a.position),
                                     dot(constraint.normal, stop - s.a.position)) -
                            constraint.offset;
      if (std::abs(margin) < 1e-10) continue;
      EXPECT_EQ(admits(s.a, next, s.law, constraints), margin > 0.0);
      refused += margin < 0.0 ? 1 : 0;
    }
    EXPECT_GT(refused, 100);
  }
}

TEST(Capsules, half_planes_suffice_up_to_their_speed) {
  for (const Motion motion : kMotions) {
    Random random(36);
    int inside = 0;
    for (int i = 0; i < 4000; ++i) {
      const PairSituation s = sound_pair(random, kCapsules, motion);
      CertificateConstraints constraints = constraints_of(s.a, s.b, s.law);
      const double u = braking_decrement(s.a.max_acceleration, s.law.step);
      const double speed = norm(s.a.velocity);
      for (const double top : {speed + u, speed, std::max(speed - u, 0.0)}) {
        std::vector<HalfPlane> planes;
        append_half_planes(constraints.capsules, s.a, s.law.step, top, planes);
        const Vec2 next = random_choice(random, s);
        const bool within = std::all_of(planes.begin(), planes.end(), [&](const HalfPlane& plane) {
          return violation(plane, next) <= -1e-12;
        });
        if (planes.empty() || !within || norm(next) > top) continue;
        EXPECT_TRUE(admits(s.a, next, s.law, constraints)) << "pair " << i;
        ++inside;
      }
      // at the last of these speeds braking is left
      std::vector<HalfPlane> planes;
      append_half_planes(constraints.capsules, s.a, s.law.step, std::max(speed - u, 0.0), planes);
      for (const HalfPlane& plane : planes) {
        if (constraints.invariant.slack < 1e-9) continue;
        EXPECT_LE(violation(plane, braked(s.a.velocity, u)), 1e-9 * u) << "pair " << i;
      }
    }
    EXPECT_GT(inside, 1000);
  }
}

}  // namespace
}  // namespace avo::test
