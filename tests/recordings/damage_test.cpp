// SPDX-License-Identifier: Apache-2.0
// Recordings that are cut off or changed: readers say so, and never crash. AVO_EVERY_BYTE sets the
// step from one length to the next (97); AVO_EVERY_BYTE=1 is the soak.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

#include "avo/simulation.h"
#include "avo_io/recording.h"
#include "avo_io/scene.h"
#include "io/recording/hdf5_recording.h"
#include "io/recording/spool.h"
#include "run_avo.h"

namespace avo_test {
namespace {

struct Sample {
  std::string scene;
  int steps;
};
const std::vector<Sample> kSamples{{"circle-3", 70},
                                   {"cars-100", 3},
                                   {"positions-exchange", 20},
                                   {"circle-10", 130},
                                   {"planes-12", 66}};

/// A recording, and its spool beside it.
std::string sample(const Sample& of) {
  const std::string h5 = path_of("run.h5");
  avo_io::SceneSource source;
  const avo::Scenario scenario = avo_io::load_scenario(of.scene, {}, &source);
  avo::Simulation simulation(scenario, 1);
  avo_io::Hdf5Recording recording(h5, scenario, source);
  for (int k = 0; k < of.steps; ++k) {
    recording.add(simulation);
    simulation.step();
  }
  recording.finish(simulation);
  write_file(path_of("copy.part"), read_file(h5 + ".part"));
  recording.commit();
  return h5;
}

/// All rows, as text; empty where a reader refuses the file.
std::string rows_in(const std::string& path) {
  std::string rows;
  try {
    avo_io::RecordingReader reader(path);
    avo_io::RecordedTime moment;
    while (reader.next(moment)) {
      rows += std::to_string(moment.time);
      for (const avo::CheckedState& state : moment.rows)
        rows.append(reinterpret_cast<const char*>(&state.position), sizeof state.position);
    }
  } catch (const avo_io::RecordingError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return "";
  }
  return rows;
}

std::size_t every_byte() {
  const char* number = std::getenv("AVO_EVERY_BYTE");
  return number != nullptr ? static_cast<std::size_t>(std::atoi(number)) : 97;
}

/// For scripts/soak.
void tell_cuts(const char* kind, std::size_t cuts) {
  std::printf("cuts: %zu %s, cut off at %zu lengths\n", kSamples.size(), kind, cuts);
}

TEST(Damage, a_recording_that_is_cut_off_is_refused) {
  std::size_t cuts = 0;
  for (const Sample& of : kSamples) {
    const std::string bytes = read_file(sample(of)), cut = path_of("cut.h5");
    ASSERT_FALSE(rows_in(path_of("run.h5")).empty());
    write_file(cut, bytes);
    for (std::size_t size = bytes.size() - 1; size > 0; size -= std::min(size, every_byte())) {
      ASSERT_EQ(truncate(cut.c_str(), static_cast<off_t>(size)), 0);
      EXPECT_EQ(rows_in(cut), "") << of.scene << " at byte " << size << " of " << bytes.size();
      ++cuts;
    }
    ASSERT_EQ(truncate(cut.c_str(), 0), 0);
    EXPECT_EQ(rows_in(cut), "");
    ++cuts;
  }
  tell_cuts("recordings", cuts);
}

TEST(Damage, of_a_spool_that_is_cut_off_the_whole_blocks_are_read) {
  std::size_t cuts = 0;
  for (const Sample& of : kSamples) {
    sample(of);
    const std::string spool = path_of("copy.part"), bytes = read_file(spool);
    const std::string all = rows_in(spool);
    EXPECT_EQ(all, rows_in(path_of("run.h5")));
    std::size_t longest = 0;
    for (std::size_t size = bytes.size() - 1; size > 0; size -= std::min(size, every_byte())) {
      ASSERT_EQ(truncate(spool.c_str(), static_cast<off_t>(size)), 0);
      const std::string rows = rows_in(spool);
      ASSERT_TRUE(all.starts_with(rows)) << of.scene << " at byte " << size;
      longest = std::max(longest, rows.size());
      ++cuts;
    }
    EXPECT_EQ(longest, all.size()) << "a cut within the last word loses no rows";
  }
  tell_cuts("spools", cuts);
}

/// What avo check says of it within 128 MiB of memory.
ProcessResult checked_in_little_memory(const std::string& path) {
  return run_avo({"check", path}, {.before = [] {
                   const rlimit limit{128U << 20U, 128U << 20U};
                   setrlimit(RLIMIT_DATA, &limit);
                 }});
}

avo_io::RecordingHeader of_a_million() {
  avo_io::RecordingHeader header{.version = "1", .build = "", .robots = 1'000'000, .scene = {}};
  header.scene.yaml = "version: 1\nrobots: [{position: [0, 0], goal: [1, 0]}]\n";
  header.scene.name = "one";
  return header;
}

TEST(Damage, a_file_that_promises_more_than_it_can_hold_takes_little_memory) {
  const std::string spool = path_of("many.h5.part"), h5 = path_of("many.h5");
  const avo_io::BlockShape shape{1'000'000};
  avo_io::CompressedBlock block{{0.0, 0.1}, std::vector<std::string>(shape.chunks(), "x")};
  {
    avo_io::SpoolWriter writer(spool, of_a_million());
    writer.write(block);
  }
  ProcessResult result = checked_in_little_memory(spool);
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_EQ(result.err, spool + ": found a damaged block, must be whole\n");
  avo_io::write_hdf5(spool, h5, h5);
  result = checked_in_little_memory(h5);
  EXPECT_EQ(result.exit_code, 3) << result.err;
  // without any scene that could tell
  for (const std::string& path : {spool, h5}) EXPECT_EQ(rows_in(path), "");
}

// A file with changed bytes may yield anything but a crash. Data that are compressed or have a
// checksum yield no other rows.
TEST(Damage, changed_bytes_crash_no_reader) {
  std::mt19937_64 random(5);
  for (const Sample& of : kSamples) {
    const std::string h5 = sample(of);
    for (const std::string& path : {h5, path_of("copy.part")}) {
      const std::string bytes = read_file(path), all = rows_in(path);
      std::size_t refused = 0;
      for (int k = 0; k < 300; ++k) {
        std::string changed = bytes;
        const std::size_t at = random() % changed.size();
        changed[at] = static_cast<char>(changed[at] ^ (1 << (random() % 8)));
        write_file(path_of("changed"), changed);
        const std::string rows = rows_in(path_of("changed"));
        if (path != h5) {
          EXPECT_TRUE(all.starts_with(rows)) << of.scene << " byte " << at;
        }
        refused += rows != all ? 1 : 0;
      }
      EXPECT_GT(refused, 30U);
    }
  }
}

}  // namespace
}  // namespace avo_test
