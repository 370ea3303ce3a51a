// SPDX-License-Identifier: Apache-2.0
// The scenes of robots among obstacles that react to nobody: at rest, or with a velocity they keep.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "placement.h"
#include "scenes.h"

namespace avo::safety {

Scene doorway() {
  constexpr double kPost = 0.25;  // m, radius; the posts touch
  Scenario scenario = usual_scenario();
  for (const double side : {-1.0, 1.0}) {
    for (const Vec2 start : block({8.0 * side, 0.0}, 4, 4, 2.0)) {
      scenario.robots.push_back(usual_robot(start, start - Vec2{16.0 * side, 0.0}, kSpeed));
    }
    for (int k = 0; k < 30; ++k) {
      MovingObstacle post;
      post.position = {0.0, side * (1.5 + 2.0 * kPost * k)};
      post.radius = kPost;
      scenario.moving_obstacles.push_back(post);
    }
  }
  return measured_by_straight_time(std::move(scenario));
}

Scene among_movers(std::uint64_t seed) {
  constexpr std::size_t kRobots = 20;
  constexpr double kSide = 20.0, kFar = 24.0;  // m, of the square; whence the obstacles come
  Scene scene{usual_scenario()};
  Random random(seed, 8);
  const std::vector<double> radii(kRobots, 0.5);
  const std::vector<Vec2> starts = random_places(radii, kSide, 0.3, random);
  const std::vector<Vec2> goals = random_places(radii, kSide, 0.5, random);
  for (std::size_t i = 0; i < kRobots; ++i) {
    scene.scenario.robots.push_back(usual_robot(starts[i], goals[i], kSpeed));
  }
  for (int k = 0; k < 8; ++k) {
    MovingObstacle mover;
    mover.position = kFar * circle_point(k, 8);
    const Vec2 way = random.in_square(0.5 * kSide) - mover.position;
    mover.velocity = (random.between(0.5, 1.5) / norm(way)) * way;
    mover.radius = random.between(0.3, 0.8);
    scene.scenario.moving_obstacles.push_back(mover);
  }
  scene.unit = scene.scenario.duration = 60.0;
  return scene;
}

}  // namespace avo::safety
