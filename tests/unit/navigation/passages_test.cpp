// SPDX-License-Identifier: Apache-2.0
// Gaps and passages are those of the set of walls, and places are told from them.
#include "navigation/passages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "navigation/gaps.h"
#include "support/walls.h"
#include "unit/navigation/buildings.h"
#include "unit/navigation/mazes.h"
#include "unit/navigation/passages.h"
#include "walls/segment.h"

namespace avo {
namespace {

using test::kWatched;
using test::passages_of;

constexpr double kRounding = 1e-9;

std::vector<Gap> gaps_of(const std::vector<Wall>& walls, const std::vector<double>& radii = {0.5}) {
  return find_gaps(ClearanceGrid(walls, gap_reach(radii, 0.3)), radii);
}

bool is_near(Vec2 p, Vec2 q) {
  return norm(p - q) <= kRounding;
}

// In either direction.
bool is_same(const Passage& one, const Passage& other) {
  const bool along =
      is_near(one.axis.front(), other.axis.front()) && is_near(one.axis.back(), other.axis.back());
  const bool against =
      is_near(one.axis.front(), other.axis.back()) && is_near(one.axis.back(), other.axis.front());
  return (along || against) && std::abs(one.length() - other.length()) <= kRounding &&
         std::abs(one.half_width - other.half_width) <= kRounding && one.radius == other.radius &&
         one.two_lanes == other.two_lanes;
}

int same_as(const Passage& passage, const Passages& others) {
  int count = 0;
  for (std::uint32_t k = 0; k < others.size(); ++k) count += is_same(passage, others[k]) ? 1 : 0;
  return count;
}

// One lane between these mouths.
void expect_one(const Passages& passages, Vec2 mouth, Vec2 other, double half_width,
                bool two_lanes) {
  ASSERT_EQ(passages.size(), 1u);
  const Passage& passage = passages[0];
  const bool turned = is_near(passage.axis.front(), other);
  EXPECT_TRUE(is_near(turned ? passage.axis.back() : passage.axis.front(), mouth));
  EXPECT_TRUE(is_near(turned ? passage.axis.front() : passage.axis.back(), other));
  EXPECT_NEAR(passage.half_width, half_width, kRounding);
  EXPECT_EQ(passage.two_lanes, two_lanes);
}

// From each end to each wall, with nothing within the circle between; without those that another
// one crosses that is no wider.
std::vector<Gap> gaps_of_all_pairs(const std::vector<Wall>& walls, double radius) {
  const double wide = 8.0 * radius;
  std::vector<Gap> all;
  for (const Wall& wall : walls) {
    for (const Vec2 end : {wall.a, wall.b}) {
      for (const Wall& other : walls) {
        const Vec2 nearest = nearest_on({other.a, other.b}, end);
        const double width = norm(nearest - end) - wall.radius - other.radius;
        if (width < 2.0 * radius - kRounding || width >= wide) continue;
        const Vec2 across = (nearest - end) / norm(nearest - end);
        const Gap gap{end + wall.radius * across, nearest - other.radius * across, radius, false};
        const bool is_free = std::all_of(walls.begin(), walls.end(), [&](const Wall& third) {
          return distance(gap.middle(), {third.a, third.b}) - third.radius >=
                 0.5 * width - kRounding;
        });
        const bool is_known = std::any_of(all.begin(), all.end(), [&](const Gap& one) {
          return (is_near(one.a, gap.a) && is_near(one.b, gap.b)) ||
                 (is_near(one.a, gap.b) && is_near(one.b, gap.a));
        });
        if (is_free && !is_known) all.push_back(gap);
      }
    }
  }
  std::vector<Gap> kept;
  for (const Gap& gap : all) {
    const bool is_crossed = std::any_of(all.begin(), all.end(), [&](const Gap& other) {
      const bool shares = is_near(gap.a, other.a) || is_near(gap.a, other.b) ||
                          is_near(gap.b, other.a) || is_near(gap.b, other.b);
      return !shares && other.width() <= (1.0 + kRounding) * gap.width() &&
             distance(Segment{gap.a, gap.b}, Segment{other.a, other.b}) == 0.0;
    });
    if (!is_crossed) kept.push_back(gap);
  }
  return kept;
}

TEST(Gaps, AreThoseOfAllPairsAmongDenseWalls) {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    // pieces that touch, far shorter than a robot, and no four ends on one circle
    std::vector<Wall> walls;
    for (int line = 0; line < 14; ++line) {
      Vec2 a{random.uniform(0.0, 6.0), random.uniform(0.0, 6.0)};
      for (int piece = 0; piece < 6; ++piece) {
        const Vec2 b = a + random.uniform(0.05, 0.3) * random.direction();
        walls.push_back({a, b, seed % 3 == 0 ? 0.02 : 0.0});
        a = b;
      }
    }
    const std::vector<Gap> found = gaps_of(walls, {0.2}), all = gaps_of_all_pairs(walls, 0.2);
    EXPECT_EQ(found.size(), all.size());
    for (const Gap& gap : all) {
      const auto is_it = [&](const Gap& one) {
        return (is_near(one.a, gap.a) && is_near(one.b, gap.b)) ||
               (is_near(one.a, gap.b) && is_near(one.b, gap.a));
      };
      EXPECT_EQ(std::count_if(found.begin(), found.end(), is_it), 1);
    }
    count += found.size();
  }
  EXPECT_GT(count, 500u);
}

TEST(Passages, ADoorIsOneFromBeforeItToBehindIt) {
  expect_one(passages_of(test::doorway(1.6)), {-0.65, 0}, {0.65, 0}, 0.8, false);
  expect_one(passages_of(test::corridor(1.6)), {-5.65, 0}, {5.65, 0}, 0.8, false);
  expect_one(passages_of(test::corridor(2.4)), {-5.65, 0}, {5.65, 0}, 1.2, true);
}

TEST(Passages, AnOfficeHasTenDoorsAndACorridor) {
  const Passages office = passages_of(test::office());
  ASSERT_EQ(office.size(), 11u);
  int doors = 0;
  for (std::uint32_t k = 0; k < office.size(); ++k) {
    if (office[k].two_lanes) {
      EXPECT_NEAR(office[k].length(), 26.9, kRounding);
      EXPECT_NEAR(office[k].half_width, 1.5, kRounding);
    } else {
      ++doors;
      EXPECT_NEAR(office[k].length(), 1.3, kRounding);
      EXPECT_NEAR(office[k].half_width, 0.8, kRounding);
    }
  }
  EXPECT_EQ(doors, 10);
}

TEST(Passages, AreTheSameInWhateverPiecesTheWallsCome) {
  for (const std::vector<Wall>& walls :
       {test::doorway(1.6), test::corridor(1.6), test::corridor(2.4), test::office(),
        test::maze(6, 1.6, 3)}) {
    const Passages whole = passages_of(walls);
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      SCOPED_TRACE(seed);
      test::Random random(seed);
      std::vector<Wall> pieces = test::in_pieces(walls, random);
      const Passages loose = passages_of(pieces);
      ASSERT_EQ(loose.size(), whole.size());
      for (std::uint32_t k = 0; k < whole.size(); ++k) EXPECT_EQ(same_as(whole[k], loose), 1) << k;
    }
  }
}

