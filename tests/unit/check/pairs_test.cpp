// SPDX-License-Identifier: Apache-2.0
// Pairs of robots, solved by hand: when and by how much they overlap between the rows.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "unit/check/recordings.h"

namespace avo {
namespace {

using test::free_robot;
using test::Moment;
using test::report_of;

const std::vector<CheckedRobot> kTwo{free_robot(), free_robot()};

// Robot 1 passes robot 0 at 200 m/s within a step of 0.1 s, `miss` beside it.
std::vector<Moment> pass(double miss) {
  return {{0.0, {{0, {0, 0}, {0, 0}}, {1, {-10, miss}, {200, 0}}}},
          {0.1, {{0, {0, 0}, {0, 0}}, {1, {10, miss}, {200, 0}}}}};
}

TEST(CheckPairs, sees_an_overlap_that_both_rows_miss) {
  const CheckReport report = report_of(kTwo, pass(0.5));
  EXPECT_EQ(report.overlaps.count, 1);
  ASSERT_TRUE(report.overlaps.first.has_value());
  EXPECT_NEAR(report.overlaps.first->time, 0.05 - std::sqrt(0.75) / 200.0, 1e-11);
  EXPECT_EQ(report.overlaps.first->robot, 0);
  EXPECT_EQ(report.overlaps.first->other, 1);
  EXPECT_NEAR(report.overlaps.first->amount, 0.5, 2e-9);
  EXPECT_NEAR(*report.least_clearance, -0.5, 1e-13);
  EXPECT_FALSE(report.safe());
  EXPECT_TRUE(report_of(kTwo, pass(1.25)).safe());
  EXPECT_NEAR(*report_of(kTwo, pass(1.25)).least_clearance, 0.25, 1e-13);
}

// Held accelerations: the cubic is the path. Both brake from 1 m/s at 1 m/s^2, to rest 2 gap apart.
TEST(CheckPairs, sees_the_turn_of_a_held_acceleration) {
  // x = t - t², t in [0, 1]: forth and back, 1/4 m at the most
  const std::vector<Moment> turn{{0.0, {{0, {0, 0}, {1, 0}}, {1, {1.2, 0}, {0, 0}}}},
                                 {1.0, {{0, {0, 0}, {-1, 0}}, {1, {1.2, 0}, {0, 0}}}}};
  const CheckReport report = report_of(kTwo, turn);
  EXPECT_NEAR(*report.least_clearance, -0.05, 1e-15);
  EXPECT_NEAR(report.overlaps.first->time, 0.5 - std::sqrt(0.05), 1e-8) << "t - t² = 0.2";
}

TEST(CheckPairs, contact_is_no_overlap) {
  const auto at = [](double distance) {
    return report_of(kTwo, {{0.0, {{0, {0, 0}, {1, 0}}, {1, {distance, 0}, {1, 0}}}},
                            {1.0, {{0, {1, 0}, {1, 0}}, {1, {1.0 + distance, 0}, {1, 0}}}}});
  };
  EXPECT_TRUE(at(1.0).safe());
  EXPECT_EQ(at(1.0).least_clearance, 0.0);
  EXPECT_TRUE(at(1.0 - 0.9e-9).safe()) << "the tolerance is 1e-9";
  EXPECT_FALSE(at(1.0 - 1.1e-9).safe());
  const CheckReport report = at(1.0 - 1e-8);
  EXPECT_EQ(report.overlaps.count, 1);
  EXPECT_EQ(report.overlaps.first->time, 0.0);
  EXPECT_NEAR(report.overlaps.worst, 0.9e-8, 1e-15);
}

TEST(CheckPairs, the_tolerance_is_of_the_sum_of_radii) {
  const std::vector<Moment> recording{{0.0, {{0, {0, 0}, {}}, {1, {3.98, 0}, {}}}},
                                      {1.0, {{0, {0, 0}, {}}, {1, {3.98, 0}, {}}}}};
  const std::vector<CheckedRobot> robots{free_robot(1.0), free_robot(3.0)};
  EXPECT_FALSE(report_of(robots, recording, {}, {.relative_tolerance = 0.0049}).safe());
  EXPECT_TRUE(report_of(robots, recording, {}, {.relative_tolerance = 0.0051}).safe());
}

TEST(CheckPairs, interpolation_errors_of_both_are_granted) {
  // it passes by between the rows, which are not interpolated themselves
  const std::vector<Moment> recording{{0.0, {{0, {0, 0}, {}}, {1, {0.999, -1}, {0, 2}}}},
                                      {1.0, {{0, {0, 0}, {}}, {1, {0.999, 1}, {0, 2}}}}};
  std::vector<CheckedRobot> robots = kTwo;
  robots[0].interpolation_error = 0.0007;
  EXPECT_FALSE(report_of(robots, recording).safe());
  EXPECT_EQ(report_of(robots, recording).interpolation_error, 0.0007);
  robots[1].interpolation_error = 0.0004;
  EXPECT_TRUE(report_of(robots, recording).safe());
  EXPECT_NEAR(*report_of(robots, recording).least_clearance, -0.001, 1e-15) << "as judged";
}

// Dyadic numbers: the differences of the rows are exact, so are all numbers of the report.
TEST(CheckPairs, is_the_same_far_from_the_origin) {
  const auto at = [](Vec2 origin) {
    return report_of(
        kTwo, {{0.0, {{0, origin, {0.5, 0.25}}, {1, origin + Vec2{1.25, 0}, {-0.75, 0.125}}}},
               {0.5,
                {{0, origin + Vec2{0.25, 0.125}, {0.5, 0.25}},
                 {1, origin + Vec2{0.875, 0.0625}, {-0.75, 0.125}}}}});
  };
  const CheckReport near = at({0, 0}), far = at({1e7, -1e7});
  EXPECT_EQ(near.overlaps.count, 1);
  EXPECT_EQ(far.overlaps.count, 1);
  EXPECT_EQ(near.least_clearance, far.least_clearance);
  EXPECT_EQ(near.overlaps.first->time, far.overlaps.first->time);
  EXPECT_NEAR(near.overlaps.first->time, 0.25 / 1.25, 0.02);
}

TEST(CheckPairs, robots_in_one_place) {
  const CheckReport report =
      report_of({free_robot(), free_robot(), free_robot()},
                {{2.0, {{0, {1, 1}, {}}, {1, {1, 1}, {}}, {2, {1, 1}, {}}}},
                 {3.0, {{0, {1, 1}, {}}, {1, {1, 1}, {}}, {2, {1, 1}, {}}}}});
  EXPECT_EQ(report.overlaps.count, 3) << "pairs, each once";
  EXPECT_EQ(report.least_clearance, -1.0);
  EXPECT_EQ(report.overlaps.first->time, 2.0);
  EXPECT_EQ(report.overlaps.first->robot, 0);
  EXPECT_EQ(report.overlaps.first->other, 1);
}

TEST(CheckPairs, an_overlap_in_a_single_row_counts) {
  EXPECT_EQ(report_of(kTwo, {{0.0, {{0, {0, 0}, {}}, {1, {0.5, 0}, {}}}}}).overlaps.count, 1);
  const CheckReport last = report_of(kTwo, {{0.0, {{0, {0, 0}, {0, 0}}, {1, {3, 0}, {-1, 0}}}},
                                            {1.0, {{0, {0, 0}, {0, 0}}, {1, {2, 0}, {-1, 0}}}},
                                            {2.5, {{0, {0, 0}, {0, 0}}, {1, {0.5, 0}, {-1, 0}}}}});
  EXPECT_EQ(last.overlaps.count, 1);
  EXPECT_NEAR(last.overlaps.first->time, 2.0, 1e-8) << "in the second step, not the first";
}

TEST(CheckPairs, meets_again_and_counts_once) {
  std::vector<Moment> recording;
  for (int k = 0; k <= 4; ++k) {
    const double side = k % 2 == 0 ? -5.0 : 5.0;
    recording.push_back({1.0 * k, {{0, {0, 0}, {}}, {1, {side, 0.1 * k}, {}}}});
  }
  const CheckReport report = report_of(kTwo, recording);
  EXPECT_EQ(report.overlaps.count, 1);
  EXPECT_LT(report.overlaps.first->time, 1.0);
  EXPECT_GT(report.overlaps.worst, 0.9) << "the first pass is the nearest";
  EXPECT_EQ(report.overlaps.worst, report.overlaps.first->amount);
}

TEST(CheckPairs, the_deepest_overlap_of_all_is_the_worst) {
  const std::vector<CheckedRobot> robots{free_robot(), free_robot(), free_robot(2.0)};
  const CheckReport report =
      report_of(robots, {{0.0, {{0, {0, 0}, {}}, {1, {0.7, 0}, {}}, {2, {9, 0}, {}}}},
                         {1.0, {{0, {0, 0}, {}}, {1, {0.7, 0}, {}}, {2, {9, 0}, {}}}},
                         {2.0, {{0, {0, 0}, {}}, {1, {0.7, 0}, {}}, {2, {1.5, 0}, {}}}}});
  EXPECT_EQ(report.overlaps.count, 3);
  EXPECT_NEAR(report.overlaps.first->amount, 0.3, 1e-8);
  EXPECT_NEAR(report.overlaps.worst, 1.7, 1e-8) << "0.8 m between 1 and 2";
  EXPECT_NEAR(*report.least_clearance, -1.7, 1e-8);
}

// Robots 0 and 1 are known to 0.25 m each, but not in the rows themselves.
TEST(CheckPairs, rows_are_judged_without_interpolation_error) {
  std::vector<CheckedRobot> robots(4, free_robot());
  robots[0].interpolation_error = robots[1].interpolation_error = 0.25;
  const auto at = [](double time, double distance) {
    return Moment{time,
                  {{0, {0, 0}, {}}, {1, {0.1, 0}, {}}, {2, {9, 0}, {}}, {3, {9, distance}, {}}}};
  };
  const CheckReport report = report_of(robots, {at(0, 0.9), at(1, 0.9), at(2, 0.4), at(3, 0.4)});
  EXPECT_NEAR(report.overlaps.first->amount, 0.9, 1e-8);
  EXPECT_NEAR(report.overlaps.worst, 0.9, 1e-8);
  EXPECT_EQ(report.least_clearance, -0.9);
}

TEST(CheckPairs, the_least_clearance_is_that_of_all_times) {
  const auto at = [](double time, double distance) {
    return Moment{time, {{0, {0, 0}, {}}, {1, {0, distance}, {}}}};
  };
  EXPECT_EQ(report_of(kTwo, {at(0, 10.0), at(1, 9.5), at(2, 9.75)}).least_clearance, 8.5);
}

// Two pairs touch within one step, and the report names the first pair. The direction of the sweep
// does not matter.
TEST(CheckPairs, the_first_of_a_step_is_the_first) {
  const std::vector<CheckedRobot> four(4, free_robot());
  for (const double side : {-1.0, 1.0}) {
    const auto at = [side](double time, double gap, double other) {
      return Moment{time,
                    {{0, {-20 * side, 0}, {}},
                     {1, {-20 * side, gap}, {}},
                     {2, {20 * side, 0}, {}},
                     {3, {20 * side, other}, {}}}};
    };
    EXPECT_EQ(report_of(four, {at(0, 2, 2), at(1, 0.9, 0)}).overlaps.first->robot, 2);
    EXPECT_EQ(report_of(four, {at(0, 2, 2), at(1, 0, 0.9)}).overlaps.first->robot, 0);
    EXPECT_EQ(report_of(four, {at(0, 0, 0), at(1, 0, 0)}).overlaps.first->robot, 0) << "of equals";
  }
}

// The velocity jumps at the row: the straight line stays clear, the cubic swings out.
TEST(CheckPairs, straight_robots_are_judged_on_lines) {
  const std::vector<Moment> recording{{0.0, {{0, {0, 0}, {0, 4}}, {1, {0, 1.1}, {}}}},
                                      {1.0, {{0, {-1, 0}, {-1, 0}}, {1, {0, 1.1}, {}}}}};
  EXPECT_EQ(report_of(kTwo, recording).overlaps.count, 1);
  std::vector<CheckedRobot> robots = kTwo;
  robots[0].straight = true;
  EXPECT_EQ(report_of(robots, recording).overlaps.count, 0);
  EXPECT_NEAR(*report_of(robots, recording).least_clearance, 0.1, 1e-15);
}

TEST(CheckPairs, no_pair_has_no_clearance) {
  EXPECT_EQ(report_of({free_robot()}, {{0.0, {{0, {}, {}}}}, {1.0, {{0, {}, {}}}}}).least_clearance,
            std::nullopt);
  EXPECT_EQ(report_of(kTwo, {{0.0, {{0, {}, {}}}}, {1.0, {{1, {}, {}}}}}).least_clearance,
            std::nullopt)
      << "never there together";
}

// Robot A passes through robot B, which stands or moves. The verdict depends on which robot avoids
// the other.
TEST(Pairs, count_for_those_who_avoid_the_other) {
  const auto judged = [](std::uint32_t avoids_A, std::uint32_t avoids_B, double speed_B) {
    CheckedRobot A, B;
    A.layers = 1, B.layers = 2;
    A.avoids = avoids_A, B.avoids = avoids_B;
    Check check({A, B});
    for (int k = 0; k < 80; ++k) {
      const double t = 0.1 * k;
      check.add(t, std::vector<CheckedState>{{0, {t - 4.0, 0}, {1, 0}},
                                             {1, {speed_B * (t - 4.0), 0.1}, {speed_B, 0}}});
    }
    return check.report();
  };
  const CheckReport both = judged(2, 1, 0.0), neither = judged(1, 2, 0.0);
  EXPECT_EQ(both.overlaps.count, 1);
  EXPECT_EQ(both.one_sided_contacts_moving.count + both.one_sided_contacts_at_rest, 0);
  EXPECT_TRUE(neither.safe());
  EXPECT_FALSE(neither.least_clearance);
  const CheckReport in_motion = judged(2, 2, 0.0), at_rest = judged(1, 1, 0.0);
  EXPECT_FALSE(in_motion.safe());
  EXPECT_EQ(in_motion.overlaps.count + at_rest.overlaps.count, 0);
  EXPECT_EQ(in_motion.one_sided_contacts_moving.count, 1);
  EXPECT_EQ(in_motion.one_sided_contacts_moving.first->robot, 0);
  EXPECT_EQ(in_motion.one_sided_contacts_moving.first->other, 1);
  EXPECT_FALSE(at_rest.safe()) << "it is run over";
  EXPECT_EQ(at_rest.one_sided_contacts_at_rest, 1);
  ASSERT_EQ(at_rest.one_sided_hits.size(), 1U);
  EXPECT_EQ(at_rest.one_sided_hits[0].robot, 1);
  EXPECT_EQ(at_rest.one_sided_hits[0].other, 0);
  EXPECT_FALSE(at_rest.one_sided_hits[0].moved);
  EXPECT_NEAR(at_rest.one_sided_hits[0].depth, 0.9, 1e-9);
  EXPECT_TRUE(at_rest.mover_hits.empty());
  EXPECT_EQ(judged(1, 1, -0.5).one_sided_contacts_moving.first->robot, 1);
}

}  // namespace
}  // namespace avo
