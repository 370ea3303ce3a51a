// SPDX-License-Identifier: Apache-2.0
// Passages that are kept after edits of the walls are those that are found anew.
#include <algorithm>
#include <gtest/gtest.h>
#include <optional>
#include <utility>
#include <vector>

#include "support/walls.h"
#include "unit/navigation/mazes.h"
#include "unit/navigation/passages.h"

namespace avo {
namespace {

using test::kWatched;
using test::passages_of;

void expect_same_crossing(const std::optional<Passages::Crossing>& one,
                          const std::optional<Passages::Crossing>& other) {
  ASSERT_EQ(one.has_value(), other.has_value());
  if (!one) return;
  ASSERT_EQ(one->passage, other->passage);
  ASSERT_TRUE(one->part == other->part && one->gap.a == other->gap.a);
}

// To the last bit, in their order, and told from places as those.
void expect_same_to_the_bit(const Passages& one, const Passages& other, test::Random& random,
                            double side) {
  ASSERT_EQ(one.size(), other.size());
  for (std::uint32_t k = 0; k < one.size(); ++k) {
    ASSERT_EQ(one[k].axis, other[k].axis) << k;
    ASSERT_TRUE(one[k].half_width == other[k].half_width && one[k].radius == other[k].radius);
    ASSERT_EQ(one[k].two_lanes, other[k].two_lanes);
    ASSERT_EQ(one[k].bay_side, other[k].bay_side);
  }
  for (int k = 0; k < 100; ++k) {
    const Vec2 p = test::in_square(random, side), q = p + random.uniform(0, 6) * random.direction();
    ASSERT_EQ(one.at(p), other.at(p));
    expect_same_crossing(one.first_crossed(p, q), other.first_crossed(p, q));
    expect_same_crossing(one.first_narrow(p, q), other.first_narrow(p, q));
  }
}

// Walls of a building of that kind, of which some belong together as an obstacle does.
std::vector<Wall> building(std::uint64_t seed, double side) {
  switch (seed % 4) {
    case 0:
      return test::maze(static_cast<int>(side / 2.0), 2.0, seed);
    case 1:
      return test::random_walls(static_cast<int>(0.2 * side * side), side, seed);
    case 2:
      return test::noise_map(static_cast<int>(side), 0.1, seed);
    default:
      std::vector<Wall> rows;  // so long that lanes are narrow beyond the first range
      for (double y = 0.0; y < side; y += 1.3)
        for (double x = 0.0; x < side; x += 10.0) rows.push_back({{x, y}, {x + 8.5, y}, 0.0});
      return rows;
  }
}

// After any edits, one after the other: the passages are those that are found of nothing, and few
// gaps and pairs of them are looked at anew.
TEST(PassagesAfterEdits, AreThoseThatAreFoundAnew) {
  Passages::Work in_all, anew;
  std::size_t most = 0, edits_like_new = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const double side = seed % 4 == 3 ? 40.0 : 60.0;
    const std::vector<double> radii = seed % 2 == 0 ? std::vector{0.3} : std::vector{0.15, 0.35};
    std::vector<Wall> walls = building(seed, side);
    walls.push_back({{1, 1}, {1, 1}, 0.3});  // the widest
    Passages passages = passages_of(walls, radii);
    for (int edit = 0; edit < 8; ++edit) {
      SCOPED_TRACE(edit);
      const auto any_place = [&] {
        return walls.begin() + random.below(static_cast<int>(walls.size()) - 5);
      };
      const auto place = any_place();
      const Vec2 center = random.below(3) == 0 ? place->b : test::in_square(random, side);
      if (random.below(3) > 0) walls.erase(place, place + 1 + random.below(4));
      const auto where = random.below(2) == 0 ? walls.end() - 1 : place;
      std::vector<Wall> added;
      for (int k = random.below(4); k > 0; --k) {
        const Vec2 a = center + random.uniform(0.0, 2.0) * random.direction();
        const Vec2 b = a + random.log_uniform(0.2, 6.0) * random.direction();
        const double radius = random.below(3) == 0 ? 0.1 : 0.0;
        added.push_back({random.below(2) == 0 ? center : a, b, radius});
      }
      walls.insert(where, added.begin(), added.end());
      if (random.below(8) == 0) walls.erase(any_place());  // elsewhere in the list as well
      passages = Passages(walls, radii, kWatched, std::move(passages));
      const Passages expected = passages_of(walls, radii);
      expect_same_to_the_bit(passages, expected, random, side);
      if (HasFatalFailure()) return;
      ASSERT_LE(passages.work().gaps, expected.work().gaps);
      ASSERT_LE(passages.work().pairs, expected.work().pairs);
      edits_like_new += passages.work().gaps == expected.work().gaps ? 1 : 0;
      in_all.gaps += passages.work().gaps, in_all.pairs += passages.work().pairs;
      anew.gaps += expected.work().gaps, anew.pairs += expected.work().pairs;
      most = std::max(most, passages.size());
    }
  }
  EXPECT_GT(most, 500u);
  EXPECT_LT(edits_like_new, 32u);
  EXPECT_GT(anew.pairs, 500000u);
  EXPECT_LT(2 * in_all.pairs, anew.pairs) << in_all.pairs << " of " << anew.pairs;
  EXPECT_LT(2 * in_all.gaps, anew.gaps) << in_all.gaps << " of " << anew.gaps;
}

// Between two gaps that stay, a hole in a wall beside the route closes and opens. What was one wide
// place is narrow all along.
TEST(PassagesAfterEdits, SeeWallsThatAreBesideTheWayAlone) {
  const std::vector<double> radii{0.35};
  std::vector<Wall> walls{{{-20, 0}, {30, 0}},
                          {{-20, 3}, {3.5, 3}},
                          {{6.5, 3}, {30, 3}},
                          {{0, 3}, {0, 2}},
                          {{10, 3}, {10, 2}}};
  Passages passages = passages_of(walls, radii);
  ASSERT_EQ(passages.size(), 2u);
  walls.push_back({{3.5, 3}, {6.5, 3}});
  passages = Passages(walls, radii, kWatched, std::move(passages));
  ASSERT_EQ(passages_of(walls, radii).size(), 1u);
  EXPECT_EQ(passages.size(), 1u);
  walls.pop_back();
  EXPECT_EQ(Passages(walls, radii, kWatched, std::move(passages)).size(), 2u);
}

// What one short wall more costs does not depend on how many walls there are elsewhere.
TEST(PassagesAfterEdits, AreLookedForNearTheEditAlone) {
  std::vector<Passages::Work> works;
  for (const double side : {60.0, 120.0}) {
    test::Random random(7);
    std::vector<Wall> walls;
    for (int k = 0; k < static_cast<int>(0.09 * side * side); ++k) {
      const Vec2 a = test::in_square(random, side);
      walls.push_back({a, a + random.direction()});
    }
    Passages passages = passages_of(walls);
    EXPECT_GT(passages.work().pairs, 30000u);
    walls.push_back({{30.0, 30.0}, {30.3, 30.0}});
    works.push_back(Passages(walls, std::vector{0.5}, kWatched, std::move(passages)).work());
  }
  for (const Passages::Work& work : works) {
    EXPECT_LT(work.gaps, 150u);
    EXPECT_LT(work.pairs, 10000u);
  }
}

}  // namespace
}  // namespace avo
