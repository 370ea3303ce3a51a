// SPDX-License-Identifier: Apache-2.0
// Eqs. (13), (14): one robot among movers that do not react, against sampling.
#include "planner/methods/passive_obstacles.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "support/brute_force.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::Random;

struct Scene {
  std::vector<PassiveObstacle> obstacles;
  Disc acceleration, speed;
  Vec2 preferred;
  double size = 1.0;  // m
};

// `count` movers around a robot; proportional control, or velocities adopted at once.
Scene random_scene(Random& random, int count) {
  Scene scene;
  const bool at_once = random.below(4) == 0;
  const double control_time = random.log_uniform(0.3, 6.0);
  const double horizon = random.log_uniform(1.0, 15.0);
  const double v_max = random.uniform(0.5, 3.0);
  const double a_max = random.uniform(0.2, 2.0);
  const Vec2 v_A = test::in_disc(random, v_max);
  const double inf = std::numeric_limits<double>::infinity();
  scene.speed = {{}, v_max};
  scene.acceleration = at_once ? Disc{{}, inf} : Disc{v_A, control_time * a_max};
  scene.preferred = test::in_disc(random, 1.2 * v_max);
  const Response response = at_once ? Response::velocity() : Response::proportional(control_time);
  for (int k = 0; k < count; ++k) {
    const Vec2 v_B = test::in_disc(random, 2.5);
    const Vec2 a_B = random.below(3) == 0 ? test::in_disc(random, 0.5) : Vec2{};
    const double r = random.log_uniform(0.2, 2.0);
    const double distance = r * 1.0001 + random.uniform(0.0, 10.0);
    const Vec2 p = distance * random.direction();
    scene.obstacles.push_back(
        {{{p, v_A - v_B, r}, response, horizon}, v_B + response.control_time() * a_B});
  }
  return scene;
}

// The projections on the discs are exact to a few roundings.
bool in_disc(const Disc& disc, Vec2 u) {
  return norm(u - disc.center) <= disc.radius + 1e-15 * (norm(disc.center) + disc.radius);
}

bool is_free(const Scene& scene, Vec2 u) {
  if (!in_disc(scene.acceleration, u) || !in_disc(scene.speed, u)) return false;
  for (const PassiveObstacle& each : scene.obstacles) {
    if (contains(each.obstacle, u - each.v_new_B)) return false;
  }
  return true;
}

PassiveChoice choose(const Scene& scene) {
  PassiveWorkspace workspace;
  return choose_among_movers(scene.obstacles, scene.acceleration, scene.speed, scene.preferred,
                             workspace);
}

// Free samples of the discs, and of shrinking neighborhoods of the choice, that beat it.
double nearest_sample(Random& random, const Scene& scene, Vec2 around, int count) {
  double best = std::numeric_limits<double>::infinity();
  const auto try_at = [&](Vec2 u) {
    const double d = norm(u - scene.preferred);
    if (d < best && is_free(scene, u)) best = d;
  };
  for (int k = 0; k < count; ++k) {
    try_at(scene.speed.center + test::in_disc(random, scene.speed.radius));
    try_at(scene.acceleration.center +
           test::in_disc(random, std::min(100.0, scene.acceleration.radius)));
    const double size = random.log_uniform(1e-9, 1.0);
    try_at(around + test::in_disc(random, size));
  }
  return best;
}

// Properties (1) and (2) of choose_among_movers.
TEST(PassiveObstacles, P2_free_choice_is_safe_and_no_sample_is_nearer) {
  Random random(14);
  int moved = 0, jammed = 0;
  for (int k = 0; k < 1500; ++k) {
    const Scene scene = random_scene(random, 1 + random.below(10));
    const PassiveChoice choice = choose(scene);
    if (choice.state == PassiveState::discs_disjoint) continue;
    const double sample = nearest_sample(random, scene, choice.velocity, 1500);
    if (choice.state == PassiveState::least_unsafe) {
      ++jammed;
      EXPECT_GT(choice.violation, 0.0);
      EXPECT_EQ(sample, std::numeric_limits<double>::infinity()) << "missed in scene " << k;
      continue;
    }
    EXPECT_EQ(choice.violation, 0.0);
    EXPECT_TRUE(is_free(scene, choice.velocity)) << "scene " << k;
    const double distance = norm(choice.velocity - scene.preferred);
    if (distance > 0.0) ++moved;
    EXPECT_LE(distance, sample + 1e-9) << "scene " << k;
  }
  EXPECT_GT(moved, 500);
  EXPECT_GT(jammed, 100);
}

