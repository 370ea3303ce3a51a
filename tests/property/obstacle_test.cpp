// SPDX-License-Identifier: Apache-2.0
// The obstacles as sets: membership against brute force, discs and boundary, monotony, scaling.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "avo/velocity_obstacle.h"
#include "support/brute_force.h"
#include "support/cases.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::Random;
using test::Situation;

struct Query {
  Obstacle obstacle{{}, Response::velocity(), 0.0};
  Vec2 u;
};

// Any pair, any response; u drawn around what brings the centers together at some time.
Query query(Random& random) {
  const Situation s = test::any_situation(random);
  const Response responses[] = {Response::proportional(s.control_time), Response::velocity(),
                                Response::acceleration(), Response::held(s.control_time)};
  Query q;
  q.obstacle = {s.pair, responses[random.below(4)], s.time_horizon};
  const double t = s.time_horizon * random.uniform(0.05, 1.0);
  const Disc target = disc(q.obstacle, t);
  q.u = target.center + test::in_disc(random, 3.0 * target.radius);
  return q;
}

// Distances are known to a few roundings of the terms of x(t).
double rounding(const Query& q) {
  const Pair& pair = q.obstacle.pair;
  const double tau = q.obstacle.time_horizon;
  return 1e-14 * (norm(pair.position) + tau * norm(pair.velocity) +
                  q.obstacle.response.gain(tau) * norm(change(q.obstacle, q.u)));
}

TEST(Obstacle, P2_closest_approach_is_the_minimum) {
  test::in_all_cases([](Random& random) {
    const Query q = query(random);
    const ClosestApproach found = closest_approach(q.obstacle, q.u);
    const auto distance = [&](double t) { return norm(relative_position(q.obstacle, q.u, t)); };
    ASSERT_TRUE(found.time >= 0.0 && found.time <= q.obstacle.time_horizon);
    ASSERT_TRUE(std::abs(distance(found.time) - found.distance) <= rounding(q));
    for (int k = 0; k <= 400; ++k) {
      const double part = k / 400.0;
      ASSERT_TRUE(distance(part * part * q.obstacle.time_horizon) >= found.distance - rounding(q));
    }
    for (int k = -20; k <= 20; ++k) {
      const double t = found.time * (1.0 + k * 1e-4);
      if (t > q.obstacle.time_horizon) break;
      ASSERT_TRUE(distance(t) >= found.distance - rounding(q));
    }
    ASSERT_TRUE(contains(q.obstacle, q.u) == (found.distance < q.obstacle.pair.radius));
  });
}

// With the gain in long double: the distance is attained at the time given, and not undercut.
TEST(Obstacle, P2_no_long_double_sample_is_nearer) {
  test::in_all_cases([](Random& random) {
    const Situation s = test::any_situation(random);
    const Vec2 w = test::in_disc(random, s.reach);
    const Query q{test::obstacle_of(s), s.pair.velocity + w};
    const ClosestApproach found = closest_approach(q.obstacle, q.u);
    const double gain = static_cast<double>(test::slow_gain(found.time, s.control_time));
    const Vec2 x = s.pair.position + found.time * s.pair.velocity + gain * w;
    ASSERT_TRUE(std::abs(norm(x) - found.distance) <= 4.0 * rounding(q));
    ASSERT_TRUE(found.distance <= test::slow_distance(s, w, 400) + 4.0 * rounding(q));
  });
}

TEST(Obstacle, P3_disc_is_the_set_that_collides_at_its_time) {
  test::in_all_cases([](Random& random) {
    const Query q = query(random);
    const double t = q.obstacle.time_horizon * random.uniform(1e-3, 1.0);
    const Disc at_t = disc(q.obstacle, t);
    const double gain = q.obstacle.response.gain(t);
    const double inside = at_t.radius - norm(q.u - at_t.center);
    const double closer = q.obstacle.pair.radius - norm(relative_position(q.obstacle, q.u, t));
    ASSERT_TRUE(std::abs(gain * inside - closer) <= rounding(q));
  });
}

TEST(Obstacle, P3_boundary_points_touch_one_disc_at_its_time) {
  test::in_all_cases([](Random& random) {
    const Query q = query(random);
    const Obstacle& obstacle = q.obstacle;
    const double r = obstacle.pair.radius;
    constexpr int kSamples = 9;
    const Boundary found = boundary(obstacle, kSamples);
    ASSERT_TRUE(found.left.size() == found.right.size());
    std::size_t next = 0;
    for (int k = kSamples; k >= 1; --k) {
      const double t = obstacle.time_horizon * k / kSamples;
      const Vec2 y = obstacle.pair.position + obstacle.response.lag(t) * obstacle.pair.velocity;
      if (std::abs(norm(y) - r) <= 1e-9 * r) return;  // either answer is right
      if (norm(y) < r) continue;
      for (const Vec2 u : {found.left.at(next), found.right.at(next)}) {
        const Query at_u{obstacle, u};
        const Vec2 x = relative_position(obstacle, u, t);
        const Vec2 x_rate =
            obstacle.pair.velocity + obstacle.response.rate(t) * change(obstacle, u);
        ASSERT_TRUE(std::abs(norm(x) - r) <= rounding(at_u));
        // contact without closing, to the rounding of x and of the velocities
        const double size =
            norm(obstacle.pair.velocity) + obstacle.response.rate(t) * norm(change(obstacle, u));
        ASSERT_TRUE(std::abs(dot(x, x_rate)) <= 10.0 * rounding(at_u) * size + 1e-13 * r * size);
      }
      ++next;
    }
    ASSERT_TRUE(next == found.left.size());
  });
}

