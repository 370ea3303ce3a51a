// SPDX-License-Identifier: Apache-2.0
// What avo run shows on a terminal while it runs, and what it does not show elsewhere.
#include <chrono>
#include <cstdlib>
#include <gtest/gtest.h>
#include <regex>
#include <string>
#include <vector>

#include "pseudo_terminal.h"
#include "run_avo.h"

namespace avo_test {
namespace {

using Strings = std::vector<std::string>;

// About half a second of work.
const Strings kLong{"avo", "run", "uniform-3000", "--duration", "30", "--threads", "1"};

Strings with(Strings command, const Strings& more) {
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

struct Bar {
  double part, left;  // of 1; s
};

std::vector<Bar> bars_of(const std::string& shown) {
  static const std::regex pattern(
      R"(\r\[(#* *)\] +(\d+) %  t = (\d+\.\d) of 30\.0 s, (at most )?(\d+) s left\x1b\[K)");
  std::vector<Bar> bars;
  for (std::sregex_iterator i(shown.begin(), shown.end(), pattern), end; i != end; ++i) {
    EXPECT_EQ((*i)[1].length(), 30);
    bars.push_back({std::stod((*i)[3]) / 30.0, std::stod((*i)[5])});
    EXPECT_NEAR(std::stod((*i)[2]), 100.0 * bars.back().part, 1.0);
  }
  return bars;
}

TEST(Progress, a_bar_with_the_time_that_is_left_is_shown_and_wiped) {
  const auto start = std::chrono::steady_clock::now();
  PseudoTerminal terminal(kLong);
  EXPECT_EQ(terminal.wait(), 0);
  const double all =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const std::string& shown = terminal.shown();
  const std::vector<Bar> bars = bars_of(shown);
  ASSERT_GE(bars.size(), 2U) << shown;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    if (i > 0) {
      EXPECT_GT(bars[i].part, bars[i - 1].part);
    }
    EXPECT_LE(bars[i].left, all * (1.0 / bars[i].part - 1.0) + 1.0)
        << "as long as what is done has taken, in proportion";
  }
  const std::size_t last = shown.rfind(" left");
  EXPECT_EQ(shown.find("\r\x1b[K", last) + 4, shown.find("uniform-3000: 3000 robots"))
      << "wiped, and then the results: " << shown;
  EXPECT_EQ(shown.find("at most"), std::string::npos);
}

TEST(Progress, a_run_that_may_end_before_tells_the_most_that_is_left) {
  PseudoTerminal terminal(with(kLong, {"--until-arrived"}));
  EXPECT_TRUE(terminal.wait_for("at most ")) << terminal.shown();
}

TEST(Progress, a_narrow_terminal_gets_one_line_that_fits) {
  PseudoTerminal terminal(kLong, {.columns = 24});
  EXPECT_EQ(terminal.wait(), 0);
  const std::regex pattern(R"(\r([^\r\n\x1b]*)\x1b\[K)");
  const std::string& shown = terminal.shown();
  int lines = 0;
  for (std::sregex_iterator i(shown.begin(), shown.end(), pattern), end; i != end; ++i, ++lines)
    EXPECT_LE((*i)[1].length(), 23);
  EXPECT_GE(lines, 2);
}

TEST(Progress, is_shown_nowhere_else) {
  const TerminalOptions piped{.err_path = path_of("err.txt")};
  const Strings silent[] = {with(kLong, {"-q"}), with(kLong, {"--quiet"})};
  for (const Strings& command : silent) {
    PseudoTerminal terminal(command);
    EXPECT_EQ(terminal.wait(), 0);
    EXPECT_EQ(terminal.shown(), "");
  }
  PseudoTerminal elsewhere(kLong, piped);
  EXPECT_EQ(elsewhere.wait(), 0);
  EXPECT_EQ(elsewhere.shown().find('\x1b'), std::string::npos);
  EXPECT_EQ(read_file(piped.err_path), "");
  PseudoTerminal dumb(kLong, {.kind = "dumb"});
  EXPECT_EQ(dumb.wait(), 0);
  EXPECT_EQ(dumb.shown().find('\x1b'), std::string::npos) << "it could not wipe the bar";
  EXPECT_EQ(dumb.shown().find("left"), std::string::npos);
}

TEST(Progress, control_c_wipes_it_and_ends_the_run_with_what_it_has) {
  std::string shown;
  for (int k = 0; k < 20; ++k) {  // again where the machine stalls for the second that a run has
    PseudoTerminal terminal({"avo", "run", "circle-100", "--duration", "1e6", "--record",
                             path_of("out.csv"), "--summary", path_of("out.json")});
    ASSERT_TRUE(terminal.wait_for(" left"));
    terminal.type("\x03");
    EXPECT_EQ(terminal.wait(), 130);
    shown = terminal.shown();
    if (shown.find("ended by a signal;") == shown.npos) break;
  }
  EXPECT_GT(shown.rfind("\r\x1b[K"), shown.rfind(" left"));
  EXPECT_NE(shown.find("stopped by a signal after "), std::string::npos) << shown;
  EXPECT_EQ(files_in(folder()), (Strings{"out.csv", "out.json"}));
}

TEST(Progress, explain_shows_it_too) {
  PseudoTerminal terminal(
      {"avo", "explain", "uniform-1000", "--robot", "0", "--time", "100", "-v"});
  EXPECT_TRUE(terminal.wait_for(" left")) << terminal.shown();
  EXPECT_NE(terminal.shown().find("instructions "), std::string::npos);
  EXPECT_EQ(terminal.wait(), 0);
  const std::string shown = terminal.shown();
  const std::size_t result = shown.find("uniform-1000, robot 0");
  ASSERT_NE(result, std::string::npos) << shown;
  const std::string wiped = "\r\033[K";
  EXPECT_EQ(shown.substr(result - wiped.size(), wiped.size()), wiped);
}

TEST(Progress, bench_tells_of_it_between_its_runs) {
  PseudoTerminal terminal(
      {"avo", "bench", "uniform-3000", "--steps", "300", "--threads", "1", "--json"});
  EXPECT_EQ(terminal.wait(), 0);
  const std::string& shown = terminal.shown();
  for (const char* done : {"25 %  1 of 4 parts, ", "50 %  2 of 4 parts, ", "75 %  3 of 4 parts, "})
    EXPECT_NE(shown.find(done), std::string::npos) << done << shown;
  const std::regex bar(" of 4 parts");
  EXPECT_EQ(std::distance(std::sregex_iterator(shown.begin(), shown.end(), bar), {}), 3)
      << "never within what is timed";
  EXPECT_NE(shown.find("\r\x1b[K{"), std::string::npos) << "wiped, and then the results: " << shown;
}

TEST(Progress, check_tells_the_most_that_is_left_where_a_scene_says_how_long_it_is) {
  const std::string csv = path_of("long.csv");
  ASSERT_EQ(run_avo({"run", "drives-100", "--duration", "40", "--record", csv, "-q"}).exit_code, 0);
  const Strings command{"avo", "check", csv, "--scene", "drives-100"};
  PseudoTerminal terminal(with(command, {"--set", "duration=80"}));
  EXPECT_EQ(terminal.wait(), 0);
  const std::string& shown = terminal.shown();
  EXPECT_TRUE(std::regex_search(
      shown, std::regex(R"(\r\[#* *\] +\d+ %  t = \d+\.\d of 80\.0 s, at most \d+ s left\x1b\[K)")))
      << shown;
  EXPECT_NE(shown.find("\r\x1b[K" + csv), std::string::npos) << "wiped: " << shown;
  PseudoTerminal quiet(with(command, {"-q"}));
  EXPECT_EQ(quiet.wait(), 0);
  EXPECT_EQ(quiet.shown(), "");
}

TEST(Progress, a_scene_can_be_typed) {
  PseudoTerminal terminal({"avo", "validate", "-"});
  terminal.type(
      "version: 1\nname: typed\nrobots:\n"
      "  - {position: [0, 0], goal: [5, 0]}\n\x04");
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_NE(terminal.shown().find("standard input: valid: 1 robots"), std::string::npos)
      << terminal.shown();
}

}  // namespace
}  // namespace avo_test
