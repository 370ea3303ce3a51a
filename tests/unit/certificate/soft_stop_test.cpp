// SPDX-License-Identifier: Apache-2.0
// Linear soft stop: what z does, where the step lies, one constraint in two variables.
#include <gtest/gtest.h>

#include "situations.h"

namespace avo::test {
namespace {

constexpr Certificate kS2 = Certificate::linear_soft_stop;

// d_s between Δt and 4 s; speeds within d_s a_max.
PairSituation soft_pair(Random& random) {
  for (;;) {
    PairSituation s = random_pair(random, kS2, Motion::held);
    s.options.soft_stop_time = random.log_uniform(s.options.time_step, 4.0);
    s.law = law_of(s.options);
    for (Robot* robot : {&s.a, &s.b}) {
      robot->max_speed =
          std::min(robot->max_speed, s.options.soft_stop_time * robot->max_acceleration);
      if (norm(robot->velocity) > robot->max_speed) robot->velocity = {};
    }
    if (invariant_holds({s.a, s.b}, s.law)) return s;
  }
}

Vec2 z_of(Vec2 p, Vec2 v, const PlannerOptions& options) {
  return p + (options.soft_stop_time - 0.5 * options.time_step) * v;
}

CertificateWalls walls_of(const Robot& self, const Robot& other, const CertificateLaw& law) {
  CertificateWalls walls;
  collect_walls(self, std::vector<Neighbor>{seen(other)}, law, walls);
  return walls;
}

TEST(SoftStop, z_moves_by_the_constrained_velocity) {
  Random random(41);
  for (int i = 0; i < 2000; ++i) {
    const PairSituation s = soft_pair(random);
    const double h = s.options.time_step;
    const Vec2 next = random_choice(random, s), v = s.a.velocity;
    const TrueStep step{s.a.position, v, next};
    const Vec2 moved = z_of(step.at(h, s.options), next, s.options);
    const Vec2 constrained = soft_stop_velocity(v, next, h, s.options.soft_stop_time);
    EXPECT_LE(norm(constrained - (v + (s.options.soft_stop_time / h) * (next - v))), 1e-12);
    EXPECT_LE(norm(moved - (z_of(s.a.position, v, s.options) + h * constrained)), 1e-11);
    // the soft stop leaves z where it is, within a_max
    const Vec2 backup = backup_velocity(s.a, s.law);
    EXPECT_LE(norm(soft_stop_velocity(v, backup, h, s.options.soft_stop_time)), 1e-12);
    EXPECT_LE(norm(backup - v), s.a.max_acceleration * h * (1.0 + 1e-12));
  }
}

TEST(SoftStop, step_lies_between_p_and_both_z) {
  // p + t v + t²/2 a with z and z' = z + Δt (v + d_s a): weights of p, z, z' are 1 - x - y, x - y',
  // y'
  Random random(42);
  for (int i = 0; i < 2000; ++i) {
    const PairSituation s = soft_pair(random);
    const double h = s.options.time_step, d = s.options.soft_stop_time;
    const Vec2 next = random_choice(random, s), v = s.a.velocity;
    const Vec2 p = s.a.position, z = z_of(p, v, s.options);
    const TrueStep step{p, v, next};
    const Vec2 z_next = z_of(step.at(h, s.options), next, s.options);
    for (int k = 0; k <= 10; ++k) {
      const double t = h * k / 10.0;
      const double of_next = 0.5 * t * t / (h * d);
      const double of_z = (t - h * of_next) / (d - 0.5 * h) - of_next;
      const double of_p = 1.0 - of_z - of_next;
      EXPECT_GE(std::min({of_next, of_z, of_p}), -1e-14);
      EXPECT_LE(norm(of_p * p + of_z * z + of_next * z_next - step.at(t, s.options)), 1e-11);
    }
  }
}

TEST(SoftStop, walls_of_a_pair_are_mirror_images_and_share_the_gap) {
  Random random(43);
  for (int i = 0; i < 2000; ++i) {
    const PairSituation s = soft_pair(random);
    const CertificateWalls of_A = walls_of(s.a, s.b, s.law), of_B = walls_of(s.b, s.a, s.law);
    ASSERT_EQ(of_A.soft_stops.size(), 1U);
    const HalfPlane a = of_A.soft_stops[0].half_plane, b = of_B.soft_stops[0].half_plane;
    ASSERT_EQ(a.normal.x, -b.normal.x);
    ASSERT_EQ(a.normal.y, -b.normal.y);
    EXPECT_EQ(of_A.invariant.slack, of_B.invariant.slack);
    const Vec2 z =
        z_of(s.a.position, s.a.velocity, s.options) - z_of(s.b.position, s.b.velocity, s.options);
    // what both may use up of n . z_AB - r within a step
    const double gap = dot(a.normal, z) - s.a.radius - s.b.radius;
    EXPECT_NEAR(-(a.offset + b.offset) * s.options.time_step, gap, 1e-9);
  }
}

TEST(SoftStop, half_planes_say_the_same_as_the_test) {
  Random random(44);
  int refused = 0;
  for (int i = 0; i < 4000; ++i) {
    const PairSituation s = soft_pair(random);
    CertificateWalls walls = walls_of(s.a, s.b, s.law);
    std::vector<HalfPlane> planes;
    append_half_planes(walls.soft_stops, s.a.velocity, s.options.time_step,
                       s.options.soft_stop_time, planes);
    const Vec2 next = random_choice(random, s);
    if (std::abs(violation(planes[0], next)) < 1e-10) continue;
    EXPECT_EQ(admits(s.a, next, s.law, walls), violation(planes[0], next) < 0.0);
    refused += violation(planes[0], next) > 0.0 ? 1 : 0;
    if (walls.invariant.slack > 1e-9) {
      EXPECT_TRUE(admits(s.a, backup_velocity(s.a, s.law), s.law, walls));
    }
  }
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace avo::test
