// SPDX-License-Identifier: Apache-2.0
// The curves of avo compare --scaling, against what is worked out by hand.
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "avo_io/sweep.h"
#include "reports/comparison.h"

namespace avo_test {
namespace {

using avo::Vec2;
using ScalingCurves = std::vector<std::pair<std::string, std::vector<Vec2>>>;

/// Rows of scene, method, one parameter, number of robots, ms.
ScalingCurves scaling(const std::string& parameter,
                      const std::vector<std::vector<std::string>>& rows) {
  avo_io::SweepTable table{{"sweep", "run", "scene", "method", parameter, "seed", "state_hash",
                            "robots", "step_milliseconds_median"},
                           {}};
  for (const auto& row : rows)
    table.rows.push_back({"s", "0", row[0], row[1], row[2], "1", "0x", row[3], row[4]});
  avo_cli::Comparison comparison;
  comparison.tables.emplace_back("a.csv", table);
  return avo_cli::scaling_of(cases_of(comparison));
}

TEST(Scaling, has_one_median_for_each_number_of_robots_and_method) {
  // two scenes of 10 robots: the median of all five runs, and not two points, nor of their medians
  const ScalingCurves expected{{"avo", {{10, 3}, {20, 7}}}, {"orca", {{10, 4.5}}}};
  EXPECT_EQ(scaling("p", {{"c-20", "avo", "1", "20", "7"},
                          {"c-10", "avo", "1", "10", "1"},
                          {"c-10", "avo", "1", "10", "2"},
                          {"c-10", "avo", "1", "10", "3"},
                          {"u-10", "avo", "1", "10", "40"},
                          {"u-10", "avo", "1", "10", "50"},
                          {"c-10", "orca", "1", "10", "4"},
                          {"u-10", "orca", "1", "10", "5"}}),
            expected);
}

TEST(Scaling, takes_a_parameter_that_sets_the_number_for_no_other_curve) {
  EXPECT_EQ(scaling("groups.0.number", {{"c", "avo", "10", "10", "1"},
                                        {"c", "avo", "20", "20", "2"},
                                        {"c", "orca", "10", "10", "3"},
                                        {"c", "orca", "20", "20", "4"}}),
            (ScalingCurves{{"avo", {{10, 1}, {20, 2}}}, {"orca", {{10, 3}, {20, 4}}}}));
}

TEST(Scaling, has_a_curve_for_each_value_of_another_parameter) {
  EXPECT_EQ(scaling("sensing_radius", {{"c-10", "avo", "5", "10", "1"},
                                       {"c-20", "avo", "5", "20", "2"},
                                       {"c-10", "avo", "8", "10", "3"},
                                       {"c-20", "avo", "8", "20", "4"}}),
            (ScalingCurves{{"5", {{10, 1}, {20, 2}}}, {"8", {{10, 3}, {20, 4}}}}));
}

TEST(Scaling, leaves_out_runs_without_a_time) {
  EXPECT_EQ(scaling("p", {{"c", "avo", "1", "10", ""}, {"c", "orca", "1", "10", "2"}}),
            (ScalingCurves{{"orca", {{10, 2}}}}));
}

}  // namespace
}  // namespace avo_test
