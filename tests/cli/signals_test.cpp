// SPDX-License-Identifier: Apache-2.0
// What avo run does when it is asked to end: finishes its outputs, or leaves none behind.
#include <algorithm>
#include <chrono>
#include <fcntl.h>
#include <fmt/format.h>
#include <functional>
#include <gtest/gtest.h>
#include <signal.h>
#include <string>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

void wait_ms(int milliseconds) {
  usleep(1000U * static_cast<unsigned>(milliseconds));
}

ProcessResult endless(const std::function<void(int pid)>& meanwhile,
                      const std::function<void()>& before = {}) {
  return run_avo_to_its_own_end({"run", "circle-5", "--set", "duration=1e6", "--record",
                                 path_of("out.csv"), "--summary", path_of("out.json")},
                                {.before = before, .meanwhile = [&](int pid) {
                                   // the first rows are there
                                   wait_until_any_larger(pid, ".part", 0);
                                   meanwhile(pid);
                                 }});
}

void expect_whole(const ProcessResult& result) {
  const Strings lines = lines_of(read_file(path_of("out.csv")));
  ASSERT_GT(lines.size(), 6U);
  ASSERT_EQ((lines.size() - 1) % 5, 0U) << "every step whole";
  const auto steps = static_cast<int>((lines.size() - 1) / 5 - 1);
  EXPECT_EQ(Json::parse(read_file(path_of("out.json")))["steps"], steps);
  EXPECT_EQ(std::count(lines.back().begin(), lines.back().end(), ','), 5);
  EXPECT_NE(result.err.find(fmt::format("stopped by a signal after {} of 10000000 steps", steps)),
            std::string::npos)
      << result.err;
  EXPECT_EQ(files_in(folder()), (Strings{"out.csv", "out.json"}));
}

TEST(Signals, the_first_one_ends_the_run_with_what_it_has) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    const ProcessResult result = endless([&](int pid) { kill(pid, signal); });
    EXPECT_EQ(result.exit_code, 128 + signal);
    expect_whole(result);
  }
}

TEST(Signals, one_that_comes_twice_at_once_is_one) {
  const ProcessResult result = endless([](int pid) {
    kill(pid, SIGINT);
    kill(pid, SIGINT);
  });
  EXPECT_EQ(result.exit_code, 130);
  expect_whole(result);
}

TEST(Signals, hangup_is_ignored_where_it_was_from_the_start) {
  const ProcessResult result = endless(
      [](int pid) {
        kill(pid, SIGHUP);
        wait_ms(300);
        kill(pid, SIGTERM);
      },
      [] { signal(SIGHUP, SIG_IGN); });
  EXPECT_EQ(result.exit_code, 128 + SIGTERM) << "not that of SIGHUP";
  expect_whole(result);
}

/// The run cannot go on where it writes to the file called `pipe`, because the file has no reader.
/// The recording is the pipe, and the recording is full or has some rows. The machine may stall for
/// the second that the run has, so that the run does not come to the pipe. Then the function starts
/// the run again.
ProcessResult blocked(const std::string& pipe, const std::function<void(int pid)>& meanwhile) {
  ProcessResult result;
  for (int in_pipe = 0; in_pipe == 0;) {
    EXPECT_EQ(mkfifo(path_of(pipe).c_str(), 0600), 0);
    const int reader = open(path_of(pipe).c_str(), O_RDWR | O_CLOEXEC);
    EXPECT_GE(reader, 0);
    const auto is_full = [&] {
      return ioctl(reader, FIONREAD, &in_pipe) == 0 &&
             in_pipe >= fcntl(reader, F_GETPIPE_SZ) - 4096;
    };
    result = run_avo({"run", "circle-200", "--set", "duration=1e4", "--record", path_of("out.csv"),
                      "--summary", path_of("out.json"), "--figure", path_of("out.svg")},
                     {.meanwhile = [&](int pid) {
                       if (pipe == "out.csv")
                         wait_until(pid, is_full);
                       else
                         wait_until_any_larger(pid, ".part", 0);
                       meanwhile(pid);
                     }});
    EXPECT_EQ(result.err, "ended by a signal; outputs that were not complete are not there\n");
    EXPECT_EQ(ioctl(reader, FIONREAD, &in_pipe), 0);
    close(reader);
    unlink(path_of(pipe).c_str());
    if (testing::Test::HasFailure()) break;
  }
  return result;
}

TEST(Signals, a_run_that_does_not_end_is_ended) {
  const ProcessResult result = blocked("out.csv", [](int pid) { kill(pid, SIGTERM); });
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
  EXPECT_EQ(files_in(folder()), Strings{}) << "no part of an output";
}

// The second one comes within the second that the run has, which is tried again where the machine
// stalls between the two.
TEST(Signals, a_second_one_ends_it_at_once) {
  using Clock = std::chrono::steady_clock;
  ProcessResult result;
  Clock::duration between;
  do {
    result = blocked("out.csv", [&between](int pid) {
      const Clock::time_point first = Clock::now();
      kill(pid, SIGTERM);
      wait_ms(100);
      kill(pid, SIGINT);
      between = Clock::now() - first;
    });
  } while (between >= std::chrono::seconds(1));
  EXPECT_EQ(result.exit_code, 130) << "else it would be that of the first";
  EXPECT_EQ(files_in(folder()), Strings{});
}

// The figure comes last, and it does not end.
TEST(Signals, what_is_complete_is_kept_where_a_figure_takes_too_long) {
  const ProcessResult result = blocked("out.svg", [](int pid) { kill(pid, SIGTERM); });
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
  EXPECT_EQ(files_in(folder()), (Strings{"out.csv", "out.json"}));
  EXPECT_EQ(read_file(path_of("out.csv")).back(), '\n');
  EXPECT_GT(Json::parse(read_file(path_of("out.json")))["steps"], 0);
}

TEST(Signals, explain_ends_as_well) {
  const ProcessResult result = run_avo({"explain", "circle-50", "--robot", "0", "--time", "1e6",
                                        "--set", "duration=1e6", "--figure", path_of("out.svg")},
                                       {.meanwhile = [](int pid) {
                                         wait_until_caught(pid, SIGHUP);
                                         wait_until_worked(pid, 0.1);
                                         kill(pid, SIGHUP);
                                       }});
  EXPECT_EQ(result.exit_code, 128 + SIGHUP);
  EXPECT_EQ(files_in(folder()), Strings{});
}

}  // namespace
}  // namespace avo_test