// Movers in contact, grazing, head-on, at rest, just out of reach: in contact the obstacle cannot
// be drawn larger, and the choice may touch it to rounding.
TEST(PassiveObstacles, P1_free_choice_is_safe_in_degenerate_scenes) {
  Random random(8);
  int moved = 0, jammed = 0;
  for (int k = 0; k < 3000; ++k) {
    Scene scene = random_scene(random, 0);
    const Vec2 v_A = std::isfinite(scene.acceleration.radius) ? scene.acceleration.center
                                                              : test::in_disc(random, 1.0);
    const double control_time = random.log_uniform(0.3, 6.0);
    const Response response = std::isfinite(scene.acceleration.radius)
                                  ? Response::proportional(control_time)
                                  : Response::velocity();
    const int count = 1 + random.below(4);
    for (int i = 0; i < count; ++i) {
      const test::Situation s = test::degenerate_situation(random);
      scene.obstacles.push_back({{s.pair, response, s.time_horizon}, v_A - s.pair.velocity});
    }
    if (random.below(3) == 0) scene.preferred = v_A;
    const PassiveChoice choice = choose(scene);
    ASSERT_TRUE(is_finite(choice.velocity)) << "scene " << k;
    if (choice.state == PassiveState::discs_disjoint) continue;
    EXPECT_TRUE(in_disc(scene.acceleration, choice.velocity));
    EXPECT_TRUE(in_disc(scene.speed, choice.velocity));
    if (choice.state == PassiveState::least_unsafe) {
      ++jammed;
      continue;
    }
    if (norm(choice.velocity - scene.preferred) > 0.0) ++moved;
    for (const PassiveObstacle& each : scene.obstacles) {
      const Pair& pair = each.obstacle.pair;
      const double distance =
          closest_approach(each.obstacle, choice.velocity - each.v_new_B).distance;
      const double rounding =
          1e-13 * (norm(pair.position) +
                   each.obstacle.time_horizon * (norm(pair.velocity) + scene.speed.radius));
      EXPECT_GE(distance, pair.radius - rounding) << "scene " << k;
    }
  }
  EXPECT_GT(moved, 500);
  EXPECT_GT(jammed, 100);
}

// Property (4): hardly ever is a sampled velocity much less unsafe. (The violation jumps where the
// closest approach does, so that a small pocket can be missed: 5 of 2000 jams by a tenth of v_max.)
TEST(PassiveObstacles, least_unsafe_is_about_the_least) {
  Random random(4);
  int jammed = 0, missed = 0;
  for (int k = 0; k < 3000 && jammed < 150; ++k) {
    const Scene scene = random_scene(random, 4 + random.below(8));
    const PassiveChoice choice = choose(scene);
    if (choice.state != PassiveState::least_unsafe) continue;
    ++jammed;
    EXPECT_TRUE(in_disc(scene.acceleration, choice.velocity) &&
                in_disc(scene.speed, choice.velocity));
    const auto violation_of = [&](Vec2 u) {
      double worst = 0.0;
      for (const PassiveObstacle& each : scene.obstacles) {
        const ClosestApproach nearest = closest_approach(each.obstacle, u - each.v_new_B);
        const double depth = each.obstacle.pair.radius - nearest.distance;
        if (depth > 0.0) worst = std::max(worst, depth / each.obstacle.response.gain(nearest.time));
      }
      return worst;
    };
    EXPECT_NEAR(choice.violation, violation_of(choice.velocity), 1e-9);
    double least = choice.violation;
    for (int i = 0; i < 400; ++i) {
      const Vec2 u = test::in_disc(random, scene.speed.radius);
      if (in_disc(scene.acceleration, u)) least = std::min(least, violation_of(u));
    }
    if (choice.violation > least + 0.05 * scene.speed.radius) ++missed;
  }
  EXPECT_LE(missed, 3);
  EXPECT_EQ(jammed, 150);
}

// Lengths over 13 decades: the same choice, scaled, to what rounding may do.
TEST(PassiveObstacles, scales_with_length) {
  Random random(13);
  for (int k = 0; k < 300; ++k) {
    const Scene scene = random_scene(random, 1 + random.below(6));
    const PassiveChoice choice = choose(scene);
    if (choice.state != PassiveState::free) continue;
    for (const double scale : {0x1p-20, 0x1p23}) {
      Scene other = scene;
      other.acceleration = {scale * scene.acceleration.center, scale * scene.acceleration.radius};
      other.speed = {scale * scene.speed.center, scale * scene.speed.radius};
      other.preferred = scale * scene.preferred;
      for (PassiveObstacle& each : other.obstacles) {
        Pair& pair = each.obstacle.pair;
        pair = {scale * pair.position, scale * pair.velocity, scale * pair.radius};
        each.v_new_B = scale * each.v_new_B;
      }
      const PassiveChoice scaled = choose(other);
      EXPECT_EQ(scaled.state, choice.state);
      EXPECT_EQ(scaled.velocity, scale * choice.velocity) << "scene " << k;
    }
  }
}

