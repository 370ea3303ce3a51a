// SPDX-License-Identifier: Apache-2.0
// The curve of avo compare --arrival, against what is worked out by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo_io/sweep.h"
#include "reports/comparison.h"

namespace avo_test {
namespace {

using avo::Vec2;

/// One case of all rows.
avo_cli::Case case_of(const avo_io::SweepTable& table) {
  avo_cli::Case entry;
  entry.table = &table;
  for (const auto& row : table.rows) entry.runs.push_back(&row);
  return entry;
}

void expect_points(const avo_io::SweepTable& table, const std::vector<Vec2>& expected) {
  const std::vector<Vec2> found = avo_cli::arrivals_of(case_of(table));
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(found[k].x, expected[k].x, 1e-12) << k;
    EXPECT_NEAR(found[k].y, expected[k].y, 1e-12) << k;
  }
}

TEST(Arrivals, of_one_run_are_lines_from_the_first_to_the_last) {
  expect_points({{"last_arrival", "first_arrival", "arrival_50"}, {{"9", "3", "5"}}},
                {{0, 0}, {3, 0}, {5, 50}, {9, 100}});
}

TEST(Arrivals, are_the_mean_of_shares_and_not_of_times) {
  // at 4 s: half of 25 % and 0; at 8 s: half of 100 % and 50 %
  expect_points(
      {{"first_arrival", "arrival_50", "last_arrival"}, {{"3", "5", "6"}, {"4", "8", "10"}}},
      {{0, 0}, {3, 0}, {4, 12.5}, {5, 31.25}, {6, 62.5}, {8, 75}, {10, 100}});
}

TEST(Arrivals, stay_where_they_are_known_last) {
  // in the second run no robot arrives, and in the third run half of the robots arrive
  expect_points({{"first_arrival", "arrival_50", "arrival_90", "last_arrival"},
                 {{"2", "4", "5", "6"}, {"", "", "", ""}, {"2", "4", "", ""}}},
                {{0, 0}, {2, 0}, {4, 100.0 / 3}, {5, 140.0 / 3}, {6, 50}});
}

TEST(Arrivals, jump_where_many_arrive_at_once) {
  expect_points({{"first_arrival", "arrival_50", "last_arrival"}, {{"3", "3", "3"}}},
                {{0, 0}, {3, 0}, {3, 100}});
  expect_points(
      {{"first_arrival", "arrival_50", "last_arrival"}, {{"3", "3", "5"}, {"2", "3", "4"}}},
      {{0, 0}, {2, 0}, {3, 25}, {3, 50}, {4, 87.5}, {5, 100}});
}

TEST(Arrivals, of_nobody_are_none) {
  expect_points({{"first_arrival", "last_arrival"}, {{"", ""}}}, {{0, 0}});
}

TEST(Arrivals, of_many_runs_are_few_points) {
  avo_io::SweepTable table{{"first_arrival", "last_arrival"}, {}};
  for (int k = 0; k < 3000; ++k)
    table.rows.push_back({fmt::format("{}", 1 + k), fmt::format("{}", 4000.5 + k)});
  const std::vector<Vec2> found = avo_cli::arrivals_of(case_of(table));
  EXPECT_LE(found.size(), 2001U);
  EXPECT_EQ(found.back().x, 6999.5);
  EXPECT_EQ(found.back().y, 100.0);
  for (std::size_t k = 1; k < found.size(); ++k) EXPECT_GE(found[k].y, found[k - 1].y - 1e-12);
}

}  // namespace
}  // namespace avo_test
