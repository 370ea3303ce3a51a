// SPDX-License-Identifier: Apache-2.0
// Eqs. (13), (14): one robot among movers that do not react, against sampling.
#include "planner/passive_obstacles.h"

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
    const Vec2 p = (r * 1.0001 + random.uniform(0.0, 10.0)) * random.direction();
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
  return choose_among_obstacles(scene.obstacles, scene.acceleration, scene.speed, scene.preferred,
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
    try_at(around + test::in_disc(random, random.log_uniform(1e-9, 1.0)));
  }
  return best;
}

TEST(PassiveObstacles, free_choice_is_safe_and_no_sample_is_nearer) {
  Random random(14);
  int free = 0, moved = 0, jammed = 0, worse = 0;
  for (int k = 0; k < 600; ++k) {
    const Scene scene = random_scene(random, 1 + random.below(10));
    const PassiveChoice choice = choose(scene);
    if (choice.state == PassiveState::discs_disjoint) continue;
    const double sample = nearest_sample(random, scene, choice.velocity, 1500);
    if (choice.state == PassiveState::least_unsafe) {
      ++jammed;
      EXPECT_EQ(sample, std::numeric_limits<double>::infinity()) << "free velocity missed " << k;
      continue;
    }
    ++free;
    ASSERT_TRUE(is_free(scene, choice.velocity)) << k;
    const double d = norm(choice.velocity - scene.preferred);
    if (d > 0.0) ++moved;
    if (!(d <= sample + 1e-9)) {
      ++worse;
      ADD_FAILURE() << k << " sample nearer by " << d - sample << " of " << d << " n "
                    << scene.obstacles.size();
    }
  }
  std::printf("free %d moved %d jammed %d worse %d\n", free, moved, jammed, worse);
}

}  // namespace
}  // namespace avo
