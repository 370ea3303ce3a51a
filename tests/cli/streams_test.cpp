// SPDX-License-Identifier: Apache-2.0
// The standard streams: closed, full or without a reader; and what may be shown on a terminal.
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <vector>

#include "recordings.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;

ProcessOptions closing(const std::vector<int>& streams) {
  return {.before = [streams] {
    for (const int stream : streams) close(stream);
  }};
}

TEST(Streams, messages_that_cannot_be_written_change_nothing) {
  for (const char* where : {"/dev/full", "|"}) {
    const ProcessOptions options{.err_path = where};
    EXPECT_EQ(run_avo({"validate", "missing"}, options).exit_code, 4) << where;
    EXPECT_EQ(run_avo({"nonsense"}, options).exit_code, 2) << where;
    EXPECT_EQ(
        run_avo({"validate", "circle-2", "--set", "method=avo_paper", "--set", "sensing_radius=2"},
                options)
            .exit_code,
        0)
        << "a warning";
  }
  EXPECT_EQ(run_avo({"validate", "missing"}, closing({2})).exit_code, 4);
}

TEST(Streams, a_closed_one_becomes_no_file_of_ours) {
  const std::string csv = path_of("x.csv");
  const ProcessResult out =
      run_avo({"run", "circle-2", "--record", csv, "--summary", "-"}, closing({1}));
  EXPECT_EQ(out.exit_code, 4);
  EXPECT_EQ(out.err, "standard output: found it closed, must be open for writing\n");
  EXPECT_FALSE(exists(csv));
  // the warning must not go into the recording
  const ProcessResult others =
      run_avo({"run", "moving-obstacle", "--set", "method=avo_paper", "--set", "control_time=1",
               "--set", "duration=1", "--record", csv},
              closing({0, 2}));
  EXPECT_EQ(others.exit_code, 0);
  EXPECT_EQ(lines_of(read_file(csv)).size(), 12U);
}

TEST(Streams, output_asked_for_on_a_closed_one_fails_at_once) {
  for (const Strings& arguments : {Strings{"run", "positions-exchange", "--set", "duration=1e6"},
                                   Strings{"validate", "circle-2"}, Strings{"schema"},
                                   Strings{"bench", "circle-2"}, Strings{"--version"}}) {
    const ProcessResult result = run_avo(arguments, closing({0, 1}));
    EXPECT_EQ(result.exit_code, 4) << arguments[0];
    EXPECT_EQ(result.err, "standard output: found it closed, must be open for writing\n");
  }
  EXPECT_EQ(run_avo({"nonsense"}, closing({1})).exit_code, 2);
}

TEST(Streams, input_asked_for_on_a_closed_one_fails) {
  const ProcessResult result = run_avo({"check", "-", "--scene", "circle-2"}, closing({0}));
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.err, "standard input: Bad file descriptor\n");
}

TEST(Streams, a_pipe_without_a_reader_is_met_quietly) {
  for (const Strings& arguments :
       {Strings{"run", "circle-2"}, Strings{"run", "circle-2", "--record", "-"},
        Strings{"schema"}}) {
    const ProcessResult result = run_avo(arguments, {.out_path = "|"});
    EXPECT_EQ(result.exit_code, 141) << arguments[0];
    EXPECT_EQ(lines_of(result.err).size(), 0U);
  }
}

/// No byte of it is more than text.
void expect_plain(const std::string& text) {
  for (const char byte : text) EXPECT_TRUE((byte >= ' ' && byte <= '~') || byte == '\n') << text;
}

TEST(Streams, messages_show_no_control_characters) {
  const std::string evil = "a\x1b[31m\x7f\xff\xc2\x9b\xe2\x80\xae";
  const std::string shown = "a\\x1b[31m\\x7f\\xff\\xc2\\x9b\\xe2\\x80\\xae";
  write_file(path_of("in.csv"), kHeader + "0,0,0,0,0," + evil + "\n");
  write_file(path_of(evil + ".csv"), kHeader + "0,0,0,0,0,0\n");
  const std::vector<Strings> commands{{"validate", "circle-2", "--set", evil + "=1"},
                                      {"validate", "circle-2", "--set", "name=" + evil},
                                      {"validate", "circle-2", "--set", evil},
                                      {"validate", evil},
                                      {"validate", "circle-2", evil},
                                      {"run", "circle-2", "--threads", evil},
                                      {"run", "circle-2", "--record", evil + "/x.csv"},
                                      {"run", "circle-2", "--" + evil},
                                      {"scenes", evil},
                                      {evil},
                                      {"check", path_of("in.csv"), "--scene", "circle-2"},
                                      {"check", path_of(evil + ".csv"), "--scene", "circle-2"}};
  for (const Strings& command : commands) {
    const ProcessResult result = run_avo(command);
    EXPECT_GE(result.exit_code, 2);
    expect_plain(result.err);
    EXPECT_NE(result.err.find(shown), std::string::npos) << result.err;
    EXPECT_EQ(lines_of(result.err).size(), 1U);
  }
  EXPECT_EQ(lines_of(run_avo({"validate", "two\nlines"}).err).size(), 1U);
}

