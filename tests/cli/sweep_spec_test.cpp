// SPDX-License-Identifier: Apache-2.0
// The files of sweeps: what they say, and what is refused of each key.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "support/refusal.h"
#include "sweeps.h"

namespace avo_test {
namespace {

using testing::HasSubstr;

constexpr const char* kHead = "version: 1\nscenes: [circle-5]\n";

TEST(SweepSpec, says_what_varies) {
  const avo_io::SweepSpec spec = avo_io::parse_sweep(
      "version: 1\nscenes: [a.yaml, circle-5]\nmethods: [orca]\nthreads: 2\n"
      "parameters:\n  name: ['it''s', 7]\n  robots.0.goal: [[1, 2.5]]\n"
      "seeds: [5, 18446744073709551615]\nuntil_arrived: true\nline: [[0, -1], [2, 3]]\n"
      "judged: [4, 0]\n",
      "s");
  EXPECT_EQ(spec.scenes, (Strings{"a.yaml", "circle-5"}));
  EXPECT_EQ(spec.methods, (Strings{"orca"}));
  ASSERT_EQ(spec.parameters.size(), 2U);
  EXPECT_EQ(spec.parameters[0].values, (Strings{"'it''s'", "7"}));
  EXPECT_EQ(spec.parameters[1].values, (Strings{"[1, 2.5]"}));
  EXPECT_EQ(spec.seeds.back(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(spec.threads, 2);
  EXPECT_TRUE(spec.until_arrived);
  EXPECT_EQ(spec.judged, (std::vector<std::uint64_t>{4, 0}));
  ASSERT_TRUE(spec.line.has_value());
  EXPECT_EQ(spec.line->a, (avo::Vec2{0, -1}));
  EXPECT_EQ(spec.line->b, (avo::Vec2{2, 3}));
  EXPECT_EQ(run_count(spec), 8);
  EXPECT_EQ(run_name(spec, 7),
            "circle-5 orca name=7 robots.0.goal=[1, 2.5] seed=18446744073709551615");
}

TEST(SweepSpec, has_one_run_where_nothing_varies) {
  EXPECT_EQ(run_count(avo_io::parse_sweep(kHead, "s")), 1);
  EXPECT_EQ(avo_io::parse_sweep(kHead + std::string("seeds: {count: 3}\n"), "s").seeds,
            (std::vector<std::uint64_t>{1, 2, 3}));
}

TEST(SweepSpec, refuses_each_key_where_it_stands) {
  const std::string head = kHead;
  const std::pair<std::string, std::string> cases[] = {
      {"scenes: [circle-5]\n", "s:1:1: found no \"version\", must be given: version: 1"},
      {"version: 2\nscenes: [a]\n", "s:1:10: version: found 2, must be 1"},
      {"version: 1\n",
       "s:1:1: found no \"scenes\", must be given: names of built-in scenes, or "
       "files"},
      {"version: 1\nscenes: circle-5\n", "s:2:9: scenes: found \"circle-5\", must be a list"},
      {"version: 1\nscenes: []\n", "s:2:9: scenes: found an empty list, must have an item"},
      {"version: 1\nscenes: [a, a]\n", "s:2:13: scenes.1: found \"a\" twice, must be there once"},
      {"version: 1\nscenes: ['-']\n",
       "s:2:10: scenes.0: found \"-\", must be a name or a file, not the standard input"},
      {head + "sceens: 1\n",
       "s:3:1: found the unknown key \"sceens\", did you mean \"scenes\"? Allowed are version, "
       "scenes, methods, parameters, seeds, threads, until_arrived, line, judged"},
      {head + "judged: [0, 0]\n", "s:3:13: judged.1: found 0 twice, must be there once"},
      {head + "judged: [-1]\n", "s:3:10: judged.0: found -1, must be >= 0"},
      {head + "methods: [ocra]\n",
       "s:3:11: methods.0: found \"ocra\", did you mean \"orca\"? Must be one of avo, avo_paper, "
       "velocity_obstacle, orca, orca_clamped, reciprocal_velocity_obstacle, buffered_voronoi"},
      {head + "parameters: [1]\n",
       "s:3:13: parameters: found a list, must be a map from keys to lists of values"},
      {head + "parameters: {time_step: 0.1}\n",
       "s:3:25: parameters.time_step: found 0.1, must be a list"},
      {head + "parameters: {time_step: [0.1, 0.1]}\n",
       "s:3:31: parameters.time_step.1: found 0.1 twice, must be there once"},
      {head + "parameters: {seed: [1]}\n",
       "s:3:14: parameters.seed: found a parameter, must be in \"seeds\""},
      {head + "parameters: {method: [orca]}\n",
       "s:3:14: parameters.method: found a parameter, must be in \"methods\""},
      {head + "parameters: {a: [{b: 1}]}\n", "s:3:18: parameters.a.0: found a map, must be a text"},
      {head + "seeds: 7\n", "s:3:8: seeds: found 7, must be a list"},
      {head + "seeds: [-1]\n", "s:3:9: seeds.0: found -1, must be >= 0"},
      {head + "seeds: {from: 1}\n", "s:3:8: seeds: found no \"count\", must be given: how many"},
      {head + "seeds: {count: 0}\n", "s:3:16: seeds.count: found 0, must be >= 1"},
      {head + "seeds: {from: 18446744073709551615, count: 2}\n",
       "s:3:44: seeds.count: found 2, must end with a seed < 2^64"},
      {head + "threads: 0\n", "s:3:10: threads: found 0, must be >= 1"},
      {head + "until_arrived: 1\n", "s:3:16: until_arrived: found 1, must be true or false"},
      {head + "line: 7\n", "s:3:7: line: found 7, must be a list"},
      {head + "line: [[0, 1]]\n",
       "s:3:7: line: found a list of 1, must be two points, [[x, y], [x, y]]"},
      {head + "line: [[0, 1], [0, 1]]\n",
       "s:3:7: line: found one point, must be two points, [[x, y], [x, y]]"},
      {head + "line: [0, 1, 0, 2]\n", "s:3:8: line.0: found 0, must be [x, y] in m"},
      {"version: 1\nscenes: [a, b]\nseeds: {count: 500001}\n",
       "s:1:1: found 1000002 runs in all, must be at most 1000000"},
  };
  for (const auto& [yaml, message] : cases)
    EXPECT_EQ(avo::test::refusal([&text = yaml] { avo_io::parse_sweep(text, "s"); }), message);
}

TEST(SweepSpec, has_all_its_scenes_checked_before_the_first_run) {
  const std::string out = path_of("runs.csv"), name = path_of("sweep.yaml");
  const std::pair<std::string, std::string> cases[] = {
      {"version: 1\nscenes: [circle-5, no-such]\n", "no-such: found no such file and no scene"},
      {"version: 1\nscenes: [circle-5]\nparameters: {time_step: [0.1, -1]}\n",
       name + ": circle-5 time_step=-1: --set time_step=-1: time_step: found -1, must be"},
      {"version: 1\nscenes: [circle-5]\nparameters: {sensing_raduis: [5]}\n",
       "did you mean \"sensing_radius\"?"},
      {"version: 1\nscenes: [circle-5]\nparameters: {groups.0.max_speed: [2, 90]}\n",
       name + ": circle-5 groups.0.max_speed=90: found a scene that breaks what its certificate "
              "assumes, must keep it; avo validate says where\n"},
  };
  for (const auto& [yaml, message] : cases) {
    const ProcessResult result = sweep(yaml, {"--out", out});
    EXPECT_GT(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_EQ(lines_of(result.err).size(), 1U);
    EXPECT_EQ(files_in(folder()), (Strings{"sweep.yaml"})) << yaml;
  }
}

TEST(SweepSpec, refuses_wrong_words_of_the_command_line) {
  const std::string out = path_of("runs.csv");
  for (const char* shard : {"0/2", "3/2", "1", "1/", "/2", "1/2/3", "a/b", "1/0", ""}) {
    const ProcessResult result = sweep(kSmallSweep, {"--out", out, "--shard", shard});
    EXPECT_EQ(result.exit_code, 2) << shard;
    EXPECT_THAT(result.err, HasSubstr("--shard: found"));
  }
  const ProcessResult empty = sweep(kSmallSweep, {"--out", out, "--shard", "3/25"});
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_THAT(empty.err, HasSubstr("--shard: found 3/25, must be one of at most 24 parts"));
  EXPECT_EQ(sweep(kSmallSweep, {"--out", "-"}).exit_code, 2);
  EXPECT_EQ(sweep(kSmallSweep, {"--out", path_of("runs.txt")}).exit_code, 2);
  EXPECT_EQ(sweep(kSmallSweep, {"--out", path_of("sweep.yaml")}).exit_code, 2);
  EXPECT_EQ(sweep(kSmallSweep, {"--out", out, "--summary", out}).exit_code, 2);
  EXPECT_EQ(sweep(kSmallSweep, {}).exit_code, 2);
  EXPECT_EQ(files_in(folder()), (Strings{"sweep.yaml"}));
  write_file(out, "");
  EXPECT_EQ(sweep(kSmallSweep, {"--out", out, "--merge", out}).exit_code, 2);
}

}  // namespace
}  // namespace avo_test
