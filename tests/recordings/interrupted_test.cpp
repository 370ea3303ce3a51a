// SPDX-License-Identifier: Apache-2.0
// Verbs that make something of a recording and are asked to end: what was there before stays, and
// nothing else is left.
#include <algorithm>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "recorded.h"
#include "verdicts.h"

namespace avo_test {
namespace {

const std::string kEndedAtOnce =
    "ended by a signal; outputs that were not complete are not there\n";

bool has_output_begun() {
  const Strings names = files_in(folder());
  return std::any_of(names.begin(), names.end(),
                     [](const std::string& name) { return name.starts_with(".avo-"); });
}

/// Ends by the signal, a little after its output has begun. How soon it ends, scripts/waiting
/// shows.
ProcessOptions interrupted_by(int signal, useconds_t wait = 100'000) {
  return {.meanwhile = [signal, wait](int pid) {
    wait_until(pid, has_output_begun);
    usleep(wait);
    kill(pid, signal);
  }};
}

/// An output that was there before is there still, and nothing else.
void expect_untouched(const std::string& output) {
  EXPECT_EQ(read_file(path_of(output)), "precious");
  Strings names{output, "run.h5"};
  std::sort(names.begin(), names.end());
  EXPECT_EQ(files_in(folder()), names);
}

TEST(Interrupted, a_report_ends_at_once) {
  const std::string h5 = recorded({"circle-1000", "--duration=250", "--every=100"});
  write_file(path_of("out.html"), "precious");
  for (const int signal : {SIGINT, SIGTERM}) {
    const ProcessResult result =
        run_avo({"report", h5, path_of("out.html")}, interrupted_by(signal));
    EXPECT_EQ(result.exit_code, 128 + signal);
    EXPECT_EQ(result.err, kEndedAtOnce);
    expect_untouched("out.html");
  }
}

TEST(Interrupted, a_conversion_ends_at_once) {
  const std::string pipe = path_of("run.h5");  // the rows of the pipe never end
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int writer = open(pipe.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(writer, 0);
  write_file(path_of("out.csv"), "precious");
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string rows = "time,robot,x,y,vx,vy\n0,0,0,0,0,0\n1,0,0,0,0,0\n";
    ASSERT_EQ(::write(writer, rows.data(), rows.size()), static_cast<ssize_t>(rows.size()));
    const ProcessResult result =
        run_avo({"convert", pipe, path_of("out.csv")}, interrupted_by(signal));
    EXPECT_EQ(result.exit_code, 128 + signal);
    EXPECT_EQ(result.err, kEndedAtOnce);
    expect_untouched("out.csv");
  }
  close(writer);
}

TEST(Interrupted, a_comparison_ends_at_once) {
  const std::string h5 = recorded({"circle-500", "--duration=400"});
  write_file(path_of("out.svg"), "precious");
  const ProcessResult result =
      run_avo({"compare", h5, h5, h5, h5, h5, h5, "--arrival", path_of("out.svg")},
              {.meanwhile = [](int pid) {
                wait_until_caught(pid, SIGTERM);
                kill(pid, SIGTERM);
              }});
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
  EXPECT_EQ(result.err, kEndedAtOnce);
  expect_untouched("out.svg");
}

TEST(Interrupted, a_video_leaves_what_was_there) {
  const std::string h5 = recorded({"circle-30"});
  write_file(path_of("out.mp4"), "precious");
  for (const useconds_t wait : {0U, 30'000U, 400'000U}) {
    const ProcessResult result =
        run_avo_to_its_own_end({"video", h5, path_of("out.mp4")}, interrupted_by(SIGINT, wait));
    EXPECT_EQ(result.exit_code, 130) << result.out;
    EXPECT_EQ(result.err, "stopped by a signal; there is no video\n");
    expect_untouched("out.mp4");
  }
}

// One that does not read what it is given, and would write in the end.
TEST(Interrupted, a_video_kills_the_program_that_makes_it) {
  const std::string h5 = recorded({"circle-30"}), here = folder();
  write_file(path_of("out.mp4"), "precious");
  write_file(path_of("ffmpeg"), "#!/bin/sh\nfor last; do :; done\nfile=${last#file:}\necho $$ > " +
                                    here +
                                    "/pid\nexec 0<&-\nwhile :; do echo x >> \"$file\"; done\n");
  ASSERT_EQ(chmod(path_of("ffmpeg").c_str(), 0755), 0);
  const ProcessResult result =
      run_avo({"video", h5, path_of("out.mp4")},
              {.before = [here] { setenv("PATH", (here + ":/bin:/usr/bin").c_str(), 1); },
               .meanwhile =
                   [](int pid) {
                     wait_until_larger(pid, path_of("pid"), 0);
                     usleep(100'000);
                     kill(pid, SIGTERM);
                   }});
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
  const std::string child = "/proc/" + std::to_string(std::stoi(read_file(path_of("pid"))));
  EXPECT_TRUE(wait_until([&child] { return read_file(child + "/cmdline").empty(); }))
      << "it is gone, or nobody has asked for its end yet";
  unlink(path_of("pid").c_str());
  unlink(path_of("ffmpeg").c_str());
  expect_untouched("out.mp4");
}

TEST(Interrupted, a_video_has_at_most_a_million_frames) {
  const std::string h5 = recorded({"circle-4", "--duration", "2"});
  const ProcessResult result = run_avo({"video", h5, path_of("x.mp4"), "--speed", "1e-5"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err,
            "avo: --fps 30 and --speed 1e-05: found 6000001 frames, must be 1000000 at most\n");
  const std::string csv = path_of("late.csv");
  write_file(csv, "time,robot,x,y,vx,vy\n0,0,0,0,0,0\n1e11,0,0,0,0,0\n");
  EXPECT_EQ(run_avo({"video", csv, path_of("x.mp4"), "--scene", "circle-2"}).exit_code, 2);
  EXPECT_EQ(files_in(folder()), (Strings{"late.csv", "run.h5"}));
}

}  // namespace
}  // namespace avo_test
