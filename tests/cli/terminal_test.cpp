// SPDX-License-Identifier: Apache-2.0
// What is typed at a terminal: what the standard output says there, and what the standard error
// output.
#include <gtest/gtest.h>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "pseudo_terminal.h"
#include "run_avo.h"

namespace avo_test {
namespace {

const std::string kNothing;
const std::string kSettings = "scene {13}circle-3, built in\n(.*\n)*version +\\S+\n";
const std::string kKeys = "\\{\n  \"scene\": \"circle-3\",\n(.*\n)*\\}\n";

/// A table for people to read: its first lines, and its last.
std::string table(const std::string& first) {
  return first + "\n(  .*\n)*  time of a step .*\n";
}

struct Typed {
  std::string command;   ///< words with blanks between them
  std::string out, err;  ///< patterns of all that is said
  std::string keys = {};
};

// The terminal repeats what is typed, but for the end.
const std::string kSceneInTerminal =
    "version: 1\nname: typed\nrobots:\n  - {position: [0, 0], goal: [5, 0]}\n";

const std::vector<Typed> kTyped = {
    {"avo run circle-3 --duration 1",
     table("circle-3: 3 robots, 10 steps of 0.1 s\n  arrived +0 of 3"), kNothing},
    {"avo run circle-3 --until-arrived",
     table("circle-3: 3 robots, \\d+ steps of 0.1 s\n  arrived +3 of 3, after .*"), kNothing},
    {"avo run circle-3 --duration 1 --record - --every 4",
     "time,robot,x,y,vx,vy,every\n(0,[012],.*,4\n){3}(0.4\\d*,[012],.*,4\n){3}(0.8\\d*,[012],.*,"
     "4\n){3}"
     "(1,[012],.*,4\n){3}",
     table("circle-3: 3 robots, 10 steps of 0.1 s")},
    {"avo run circle-3 --duration 1 --json", kKeys, table("circle-3: 3 robots, 10 steps of 0.1 s")},
    {"avo run circle-3 --duration 1 --json -q", kKeys, kNothing},
    {"avo run circle-3 --duration 1 -v", table("circle-3: 3 robots, 10 steps of 0.1 s"), kSettings},
    {"avo run circle-3 --duration 1 -q", kNothing, kNothing},
    {"avo run - --duration 1", kSceneInTerminal + table("typed: 1 robots, 10 steps of 0.1 s"),
     kNothing, kSceneInTerminal},
    {"avo run circle-3 --duration soon", kNothing,
     "--duration: found \"soon\", must be a number \\(s\\)\n"},
    {"avo help run", "simulate a scene to its end\nUsage: avo run .*\n(.*\n)*Example: avo run .*\n",
     kNothing},
    {"avo -V", "avo \\d+\\.\\d+\\.\\d+\n", kNothing},
    {"avo scenes circle-10", "# N robots on a circle .*\n(.*\n)*name: circle-10\n(.*\n)*",
     kNothing}};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string("{}[]-.").find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

/// What a terminal shows, without its line ends and without bars, which are wiped.
std::string settled(const std::string& shown) {
  static const std::regex bar("\r[^\r\n]*\x1b\\[K"), end("\r\n");
  return std::regex_replace(std::regex_replace(shown, bar, ""), end, "\n");
}

std::string said(const Typed& typed, const TerminalOptions& options) {
  std::istringstream words(typed.command);
  std::vector<std::string> command;
  for (std::string word; words >> word;) command.push_back(word);
  PseudoTerminal terminal(command, options);
  if (!typed.keys.empty()) terminal.type(typed.keys + "\x04");
  EXPECT_EQ(terminal.wait(), typed.err.find("found") == std::string::npos ? 0 : 2);
  return settled(terminal.shown());
}

std::string echoed(const Typed& typed) {
  return typed.keys.empty() ? typed.out : escaped(typed.keys) + typed.out.substr(typed.keys.size());
}

TEST(Terminal, gets_results_on_one_stream_and_words_about_them_on_the_other) {
  for (const Typed& typed : kTyped) {
    SCOPED_TRACE(typed.command);
    const TerminalOptions apart{.err_path = path_of("err.txt")};
    const std::string out = said(typed, apart), err = read_file(apart.err_path);
    EXPECT_TRUE(std::regex_match(out, std::regex(echoed(typed)))) << out;
    EXPECT_TRUE(std::regex_match(err, std::regex(typed.err))) << err;
    // both are shown where both are the terminal, the bar wiped
    const std::string both = said(typed, {});
    EXPECT_EQ(both.find('\x1b'), std::string::npos) << both;
    EXPECT_TRUE(std::regex_match(both, std::regex(echoed(typed) + typed.err)) ||
                std::regex_match(both, std::regex(typed.err + echoed(typed))))
        << both;
  }
}

}  // namespace
}  // namespace avo_test
