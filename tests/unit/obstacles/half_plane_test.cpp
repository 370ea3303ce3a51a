// SPDX-License-Identifier: Apache-2.0
// The half-plane in cases that can be worked out by hand: ties, contact, overlap, shares, ORCA.
#include "avo/half_plane.h"

#include <cmath>
#include <gtest/gtest.h>

namespace avo {
namespace {

constexpr double kRounding = 1e-13;
constexpr double kDelta = 4.0, kTau = 10.0, kStep = 0.1;
const double kGain = kTau + kDelta * std::expm1(-kTau / kDelta);  // g(τ)
const Horizon kHorizon(kDelta, kTau, kStep);
constexpr double kReach = 8.0;

TEST(HalfPlane, at_rest_is_towards_p) {
  const RelativeHalfPlane found = half_plane({{3.0, 4.0}, {0.0, 0.0}, 1.0}, kReach, kHorizon);
  EXPECT_EQ(found.state, PairState::constrained);
  EXPECT_NEAR(found.plane.normal.x, 0.6, kRounding);
  EXPECT_NEAR(found.plane.normal.y, 0.8, kRounding);
  EXPECT_NEAR(found.plane.offset, -4.0 / kGain, kRounding);  // may close in to contact at τ
}

TEST(HalfPlane, moving_apart_fast_enough_is_free) {
  EXPECT_EQ(half_plane({{3.0, 4.0}, {30.0, 40.0}, 1.0}, 0.5, kHorizon).state, PairState::free);
}

TEST(HalfPlane, out_of_reach_is_free) {
  EXPECT_EQ(half_plane({{300.0, 0.0}, {-1.0, 0.0}, 1.0}, kReach, kHorizon).state, PairState::free);
}

TEST(HalfPlane, head_on_passes_on_the_right) {
  const RelativeHalfPlane found = half_plane({{6.0, 0.0}, {-2.0, 0.0}, 1.0}, kReach, kHorizon);
  ASSERT_EQ(found.state, PairState::constrained);
  EXPECT_GT(found.plane.offset, 0.0);
  EXPECT_GT(found.plane.normal.y, 0.0);  // left of p: A, ahead of B, goes left of p, its own right
  // the same from B's side
  const RelativeHalfPlane other = half_plane({{-6.0, 0.0}, {2.0, 0.0}, 1.0}, kReach, kHorizon);
  EXPECT_EQ(other.plane.normal, -found.plane.normal);
  EXPECT_EQ(other.plane.offset, found.plane.offset);
}

TEST(HalfPlane, contact_at_rest_forbids_closing) {
  const RelativeHalfPlane found = half_plane({{1.0, 0.0}, {0.0, 0.0}, 1.0}, kReach, kHorizon);
  ASSERT_EQ(found.state, PairState::constrained);
  EXPECT_NEAR(found.plane.normal.x, 1.0, kRounding);
  EXPECT_NEAR(found.plane.offset, 0.0, kRounding);
}

TEST(HalfPlane, unavoidable_asks_for_all_that_is_in_reach) {
  const RelativeHalfPlane found = half_plane({{1.1, 0.2}, {-3.0, 0.0}, 1.0}, kReach, kHorizon);
  ASSERT_EQ(found.state, PairState::unavoidable);
  EXPECT_EQ(found.plane.offset, kReach);
  EXPECT_GT(found.excess, 0.0);
  EXPECT_TRUE(std::isfinite(half_plane({{1.0, 0.0}, {-3.0, 0.0}, 1.0}, kReach, kHorizon).excess));
}

// The near side of the horn of these pairs was once misread. The offsets are those of a brute force
// over the hull's support.
TEST(HalfPlane, horn_that_leaves_the_reach_between_its_cusps) {
  const Pair pair{{-0.010306563999460804, 1.0254705997826155},
                  {-0.5884233876357865, -1.0109925795943762},
                  0.46707335743732381};
  const RelativeHalfPlane found =
      half_plane(pair, 2.2854234739959218, {3.0823213790112578, 1.6795238843219775, 0.1});
  EXPECT_NEAR(found.plane.offset, -0.5871969, 1e-6);  // once -0.58746, by 2.6e-4 optimistic
}

TEST(HalfPlane, horn_of_a_pair_in_contact_that_moves_across) {
  const Pair pair{{-2.091457413583115, 1.4828906774869444},
                  {1.3636619611539846, 1.9061170658831403},
                  2.5637932763976641};
  const RelativeHalfPlane found =
      half_plane(pair, 1.81967170619951, {0.38234431585920686, 9.5336638232234741, 0.1});
  EXPECT_NEAR(found.plane.offset, -0.031697, 1e-6);  // once -0.238
}

TEST(HalfPlane, horn_of_a_grazing_pair) {
  const Pair pair{{-3.1580679342098072, -1.8904893425504006},
                  {3.5276511073092074, 0.7121981991297015},
                  1.2281273175645158};
  const RelativeHalfPlane found =
      half_plane(pair, 0.4069751041727051, {0.12791741119471656, 3.0439087282391397, 0.1});
  EXPECT_NEAR(found.plane.offset, 0.0, 1e-6);  // once -0.123
}

// Its second crossing is to be looked for among many, and near where |b| is 0.
TEST(HalfPlane, horn_of_a_grazing_pair_far_from_the_end) {
  const Pair pair{{0.13425453075329963, 0.089496046799116283},
                  {4.8318007516416284, -7.6465557925532082},
                  0.16130186471266802};
  const double R = 0.75275104725076436;
  const RelativeHalfPlane found = half_plane(pair, R, {0.5, 3.0, 0.1});
  EXPECT_NEAR(found.plane.offset, -7.26e-5 * R, 1e-6);  // once -R, which admits nearly everything
}

TEST(HalfPlane, overlap_separates_along_p) {
  const RelativeHalfPlane found = half_plane({{0.9, 0.0}, {0.0, 0.0}, 1.0}, kReach, kHorizon);
  ASSERT_EQ(found.state, PairState::overlapping);
  EXPECT_EQ(found.plane.normal, (Vec2{1.0, 0.0}));
  EXPECT_GT(found.plane.offset, 0.0);
  EXPECT_LE(found.plane.offset, kReach * (1.0 + kRounding));
  // what it asks for ends the overlap within the window
  const double demand = found.plane.offset;
  const double gain = kTau + kDelta * std::expm1(-kTau / kDelta);
  EXPECT_GE(0.9 + gain * demand, 1.0);
}

TEST(HalfPlane, deeper_overlap_asks_for_no_less) {
  double last = 0.0;
  for (const double distance : {0.9999, 0.99, 0.9, 0.5, 0.1}) {
    const RelativeHalfPlane found =
        half_plane({{distance, 0.0}, {0.0, 0.0}, 1.0}, kReach, kHorizon);
    EXPECT_GE(found.plane.offset, last * (1.0 - 1e-9));
    last = found.plane.offset;
  }
}

TEST(HalfPlane, equal_centers_separate_along_v) {
  const RelativeHalfPlane found = half_plane({{0.0, 0.0}, {0.0, 2.0}, 1.0}, kReach, kHorizon);
  EXPECT_EQ(found.state, PairState::overlapping);
  EXPECT_EQ(found.plane.normal, (Vec2{0.0, 1.0}));
  EXPECT_EQ(half_plane({{0.0, 0.0}, {0.0, 0.0}, 1.0}, kReach, kHorizon).state,
            PairState::coincident);
}

// |p| = 5, r = 3: the legs of the cone have n . p = 3.
TEST(Orca, leg_of_the_cone) {
  const RelativeHalfPlane found = orca_half_plane({{5.0, 0.0}, {-9.0, 0.0}, 3.0}, 10.0, 0.1);
  EXPECT_NEAR(found.plane.normal.x, 0.6, kRounding);
  EXPECT_NEAR(found.plane.normal.y, 0.8, kRounding);
  EXPECT_NEAR(found.plane.offset, 5.4, kRounding);
}

TEST(Orca, cut_off_of_the_cone) {
  const RelativeHalfPlane found = orca_half_plane({{5.0, 0.0}, {-0.1, 0.0}, 3.0}, 10.0, 0.1);
  EXPECT_NEAR(found.plane.normal.x, 1.0, kRounding);
  EXPECT_NEAR(found.plane.offset, -0.1, kRounding);
}

TEST(Reciprocity, shares_follow_ability) {
  EXPECT_EQ(reciprocal_share(1.0, 1.0), 0.5);
  EXPECT_EQ(reciprocal_share(3.0, 1.0), 0.75);
  EXPECT_EQ(reciprocal_share(1.0, 3.0), 0.25);
  EXPECT_EQ(reciprocal_share(3.0, 1.0, 0.1, 0.1), 0.75);
  EXPECT_EQ(reciprocal_share(1.0, 1.0, 3.0, 1.0), 0.25);
  EXPECT_EQ(reciprocal_share(3.0, 1.0, 3.0, 1.0), 0.5);
  EXPECT_EQ(reciprocal_share(1.0, 1.0, 64.0, 1.0), 1.0 / 64.0);
  EXPECT_EQ(reciprocal_share(1.0, 1.0, 1.0, 1e12), 63.0 / 64.0);
  EXPECT_EQ(reciprocal_share(2.0, 0.0), 1.0);  // a mover that does not decide
  EXPECT_EQ(room_share(3.0, 1.0, 0.1, 0.1), 0.75);
  EXPECT_EQ(room_share(1.0, 1.0, 3.0, 1.0), 0.75);
  EXPECT_EQ(room_share(3.0, 1.0, 1.0, 3.0), 0.5);
  EXPECT_EQ(room_share(1.0, 1.0, 1e12, 1.0), 63.0 / 64.0);
}

// Eq. (17): scaled about v_AB, moved to v_A.
TEST(Reciprocity, apportion_scales_and_moves) {
  const HalfPlane found = apportion({{0.6, 0.8}, -2.0}, {5.0, 10.0}, 0.25);
  EXPECT_EQ(found.normal, (Vec2{0.6, 0.8}));
  EXPECT_NEAR(found.offset, 11.0 - 0.5, kRounding);
}

}  // namespace
}  // namespace avo