TEST(Passages, ThickWallsAndPostsMakeTheSameDoor) {
  const std::vector<std::vector<Wall>> doors{
      {{{-0.2, -5}, {-0.2, -1.0}, 0.2}, {{-0.2, 1.0}, {-0.2, 5}, 0.2}},
      {{{-0.2, 5}, {-0.2, 1.0}, 0.2}, {{-0.2, 2}, {-0.2, 1.0}, 0.1}, {{-0.2, -1}, {-0.2, -5}, 0.2}},
      {{{-0.2, -1.1}, {-0.2, -1.1}, 0.3}, {{-0.2, 1.1}, {-0.2, 1.1}, 0.3}},
      // ends of thin walls in the middle of posts
      {{{-0.2, -1.1}, {-0.2, -1.1}, 0.3},
       {{-0.2, 1.1}, {-0.2, 1.1}, 0.3},
       {{-0.2, -1.1}, {-0.2, -5}, 0.0},
       {{-0.2, 5}, {-0.2, 1.1}, 0.0}}};
  for (const std::vector<Wall>& walls : doors)
    expect_one(passages_of(walls), {-0.85, 0}, {0.45, 0}, 0.8, false);
}

// A thin wall leads on from the end of a thick wall. The end of the thick wall sticks out all the
// same.
TEST(Passages, WhatIsThickerAtAnEndIsNarrower) {
  const std::vector<Wall> walls{
      {{0, 0}, {5, 0}, 0.0}, {{5, 0}, {7, 0}, 0.3}, {{7, 0}, {12, 0}, 0.0}, {{0, 2}, {12, 2}, 0.0}};
  const Passages passages = passages_of(walls);
  ASSERT_EQ(passages.size(), 1u);
  EXPECT_NEAR(passages[0].half_width, 0.85, kRounding);
}

