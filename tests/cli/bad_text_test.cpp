// SPDX-License-Identifier: Apache-2.0
// What is said of scene files that are no plain YAML, no text, or too large.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "bad_scenes.h"

namespace avo_test {
namespace {

class BadTextTest : public testing::TestWithParam<BadScene> {};

TEST_P(BadTextTest, is_refused_in_one_line) {
  expect_refused(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Scenes, BadTextTest, testing::ValuesIn(bad_texts()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BadText, the_good_one_behind_the_bad_ones_is_good) {
  write_file(path_of("good.yaml"), kGood);
  const ProcessResult result = run_avo({"validate", path_of("good.yaml")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
}

TEST(BadText, files_that_are_no_files) {
  EXPECT_EQ(run_avo({"validate", folder()}).exit_code, 4);
  EXPECT_EQ(run_avo({"validate", folder()}).err,
            folder() + ": found a directory, must be a regular file\n");
  EXPECT_EQ(run_avo({"validate", "/dev/zero"}).err,
            "/dev/zero: found a device, must be a regular file\n");
  const ProcessResult missing = run_avo({"run", "circel-10"});
  EXPECT_EQ(missing.exit_code, 4);
  EXPECT_EQ(
      missing.err,
      "circel-10: found no such file and no scene of that name, did you mean \"circle-10\"? Scenes "
      "are arena, bottleneck, cars-100, circle-N, corridor, corridor-one-lane, crossed-crowd, "
      "crossing-streams, crowdnav-circle, crowdnav-square, doorway, doorway-narrow, drives-100, "
      "maze, mixed-fleet, mixed-yard, moving-obstacle, office, permutation-100, person, planes-12, "
      "positions-exchange, reversing-cars, swap-blocks, uniform-N, warehouse\n");
}

TEST(BadText, size_is_limited_before_reading_on) {
  const std::string path = path_of("large.yaml");
  write_file(path, std::string((std::size_t{16} << 20U) + 1, '#'));
  const ProcessResult result = run_avo({"validate", path});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, path + ":1:1: found more than 16 MiB, must be smaller\n");
}

TEST(BadText, number_of_values_is_limited) {
  std::string text = "robots: [";
  for (int i = 0; i < 2000000; ++i) text += "1,";
  const std::string path = path_of("values.yaml");
  write_file(path, text + "]");
  EXPECT_EQ(run_avo({"validate", path}).err, path + ":1:4000004: found more than 2000000 values\n");
}

TEST(BadText, bombs_are_refused_in_one_line) {
  const auto repeated = [](const std::string& text, int times) {
    std::string result;
    for (int i = 0; i < times; ++i) result += text;
    return result;
  };
  const std::vector<std::string> bombs{"version: 1\nrobots: " + repeated("[", 100000),
                                       "version: 1\nrobots: " + repeated("{", 100000),
                                       repeated("- ", 100000),
                                       repeated("? ", 100000),
                                       repeated("!", 100000),
                                       repeated("&a ", 100000),
                                       repeated("---\n", 100000),
                                       "robots: [" + repeated("1,", 2100000) + "]",
                                       repeated("version: 1\n", 200000)};
  for (const std::string& bomb : bombs) {
    const std::string path = path_of("bomb.yaml");
    write_file(path, bomb);
    const ProcessResult result = run_avo({"validate", path});
    EXPECT_EQ(result.exit_code, 3) << bomb.substr(0, 40);
    EXPECT_EQ(lines_of(result.err).size(), 1U) << bomb.substr(0, 40);
  }
}

}  // namespace
}  // namespace avo_test
