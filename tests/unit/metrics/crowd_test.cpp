// SPDX-License-Identifier: Apache-2.0
// The tests check Voronoi cells, danger, order and the flow across a line, by hand and against
// other computations.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/error.h"
#include "metrics/voronoi.h"
#include "runs.h"
#include "support/generators.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::robot_at;

RunMetrics measured(const Scenario& scene, int steps, const MetricsOptions& options) {
  Simulation simulation(scene, 1);
  Metrics metrics(scene, options);
  metrics.observe(simulation);
  for (int k = 0; k < steps; ++k) simulation.step(), metrics.observe(simulation);
  return metrics.summary().metrics;
}

constexpr MetricsOptions kCrowd{.crowd = true};

double area_among(const std::vector<Vec2>& others) {
  VoronoiCell cell;
  cell.begin();
  for (const Vec2 other : others) cell.cut(other);
  return cell.area();
}

TEST(VoronoiCell, by_hand) {
  // a regular dodecagon in a circle of 2 m: 3 r²
  EXPECT_NEAR(area_among({}), 12.0, 1e-12);
  EXPECT_NEAR(area_among({{1, 0}, {-1, 0}, {0, 1}, {0, -1}}), 1.0, 1e-12);
  EXPECT_NEAR(area_among({{3, 0}, {-3, 0}, {0, 1}, {0, -1}, {3, 1}}), 3.0, 1e-12);
  EXPECT_NEAR(area_among({{4.0, 0}, {0, 4.0}}), 12.0, 1e-12);  // too far off
  EXPECT_NEAR(area_among({{0, 0}}), 12.0, 1e-12);              // in the very place
}

// The share of places that are nearer to the point than to any other, by counting.
TEST(VoronoiCell, has_the_places_that_are_nearest) {
  test::Random random(1);
  for (int round = 0; round < 5; ++round) {
    std::vector<Vec2> others;
    for (int k = 0; k < 4 + 2 * round; ++k)
      others.push_back({random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)});
    VoronoiCell whole;
    whole.begin();
    constexpr int kSide = 400;
    int inside = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
      const Vec2 q{4.0 * (i % kSide + 0.5) / kSide - 2.0, 4.0 * (i / kSide + 0.5) / kSide - 2.0};
      bool is_inside = true;
      for (const Vec2 other : others) is_inside &= norm(q) < norm(q - other);
      for (std::size_t k = 0; k < 12; ++k) {
        const Vec2 a = whole.corners[k], b = whole.corners[(k + 1) % 12];
        is_inside &= cross(b - a, q - a) > 0.0;
      }
      if (is_inside) ++inside;
    }
    EXPECT_NEAR(area_among(others), 16.0 * inside / (kSide * kSide), 0.02);
  }
}

// Two side by side, 1.1 m apart: each cell ends in the middle. A third one is alone.
TEST(Crowd, of_two_side_by_side_and_one_alone) {
  Scenario scene = blind(
      {cruising({0, 0}, {90, 0}), cruising({0, 1.1}, {90, 1.1}), cruising({0, 50}, {0, 150})});
  const RunMetrics m = measured(scene, 20, kCrowd);
  EXPECT_NEAR(*m.danger, 2.0 / 3.0, 1e-9);
  EXPECT_NEAR(*m.danger_separation, 0.1, 1e-9);
  EXPECT_NEAR(*m.order, std::sqrt(5.0) / 3.0, 1e-9);  // |2 ex + ey|/3
  const double half = 1.0 / area_among({{0, 1.1}});
  EXPECT_NEAR(*m.density_max, half, 1e-9);
  EXPECT_NEAR(*m.density_mean, (2.0 * half + 1.0 / 12.0) / 3.0, 1e-9);
  EXPECT_EQ(measured(scene, 20, {}).danger, std::nullopt);
}

TEST(Crowd, opposite_directions_are_no_order) {
  const Scenario scene = blind({cruising({0, 0}, {90, 0}), cruising({0, 9}, {-90, 9})});
  const RunMetrics m = measured(scene, 20, kCrowd);
  EXPECT_NEAR(*m.order, 0.0, 1e-9);
  EXPECT_EQ(*m.danger, 0.0);
  EXPECT_FALSE(m.danger_separation);
}

// Those that have arrived stand around, and have no part in it but as neighbors.
TEST(Crowd, is_that_of_trips) {
  const Scenario scene = blind({robot_at({0, 0}, {0, 0}), robot_at({0, 1.1}, {0, 1.1})});
  const RunMetrics m = measured(scene, 20, kCrowd);
  EXPECT_FALSE(m.danger);
  EXPECT_FALSE(m.density_mean);
  EXPECT_FALSE(m.order);
}

// At 2 m/s, 3 m behind each other: one every 1.5 s, the first after 1 s.
TEST(Flow, of_a_column) {
  std::vector<RobotSetup> robots;
  for (int k = 0; k < 5; ++k) robots.push_back(cruising({-2.0 - 3.0 * k, 0.3}, {90, 0.3}));
  robots.push_back(cruising({-2.0, 1.7}, {90, 1.7}));    // beside the line
  robots.push_back(cruising({-2.0, -0.9}, {90, -0.9}));  // beside the line too
  const RunMetrics m = measured(blind(robots), 120, {.line = MeasuringLine{{0, -0.8}, {0, 1.6}}});
  ASSERT_EQ(m.crossing_times->size(), 5U);
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR((*m.crossing_times)[k], 1.0 + 1.5 * static_cast<double>(k), 1e-9);
  EXPECT_NEAR(*m.flow, 1.0 / 1.5, 1e-9);
  EXPECT_NEAR(*m.specific_flow, 1.0 / 1.5 / 2.4, 1e-9);
  EXPECT_FALSE(m.danger);
}

// Each robot counts once, in both directions, and a robot that stops on the line is over the line.
TEST(Flow, counts_each_robot_once) {
  Scenario scene = blind({cruising({-3, 0}, {90, 0}), cruising({3, 5}, {-90, 5})});
  Simulation simulation(scene, 1);
  const MetricsOptions options{.line = MeasuringLine{{0, -9}, {0, 9}}};
  Metrics metrics(scene, options);
  metrics.observe(simulation);
  for (int k = 0; k < 300; ++k) {
    if (k == 30) simulation.set_goal({0}, {-90, 0});  // and back
    simulation.step();
    metrics.observe(simulation);
  }
  EXPECT_LT(simulation.fleet().position[0].x, 0.0);
  EXPECT_EQ(metrics.summary().metrics.crossing_times->size(), 2U);
}

TEST(Flow, of_fewer_than_two_is_unknown) {
  const MetricsOptions options{.line = MeasuringLine{{0, -9}, {0, 9}}};
  const RunMetrics m = measured(blind({cruising({-3, 0}, {90, 0})}), 50, options);
  EXPECT_EQ(m.crossing_times->size(), 1U);
  EXPECT_FALSE(m.flow);
  EXPECT_FALSE(m.specific_flow);
}

TEST(Flow, needs_a_line_of_two_points) {
  const Scenario scene = blind({cruising({-3, 0}, {90, 0})});
  EXPECT_THROW(Metrics(scene, {.line = MeasuringLine{{1, 2}, {1, 2}}}), Error);
  EXPECT_THROW(Metrics(scene, {.line = MeasuringLine{{1, 2}, {1, std::nan("")}}}), Error);
}

}  // namespace
}  // namespace avo