std::vector<Wall> bend() {
  return {{{0, 0}, {10, 0}}, {{10, 0}, {10, 10}}, {{0, 1.6}, {8.4, 1.6}}, {{8.4, 1.6}, {8.4, 10}}};
}

TEST(Passages, ABendBelongsToOne) {
  const Passages passages = passages_of(bend());
  expect_one(passages, {-0.65, 0.8}, {9.2, 10.65}, 0.8, false);
  EXPECT_NEAR(passages[0].length(), 0.65 + 8.4 + 0.8 * M_SQRT2 + 8.4 + 0.65, kRounding);
}

TEST(Passages, WhereThreeWaysMeetThreeEnd) {
  const Passages passages = passages_of({{{-10, 0}, {10, 0}},
                                         {{-10, 1.6}, {-0.8, 1.6}},
                                         {{-0.8, 1.6}, {-0.8, 10}},
                                         {{0.8, 10}, {0.8, 1.6}},
                                         {{0.8, 1.6}, {10, 1.6}}});
  ASSERT_EQ(passages.size(), 3u);
  for (std::uint32_t k = 0; k < 3; ++k) {
    EXPECT_EQ(passages[k].axis.size(), 4u);
    EXPECT_NEAR(passages[k].half_width, 0.8, kRounding);
  }
}

// The straight route from door to door leads along a wall, and the room is beside the route.
TEST(Passages, TwoDoorsInACornerOfARoomAreTwo) {
  const std::vector<Wall> walls = {{{-7, 0}, {-7, 7}}, {{-7, 0}, {0, 0}},    {{0, 0}, {0, 1.4}},
                                   {{0, 2.6}, {0, 7}}, {{-7, 7}, {-1.2, 7}}, {{0, 7}, {0, 12}}};
  const Passages passages = passages_of(walls);
  ASSERT_EQ(passages.size(), 2u);
  for (std::uint32_t k = 0; k < 2; ++k) EXPECT_EQ(passages[k].axis.size(), 3u);
}

// A lane has a pocket beside it. One robot fits into the pocket, or a route leads on from the
// pocket.
std::size_t passages_beside_a_pocket(double depth) {
  const double low = 0.8 + depth;
  return passages_of({{{-9, -0.8}, {9, -0.8}},
                      {{-9, 0.8}, {-0.7, 0.8}},
                      {{0.7, 0.8}, {9, 0.8}},
                      {{-0.7, 0.8}, {-0.7, low}},
                      {{0.7, 0.8}, {0.7, low}},
                      {{-0.7, low}, {0.7, low}}})
      .size();
}

TEST(Passages, APocketForOneRobotIsNone) {
  EXPECT_EQ(passages_beside_a_pocket(1.2), 1u) << "the lane alone";
  EXPECT_GE(passages_beside_a_pocket(4.0), 3u) << "three lanes meet";
}

