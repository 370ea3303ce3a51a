// SPDX-License-Identifier: Apache-2.0
// Passages of space, and robots that meet there.
#include "space/routes/passages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "avo/space/metrics.h"
#include "avo/space/simulation.h"
#include "core/elementary.h"
#include "unit/space/draws.h"
#include "unit/space/shortest.h"

namespace avo::space::tests {
namespace {

// A block without end but for a tube along the z axis or the x axis, of that width, from -half to
// half.
std::vector<Box> block(bool is_upright, double width, double half) {
  const double w = 0.5 * width;
  const auto at = [&](double a, double b, double along) {
    return is_upright ? Vec3{a, b, along} : Vec3{along, a, b};
  };
  return {box_of(at(-Box::kFar, -Box::kFar, -half), at(-w, Box::kFar, half)),
          box_of(at(w, -Box::kFar, -half), at(Box::kFar, Box::kFar, half)),
          box_of(at(-w, -Box::kFar, -half), at(w, -w, half)),
          box_of(at(-w, w, -half), at(w, Box::kFar, half))};
}

SpacePassages passages_of(const std::vector<Box>& boxes, double radius = 0.5) {
  return SpacePassages(Solids(boxes), std::span(&radius, 1));
}

TEST(SpacePassages, are_windows_and_shafts_of_one_lane_and_of_two) {
  for (const bool is_upright : {true, false}) {
    for (const double width : {0.9, 1.6, 3.0, 5.0}) {
      const SpacePassages found = passages_of(block(is_upright, width, 4.0));
      if (width == 0.9 || width == 5.0) {
        EXPECT_TRUE(found.empty()) << width;
        continue;
      }
      ASSERT_EQ(found.size(), 1U) << width;
      EXPECT_EQ(found[0].plane.two_lanes, width == 3.0);
      EXPECT_NEAR(found[0].length(), 8.0 + 2.0 * 0.65, 1e-9);
      EXPECT_NEAR(found[0].half_lanes, 0.5 * width, 1e-12);
      EXPECT_NEAR(norm(found[0].mouth), 4.65, 1e-9);
    }
  }
}

TEST(SpacePassages, need_four_sides_and_two_open_ends) {
  const std::vector<Box> slab = {
      box_of({-Box::kFar, -Box::kFar, -Box::kFar}, {Box::kFar, Box::kFar, 0.0}),
      box_of({-Box::kFar, -Box::kFar, 1.6}, {Box::kFar, Box::kFar, Box::kFar})};
  EXPECT_TRUE(passages_of(slab).empty());
  std::vector<Box> corridor = slab;  // 4 m long, with a floor and a ceiling
  corridor.push_back(box_of({-2, -5, 0}, {2, -0.8, 1.6}));
  EXPECT_TRUE(passages_of(corridor).empty());
  corridor.push_back(box_of({-2, 0.8, 0}, {2, 5, 1.6}));
  ASSERT_EQ(passages_of(corridor).size(), 1U);
  EXPECT_FALSE(passages_of(corridor)[0].plane.two_lanes);
  corridor.push_back(box_of({2, -5, 0}, {2.2, 5, 1.6}));  // a dead end
  EXPECT_TRUE(passages_of(corridor).empty());
}

TEST(SpacePassages, do_not_depend_on_how_a_wall_is_cut_into_boxes_or_turned) {
  std::vector<Box> cut;
  for (const Box& one : block(true, 1.6, 4.0)) {
    for (const auto& [low, high] : {std::array{-4.0, 1.0}, {1.0, 2.5}, {2.5, 4.0}}) {
      cut.push_back(one);
      cut.back().min.z = low, cut.back().max.z = high;
    }
  }
  const SpacePassages found = passages_of(cut);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].length(), 9.3, 1e-9);
  std::vector<Box> turned = block(false, 1.6, 0.1);
  for (Box& one : turned) one.heading = 0.7;
  const SpacePassages window = passages_of(turned);
  ASSERT_EQ(window.size(), 1U);
  EXPECT_NEAR(std::abs(window[0].axis.x), std::cos(0.7), 1e-12);
  EXPECT_NEAR(std::abs(window[0].axis.y), std::sin(0.7), 1e-12);
}

