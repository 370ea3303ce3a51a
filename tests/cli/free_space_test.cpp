// SPDX-License-Identifier: Apache-2.0
// Where a disc has room: the answers of a search through all discs, whatever their sizes.
#include "io/maps/free_space.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo_io/scene.h"
#include "support/generators.h"

namespace avo_test {
namespace {

using avo::Disc;
using avo::Vec2;
using avo::test::Random;

struct Place {
  Vec2 min, max;
  double radius, clearance;
};

Place any_place(Random& random) {
  const double scale = random.log_uniform(1e-3, 1e6);
  const Vec2 min = random.log_uniform(1e-3, 1e5) * scale * random.direction();
  const Vec2 size{scale * random.uniform(0.0, 30.0),
                  random.below(5) == 0 ? 0.0 : scale * random.uniform(0.0, 30.0)};
  return {min, min + size, scale * random.log_uniform(0.01, 2.0),
          random.below(2) == 0 ? 0.0 : scale * random.log_uniform(0.01, 2.0)};
}

Vec2 point_in(const Place& place, Random& random, double beyond = 0.0) {
  const Vec2 size = place.max - place.min;
  const double x = random.uniform(-beyond, 1.0 + beyond);
  const double y = random.uniform(-beyond, 1.0 + beyond);
  return place.min + Vec2{x * size.x, y * size.y};
}

TEST(FreeSpace, agrees_with_a_search_through_all_discs) {
  Random random(5);
  int clear = 0, taken = 0;
  for (int k = 0; k < 300 && !HasFailure(); ++k) {
    const Place place = any_place(random);
    avo_io::FreeSpace space(place.min, place.max, place.radius, place.clearance,
                            static_cast<std::size_t>(random.below(100)));
    std::vector<Disc> discs;
    for (int i = 0; i < 60; ++i) {
      const double radius = place.radius * random.log_uniform(0.01, 20.0);
      discs.push_back({point_in(place, random, 0.3), random.below(2) == 0 ? place.radius : radius});
      space.add(discs.back());
      for (int j = 0; j < 10; ++j) {
        const Vec2 center = point_in(place, random);
        const bool expected = std::none_of(discs.begin(), discs.end(), [&](const Disc& disc) {
          return norm(center - disc.center) < place.radius + disc.radius + place.clearance;
        });
        EXPECT_EQ(space.is_clear(center), expected);
        ++(expected ? clear : taken);
      }
    }
  }
  EXPECT_GT(clear, 10000);
  EXPECT_GT(taken, 10000);
}

// Next to where discs touch there is one point at most, and the very next double is free.
TEST(FreeSpace, touching_is_clear_and_nearer_is_not) {
  avo_io::FreeSpace space({0, 0}, {100, 100}, 0.5, 0.25, 10);
  space.add({{50, 50}, 0.5});
  for (const Vec2 way : {Vec2{1.25, 0}, Vec2{-1.25, 0}, Vec2{0, 1.25}, Vec2{0.75, -1.0}}) {
    EXPECT_TRUE(space.is_clear(Vec2{50, 50} + way));
    EXPECT_FALSE(space.is_clear(Vec2{50, 50} + 0.999999 * way));
  }
}

TEST(FreeSpace, of_the_smallest_and_largest_sizes) {
  for (const double size : {0.0, 5e-324, 1.0, 1e12}) {
    for (const double radius : {5e-324, 1e-300, 1e12}) {
      avo_io::FreeSpace space({0, 0}, {size, size}, radius, 0.0, 2);
      EXPECT_TRUE(space.is_clear({0, 0}));
      space.add({{0, 0}, radius});
      EXPECT_FALSE(space.is_clear({0, 0}));
      EXPECT_EQ(space.is_clear({size, size}), std::sqrt(2.0) * size >= 2.0 * radius);
    }
  }
}

std::uint64_t hash_of(const avo::Scenario& scenario) {
  std::uint64_t hash = 0;
  const auto add = [&](double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 0x100000001b3U;
  };
  for (const avo::RobotSetup& robot : scenario.robots) {
    add(robot.position.x), add(robot.position.y), add(robot.goal.x), add(robot.goal.y);
  }
  return hash;
}

const std::string kThreeSizes = R"yaml(version: 1
moving_obstacles: [{position: [0, 8], radius: 30}]
groups:
  - {number: 400, radius: 0.5, placement: {random: {min: [-50, -50], max: [50, 50], clearance: 0.2}},
     goals: {random: {min: [-50, -50], max: [50, 50]}}}
  - {number: 9, radius: 4, placement: {random: {min: [-80, -50], max: [80, 50]}},
     goals: {random: {min: [0, 0], max: [90, 9]}}}
  - {number: NUMBER, radius: 0.3, placement: {random: {min: [-50, -50], max: [50, 50]}},
     goals: {random: {min: [-50, -50], max: [50, 50]}}}
)yaml";

std::string three_sizes(int number) {
  std::string text = kThreeSizes;
  return text.replace(text.find("NUMBER"), 6, std::to_string(number));
}

// Pinned: the places that the seeds have dealt from the start.
TEST(FreeSpace, random_placements_keep_their_bits) {
  EXPECT_EQ(hash_of(avo_io::parse_scenario(three_sizes(3000), "f")), 17603348102689901284U);
  EXPECT_EQ(hash_of(avo_io::load_scenario("uniform-1000")), 10285251189373852979U);
  EXPECT_EQ(hash_of(avo_io::load_scenario("cars-100")), 12929317441872892883U);
}

TEST(FreeSpace, room_is_found_for_as_many_as_ever) {
  try {
    avo_io::parse_scenario(three_sizes(12000), "f");
    FAIL();
  } catch (const avo_io::SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("found room for 11299 of 12000"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace avo_test