// Two gaps beside the end of a wall that divides the passage do not see each other.
TEST(Passages, OneEndsWhereItBranches) {
  const Passages passages =
      passages_of({{{-10, 0}, {20, 0}}, {{20, 2.4}, {-10, 2.4}}, {{0, 1.2}, {10, 1.2}}}, {0.56});
  ASSERT_EQ(passages.size(), 4u);
  int branches = 0;
  for (std::uint32_t k = 0; k < 4; ++k) branches += passages[k].axis.size() == 4 ? 1 : 0;
  EXPECT_EQ(branches, 2);
}

// In the middle, a route from corner to corner is wider than the routes that cross it.
TEST(Passages, TheDiagonalsOfACrossingAreNoGaps) {
  std::vector<Wall> walls;
  for (const Vec2 side : {Vec2{1, 1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{-1, -1}}) {
    walls.push_back({{10 * side.x, 0.8 * side.y}, {0.8 * side.x, 0.8 * side.y}});
    walls.push_back({{0.8 * side.x, 0.8 * side.y}, {0.8 * side.x, 10 * side.y}});
  }
  const std::vector<Gap> gaps = gaps_of(walls);
  EXPECT_EQ(gaps.size(), 8u);
  for (const Gap& gap : gaps) EXPECT_NEAR(gap.width(), 1.6, kRounding);
  EXPECT_EQ(passages_of(walls).size(), 4u);
}

// Robots that enter a door to the right have their bay below it, if there is room.
TEST(Passages, BaysAreOnTheLeftOnlyWhereTheRightHasNoRoom) {
  const auto sides_with = [](const std::vector<Wall>& beside) {
    std::vector<Wall> walls = test::doorway(1.6);
    walls.insert(walls.end(), beside.begin(), beside.end());
    const Passages passages = passages_of(walls);
    std::array<double, 2> sides{};
    for (std::uint32_t k = 0; k < passages.size(); ++k) {
      const Passage& passage = passages[k];
      if (std::abs(passage.axis[1].x) > 0.5) continue;  // of the walls beside it
      const bool forward = passage.direction[0].x > 0.0;
      sides = {passage.bay_side[forward ? 0 : 1], passage.bay_side[forward ? 1 : 0]};
    }
    return sides;
  };
  const Wall below{{-8, -1.4}, {-0.3, -1.4}, 0.0}, above{{-8, 1.4}, {-0.3, 1.4}, 0.0};
  EXPECT_EQ(sides_with({}), (std::array{1.0, 1.0}));
  EXPECT_EQ(sides_with({below}), (std::array{-1.0, 1.0}));
  EXPECT_EQ(sides_with({above}), (std::array{1.0, 1.0}));
  EXPECT_EQ(sides_with({below, above}), (std::array{1.0, 1.0})) << "room on neither side";
}

TEST(Passages, AWideDoorIsNone) {
  EXPECT_EQ(passages_of(test::doorway(3.999)).size(), 1u);
  EXPECT_EQ(passages_of(test::doorway(4.0)).size(), 0u);
  EXPECT_EQ(passages_of(test::doorway(0.999)).size(), 0u) << "nobody fits";
  EXPECT_EQ(passages_of(test::doorway(1.0)).size(), 1u);
}

TEST(Passages, LanesAreThoseOfTheLargestRadiusThatFits) {
  const auto expect_door = [](const std::vector<double>& radii, double radius, bool two_lanes) {
    const Passages door = passages_of(test::doorway(1.6), radii);
    ASSERT_EQ(door.size(), 1u);
    EXPECT_EQ(door[0].radius, radius);
    EXPECT_EQ(door[0].two_lanes, two_lanes);
    EXPECT_NEAR(door[0].length(), 2.6 * radius, kRounding);
  };
  expect_door({0.5}, 0.5, false);
  expect_door({0.25}, 0.25, true);
  expect_door({0.25, 1.0}, 0.25, true);
  expect_door({0.25, 0.5}, 0.5, false);
  expect_door({0.36}, 0.36, true);
  expect_door({0.37}, 0.37, false);
  EXPECT_TRUE(passages_of(test::doorway(1.6), {0.2}).empty());
  EXPECT_TRUE(passages_of(test::doorway(1.6), {}).empty());
}

TEST(Passages, ARingEnds) {
  std::vector<Wall> walls = test::ring({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  for (const Wall& wall : test::ring({{1.6, 1.6}, {8.4, 1.6}, {8.4, 8.4}, {1.6, 8.4}}))
    walls.push_back(wall);
  const Passages passages = passages_of(walls);
  ASSERT_EQ(passages.size(), 1u);
  EXPECT_EQ(passages[0].axis.size(), 10u) << "eight gaps and two mouths";
}

// 1225 walls that make 1043 gaps: pairs of them must not be looked at for long.
TEST(Passages, ALargeMazeIsWithinReach) {
  const std::vector<Wall> walls = test::maze(34, 1.6, 4);
  const Passages passages = passages_of(walls);
  EXPECT_GT(passages.size(), 100u);
  for (std::uint32_t k = 0; k < passages.size(); ++k) EXPECT_EQ(same_as(passages[k], passages), 1);
}

TEST(Passages, ALongCorridorIsOne) {
  EXPECT_EQ(passages_of({{{0, 0}, {120, 0}}, {{120, 1.6}, {0, 1.6}}}).size(), 1u);
}

// The lines from each gap to the next gap are as narrow as the gap, and cross no wall.
TEST(Passages, TheirAxesCrossNoWall) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<Wall> walls = test::random_walls(150, 40.0, seed);
    const Passages passages = passages_of(walls, {0.3});
    EXPECT_GT(passages.size(), 20u);
    for (std::uint32_t k = 0; k < passages.size(); ++k) {
      const std::vector<Vec2>& axis = passages[k].axis;
      ASSERT_GE(axis.size(), 3u);
      for (std::size_t n = 2; n + 1 < axis.size(); ++n) {
        for (const Wall& wall : walls) {
          EXPECT_GT(distance(Segment{axis[n - 1], axis[n]}, {wall.a, wall.b}), wall.radius);
        }
      }
    }
  }
}

TEST(PassagePlaces, PointsOfTheAxisAndPlacesAreInverse) {
  const Passages door = passages_of(test::corridor(1.6)), bent = passages_of(bend());
  test::Random random(1);
  for (int k = 0; k < 1000; ++k) {
    const Passage& straight = door[0];
    const double along = random.uniform(-4.0, straight.length() + 4.0);
    const double aside = random.uniform(-3.0, 3.0);
    for (const bool forward : {true, false}) {
      const AxisPoint at = axis_point(straight, forward, along);
      const PassagePlace place = place_in(straight, at.point + aside * perpendicular(at.direction));
      EXPECT_NEAR(place.along, forward ? along : straight.length() - along, kRounding);
      EXPECT_NEAR(place.aside, forward ? aside : -aside, kRounding);
      EXPECT_NEAR(norm(at.direction), 1.0, kRounding);
      const double way = random.uniform(-4.0, bent[0].length() + 4.0);
      const PassagePlace on = place_in(bent[0], axis_point(bent[0], forward, way).point);
      EXPECT_NEAR(on.along, forward ? way : bent[0].length() - way, kRounding);
      EXPECT_NEAR(on.aside, 0.0, kRounding);
    }
  }
  EXPECT_TRUE(is_near(axis_point(door[0], true, 0.0).point, door[0].axis.front()));
  EXPECT_TRUE(is_near(axis_point(door[0], false, 0.0).point, door[0].axis.back()));
}

TEST(PassagePlaces, InsideIsBetweenMouthsAndWalls) {
  const Passages passages = passages_of(test::corridor(1.6));
  const auto is_in = [&](const Passages& of_those, Vec2 p) {
    EXPECT_EQ(of_those.at(p).has_value(), is_inside(of_those[0], place_in(of_those[0], p)));
    return of_those.at(p).has_value();
  };
  EXPECT_TRUE(is_in(passages, {0, 0}));
  EXPECT_TRUE(is_in(passages, {4.9, 0.7}));
  EXPECT_TRUE(is_in(passages, {-5.6, 0.5}));
  EXPECT_FALSE(is_in(passages, {-5.6, 0.6})) << "beside the way in";
  EXPECT_FALSE(is_in(passages, {5.2, -0.6}));
  EXPECT_FALSE(is_in(passages, {-5.7, 0}));
  EXPECT_FALSE(is_in(passages, {5.7, 0}));
  EXPECT_FALSE(is_in(passages, {0, 1.3})) << "behind a wall";
  const Passages wide = passages_of(test::corridor(2.4));
  EXPECT_TRUE(is_in(wide, {-5.6, 1.1})) << "lanes reach to the walls";
  EXPECT_FALSE(is_in(wide, {-5.6, 1.3}));
  const Passages bent = passages_of(bend());
  EXPECT_TRUE(is_in(bent, {9.5, 0.5})) << "in the outer corner";
  EXPECT_TRUE(is_in(bent, {8.6, 1.4})) << "round the inner corner";
  EXPECT_FALSE(is_in(bent, {7.3, 2.7})) << "behind it";
  EXPECT_FALSE(is_in(bent, {11.2, -1.2}));
  EXPECT_FALSE(is_in(bent, {9.2, -1.0})) << "the second leg prolonged";
  EXPECT_FALSE(is_in(bent, {11.0, 0.8})) << "the first one prolonged";
}

TEST(PassagePlaces, OneLaneComesBeforeTwo) {
  const Passages office = passages_of(test::office());
  ASSERT_TRUE(office.at({3, 1.2}) && office.at({6, 1.2}));
  EXPECT_FALSE(office[*office.at({3, 1.2})].two_lanes) << "in a door, and in the corridor";
  EXPECT_TRUE(office[*office.at({6, 1.2})].two_lanes);
  EXPECT_FALSE(office.at({3, 5}));
  // nearer to the corridor's axis than to the door's
  const Passages corridor = passages_of(
      {{{-10, 1.15}, {-0.8, 1.15}}, {{0.8, 1.15}, {10, 1.15}}, {{-10, -1.15}, {10, -1.15}}});
  ASSERT_EQ(corridor.size(), 2u);
  ASSERT_TRUE(corridor.at({0.54, 0.51}));
  EXPECT_FALSE(corridor[*corridor.at({0.54, 0.51})].two_lanes);
}

// Three doors in a row, the one in the middle with two lanes.
std::vector<Wall> three_doors() {
  std::vector<Wall> walls;
  for (int k = 0; k < 3; ++k) {
    const double x = 10.0 * k, half = k == 1 ? 1.2 : 0.8;
    walls.push_back({{x, -8}, {x, -half}});
    walls.push_back(k == 2 ? Wall{{x, 8}, {x, half}} : Wall{{x, half}, {x, 8}});
  }
  return walls;
}

TEST(PassageCrossings, TheFirstOneOfOneLaneIsToldWithItsDirection) {
  const Passages passages = passages_of(three_doors());
  ASSERT_EQ(passages.size(), 3u);
  const auto expect_crossed = [&](Vec2 p, Vec2 q, double x, double part) {
    const auto crossed = passages.first_crossed(p, q);
    ASSERT_TRUE(crossed);
    const Passage& passage = passages[crossed->passage];
    EXPECT_NEAR(passage.axis[1].x, x, kRounding);
    EXPECT_NEAR(crossed->part, part, kRounding);
    EXPECT_TRUE(leads_across(crossed->gap, p, q) && leads_across(crossed->gap, q, p));
    EXPECT_NEAR(norm(crossed->gap.b - crossed->gap.a), 2.0 * passage.half_width, kRounding);
    const Vec2 way = axis_point(passage, crossed->forward, 0.0).direction;
    EXPECT_GT(dot(way, q - p), 0.0);
  };
  expect_crossed({-5, 0.3}, {25, 0.3}, 0.0, 5.0 / 30.0);
  expect_crossed({25, -0.3}, {-5, -0.3}, 20.0, 5.0 / 30.0);
  expect_crossed({5, 0.3}, {25, 0.3}, 20.0, 0.75);
  expect_crossed({5, 0.3}, {-5, -0.3}, 0.0, 0.5);
  EXPECT_FALSE(passages.first_crossed({5, 0}, {15, 0})) << "two lanes";
  EXPECT_FALSE(passages.first_crossed({-5, 0}, {-1, 0}));
  EXPECT_FALSE(passages.first_crossed({-1, 2}, {1, 2})) << "through a wall";
  EXPECT_FALSE(Passages().first_crossed({-1, 0}, {1, 0}));
}

TEST(PassageCrossings, TheFirstNarrowOneHasOneLaneOrTwo) {
  const Passages passages = passages_of(three_doors());
  const auto expect_narrow = [&](Vec2 p, Vec2 q, double x, bool two_lanes) {
    const auto crossed = passages.first_narrow(p, q);
    ASSERT_TRUE(crossed);
    EXPECT_NEAR(passages[crossed->passage].axis[1].x, x, kRounding);
    EXPECT_EQ(passages[crossed->passage].two_lanes, two_lanes);
    EXPECT_TRUE(leads_across(crossed->gap, p, q));
  };
  expect_narrow({-5, 0.3}, {25, 0.3}, 0.0, false);
  expect_narrow({25, 0.3}, {-5, 0.3}, 20.0, false);
  expect_narrow({5, 0.3}, {25, 0.3}, 10.0, true);
  expect_narrow({5, 0.3}, {15, 0.3}, 10.0, true);
  expect_narrow({15, 0.3}, {-5, 0.3}, 10.0, true);
  EXPECT_FALSE(passages.first_narrow({-5, 0}, {-1, 0}));
  EXPECT_FALSE(Passages().first_narrow({-1, 0}, {1, 0}));
}

// Where a passage in pieces has a bend, its direction is the direction of its axis at every gap.
TEST(PassageCrossings, TheDirectionHoldsBehindABend) {
  const Passages passages = passages_of(bend());
  const Passage& passage = passages[0];
  for (std::size_t k = 1; k + 2 < passage.axis.size(); ++k) {
    const Vec2 step = passage.axis[k + 1] - passage.axis[k];
    const Vec2 p = passage.axis[k] - 0.1 * step, q = passage.axis[k] + 0.1 * step;
    ASSERT_TRUE(passages.first_crossed(p, q) && passages.first_crossed(q, p));
    EXPECT_TRUE(passages.first_crossed(p, q)->forward);
    EXPECT_FALSE(passages.first_crossed(q, p)->forward);
  }
}

TEST(PassageCrossings, WhoeverIsNearIsWatched) {
  const Passages passages = passages_of(test::office());
  test::Random random(3);
  int watched = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec2 p{random.uniform(-20.0, 50.0), random.uniform(-25.0, 25.0)};
    std::vector<char> is_visited(passages.size(), 0);
    passages.for_each_watched(p, [&](std::uint32_t number) { is_visited[number] = 1; });
    for (std::uint32_t number = 0; number < passages.size(); ++number) {
      const Passage& passage = passages[number];
      const double away = distance(p, {passage.axis.front(), passage.axis.back()});
      if (passage.two_lanes) {
        EXPECT_EQ(is_visited[number], 0);
      } else if (away <= kWatched * passage.radius) {
        ++watched;
        EXPECT_EQ(is_visited[number], 1);
      } else if (away > 4.0 * kWatched * passage.radius) {
        EXPECT_EQ(is_visited[number], 0) << "far off";
      }
    }
  }
  EXPECT_GT(watched, 100);
}

}  // namespace
}  // namespace avo