TEST(PassiveObstacles, nothing_around_takes_what_the_discs_allow) {
  Scene scene;
  scene.acceleration = {{1.0, 0.0}, 2.0};
  scene.speed = {{}, 1.5};
  scene.preferred = {1.0, 0.5};
  EXPECT_EQ(choose(scene).velocity, scene.preferred);
  scene.preferred = {3.0, 4.0};
  EXPECT_NEAR(norm(choose(scene).velocity - Vec2{0.9, 1.2}), 0.0, 1e-15);
}

TEST(PassiveObstacles, discs_that_do_not_meet_are_said_so) {
  Scene scene;
  scene.acceleration = {{5.0, 0.0}, 1.0};
  scene.speed = {{}, 1.5};
  const PassiveChoice choice = choose(scene);
  EXPECT_EQ(choice.state, PassiveState::discs_disjoint);
  EXPECT_NEAR(choice.violation, 2.5, 1e-15);
}

// A plain velocity obstacle straight ahead: cone of half-angle asin(1/4) about +x. Preferred is the
// axis, so that both legs are equally near; the right one is taken.
TEST(PassiveObstacles, head_on_passes_on_the_right) {
  Scene scene;
  scene.acceleration = {{}, std::numeric_limits<double>::infinity()};
  scene.speed = {{}, 3.0};
  scene.preferred = {2.0, 0.0};
  scene.obstacles.push_back({{{{-4.0, 0.0}, {}, 1.0}, Response::velocity(), 50.0}, {}});
  const PassiveChoice choice = choose(scene);
  EXPECT_EQ(choice.state, PassiveState::free);
  EXPECT_NEAR(choice.velocity.x, 2.0 * 15.0 / 16.0, 1e-12);
  EXPECT_NEAR(choice.velocity.y, -2.0 * std::sqrt(15.0) / 16.0, 1e-12);
}

// Eq. (13): with an observed acceleration the obstacle is shifted by v'_B, not by v_B.
TEST(PassiveObstacles, observed_acceleration_moves_the_obstacle) {
  Scene scene;
  const double delta = 2.0;
  scene.acceleration = {{}, 4.0};
  scene.speed = {{}, 3.0};
  scene.preferred = {0.0, 0.0};  // stay: A at rest, B passes in front unless it turns towards A
  const Vec2 v_B{0.0, 0.0}, a_B{-0.5, 0.0};
  const Pair pair{{-4.0, 0.0}, -v_B, 1.0};
  const Obstacle obstacle{pair, Response::proportional(delta), 8.0};
  scene.obstacles = {{obstacle, v_B}};
  EXPECT_EQ(choose(scene).velocity, scene.preferred);
  scene.obstacles = {{obstacle, v_B + delta * a_B}};
  const PassiveChoice choice = choose(scene);
  EXPECT_EQ(choice.state, PassiveState::free);
  EXPECT_NE(choice.velocity, scene.preferred);
}

// Overlap: parted along p; the shallower, and the longer the window may be, the gentler.
TEST(PassiveObstacles, overlap_parts_along_p) {
  Scene scene;
  scene.acceleration = {{}, 4.0};
  scene.speed = {{}, 3.0};
  scene.preferred = {-1.0, 0.5};
  const Pair pair{{0.99, 0.0}, {}, 1.0};
  scene.obstacles.push_back({{pair, Response::proportional(4.0), 10.0}, {}, 0.5});
  const PassiveChoice choice = choose(scene);
  EXPECT_EQ(choice.state, PassiveState::free);
  const double needed = 0.01 / Response::proportional(4.0).gain(0.5);
  EXPECT_NEAR(choice.velocity.x, needed, 1e-12);
  EXPECT_NEAR(choice.velocity.y, 0.5, 1e-9);
  scene.obstacles[0].shortest_window = 0.0;
  EXPECT_GT(choose(scene).velocity.x, 2.9);  // as fast as the discs allow
}

TEST(PassiveObstacles, same_input_gives_the_same_bits) {
  Random random(3);
  PassiveWorkspace used;
  for (int k = 0; k < 100; ++k) {
    const Scene scene = random_scene(random, 1 + random.below(6));
    const PassiveChoice fresh = choose(scene);
    const PassiveChoice again = choose_among_movers(scene.obstacles, scene.acceleration,
                                                    scene.speed, scene.preferred, used);
    EXPECT_EQ(fresh.velocity, again.velocity);
    EXPECT_EQ(fresh.violation, again.violation);
  }
}

}  // namespace
}  // namespace avo
