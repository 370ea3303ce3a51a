// SPDX-License-Identifier: Apache-2.0
// Priorities say who gives way.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

// s, mean over the first times within half a meter of the goal; who does not arrive counts as 200.
struct MeanArrivals {
  double first = 0.0, second = 0.0;
};

// Robots of both priorities by turns on a circle, each to the place opposite to it.
MeanArrivals on_circle(Method method, int robots, double priority, std::uint64_t seed) {
  constexpr double kTurn = 6.283185307179586, kRadius = 8.6;
  test::Random random(seed);
  Scenario scene;
  scene.method = method;
  for (int k = 0; k < robots; ++k) {
    const double angle = kTurn * k / robots + random.uniform(-0.05, 0.05);
    const Vec2 place{kRadius * std::cos(angle), kRadius * std::sin(angle)};
    scene.robots.push_back(test::robot_at(place, -place));
    if (k % 2 == 0) scene.robots.back().priority = priority;
  }
  constexpr double kLast = 200.0;
  std::vector<double> arrival(static_cast<std::size_t>(robots), kLast);
  Simulation simulation(scene, 1);
  while (simulation.time() < kLast) {
    simulation.step();
    const FleetView fleet = simulation.fleet();
    for (std::size_t k = 0; k < arrival.size(); ++k) {
      if (arrival[k] == kLast && norm(fleet.position[k] - scene.robots[k].goal) < 0.5)
        arrival[k] = simulation.time();
    }
  }
  MeanArrivals mean;
  for (std::size_t k = 0; k < arrival.size(); ++k)
    (k % 2 == 0 ? mean.first : mean.second) += 2.0 * arrival[k] / robots;
  return mean;
}

TEST(Priority, whoever_has_more_arrives_earlier) {
  for (const Method method : {Method::avo, Method::avo_paper}) {
    MeanArrivals equal, more;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const int robots = method == Method::avo ? 24 : 12;
      const auto add = [](MeanArrivals& sum, const MeanArrivals& mean) {
        sum.first += mean.first / 3.0, sum.second += mean.second / 3.0;
      };
      add(equal, on_circle(method, robots, 1.0, seed));
      add(more, on_circle(method, robots, 16.0, seed));
    }
    EXPECT_LT(more.first, equal.first);
    EXPECT_GT(more.second, equal.second);
    EXPECT_GT(more.second, 1.2 * more.first);
  }
}

}  // namespace
}  // namespace avo
