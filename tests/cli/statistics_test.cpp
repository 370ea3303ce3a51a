// SPDX-License-Identifier: Apache-2.0
// Statistics of sweeps, against values worked out by hand and with many digits.
#include "io/sweep/statistics.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tuple>
#include <utility>

#include "avo_io/sweep.h"
#include "sweeps.h"

namespace avo_test {
namespace {

TEST(Statistics, quantiles_lie_on_a_line_between_neighbors) {
  const std::vector<double> values{1, 2, 4, 8};
  EXPECT_EQ(avo_io::quantile(values, 0.0), 1.0);
  EXPECT_EQ(avo_io::quantile(values, 0.5), 3.0);
  EXPECT_DOUBLE_EQ(avo_io::quantile(values, 0.95), 4.0 + 0.85 * 4.0);
  EXPECT_EQ(avo_io::quantile(values, 1.0), 8.0);
  EXPECT_EQ(avo_io::quantile({5.0}, 0.95), 5.0);
  EXPECT_EQ(avo_io::quantile({1, 2, 3}, 0.5), 2.0);
}

TEST(Statistics, of_student_are_those_of_the_exact_distribution) {
  // tan(0.475 π), √(361/19.5), and so on, by the incomplete beta function with 30 digits
  const std::pair<int, double> cases[] = {
      {1, 12.706204736174705},   {2, 4.3026527297494639},  {3, 3.1824463052837096},
      {4, 2.7764451051977944},   {5, 2.5705818356363155},  {10, 2.2281388519862747},
      {19, 2.0930240544083098},  {30, 2.0422724563012383}, {100, 1.9839715185235523},
      {998, 1.9623438462163346}, {999, 1.96234146113345},  {1000, 1.9623390808264085}};
  for (const auto& [freedom, t] : cases)
    EXPECT_NEAR(avo_io::student_95(freedom), t, 1e-12 * t) << freedom;
}

TEST(Statistics, interval_of_a_mean) {
  // 2, 4, 6: mean 4, s = 2, t_2 = 4.3027
  const auto interval = avo_io::mean_interval({2, 4, 6});
  ASSERT_TRUE(interval.has_value());
  EXPECT_NEAR(interval->low, 4.0 - 4.3026527297494639 * 2.0 / std::sqrt(3.0), 1e-10);
  EXPECT_NEAR(interval->high, 4.0 + 4.3026527297494639 * 2.0 / std::sqrt(3.0), 1e-10);
  EXPECT_FALSE(avo_io::mean_interval({7.0}).has_value());
  const auto same = avo_io::mean_interval({0.1, 0.1, 0.1});
  EXPECT_EQ(same->low, 0.1);
  EXPECT_EQ(same->high, 0.1);
  EXPECT_EQ(avo_io::mean_of({0.1, 0.1, 0.1}), 0.1);
}

TEST(Statistics, interval_of_a_share) {
  // Newcombe 1998, table I: 81 of 263, 15 of 148, 0 of 20, 1 of 29
  const std::tuple<int, int, double, double> cases[] = {{81, 263, 0.2553, 0.3662},
                                                        {15, 148, 0.0624, 0.1605},
                                                        {0, 20, 0.0, 0.1611},
                                                        {1, 29, 0.0061, 0.1718}};
  for (const auto& [number, of, low, high] : cases) {
    const avo_io::Interval found = avo_io::share_interval(number, of);
    EXPECT_NEAR(found.low, low, 5e-5);
    EXPECT_NEAR(found.high, high, 5e-5);
  }
  EXPECT_EQ(avo_io::share_interval(5, 5).high, 1.0);
}

TEST(Statistics, summary_has_a_row_for_each_set_of_parameters) {
  const avo_io::SweepTable runs{
      {"sweep", "run", "scene", "method", "d", "seed", "state_hash", "collided", "last_arrival"},
      {{"s", "0", "a", "avo", "1", "1", "0x0", "0", "10"},
       {"s", "1", "a", "avo", "2", "1", "0x1", "1", ""},
       {"s", "2", "a", "avo", "1", "2", "0x2", "1", "30"},
       {"s", "3", "a", "avo", "1", "3", "0x3", "0", ""}}};
  const avo_io::SweepTable summary = summary_of(runs);
  EXPECT_THAT(
      summary.columns,
      testing::ElementsAre("scene", "method", "d", "runs", "collided.count", "collided.median",
                           "collided.p95", "collided.mean", "collided.low", "collided.high",
                           "last_arrival.count", "last_arrival.median", "last_arrival.p95",
                           "last_arrival.mean", "last_arrival.low", "last_arrival.high"));
  ASSERT_EQ(summary.rows.size(), 2U);
  const Strings &one = summary.rows[0], &two = summary.rows[1];
  EXPECT_EQ((Strings{one.begin(), one.begin() + 7}), (Strings{"a", "avo", "1", "3", "3", "", ""}));
  EXPECT_NEAR(*avo_io::number_in(one[7]), 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(*avo_io::number_in(one[8]), 0.0615, 1e-4);  // Wilson, 1 of 3
  EXPECT_NEAR(*avo_io::number_in(one[9]), 0.7923, 1e-4);
  EXPECT_EQ((Strings{one.begin() + 10, one.begin() + 14}), (Strings{"2", "20", "29", "20"}));
  EXPECT_NEAR(*avo_io::number_in(one[14]), 20.0 - 127.06204736174705, 1e-9);
  EXPECT_EQ((Strings{two.begin(), two.begin() + 5}), (Strings{"a", "avo", "2", "1", "1"}));
  EXPECT_EQ((Strings{two.begin() + 7, two.begin() + 10}), (Strings{"1", "", ""}))
      << "of one run no interval, not of shares either";
  EXPECT_EQ((Strings{two.begin() + 10, two.end()}), (Strings{"0", "", "", "", "", ""}));
}

}  // namespace
}  // namespace avo_test
