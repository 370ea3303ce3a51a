// SPDX-License-Identifier: Apache-2.0
// The tests check which robot goes first through a passage of one lane, and where the other robots
// wait.
#include "navigation/right_of_way.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

#include "mazes.h"

namespace avo {
namespace {

using test::Random;
using test::turned;

constexpr double kSensed = 40.0;      // m
constexpr double kMostBraking = 1.0;  // m/s²

/// A straight one of 10 m from mouth to mouth, 1.6 m wide, for robots of 0.5 m.
Passage straight(double angle = 0.0) {
  Passage passage{{{-5, 0}, {-4.35, 0}, {4.35, 0}, {5, 0}},
                  {0.0, 0.65, 9.35, 10.0},
                  {{1, 0}, {1, 0}, {1, 0}},
                  0.8,
                  0.5,
                  false};
  for (Vec2& p : passage.axis) p = turned(p, angle);
  for (Vec2& direction : passage.direction) direction = turned(direction, angle);
  return passage;
}

Claimant outside(const Passage& passage, bool forward, Vec2 position) {
  const Vec2 mouth = axis_point(passage, forward, 0.0).point;
  return {{0, forward, false, norm(mouth - position)}, position};
}
Claimant inside(bool forward, Vec2 position) {
  return {{0, forward, true, 0.0}, position};
}

Course course_of(const Passage& passage, const Claimant& robot,
                 const std::vector<Claimant>& claimants, double sensed = kSensed) {
  return right_of_way(passage, robot, kMostBraking, claimants, sensed);
}

bool goes(const Course& course) {
  return !course.target && std::isinf(course.max_speed);
}
bool goes(const Passage& passage, const Claimant& robot, const std::vector<Claimant>& claimants) {
  return goes(course_of(passage, robot, claimants));
}

// Where the goals of robots A and B leave room for one robot, A and B come to rest side by side.
TEST(RightOfWay, WhoSharesAGoalIsNotWaitedFor) {
  const Passage passage = straight();
  Claimant robot = outside(passage, true, {-6.0, 0}), comes = inside(false, {-1.0, 0});
  const auto share = [&](double apart, double room) {
    robot.goal = {2.0, 0.0}, comes.goal = {2.0 + apart, 0.0};
    robot.room = 0.5, comes.room = room;
    return goes(passage, robot, {comes});
  };
  EXPECT_TRUE(share(0.0, 0.5));
  EXPECT_TRUE(share(0.9, 0.5));
  EXPECT_FALSE(share(1.0, 0.5));
  EXPECT_FALSE(share(0.0, 0.0)) << "nothing is known of its goal";
}

// Where two of them overlap, they have to part first, and the others make room as for strangers.
TEST(RightOfWay, WhoSharesAGoalIsWaitedForWhereSomeOverlap) {
  const Passage passage = straight();
  const auto sharer = [](Claimant one) {
    one.goal = {2.0, 0.0}, one.room = 0.5;
    return one;
  };
  const Claimant robot = sharer(outside(passage, true, {-6.0, 0}));
  const auto may_go = [&](double apart) {
    return goes(passage, robot,
                {sharer(inside(false, {-1.0, 0})), sharer(inside(false, {-1.0 + apart, 0}))});
  };
  EXPECT_TRUE(may_go(1.1));
  EXPECT_TRUE(may_go(1.0)) << "contact is no overlap";
  EXPECT_FALSE(may_go(0.9));
}

// All of a row make room at once, or the first one could not.
TEST(RightOfWay, AWholeRowMakesRoom) {
  const Passage passage = straight();
  std::vector<Claimant> row;
  for (const double x : {0.0, 1.05, 2.1, 3.15}) {
    Claimant one = inside(false, {x, 0});
    one.claim.ends = true, one.claim.moves = false, one.room = 0.5;
    row.push_back(one);
  }
  const Claimant comes = inside(true, {-2.0, 0});
  for (const Claimant& one : row) {
    std::vector<Claimant> all = row;
    EXPECT_TRUE(goes(passage, one, all)) << one.position.x << ": nobody comes";
    all.push_back(comes);
    const Course course = course_of(passage, one, all);
    ASSERT_TRUE(course.target) << one.position.x;
    EXPECT_GT(course.target->x, 4.0);
  }
}

TEST(RightOfWay, NobodyEntersAgainstSomebodyInside) {
  const Passage passage = straight();
  for (const double along : {-4.9, -1.0, 0.0, 4.9}) {
    const Claimant comes = inside(false, {along, 0});
    for (const double before : {-5.1, -7.0, -12.0})
      EXPECT_FALSE(goes(passage, outside(passage, true, {before, 0}), {comes}));
    EXPECT_TRUE(goes(passage, outside(passage, true, {-5.1, 0}), {inside(true, {along, 0})}));
    EXPECT_TRUE(goes(passage, outside(passage, false, {5.1, 0}), {comes}));
  }
}

TEST(RightOfWay, TheNearerOneGoesFirst) {
  const Passage passage = straight();
  const Claimant near = outside(passage, true, {-6, 0.5}), far = outside(passage, false, {6.3, 0});
  EXPECT_TRUE(goes(passage, near, {near, far}));
  EXPECT_FALSE(goes(passage, far, {near, far}));
  const Claimant third = outside(passage, false, {5.5, 0});
  EXPECT_FALSE(goes(passage, near, {near, far, third}));
  EXPECT_FALSE(goes(passage, far, {near, far, third}))
      << "its own side's first one does not help it";
  EXPECT_TRUE(goes(passage, third, {near, far, third}));
}

TEST(RightOfWay, OfTwoExactlyOneGoesHoweverSymmetric) {
  Random random(1);
  for (const double angle : {0.0, M_PI / 2.0, M_PI, 0.7}) {
    const Passage passage = straight(angle);
    for (int k = 0; k < 500; ++k) {
      const Vec2 place{random.uniform(-12.0, -5.1), random.uniform(-2.0, 2.0)};
      const Vec2 mirrored = k % 2 == 0 ? Vec2{-place.x, place.y} : -1.0 * place;
      Claimant one = outside(passage, true, turned(place, angle));
      Claimant other = outside(passage, false, turned(mirrored, angle));
      if (k % 4 < 2) other.claim.distance = one.claim.distance;
      EXPECT_NE(goes(passage, one, {one, other}), goes(passage, other, {other, one}));
    }
  }
}

TEST(RightOfWay, OneAboveTheOtherExactlyOneGoes) {
  Passage passage = straight();
  for (Vec2& p : passage.axis) p = {0.0, p.x};
  const Claimant one = outside(passage, true, {0.25, -7}),
                 other = outside(passage, false, {0.25, 7});
  EXPECT_NE(goes(passage, one, {one, other}), goes(passage, other, {other, one}));
  const Claimant up = inside(true, {0.25, -1}), down = inside(false, {0.25, 1});
  EXPECT_NE(goes(passage, up, {up, down}), goes(passage, down, {up, down}));
}

TEST(RightOfWay, WhoIsBeyondTheSensingRadiusDoesNotCount) {
  const Passage passage = straight();
  const Claimant robot = outside(passage, true, {-8, 0});
  const std::vector<Claimant> comes{inside(false, {2, 0})},
      waits{outside(passage, false, {5.5, 0})};
  EXPECT_FALSE(goes(course_of(passage, robot, comes, 10.01)));
  EXPECT_TRUE(goes(course_of(passage, robot, comes, 9.99)));
  EXPECT_FALSE(goes(course_of(passage, robot, waits, 13.51)));
  EXPECT_TRUE(goes(course_of(passage, robot, waits, 13.49)));
  const Claimant late = inside(true, {-4, 0});
  EXPECT_FALSE(goes(course_of(passage, late, comes, 6.01)));
  EXPECT_TRUE(goes(course_of(passage, late, comes, 5.99)));
}

// Follows the course as a point with that deceleration; where it comes to rest.
Vec2 waits_at(const Passage& passage, Vec2 p, const std::vector<Claimant>& claimants) {
  constexpr double kStep = 0.01;
  const Vec2 mouth = axis_point(passage, true, 0.0).point;
  double speed = 1.5;
  for (int k = 0; k < 4000; ++k) {
    const Course course = course_of(passage, outside(passage, true, p), claimants);
    const Vec2 way = course.target.value_or(mouth) - p;
    const double left = norm(way);
    speed = std::min({speed + kStep * kMostBraking, 1.5, course.max_speed});
    if (course.stops) speed = std::min(speed, std::sqrt(2.0 * kMostBraking * left));
    if (left > 0.0) p = p + std::min(kStep * speed, left) * (way / left);
  }
  return p;
}

TEST(RightOfWay, WhoWaitsLeavesTheWayOutClear) {
  for (const double angle : {0.0, 2.1}) {
    const Passage passage = straight(angle);
    const std::vector<Claimant> claimants{inside(false, turned({0, 0}, angle))};
    Random random(2);
    for (int k = 0; k < 300; ++k) {
      const Vec2 start{random.uniform(-12.0, -5.3), random.uniform(-5.0, 5.0)};
      SCOPED_TRACE(testing::Message() << start.x << " " << start.y);
      const Vec2 rest = turned(waits_at(passage, turned(start, angle), claimants), -angle);
      const double out = -5.0 - rest.x, right = -rest.y;
      // six radii straight out are kept clear but for the right-hand side
      EXPECT_TRUE(out >= 3.0 - 0.03 || right >= 0.8 - 0.03) << rest.x << " " << rest.y;
      EXPECT_GE(norm(rest - Vec2{-5.0, 0.0}), 0.9) << "beside the mouth itself";
      EXPECT_LT(norm(rest - Vec2{-5.0, 0.0}), 8.0);
      EXPECT_GT(out, 0.1) << "in the wall";
    }
  }
}

TEST(RightOfWay, WhoComesStraightIsStoppedSixRadiiBefore) {
  const Passage passage = straight();
  for (const double behind : {0.0, 0.02, 0.5, 3.0}) {
    const Claimant robot = outside(passage, true, {-8.0 - behind, 0.3});
    const Course course = course_of(passage, robot, {inside(false, {0, 0})});
    EXPECT_FALSE(course.target);
    EXPECT_NEAR(course.max_speed, std::sqrt(2.0 * kMostBraking * behind), 1e-6);
  }
  const Claimant near = outside(passage, true, {-7.99, 0.3});
  EXPECT_TRUE(course_of(passage, near, {inside(false, {0, 0})}).target);
}

TEST(RightOfWay, WhoIsInTheWayGoesAsideToItsRight) {
  const Passage passage = straight();
  const std::vector<Claimant> claimants{inside(false, {0, 0})};
  const Course course = course_of(passage, outside(passage, true, {-6, 0.3}), claimants);
  ASSERT_TRUE(course.target);
  EXPECT_TRUE(course.stops);
  EXPECT_NEAR(course.target->x, -6.0, 1e-12);
  EXPECT_NEAR(course.target->y, -1.55, 1e-12);
  const Course other =
      course_of(passage, outside(passage, false, {6, 0.3}), {inside(true, {0, 0})});
  ASSERT_TRUE(other.target);
  EXPECT_NEAR(other.target->y, 1.55, 1e-12);
  const Course beside = course_of(passage, outside(passage, true, {-5.1, 0}), claimants);
  EXPECT_NEAR(beside.target->x, -5.6, 1e-12) << "clear of the wall";
}

TEST(RightOfWay, OfTwoDirectionsInsideExactlyOneGoesBack) {
  const Passage passage = straight();
  Random random(3);
  int both = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<Claimant> all;
    const int count = 2 + random.below(4);
    for (int n = 0; n < count; ++n) {
      const double x =
          k % 3 == 0 && n % 2 == 1 ? -all.back().position.x : random.uniform(-5.0, 5.0);
      all.push_back(inside(random.below(2) == 0, {x, random.uniform(-0.2, 0.2)}));
    }
    const auto is_forward = [](const Claimant& robot) { return robot.claim.forward; };
    const bool meet = !std::all_of(all.begin(), all.end(), is_forward) &&
                      !std::none_of(all.begin(), all.end(), is_forward);
    std::optional<bool> forward, backward;  // whether robots of this direction go on
    for (const Claimant& robot : all) {
      const Course course = course_of(passage, robot, all);
      std::optional<bool>& side = robot.claim.forward ? forward : backward;
      EXPECT_TRUE(!side || *side == goes(course)) << "all of one direction do alike";
      side = goes(course);
      if (goes(course)) continue;
      ASSERT_TRUE(course.target) << "out by the mouth that it came from";
      EXPECT_FALSE(course.stops);
      EXPECT_NEAR(course.target->x, robot.claim.forward ? -6.25 : 6.25, 1e-12);
    }
    if (!meet) {
      EXPECT_TRUE(forward.value_or(true) && backward.value_or(true));
      continue;
    }
    ++both;
    EXPECT_NE(*forward, *backward);
    // the robots of one direction go on if their first robot has come farthest
    double come = -1.0, other = -1.0;
    for (const Claimant& robot : all) {
      const double way = robot.claim.forward ? robot.position.x + 5.0 : 5.0 - robot.position.x;
      (robot.claim.forward ? come : other) = std::max(robot.claim.forward ? come : other, way);
    }
    if (std::abs(come - other) > 1e-9) {
      EXPECT_EQ(*forward, come > other);
    }
  }
  EXPECT_GT(both, 1000);
}

TEST(RightOfWay, WhoBacksOutTurnsToItsRightBeforeTheMouth) {
  const Passage passage = straight();
  const std::vector<Claimant> comes{inside(false, {-3.0, 0})};
  const Course deep = course_of(passage, inside(true, {-4.5, 0}), comes);
  const Course out = course_of(passage, inside(true, {-4.8, 0}), comes);
  ASSERT_TRUE(deep.target && out.target);
  EXPECT_NEAR(deep.target->y, 0.0, 1e-12);
  EXPECT_NEAR(out.target->y, -1.0, 1e-12);
}

Claimant resting(bool forward, Vec2 position) {
  Claimant robot = inside(forward, position);
  robot.claim.moves = false;
  return robot;
}
Claimant at_home(Vec2 position) {
  Claimant robot = resting(true, position);
  robot.claim.ends = true;
  return robot;
}

TEST(RightOfWay, WhoRestsFartherThanFiveRadiiKeepsNobodyOut) {
  const Passage passage = straight();
  const Claimant robot = outside(passage, true, {-5.1, 0});
  EXPECT_TRUE(goes(passage, robot, {resting(false, {-2.59, 0})}));
  EXPECT_FALSE(goes(passage, robot, {resting(false, {-2.61, 0})}));
  EXPECT_FALSE(goes(passage, robot, {resting(false, {0.0, 0}), inside(false, {4.0, 0})}));
}

TEST(RightOfWay, WhoRestsFartherThanFiveRadiiSendsNobodyBack) {
  const Passage passage = straight();
  const Claimant robot = inside(true, {-1.0, 0});
  EXPECT_TRUE(goes(passage, robot, {resting(false, {1.51, 0})}));
  EXPECT_TRUE(goes(passage, robot, {resting(false, {1.49, 0})})) << "that one has come less far";
  EXPECT_FALSE(goes(passage, robot, {resting(false, {0.9, 0})}));
  EXPECT_FALSE(goes(passage, inside(true, {-4.0, 0}), {inside(false, {0.0, 0})})) << "it moves";
  EXPECT_TRUE(goes(passage, inside(true, {-4.0, 0}), {resting(false, {0.0, 0})}));
}

TEST(RightOfWay, WhoHasItsGoalInsideGoesOnBeforeWhoComesNear) {
  const Passage passage = straight();
  const auto goes_out_at = [&](const Claimant& robot, const std::vector<Claimant>& all) {
    const Course course = course_of(passage, robot, all);
    return course.target ? course.target->x : 0.0;
  };
  const Claimant robot = at_home({0.5, 0});
  EXPECT_NEAR(goes_out_at(robot, {inside(true, {-1.9, 0})}), 6.25, 1e-12);
  EXPECT_NEAR(goes_out_at(robot, {inside(false, {2.9, 0})}), -6.25, 1e-12);
  EXPECT_EQ(goes_out_at(robot, {}), 0.0);
  EXPECT_EQ(goes_out_at(robot, {inside(true, {-2.1, 0})}), 0.0) << "not near yet";
  EXPECT_EQ(goes_out_at(robot, {inside(true, {2.0, 0})}), 0.0) << "past already";
  EXPECT_EQ(goes_out_at(robot, {resting(true, {-1.0, 0})}), 0.0) << "it has come as well";
  EXPECT_NEAR(goes_out_at(robot, {inside(true, {-1.5, 0}), inside(false, {2.4, 0})}), 6.25, 1e-12)
      << "with those who have come farther, though others are nearer";
  EXPECT_NEAR(goes_out_at(robot, {inside(true, {-2.7, 0}), inside(false, {2.4, 0})}), -6.25, 1e-12);
  EXPECT_NEAR(goes_out_at(at_home({4.5, 0}), {inside(true, {-1.0, 0}), inside(false, {4.9, 0})}),
              6.25, 1e-12)
      << "though these are not near yet";
  const Claimant before = outside(passage, false, {5.5, 0});
  EXPECT_NEAR(goes_out_at(at_home({4.5, 0}), {before}), -6.25, 1e-12) << "one at the mouth";
}

TEST(RightOfWay, BaysAreOnTheSideWhereThereIsRoom) {
  Passage passage = straight();
  passage.bay_side = {-1.0, 1.0};
  const std::vector<Claimant> comes{inside(false, {-3.0, 0})};
  const Course waits = course_of(passage, outside(passage, true, {-6, 0}), comes);
  const Course backs = course_of(passage, inside(true, {-4.8, 0}), comes);
  ASSERT_TRUE(waits.target && backs.target);
  EXPECT_NEAR(waits.target->y, 1.55, 1e-12);
  EXPECT_NEAR(backs.target->y, 1.0, 1e-12);
  const Course beside = course_of(passage, outside(passage, true, {-6, 0.81}), comes);
  EXPECT_FALSE(beside.target) << "it stays beside the way out";
}

// A robot does not block itself, whatever the robot seems to do.
TEST(RightOfWay, WhoIsAloneGoesOn) {
  const Passage passage = straight();
  Random random(4);
  for (int k = 0; k < 1000; ++k) {
    const Vec2 p{k % 10 == 0 ? 0.0 : random.uniform(-12.0, 12.0), random.uniform(-0.5, 0.5)};
    const Vec2 v = k % 3 == 0 ? Vec2{} : Vec2{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)};
    const bool forward = random.below(2) == 0;
    const bool is_in = is_inside(passage, place_in(passage, p));
    const Claimant robot = is_in ? inside(forward, p) : outside(passage, forward, p);
    const auto claim = seen_claim(passage, 0, p, v);
    EXPECT_TRUE(
        goes(passage, robot, claim ? std::vector{Claimant{*claim, p}} : std::vector<Claimant>{}));
  }
}

