// SPDX-License-Identifier: Apache-2.0
// Runs that are killed: what they have left is read, replayed and recovered. AVO_KILLS sets how
// many (5); AVO_KILLS=60 is the soak.
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <new>
#include <random>
#include <signal.h>
#include <string>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "avo/simulation.h"
#include "avo_io/recording.h"
#include "avo_io/replay.h"
#include "avo_io/scene.h"
#include "run_avo.h"

namespace avo_test {
namespace {

using Strings = std::vector<std::string>;

/// Counts the times that were recorded; shared with the process that counts.
std::atomic<std::int64_t>& shared_counter() {
  void* memory = mmap(nullptr, sizeof(std::atomic<std::int64_t>), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return *new (memory) std::atomic<std::int64_t>(0);
}

/// Waits once it has recorded so many times.
[[noreturn]] void record_for_ever(const std::string& h5, std::atomic<std::int64_t>& times,
                                  std::int64_t most) {
  avo_io::SceneSource source;
  const avo::Scenario scenario = avo_io::load_scenario("circle-250", {}, &source);
  avo::Simulation simulation(scenario, 1);
  avo_io::Hdf5Recording recording(h5, scenario, source);
  while (true) {
    recording.add(simulation);
    ++times;
    while (times >= most) pause();
    simulation.step();
  }
}

std::int64_t times_in(const std::string& path) {
  avo_io::RecordingReader reader(path);
  avo_io::RecordedTime moment;
  std::int64_t times = 0;
  while (reader.next(moment)) ++times;
  return times;
}

/// Kills a run once it has recorded as many times and a little more; returns how many it had.
std::int64_t killed_run(const std::string& h5, std::int64_t after, useconds_t wait,
                        std::int64_t most = std::numeric_limits<std::int64_t>::max()) {
  std::atomic<std::int64_t>& times = shared_counter();
  const pid_t child = fork();
  if (child == 0) record_for_ever(h5, times, most);
  while (times < after) usleep(50);
  usleep(wait);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  const std::int64_t had = times;
  munmap(&times, sizeof times);
  return had;
}

int kills() {
  const char* number = std::getenv("AVO_KILLS");
  return number != nullptr ? std::atoi(number) : 5;
}

// What is lost is the block that was being filled and the one that was being compressed.
TEST(Killed, runs_leave_all_blocks_but_the_last_and_replay_bit_by_bit) {
  std::mt19937_64 random(11);
  for (int k = 0; k < kills(); ++k) {
    const std::string h5 = path_of("run" + std::to_string(k) + ".h5"), spool = h5 + ".part";
    const auto after = 130 + static_cast<std::int64_t>(random() % 1500);
    const std::int64_t had = killed_run(h5, after, static_cast<useconds_t>(random() % 5000));
    ASSERT_FALSE(exists(h5));
    const std::int64_t kept = times_in(spool);
    EXPECT_EQ(kept % 64, 0);
    EXPECT_GE(kept, (had / 64 - 1) * 64) << "of " << had;
    EXPECT_FALSE(avo_io::replay(spool, 1).difference) << "at once";
    const ProcessResult result = run_avo({"recover", spool});
    EXPECT_EQ(result.exit_code, 7) << result.err;
    EXPECT_TRUE(result.out.starts_with(h5 + ": " + std::to_string(kept) + " times, until "))
        << result.out;
    EXPECT_EQ(times_in(h5), kept);
    const avo_io::Replay again = avo_io::replay(h5, 1);
    EXPECT_FALSE(again.difference);
    EXPECT_EQ(again.times, kept);
    EXPECT_FALSE(again.ended);
    unlink(h5.c_str());
    unlink(spool.c_str());
  }
}

/// How many of each there were.
struct Outcomes {
  int nothing = 0;   // not even a block
  int spools = 0;    // that lack the end
  int complete = 0;  // a spool with all rows, or the recording itself
};

/// Reads what a killed run has left: each recording replays bit by bit, and each spool becomes one
/// that has all its times.
void look_at(const std::string& h5, Outcomes& outcomes) {
  const std::string spool = h5 + ".part";
  if (!exists(spool)) {
    ++(exists(h5) ? outcomes.complete : outcomes.nothing);
    if (exists(h5)) {
      EXPECT_FALSE(avo_io::replay(h5, 1).difference);
    }
    return;
  }
  const ProcessResult read = run_avo({"convert", spool, path_of("rows.csv"), "-q"});
  const ProcessResult recovered = run_avo({"recover", spool, "--output", path_of("again.h5")});
  if (read.exit_code != 0) {  // killed before its first block
    EXPECT_EQ(read.exit_code, 3) << read.err;
    EXPECT_EQ(lines_of(read.err).size(), 1U) << read.err;
    EXPECT_EQ(recovered.exit_code, 3) << recovered.err;
    ++outcomes.nothing;
    return;
  }
  EXPECT_TRUE(recovered.exit_code == 7 || recovered.exit_code == 0) << recovered.err;
  ++(recovered.exit_code == 0 ? outcomes.complete : outcomes.spools);
  EXPECT_EQ(times_in(path_of("again.h5")), times_in(spool));
  EXPECT_FALSE(avo_io::replay(path_of("again.h5"), 1).difference);
}

// At any part of it, from its start to a little after its end; told by what it has written, so that
// it does not depend on how busy the machine is.
TEST(Killed, by_chance_runs_of_avo_leave_what_can_be_read) {
  const Strings run{"run", "circle-250", "--threads", "1", "-q", "--record"};
  const auto to = [&run](const std::string& h5) {
    Strings command = run;
    command.push_back(h5);
    return command;
  };
  run_avo(to(path_of("whole.h5")));
  const auto whole = static_cast<double>(std::filesystem::file_size(path_of("whole.h5")));
  std::mt19937_64 random(17);
  Outcomes outcomes;
  for (int k = 0; k < kills(); ++k) {
    const std::string h5 = path_of("run.h5");
    const double after = 1.1 * whole * static_cast<double>(random() >> 11U) * 0x1p-53;
    const auto a_little = static_cast<useconds_t>(random() % 20'000);
    run_avo(to(h5), {.meanwhile = [&h5, after, a_little](int pid) {
              wait_until_larger(pid, h5 + ".part", static_cast<std::uintmax_t>(after));
              usleep(a_little);
              kill(pid, SIGKILL);
            }});
    look_at(h5, outcomes);
    for (const std::string& name : files_in(folder())) unlink(path_of(name).c_str());
  }
  EXPECT_EQ(outcomes.nothing + outcomes.spools + outcomes.complete, kills());
  EXPECT_GT(outcomes.spools, 0);
  std::printf(
      "kills: %d runs of circle-250, killed at random times: %d before their first block, "
      "%d left a spool, %d had ended\n",
      kills(), outcomes.nothing, outcomes.spools, outcomes.complete);
}

TEST(Killed, before_the_first_block_a_run_has_left_nothing_to_recover) {
  const std::string h5 = path_of("run.h5");
  EXPECT_EQ(killed_run(h5, 63, 0, 63), 63);
  const ProcessResult result = run_avo({"recover", h5 + ".part"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, h5 + ".part: found no whole block, must be one or more\n");
  EXPECT_FALSE(exists(h5));
}

// Killed between its last word and its name.
TEST(Killed, after_its_end_a_run_has_lost_nothing) {
  const std::string h5 = path_of("run.h5");
  avo_io::SceneSource source;
  const avo::Scenario scenario = avo_io::load_scenario("circle-5", {}, &source);
  {
    avo::Simulation simulation(scenario, 1);
    avo_io::Hdf5Recording recording(h5, scenario, source);
    for (int k = 0; k < 100; ++k) {
      recording.add(simulation);
      simulation.step();
    }
    recording.finish(simulation);
  }  // never committed
  EXPECT_FALSE(exists(h5));
  const ProcessResult result = run_avo({"recover", h5 + ".part", "--output", path_of("other.h5")});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_EQ(result.out, path_of("other.h5") + ": 100 times, until 9.9 s; nothing is lost\n");
  EXPECT_TRUE(exists(h5 + ".part")) << "stays until somebody removes it";
}

// A disk that is full, at any time: the run says so, and what was written can be read.
TEST(Killed, by_a_full_disk_a_run_says_what_is_kept) {
  const std::string h5 = path_of("run.h5"), spool = h5 + ".part";
  int kept = 0;
  for (int kibibytes = 1; kibibytes < 700; kibibytes += 53) {
    const ProcessResult result = run_avo(
        {"run", "circle-100", "--threads", "1", "--record", h5, "-q"}, {.before = [kibibytes] {
          signal(SIGXFSZ, SIG_IGN);
          const rlimit limit{1024U * static_cast<unsigned>(kibibytes),
                             1024U * static_cast<unsigned>(kibibytes)};
          setrlimit(RLIMIT_FSIZE, &limit);
        }});
    if (result.exit_code == 0) break;
    EXPECT_EQ(result.exit_code, 4) << kibibytes << result.err;
    EXPECT_NE(result.err.find("File too large"), std::string::npos) << result.err;
    EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
    EXPECT_FALSE(exists(h5));
    if (!exists(spool)) continue;
    EXPECT_FALSE(avo_io::replay(spool, 1).difference);
    const ProcessResult recovered = run_avo({"recover", spool});
    EXPECT_TRUE(recovered.exit_code == 7 || recovered.exit_code == 0) << recovered.err;
    EXPECT_EQ(times_in(h5) > 0, true);
    EXPECT_FALSE(avo_io::replay(h5, 1).difference);
    unlink(h5.c_str());
    unlink(spool.c_str());
    ++kept;
  }
  EXPECT_GT(kept, 3);
}

}  // namespace
}  // namespace avo_test
