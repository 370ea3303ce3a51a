// SPDX-License-Identifier: Apache-2.0
// avo bench: what it reports, not how long anything takes.
#include <cstdlib>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "reports/bench_report.h"
#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

Json bench(Strings arguments) {
  arguments.insert(arguments.begin(), "bench");
  arguments.push_back("--json");
  const ProcessResult result = run_avo(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return Json::parse(result.out);
}

TEST(Bench, json_has_the_keys_of_the_contract_and_no_others) {
  const Json json = bench({"circle-12", "--threads", "1", "--steps", "5"});
  Strings keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  EXPECT_EQ(keys, (Strings{"scene", "robots", "threads", "simd", "precision", "method",
                           "certificate", "step_milliseconds_median", "step_milliseconds_mean",
                           "step_milliseconds_densest_second", "nanoseconds_per_robot_step",
                           "pairs_per_robot", "infeasible_share", "stages"}));
  EXPECT_EQ(json["scene"], "circle-12");
  EXPECT_EQ(json["robots"], 12);
  EXPECT_EQ(json["threads"], 1);
  EXPECT_TRUE(json["simd"].is_string());
  EXPECT_EQ(json["precision"], "double");
  EXPECT_EQ(json["method"], "avo");
  EXPECT_EQ(json["certificate"], "braking_trajectories");
  const double step = json["step_milliseconds_median"];
  EXPECT_GT(step, 0.0);
  EXPECT_NEAR(json["nanoseconds_per_robot_step"].get<double>(), 1e6 * step / 12, 1e-3 * step);
  EXPECT_EQ(json["infeasible_share"], 0.0);
  ASSERT_TRUE(json["stages"].is_object());
  double all = 0.0;
  for (const auto& [stage, nanoseconds] : json["stages"].items()) {
    EXPECT_GE(nanoseconds.get<double>(), 0.0) << stage;
    all += nanoseconds.get<double>();
  }
  EXPECT_GT(all, 0.0);
}

TEST(Bench, counts_pairs_and_decisions_without_choice) {
  const auto pairs = [](const char* scene, const char* set) {
    return bench({scene, "--steps", "2", "--set", set})["pairs_per_robot"].get<double>();
  };
  // everyone of a circle of 20 m sees those within 15 m: 12 of 50
  EXPECT_EQ(pairs("circle-50", "max_neighbors=7"), 7.0);
  EXPECT_EQ(pairs("circle-50", "max_neighbors=1000"), 12.0);
  EXPECT_EQ(pairs("positions-exchange", "sensing_radius=99"), 1.0);
  const Json crowd = bench({"circle-100", "--set", "method=avo_paper", "--steps", "200"});
  EXPECT_GT(crowd["infeasible_share"], 0.01);
  EXPECT_LT(crowd["infeasible_share"], 1.0);
}

TEST(Bench, follows_what_is_set) {
  const Json json =
      bench({"uniform-300", "--steps", "2", "--threads", "2", "--set", "method=avo_paper"});
  EXPECT_EQ(json["robots"], 300);
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["precision"], "double");
  EXPECT_EQ(json["method"], "avo_paper");
  EXPECT_EQ(json["certificate"], "none");
}

TEST(Bench, counts_are_those_of_any_number_of_threads) {
  const auto with = [&](const std::string& threads) {
    return bench({"uniform-600", "--steps", "4", "--threads", threads});
  };
  const Json one = with("1"), three = with("3");
  EXPECT_EQ(three["threads"], 3);
  EXPECT_EQ(one["pairs_per_robot"], three["pairs_per_robot"]);
  EXPECT_EQ(one["infeasible_share"], three["infeasible_share"]);
}

TEST(Bench, text_says_how_many_steps) {
  const auto steps = [](Strings arguments) {
    arguments.insert(arguments.begin(), "bench");
    const std::string text = run_avo(arguments).out;
    const std::size_t at = text.find("(median of ");
    return at == text.npos ? -1 : std::atoi(text.c_str() + at + 11);
  };
  EXPECT_EQ(steps({"circle-4", "--steps", "7"}), 7);
  EXPECT_EQ(steps({"uniform-20"}), 100);
  EXPECT_EQ(steps({"circle-4", "--set", "duration=3"}), 30) << "nobody arrives in 3 s";
  const int crossing = steps({"circle-4"});  // 40 m at 2 m/s, and some seconds to accelerate
  EXPECT_GT(crossing, 200);
  EXPECT_LT(crossing, 400);
}

TEST(Bench, of_free_clocks_each_robot_decides_once_a_step) {
  const Json json = bench({"circle-12", "--set", "clock=free", "--steps", "5"});
  EXPECT_EQ(json["pairs_per_robot"], bench({"circle-12", "--steps", "5"})["pairs_per_robot"]);
  EXPECT_GT(json["step_milliseconds_median"], 0.0);
  EXPECT_GE(json["step_milliseconds_densest_second"], json["step_milliseconds_median"]);
}

TEST(Bench, refuses_in_one_line) {
  const auto refused = [](Strings arguments) {
    arguments.insert(arguments.begin(), "bench");
    const ProcessResult result = run_avo(arguments);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
    return result.exit_code;
  };
  for (const std::string steps : {"0", "-1", "x", "1.5", "1000001"})
    EXPECT_EQ(refused({"circle-4", "--steps", steps}), 2) << steps;
  for (const std::string threads : {"-1", "x", "1025"})
    EXPECT_EQ(refused({"circle-4", "--threads", threads}), 2) << threads;
  EXPECT_EQ(refused({}), 2);
  EXPECT_EQ(refused({"circle-1"}), 2);
  EXPECT_EQ(refused({"circle-4", "--set", "precision=double"}), 2);
  EXPECT_EQ(refused({"no-such-scene"}), 4);
}

TEST(Bench, an_unknown_simd_target_is_refused_by_every_verb) {
  setenv("AVO_SIMD", "avx3", 1);
  for (const std::string verb : {"bench", "run", "validate"}) {
    const ProcessResult result = run_avo({verb, "circle-4"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(lines_of(result.err).size(), 1U);
    EXPECT_TRUE(result.err.starts_with("avo: AVO_SIMD: found avx3, must be ")) << result.err;
  }
  setenv("AVO_SIMD", "scalar", 1);
  EXPECT_EQ(bench({"circle-4", "--steps", "1"})["simd"], "scalar");
  unsetenv("AVO_SIMD");
}

TEST(Bench, medians) {
  EXPECT_EQ(avo_cli::median({5.0}), 5.0);
  EXPECT_EQ(avo_cli::median({9.0, 1.0, 5.0}), 5.0);
  EXPECT_EQ(avo_cli::median({4.0, 1.0, 3.0, 2.0}), 2.0);
  EXPECT_EQ(avo_cli::mean({4.0, 1.0, 4.0}), 3.0);
  EXPECT_EQ(avo_cli::densest({1.0, 9.0, 1.0, 4.0, 5.0, 6.0, 1.0}, 3), 5.0);
  EXPECT_EQ(avo_cli::densest({1.0, 3.0, 2.0}, 10), 2.0) << "all, where there are fewer";
}

}  // namespace
}  // namespace avo_test
