// SPDX-License-Identifier: Apache-2.0
// Discs, tangents, closest approaches and half-planes against a slow reference written from the
// paper's equations alone. It carries about 1e-8 of error; 1e-6 is allowed.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "avo/half_plane.h"
#include "avo/velocity_obstacle.h"
#include "rows.h"

namespace avo {
namespace {

constexpr double kTolerance = 1e-6;

Pair pair_of(const json& row) {
  return {vec(row.at("p")), vec(row.at("v")), row.at("r").get<double>()};
}

Obstacle obstacle_of(const json& row, double time_horizon) {
  return {pair_of(row), Response::proportional(row.at("delta").get<double>()), time_horizon};
}

// Numbers of the discs grow like 1/t²; the error is relative to their size.
void expect_near(Vec2 found, Vec2 expected, double size) {
  EXPECT_LE(norm(found - expected), kTolerance * std::max(1.0, size));
}

TEST(Golden, discs_and_tangents) {
  const json rows = cases("discs.json");
  ASSERT_EQ(rows.size(), 200U);
  for (const json& row : rows) {
    SCOPED_TRACE(row.dump());
    const Disc found = disc(obstacle_of(row, 20.0), row.at("t").get<double>());
    const double size = norm(vec(row.at("centre")));
    expect_near(found.center, vec(row.at("centre")), size);
    EXPECT_NEAR(found.radius, row.at("radius").get<double>(), kTolerance * std::max(1.0, size));
    const auto [left, right] = tangent_points(found);
    const json& tangents = row.at("tangents");
    if (tangents.is_null()) {
      EXPECT_EQ(left, found.center);
      EXPECT_EQ(right, found.center);
    } else {
      expect_near(left, vec(tangents.at(0)), size);
      expect_near(right, vec(tangents.at(1)), size);
    }
  }
}

TEST(Golden, closest_approach) {
  const json rows = cases("closest_approach.json");
  ASSERT_EQ(rows.size(), 400U);
  for (const json& row : rows) {
    SCOPED_TRACE(row.dump());
    const Obstacle obstacle = obstacle_of(row, row.at("tau").get<double>());
    const ClosestApproach found = closest_approach(obstacle, vec(row.at("v_new")));
    EXPECT_NEAR(found.distance, row.at("distance").get<double>(), kTolerance);
    EXPECT_LE(found.distance, row.at("distance").get<double>() + 1e-9);
    EXPECT_NEAR(found.time, row.at("time").get<double>(), kTolerance);
    EXPECT_EQ(contains(obstacle, vec(row.at("v_new"))), row.at("collides").get<bool>());
  }
}

TEST(Golden, half_planes) {
  const json rows = cases("half_planes.json");
  ASSERT_EQ(rows.size(), 300U);
  for (const json& row : rows) {
    SCOPED_TRACE(row.dump());
    const double delta = row.at("delta").get<double>();
    const double tau = row.at("tau").get<double>();
    const double reach = delta * (row.at("max_acceleration_a").get<double>() +
                                  row.at("max_acceleration_b").get<double>());
    const RelativeHalfPlane found = half_plane(pair_of(row), reach, Horizon(delta, tau, 0.1));
    if (!row.at("constraint").get<bool>()) {
      EXPECT_EQ(found.state, PairState::free);
      continue;
    }
    ASSERT_EQ(found.state, PairState::constrained);
    const Vec2 normal = vec(row.at("normal"));
    const double offset = row.at("offset").get<double>();
    EXPECT_NEAR(found.plane.offset, offset, kTolerance);
    EXPECT_LE(norm(found.plane.normal - normal), 2e-6);
    // Nowhere within reach may the found plane allow what the reference forbids: at its own
    // nearest point, and at the ends of the reference's line.
    const double half = std::sqrt(std::max(0.0, reach * reach - offset * offset));
    for (const double along : {-half, 0.0, half}) {
      const Vec2 w = offset * normal + along * perpendicular(normal);
      EXPECT_LE(dot(found.plane.normal, w), found.plane.offset + kTolerance * std::max(1.0, reach));
    }
  }
}

}  // namespace
}  // namespace avo
