// SPDX-License-Identifier: Apache-2.0
// What is said of scene files that are no plain YAML, no text, or too large.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "bad_scenes.h"

namespace avo_test {
namespace {

const std::vector<BadScene> kBadTexts{
    {"anchor", s("version: 1\nrobots:\n  - &a {position: [0, 0], goal: [1, 0]}\n"),
     "3:5: found an anchor, anchors, aliases and merge keys are not allowed"},
    {"alias", s("version: 1\nrobots: [*a]\n"),
     "2:10: found text that is not YAML: the referenced anchor is not defined"},
    {"merge_key", s("version: 1\nrobots:\n  - {<<: {radius: 1}, position: [0, 0], goal: [1, 0]}\n"),
     "3:6: found a merge key, anchors, aliases and merge keys are not allowed"},
    {"tag", s("version: !!int 1\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n"),
     "1:10: found the tag tag:yaml.org,2002:int, tags are not allowed"},
    {"key_is_list", s("? [1, 2]\n: 3\n"),
     "1:3: found a list as a key or one that is not closed, keys must be words such as time_step"},
    {"key_is_empty", s("version: 1\n: 3\n"),
     "2:1: found an empty key, keys must be words such as time_step"},
    {"two_documents", kGood + s("---\nversion: 1\n"),
     "5:1: found a second document, a scene is one document"},
    {"tab", s("version: 1\nrobots:\n\011- {position: [0, 0], goal: [1, 0]}\n"),
     "3:2: found text that is not YAML: illegal block entry"},
    {"unclosed_list", s("version: 1\nrobots: [1, 2\n"),
     "2:1: found text that is not YAML: end of sequence flow not found"},
    {"unclosed_quote", s("version: 1\nname: \"abc\n"),
     "2:11: found text that is not YAML: illegal EOF in scalar"},
    {"bad_indentation", s("version: 1\n  name: a\n"),
     "2:7: found text that is not YAML: illegal map value"},
    {"nul_byte", s("version: 1\nname: a\000b\n"),
     "2:8: found the control character 0x00, must be text"},
    {"bad_utf8", s("version: 1\nname: \"\303(\"\n"),
     "2:8: found the byte 0xc3, must be UTF-8 text"},
    {"utf16", s("\377\376v\000e\000r\000s\000i\000o\000n\000:\000 \0001\000\n\000"),
     "1:1: found the byte 0xff, must be UTF-8 text"},
    {"escape_byte", s("version: 1\nname: \033[2J\n"),
     "2:7: found the control character 0x1b, must be text"},
    {"bom_and_crlf",
     s("\357\273\277version: 1\015\nrobots:\015\n  - {position: [0, 0], goal: [1, 0], radius: "
       "-1}\015\n"),
     "3:46: robots.0.radius: found -1, must be > 0 m"},
    {"bom_is_no_column", s("\357\273\277a\001"),
     "1:2: found the control character 0x01, must be text"},
    {"umlauts_count_as_one",
     s("version: 1\nname: \"\303\244\303\266\303\274\"\nrobots:\n  - "
       "{\"\303\244\303\266\303\274\": 1}\n"),
     s("4:6: robots.0: found the unknown key \"\303\244\303\266\303\274\", allowed are ") +
         kRobotKeys},
    {"nested_too_deep",
     s("version: 1\nrobots: "
       "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]]]]]]]"
       "]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]\n"),
     "2:72: found more than 64 levels of nesting"},
};

class BadTextTest : public testing::TestWithParam<BadScene> {};

TEST_P(BadTextTest, is_refused_in_one_line) {
  expect_refused(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Scenes, BadTextTest, testing::ValuesIn(kBadTexts),
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
      "circel-10: found no such file and no scene of that name, scenes are arena, bottleneck, "
      "cars-100, circle-N, corridor, corridor-one-lane, crossing-streams, doorway, doorway-narrow, "
      "drives-100, maze, mixed-yard, moving-obstacle, office, permutation-100, person, planes-12, "
      "positions-exchange, reversing-cars, swap-blocks, "
      "uniform-N, warehouse; did you mean \"circle-N\"?\n");
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
