// SPDX-License-Identifier: Apache-2.0
// Verbs that make something of a recording and are asked to end: what was there before stays, and
// nothing else is left.
#include <algorithm>
#include <chrono>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "verdicts.h"

namespace avo_test {
namespace {

const std::string kEndedAtOnce =
    "ended by a signal; outputs that were not complete are not there\n";

void wait_until_an_output_has_begun() {
  const auto begun = [] {
    const Strings names = files_in(folder());
    return std::any_of(names.begin(), names.end(),
                       [](const std::string& name) { return name.starts_with(".avo-"); });
  };
  for (int i = 0; i < 2000 && !begun(); ++i) usleep(5'000);
}

struct Interrupted {
  ProcessResult result;
  double seconds = 0.0;  // from the signal to the end
};

Interrupted interrupted(const Strings& command, int signal, useconds_t wait = 100'000,
                        bool output = true) {
  using Clock = std::chrono::steady_clock;
  Clock::time_point start;
  Interrupted found;
  found.result = run_avo(command, {.before = [] { alarm(30); },
                                   .meanwhile =
                                       [&](int pid) {
                                         if (output) wait_until_an_output_has_begun();
                                         usleep(wait);
                                         start = Clock::now();
                                         kill(pid, signal);
                                       }});
  found.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return found;
}

std::string recorded(const Strings& scene) {
  const std::string h5 = path_of("run.h5");
  Strings command{"run", "--record", h5, "-q"};
  command.insert(command.end(), scene.begin(), scene.end());
  EXPECT_EQ(run_avo(command).exit_code, 0);
  return h5;
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
    const Interrupted found = interrupted({"report", h5, path_of("out.html")}, signal);
    EXPECT_EQ(found.result.exit_code, 128 + signal);
    EXPECT_EQ(found.result.err, kEndedAtOnce);
    EXPECT_LT(found.seconds, 0.8) << "at once, not a second later";
    expect_untouched("out.html");
  }
}

TEST(Interrupted, a_conversion_ends_at_once) {
  const std::string pipe = path_of("run.h5");  // whose rows never come to their end
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int writer = open(pipe.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(writer, 0);
  write_file(path_of("out.csv"), "precious");
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string rows = "time,robot,x,y,vx,vy\n0,0,0,0,0,0\n1,0,0,0,0,0\n";
    ASSERT_EQ(::write(writer, rows.data(), rows.size()), static_cast<ssize_t>(rows.size()));
    const Interrupted found = interrupted({"convert", pipe, path_of("out.csv")}, signal);
    EXPECT_EQ(found.result.exit_code, 128 + signal);
    EXPECT_EQ(found.result.err, kEndedAtOnce);
    EXPECT_LT(found.seconds, 0.8);
    expect_untouched("out.csv");
  }
  close(writer);
}

TEST(Interrupted, a_comparison_ends_at_once) {
  const std::string h5 = recorded({"circle-500", "--duration=400"});
  write_file(path_of("out.svg"), "precious");
  const Interrupted found =
      interrupted({"compare", h5, h5, h5, h5, h5, h5, "--arrival", path_of("out.svg")}, SIGTERM,
                  150'000, false);
  EXPECT_EQ(found.result.exit_code, 128 + SIGTERM);
  EXPECT_EQ(found.result.err, kEndedAtOnce);
  expect_untouched("out.svg");
}

TEST(Interrupted, a_video_leaves_what_was_there) {
  const std::string h5 = recorded({"circle-30"});
  write_file(path_of("out.mp4"), "precious");
  for (const useconds_t wait : {0U, 30'000U, 400'000U}) {
    const Interrupted found = interrupted({"video", h5, path_of("out.mp4")}, SIGINT, wait);
    EXPECT_EQ(found.result.exit_code, 130) << found.result.out;
    EXPECT_EQ(found.result.err, "stopped by a signal; there is no video\n");
    EXPECT_LT(found.seconds, 1.0);
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
              {.before =
                   [here] {
                     setenv("PATH", (here + ":/bin:/usr/bin").c_str(), 1);
                     alarm(30);
                   },
               .meanwhile =
                   [](int pid) {
                     for (int i = 0; i < 1000 && !exists(path_of("pid")); ++i) usleep(5'000);
                     usleep(100'000);
                     kill(pid, SIGTERM);
                   }});
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
  usleep(1'500'000);
  const int child = std::stoi(read_file(path_of("pid")));
  EXPECT_EQ(read_file("/proc/" + std::to_string(child) + "/cmdline"), "")
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