// A wall without thickness from a to b, as scenes make it of a polyline.
Box thin_wall(Vec2 a, Vec2 b, double low, double high) {
  Box box;
  box.heading = elementary::atan2(b.y - a.y, b.x - a.x);
  const Vec2 axis = elementary::direction(box.heading);
  const double from = axis.x * a.y - axis.y * a.x, to = axis.x * b.y - axis.y * b.x;
  box.min = {dot(axis, a), std::min(from, to), low};
  box.max = {dot(axis, b), std::max(from, to), high};
  return box;
}

// Rounding leaves thin boxes out of line, some more than others.
TEST(SpacePassages, are_windows_in_thin_walls_whatever_their_directions) {
  for (int turn = 0; turn < 16; ++turn) {
    for (int reversed = 0; reversed < 16; ++reversed) {
      SCOPED_TRACE(testing::Message() << turn << ' ' << reversed);
      const double angle = turn * std::numbers::pi / 8.0;
      const Vec2 along{std::cos(angle), std::sin(angle)};
      std::vector<Box> walls;
      const auto add = [&](double from, double to, double low, double high) {
        if ((reversed >> walls.size()) % 2 != 0) std::swap(from, to);
        walls.push_back(thin_wall(from * along, to * along, low, high));
      };
      add(-6.0, -0.8, -3.0, 3.0), add(0.8, 6.0, -3.0, 3.0);
      add(-0.8, 0.8, -3.0, -0.8), add(-0.8, 0.8, 0.8, 3.0);
      EXPECT_EQ(passages_of(walls).size(), 1U);
    }
  }
}

TEST(SpacePassages, are_of_the_largest_robots_that_fit) {
  const std::array radii{0.2, 0.5, 0.9};
  const SpacePassages found(Solids(block(true, 1.6, 4.0)), radii);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].plane.radius, 0.5);
}

// Robots on both sides with goals on the other one.
Scenario meeting(std::vector<Box> boxes, bool is_upright, double half, int each, int seed) {
  Scenario scene;
  scene.boxes = std::move(boxes);
  Draws draws(static_cast<std::uint64_t>(seed));
  std::vector<Vec3> taken;
  const auto place = [&](double side) {
    for (;;) {
      const double along = side * draws.between(half + 1.5, half + 8.0);
      const double a = draws.between(-4, 4), b = draws.between(-4, 4);
      const Vec3 p = is_upright ? Vec3{a, b, along} : Vec3{along, a, b};
      const bool is_free = std::all_of(taken.begin(), taken.end(),
                                       [&](Vec3 other) { return norm(p - other) > 1.3; });
      if (is_free) return taken.push_back(p), p;
    }
  };
  for (int k = 0; k < 2 * each; ++k) {
    const double side = k % 2 == 0 ? 1.0 : -1.0;
    scene.robots.push_back({.position = place(side)});
  }
  taken.clear();
  for (int k = 0; k < 2 * each; ++k)
    scene.robots[static_cast<std::size_t>(k)].goal = place(k % 2 == 0 ? -1.0 : 1.0);
  return scene;
}

RunSummary run(const Scenario& scene, double limit) {
  Simulation simulation(scene);
  Metrics metrics(scene);
  metrics.observe(simulation);
  while (!metrics.all_arrived() && simulation.time() < limit) {
    simulation.step();
    metrics.observe(simulation);
  }
  return metrics.summary();
}

void expect_arrival(const Scenario& scene, double limit) {
  const RunSummary summary = run(scene, limit);
  EXPECT_EQ(summary.arrived, summary.robots);
  EXPECT_EQ(summary.collision_pairs, 0);
  EXPECT_EQ(summary.static_collisions, 0);
}

TEST(SpacePassages, of_one_lane_let_opposed_streams_through_in_turn) {
  expect_arrival(meeting(block(true, 1.6, 4.0), true, 4.0, 5, 1), 60.0);
  expect_arrival(meeting(block(false, 1.6, 0.1), false, 0.1, 5, 1), 60.0);
}

TEST(SpacePassages, of_two_lanes_let_opposed_streams_through_at_once) {
  expect_arrival(meeting(block(false, 3.0, 0.1), false, 0.1, 25, 1), 50.0);
  expect_arrival(meeting(block(true, 3.0, 4.0), true, 4.0, 25, 1), 50.0);
}

}  // namespace
}  // namespace avo::space::tests