TEST(SeenClaim, InsideIsByMotionAndAtRestByTheNearerMouth) {
  const Passage passage = straight();
  const auto seen = [&](Vec2 p, Vec2 v) {
    const auto claim = seen_claim(passage, 7, p, v);
    EXPECT_TRUE(claim && claim->inside && claim->passage == 7 && claim->distance == 0.0);
    EXPECT_TRUE(claim && claim->moves == (std::abs(v.x) > 0.1) && !claim->ends);
    return claim && claim->forward;
  };
  EXPECT_TRUE(seen({4, 0}, {0.11, 0}));
  EXPECT_FALSE(seen({-4, 0}, {-0.11, 0}));
  EXPECT_TRUE(seen({-4, 0}, {-0.09, 0})) << "at rest";
  EXPECT_FALSE(seen({4, 0}, {0.09, 0}));
  EXPECT_FALSE(seen({4, 0}, {0.0, 2.0})) << "across";
  EXPECT_TRUE(seen({-4, 0}, {0.0, 2.0})) << "across";
  EXPECT_TRUE(seen({-0.01, 0}, {}));
  EXPECT_FALSE(seen({0.01, 0}, {}));
}

TEST(SeenClaim, OutsideIsByMotionTowardsTheMouth) {
  const Passage passage = straight();
  const auto claim = seen_claim(passage, 7, {-8, 1}, {0.4, -0.1});
  ASSERT_TRUE(claim);
  EXPECT_TRUE(claim->forward);
  EXPECT_FALSE(claim->inside);
  EXPECT_NEAR(claim->distance, std::sqrt(10.0), 1e-12);
  const auto back = seen_claim(passage, 7, {8, 1}, {-0.4, -0.1});
  EXPECT_TRUE(back && !back->forward && !back->inside);
  EXPECT_FALSE(seen_claim(passage, 7, {-8, 1}, {-0.4, 0.1})) << "away";
  EXPECT_FALSE(seen_claim(passage, 7, {-8, 1}, {0.2, 0.6})) << "past";
  EXPECT_FALSE(seen_claim(passage, 7, {-8, 0}, {0.09, 0.0})) << "at rest";
  EXPECT_TRUE(seen_claim(passage, 7, {-8, 0}, {0.11, 0.0}));
  EXPECT_FALSE(seen_claim(passage, 7, {-13.01, 0}, {1.0, 0.0})) << "far off";
  EXPECT_TRUE(seen_claim(passage, 7, {-12.99, 0}, {1.0, 0.0}));
}

TEST(Lanes, HaveRoomBesideTheWallsAndEachOther) {
  Passage passage = straight();
  passage.two_lanes = true;
  for (passage.half_width = 1.1; passage.half_width < 2.0; passage.half_width += 0.01) {
    const double offset = lane_offset(passage);
    EXPECT_GE(passage.half_width - offset, passage.radius) << passage.half_width;
    EXPECT_GE(offset, passage.radius) << "clear of the other lane";
    EXPECT_LE(offset, std::max(0.65, 0.5 * passage.half_width));
  }
}

}  // namespace
}  // namespace avo