// The boundary of the plain cone lies in none of its discs; with the tangents from the origin
// alone it would for any other response.
TEST(Obstacle, P3_boundary_of_the_velocity_obstacle_is_inside_none) {
  test::in_all_cases([](Random& random) {
    Query q = query(random);
    q.obstacle.response = Response::velocity();
    const Boundary found = boundary(q.obstacle, 9);
    for (const auto* side : {&found.left, &found.right, &found.cap}) {
      for (const Vec2 u : *side) {
        ASSERT_TRUE(closest_approach(q.obstacle, u).distance >=
                    q.obstacle.pair.radius - rounding({q.obstacle, u}));
      }
    }
  });
}

// So it is for any response of a pair that does not close in (p . v >= 0).
TEST(Obstacle, P3_boundary_of_a_parting_pair_is_inside_none) {
  test::in_all_cases([](Random& random) {
    Query q = query(random);
    if (dot(q.obstacle.pair.position, q.obstacle.pair.velocity) < 0.0) {
      q.obstacle.pair.velocity = -q.obstacle.pair.velocity;
    }
    const Boundary found = boundary(q.obstacle, 9);
    for (const auto* side : {&found.left, &found.right, &found.cap}) {
      for (const Vec2 u : *side) {
        ASSERT_TRUE(closest_approach(q.obstacle, u).distance >=
                    q.obstacle.pair.radius * (1.0 - 1e-12) - 4.0 * rounding({q.obstacle, u}));
      }
    }
  });
}

TEST(Obstacle, P5_larger_radius_or_horizon_never_shrinks_it) {
  test::in_all_cases([](Random& random) {
    const Query q = query(random);
    const double larger = random.log_uniform(1.0, 10.0);
    if (!(contains(q.obstacle, q.u))) return false;
    Obstacle wider = q.obstacle, longer = q.obstacle;
    wider.pair.radius *= larger;
    longer.time_horizon *= larger;
    EXPECT_TRUE(contains(wider, q.u));
    // the same path is searched on other nodes: away from a rounding band
    const double distance = closest_approach(q.obstacle, q.u).distance;
    EXPECT_TRUE(contains(longer, q.u) ||
                q.obstacle.pair.radius - distance <= rounding({longer, q.u}));
    return true;
  });
}

TEST(Obstacle, P6_powers_of_two_scale_the_closest_approach_bit_for_bit) {
  test::in_all_cases([](Random& random) {
    const Situation s = test::wide_situation(random);
    const Vec2 u = s.pair.velocity + test::in_disc(random, s.reach);
    const int length = random.below(45) - 22, time = random.below(17) - 8;
    const Situation other = test::scaled(s, std::ldexp(1.0, length), std::ldexp(1.0, time));
    const ClosestApproach original = closest_approach(test::obstacle_of(s), u);
    const ClosestApproach found =
        closest_approach(test::obstacle_of(other), std::ldexp(1.0, length - time) * u);
    ASSERT_TRUE(found.time == std::ldexp(original.time, time));
    ASSERT_TRUE(found.distance == std::ldexp(original.distance, length));
  });
}

// δ -> 0: Eq. (11) becomes Eq. (5).
TEST(Obstacle, P4_tends_to_the_velocity_obstacle) {
  test::in_all_cases([](Random& random) {
    Situation s = test::wide_situation(random);
    const Vec2 u = test::in_disc(random, 5.0);
    const Obstacle plain{s.pair, Response::velocity(), s.time_horizon};
    for (const double part : {1e-3, 1e-5, 1e-7}) {
      const Obstacle smooth{s.pair, Response::proportional(part * s.time_horizon), s.time_horizon};
      // x differs by δ E(t) (v - u)
      const double bound = part * s.time_horizon * norm(s.pair.velocity - u);
      ASSERT_TRUE(std::abs(closest_approach(smooth, u).distance -
                           closest_approach(plain, u).distance) <= bound + rounding({plain, u}));
    }
  });
}

// Whatever it is given, it ends: numbers over 300 decades, infinities, NaN.
TEST(Obstacle, closest_approach_ends_on_any_numbers) {
  Random random(7);
  const double inf = std::numeric_limits<double>::infinity();
  const double special[] = {0.0,
                            -0.0,
                            inf,
                            -inf,
                            std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::denorm_min()};
  const auto number = [&] {
    if (random.below(12) == 0) return special[random.below(6)];
    const double sign = random.below(2) == 0 ? 1.0 : -1.0;
    return sign * random.log_uniform(1e-165, 1e150);
  };
  for (int k = 0; k < 100'000; ++k) {
    const double delta = random.log_uniform(1e-9, 1e9);
    const Response responses[] = {Response::proportional(delta), Response::velocity(),
                                  Response::acceleration(), Response::held(delta)};
    const Obstacle obstacle{{{number(), number()}, {number(), number()}, 1.0},
                            responses[random.below(4)],
                            random.log_uniform(1e-9, 1e9)};
    const ClosestApproach found = closest_approach(obstacle, {number(), number()});
    ASSERT_TRUE(found.time >= 0.0 && found.time <= obstacle.time_horizon);
  }
}

}  // namespace
}  // namespace avo
