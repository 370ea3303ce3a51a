// SPDX-License-Identifier: Apache-2.0
// The tables of avo sweep: joined, as HDF5, and what is refused of them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <utility>

#include "sweeps.h"

namespace avo_test {
namespace {

using testing::HasSubstr;

ProcessResult merged(const Strings& tables) {
  Strings words{"--out", path_of("all.csv"), "--merge"};
  words.insert(words.end(), tables.begin(), tables.end());
  return sweep(kSmallSweep, words);
}

TEST(SweepMerge, says_which_runs_are_missing_and_writes_nothing) {
  const std::string first = swept(kSmallSweep, "1.csv", {"--shard=1/3"});
  const std::string third = swept(kSmallSweep, "3.csv", {"--shard=3/3"});
  const ProcessResult result = merged({first, third});
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_EQ(result.err, path_of("sweep.yaml") +
                            ": found 16 of 24 runs, must be all; missing: 1 (circle-5 avo "
                            "sensing_radius=12 seed=5), 4 (circle-5 avo sensing_radius=20 seed=5), "
                            "7 (circle-5 orca sensing_radius=12 seed=5) and others\n");
  EXPECT_FALSE(exists(path_of("all.csv")));
}

TEST(SweepMerge, takes_a_run_twice_where_it_is_the_same_but_for_times) {
  const std::string a = swept(kSmallSweep, "a.csv"), b = swept(kSmallSweep, "b.csv");
  EXPECT_EQ(merged({a, b}).exit_code, 0);
  std::string text = read_file(b);
  const std::size_t at = text.find(",circle-5,avo,12,5,0x");
  ASSERT_NE(at, std::string::npos);
  text[at + 21] = text[at + 21] == '0' ? '1' : '0';  // a digit of the state's hash
  write_file(b, text);
  const ProcessResult result = merged({a, b});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr(b + ": run 1: state_hash: found 0x"));
}

TEST(SweepMerge, reads_the_columns_of_earlier_builds) {
  const std::string now = swept(kSmallSweep, "now.csv");
  std::string text = read_file(now);
  for (const auto& [name, before] : {std::pair{",mover_collisions,", ",obstacle_collisions,"},
                                     {",static_collisions,", ",collision_obstacles,"},
                                     {",min_static_clearance,", ",min_obstacle_clearance,"}}) {
    const std::size_t at = text.find(name);
    ASSERT_NE(at, std::string::npos) << name;
    text.replace(at, std::string(name).size(), before);
  }
  write_file(path_of("before.csv"), text);
  const ProcessResult result = merged({path_of("before.csv")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_file(path_of("all.csv")), read_file(now));
}

TEST(SweepMerge, refuses_tables_that_are_none) {
  const std::string runs = swept(kSmallSweep, "runs.csv");
  const std::string text = read_file(runs);
  const auto refused = [&](const std::string& changed) {
    write_file(path_of("bad.csv"), changed);
    const ProcessResult result = merged({path_of("bad.csv")});
    EXPECT_EQ(result.exit_code, 3) << changed;
    return result.err;
  };
  EXPECT_THAT(refused("time,robot\n0,1\n"), HasSubstr("bad.csv: found no table of avo sweep"));
  EXPECT_THAT(refused(""), HasSubstr("bad.csv: found no table of avo sweep"));
  EXPECT_THAT(refused(text + "1,2,3\n"), HasSubstr("bad.csv:26: found 3 values, must be "));
  EXPECT_THAT(refused(text + "\"1,2\n"), HasSubstr("bad.csv:26: found wrong quotes"));
  EXPECT_THAT(refused(text.substr(0, text.size() - 1)),
              HasSubstr("bad.csv:25: found no end of the line, the table was cut off"));
  EXPECT_THAT(refused(text.substr(0, text.find('\n') + 1)),
              HasSubstr("bad.csv: found a table without runs, must have one or more"));
  std::string number = text;
  number.replace(number.find(",0,circle-5"), 2, ",99");
  EXPECT_THAT(refused(number), HasSubstr("bad.csv: found run 99, must be 0 to 23"));
  EXPECT_EQ(merged({path_of("none.csv")}).exit_code, 4);
}

TEST(SweepHdf5, holds_every_field_as_it_is) {
  const std::string csv = swept(kSmallSweep, "runs.csv");
  const std::string h5 = swept(kSmallSweep, "runs.h5", {"--merge", csv});
  const std::string again = swept(kSmallSweep, "again.csv", {"--merge", h5});
  EXPECT_EQ(read_file(again), read_file(csv)) << "times too: nothing was run";
  const std::string same = swept(kSmallSweep, "same.h5", {"--merge", h5});
  EXPECT_EQ(read_file(same), read_file(h5)) << "no date in it";
}

TEST(SweepHdf5, is_refused_where_it_is_cut_off) {
  const std::string h5 = swept(kSmallSweep, "runs.h5");
  const std::string text = read_file(h5);
  write_file(path_of("cut.h5"), text.substr(0, text.size() / 2));
  const ProcessResult result = merged({path_of("cut.h5")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("cut.h5: found no table that avo sweep wrote as HDF5"));
}

TEST(SweepTable, quotes_what_has_commas_or_quotes) {
  const std::string yaml =
      "version: 1\nscenes: ['a, b.yaml', '\"c\".yaml']\n"
      "parameters: {robots.0.goal: [[2, 0], [0, 3]]}\n";
  for (const char* scene : {"a, b.yaml", "\"c\".yaml"})
    write_file(path_of(scene),
               "version: 1\nduration: 5\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n");
  const std::string csv = swept(yaml, "runs.csv");
  EXPECT_THAT(read_file(csv), HasSubstr(",0,\"a, b.yaml\",avo,\"[2, 0]\",1,0x"));
  EXPECT_THAT(read_file(csv), HasSubstr(",3,\"\"\"c\"\".yaml\",avo,\"[0, 3]\",1,0x"));
  const avo_io::SweepTable table = avo_io::read_sweep(csv);
  EXPECT_EQ(column(table, "robots.0.goal"), (Strings{"[2, 0]", "[0, 3]", "[2, 0]", "[0, 3]"}));
  EXPECT_EQ(column(table, "scene")[3], "\"c\".yaml");
}

}  // namespace
}  // namespace avo_test