TEST(Streams, long_words_are_shortened) {
  const std::string word(5000, 'a');
  for (const Strings& command :
       {Strings{"validate", "circle-2", "--set", word + "=1"},
        Strings{"validate", "circle-2", "--set", word + ".b=1", "--set", word + ".b.c=1"},
        Strings{"validate", "circle-2", "--set", "name=!" + word + " b"},
        Strings{"validate", "circle-2", "--set", word}, Strings{"run", "circle-2", "--" + word},
        Strings{word}, Strings{"scenes", word}, Strings{"run", "circle-2", word},
        Strings{"validate", word}}) {
    const ProcessResult result = run_avo(command);
    EXPECT_LE(result.err.size(), 1100U) << result.err;
    EXPECT_NE(result.err.find("aaa..."), std::string::npos) << result.err;
  }
  const std::string key = run_avo({"validate", "circle-2", "--set", word + "=1"}).err;
  EXPECT_LT(key.find("allowed are version"), 160U) << key;
  EXPECT_TRUE(run_avo({"validate", word}).err.ends_with(": File name too long\n"));
}

TEST(Streams, names_of_scenes_are_shown_as_text_and_written_as_json) {
  const std::string evil = path_of("a\x1b[31m\xff\n.yaml");
  const std::string shown = "a\\x1b[31m\\xff\\n";
  write_file(evil,
             "version: 1\nduration: 1\nrobots:\n"
             "  - {position: [0, 0], goal: [5, 0]}\n  - {position: [0, 9], goal: [5, 9]}\n");
  const std::string csv = path_of("out\xff.csv");
  const ProcessResult run = run_avo(
      {"run", evil, "--record", csv, "--summary", path_of("a.json"), "--figure", path_of("a.svg")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with(shown + ": 2 robots")) << run.out;
  const std::string in_json = "a\x1b[31m\xEF\xBF\xBD\n";  // U+FFFD
  EXPECT_EQ(Json::parse(read_file(path_of("a.json")))["scene"], in_json);
  const auto scene = [&](Strings arguments) {
    arguments.push_back("--json");
    return Json::parse(run_avo(arguments).out)["scene"];
  };
  EXPECT_EQ(scene({"explain", evil, "--robot", "0"}), in_json);
  EXPECT_EQ(scene({"bench", evil, "--steps", "2"}), in_json);
  EXPECT_EQ(scene({"check", csv, "--scene", evil}), in_json);
  for (const Strings& arguments :
       {Strings{"explain", evil, "--robot", "0"}, Strings{"bench", evil, "--steps", "2"},
        Strings{"check", csv, "--scene", evil}, Strings{"validate", evil}}) {
    const ProcessResult result = run_avo(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    expect_plain(result.out);
  }
}

TEST(Streams, numbers_that_are_none_are_refused_by_what_is_wrong) {
  EXPECT_EQ(run_avo({"explain", "circle-2", "--robot", "0", "--time", "inf"}).err,
            "avo: --time: found inf, must be finite and >= 0 s\n");
  EXPECT_EQ(run_avo({"explain", "circle-2", "--robot", "0", "--time", "nan"}).err,
            "avo: --time: found nan, must be finite and >= 0 s\n");
  const ProcessResult radius =
      check(kGoodRun, {"--radius", "inf", "--max-acceleration", "inf", "--max-speed", "inf"});
  EXPECT_EQ(radius.exit_code, 2);
  EXPECT_EQ(radius.err, "avo: --radius: found inf, must be finite\n");
}

}  // namespace
}  // namespace avo_test
