// SPDX-License-Identifier: Apache-2.0
// avo run: the metrics of a summary are those of the library, in a fixed order.
#include "avo/metrics.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/simulation.h"
#include "avo_io/recording.h"
#include "avo_io/scene.h"
#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

const Strings kMetricsKeys{"trips",
                           "collision_robot_steps",
                           "overlap_depth",
                           "success",
                           "collision",
                           "timeout",
                           "extra_time_mean",
                           "extra_time_p75",
                           "extra_time_p90",
                           "flowtime",
                           "path_ratio",
                           "effort",
                           "acceleration_rms",
                           "jerk",
                           "reversals",
                           "turned_back",
                           "efficacy",
                           "deadlock_time",
                           "step_ms_p50",
                           "step_ms_p99",
                           "danger",
                           "danger_separation",
                           "order",
                           "density_mean",
                           "density_max",
                           "flow",
                           "specific_flow",
                           "crossing_times"};

Strings names_of(const Json& json) {
  Strings keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

TEST(RunMetrics, are_those_of_the_library) {
  const Strings overrides{"duration=40", "control_time=3"};
  const std::string path = path_of("out.json");
  const ProcessResult result = run_avo(
      {"run", "circle-30", "--summary", path, "--set", overrides[0], "--set", overrides[1]});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(read_file(path))["metrics"];
  EXPECT_EQ(names_of(json), kMetricsKeys);

  const avo::Scenario scenario = avo_io::load_scenario("circle-30", overrides);
  avo::Simulation simulation(scenario, 1);
  avo::Metrics metrics(scenario, {.crowd = true, .line = avo::MeasuringLine{{-60, 0}, {60, 0}}});
  metrics.observe(simulation);
  for (int step = 0; step < 400; ++step) {
    simulation.step();
    metrics.observe(simulation);
  }
  const avo::RunSummary run = metrics.summary();
  const avo::RunMetrics& expected = run.metrics;
  EXPECT_EQ(json["trips"], 30);
  EXPECT_EQ(json["collision_robot_steps"], expected.collision_robot_steps);
  EXPECT_EQ(json["overlap_depth"], expected.overlap_depth);
  EXPECT_EQ(json["success"], *expected.success);
  EXPECT_EQ(json["collision"], *expected.collision);
  EXPECT_EQ(json["timeout"], *expected.timeout);
  EXPECT_EQ(json["extra_time_mean"], *expected.extra_time_mean);
  EXPECT_EQ(json["extra_time_p75"], *expected.extra_time_p75);
  EXPECT_EQ(json["extra_time_p90"], *expected.extra_time_p90);
  EXPECT_EQ(json["flowtime"], *expected.flowtime);
  EXPECT_EQ(json["path_ratio"], *expected.path_ratio);
  EXPECT_EQ(json["effort"], *expected.effort);
  EXPECT_EQ(json["acceleration_rms"], *expected.acceleration_rms);
  EXPECT_EQ(json["jerk"], *expected.jerk);
  EXPECT_EQ(json["reversals"], *expected.reversals);
  EXPECT_EQ(json["turned_back"], *expected.turned_back);
  EXPECT_EQ(json["efficacy"], *expected.efficacy);
  EXPECT_EQ(json["deadlock_time"], *expected.deadlock_time);
  EXPECT_GT(json["step_ms_p50"], 0.0);
  EXPECT_GE(json["step_ms_p99"], json["step_ms_p50"]);
  for (const char* dear : {"danger", "danger_separation", "order", "density_mean", "density_max",
                           "flow", "specific_flow", "crossing_times"})
    EXPECT_TRUE(json[dear].is_null()) << dear;

  const Json all = Json::parse(avo_io::to_json(run))["metrics"];
  EXPECT_EQ(names_of(all), kMetricsKeys);
  EXPECT_EQ(all["danger"], *expected.danger);
  EXPECT_EQ(all["danger_separation"], *expected.danger_separation);
  EXPECT_EQ(all["order"], *expected.order);
  EXPECT_EQ(all["density_mean"], *expected.density_mean);
  EXPECT_EQ(all["density_max"], *expected.density_max);
  EXPECT_EQ(all["flow"], *expected.flow);
  EXPECT_EQ(all["specific_flow"], *expected.specific_flow);
  EXPECT_EQ(all["crossing_times"], *expected.crossing_times);
}

TEST(RunMetrics, are_null_where_there_is_nothing) {
  const std::string path = path_of("out.json");
  ASSERT_EQ(
      run_avo({"run", "moving-obstacle", "--summary", path, "--set", "duration=0.1"}).exit_code, 0);
  const Json json = Json::parse(read_file(path))["metrics"];
  EXPECT_EQ(json["trips"], 1);
  EXPECT_EQ(json["timeout"], 1.0);
  for (const char* key : {"extra_time_mean", "extra_time_p75", "extra_time_p90", "flowtime",
                          "path_ratio", "jerk", "turned_back", "danger", "flow", "crossing_times"})
    EXPECT_TRUE(json[key].is_null()) << key;
}

}  // namespace
}  // namespace avo_test
