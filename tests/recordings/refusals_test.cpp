// SPDX-License-Identifier: Apache-2.0
// What no run records is refused by every verb that reads recordings, in one line.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

#include "edit_hdf5.h"
#include "io/recording/spool.h"
#include "recorded.h"
#include "verdicts.h"

namespace avo_test {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// With 128 MiB of memory, and 20 s of a processor, which a busy machine does not shorten.
ProcessResult in_little_memory(const Strings& command) {
  return run_avo(command, {.before = [] {
                   const rlimit memory{128U << 20U, 128U << 20U}, seconds{20, 20};
                   setrlimit(RLIMIT_DATA, &memory);
                   setrlimit(RLIMIT_CPU, &seconds);
                 }});
}

/// By all verbs that read a recording alone; none of them leaves anything.
void expect_refused(const std::string& path, const std::string& message) {
  const Strings before = files_in(folder());
  const std::vector<Strings> verbs{{"check", path},
                                   {"convert", path, path_of("out.csv")},
                                   {"convert", path, path_of("out.mcap")},
                                   {"replay", path},
                                   {"report", path, path_of("out.html")},
                                   {"compare", path, "--arrival", path_of("out.svg")},
                                   {"video", path, path_of("out.mp4"), "--size", "64"}};
  for (const Strings& verb : verbs) {
    const ProcessResult result = in_little_memory(verb);
    EXPECT_EQ(result.exit_code, 3) << verb[0] << result.out;
    EXPECT_EQ(result.err, path + ": " + message + "\n") << verb[0];
    EXPECT_EQ(files_in(folder()), before) << verb[0];
  }
}

TEST(Refusals, of_times_that_no_run_has) {
  const auto expect = [](hsize_t row, double time, const std::string& message) {
    const std::string h5 = recorded_circle();
    change(h5, "time", {row}, H5T_NATIVE_DOUBLE, time);
    expect_refused(h5, "time: found " + message);
  };
  expect(90, 1e6, "1000000 s, must be <= 9 s, the duration of its scene");
  expect(90, 9.1, "9.1 s, must be <= 9 s, the duration of its scene");
  expect(70, kNotANumber, "nan s, must be a finite number");
  expect(70, kInfinite, "inf s, must be a finite number");
  expect(0, -0.1, "-0.1 s, must be >= 0 s");
  expect(7, 0.6000000000000001,
         "0.6000000000000001 s, must be > 0.6000000000000001 s, the time "
         "before");
  expect(64, 6.0, "6 s, must be > 6.300000000000001 s, the time before");
}

TEST(Refusals, of_times_with_free_clocks_too) {
  const Strings free{"--set", "clock=free"};
  const std::string h5 = recorded_circle(free);
  EXPECT_EQ(run_avo({"check", h5}).exit_code, 0) << "irregular times are those of a run";
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 0);
  change(h5, "time", {20}, H5T_NATIVE_DOUBLE, 1e6);
  expect_refused(h5, "time: found 1000000 s, must be <= 9 s, the duration of its scene");
}

TEST(Refusals, of_csv_whose_times_a_scene_never_has) {
  const std::string csv = path_of("late.csv");
  write_file(csv, "time,robot,x,y,vx,vy\n0,0,0,0,0,0\n1e11,0,0,0,0,0\n");
  const std::string late = csv +
                           ":3: time: found 100000000000 s, must be 100000000 steps of 0.1 s later "
                           "than the row before at most\n";
  for (const Strings& verb :
       {Strings{"check", csv},
        Strings{"video", csv, path_of("out.gif"), "--size", "64", "--fps=1", "--speed=1e6"}}) {
    Strings command = verb;
    command.insert(command.end(), {"--scene", "person"});
    EXPECT_EQ(in_little_memory(command).err, late) << verb[0];
  }
}

TEST(Refusals, of_states_that_no_robot_has) {
  const auto expect = [](const Strings& scene, const std::vector<hsize_t>& index, double value,
                         const std::string& message) {
    const std::string h5 = recorded_circle(scene);
    change(h5, "state", index, H5T_NATIVE_DOUBLE, value);
    expect_refused(h5, message);
  };
  const std::string number = ", must be a finite number";
  const std::string range = ", must be from -1e+12 to 1e+12";
  expect({}, {80, 1, 3}, kNotANumber, "time 8 s, robot 1: vy: found nan" + number);
  expect({}, {0, 0, 0}, kNotANumber, "time 0 s, robot 0: x: found nan" + number);
  expect({}, {10, 5, 1}, -kInfinite, "time 1 s, robot 5: y: found -inf" + number);
  expect({}, {90, 2, 0}, 1.5e12, "time 9 s, robot 2: x: found 1500000000000" + range);
  expect({}, {90, 2, 2}, -1.5e12, "time 9 s, robot 2: vx: found -1500000000000" + range);
  const std::string h5 = recorded_circle();
  change(h5, "status", {30, 4}, H5I_INVALID_HID, std::uint8_t{77});
  expect_refused(h5, "time 3 s, robot 4: status: found 77, must be 0 to 6, or 255, absent");
}

TEST(Refusals, not_of_robots_that_are_not_there_or_have_no_heading) {
  const std::string h5 = path_of("run.h5");
  ASSERT_EQ(run_avo({"run", "mixed-yard", "--set", "duration=2", "--record", h5, "-q"}).exit_code,
            0);
  ASSERT_EQ(run_avo({"check", h5}).exit_code, 0);
  change(h5, "state", {5, 0, 5}, H5T_NATIVE_DOUBLE, kNotANumber);
  const ProcessResult result = run_avo({"check", h5});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, h5 + ": time 0.5 s, robot 0: speed: found nan, must be a finite number\n");
  const std::string gone = recorded_circle();
  change(gone, "status", {90, 2}, H5I_INVALID_HID, std::uint8_t{255});
  change(gone, "state", {90, 2, 0}, H5T_NATIVE_DOUBLE, kNotANumber);
  EXPECT_EQ(run_avo({"check", gone}).exit_code, 7) << "rows are missing";
}

TEST(Refusals, of_files_that_are_cut_off_before_their_first_word) {
  const std::string h5 = recorded_circle(), whole = read_file(h5);
  for (const std::string& name : {path_of("cut.h5"), path_of("cut.H5"), path_of("cut.h5.part")}) {
    for (const std::size_t size : {0, 1, 5, 7}) {
      write_file(name, whole.substr(0, size));
      expect_refused(name,
                     "found neither HDF5 nor a spool in it, cut off or damaged, must be one of "
                     "them, whole");
    }
    write_file(name, std::string(3000, 'x'));
    expect_refused(name,
                   "found neither HDF5 nor a spool in it, cut off or damaged, must be one of them, "
                   "whole");
  }
  EXPECT_EQ(
      run_avo({"check", path_of("cut.h5"), "--radius=1", "--max-acceleration=1", "--max-speed=1"})
          .exit_code,
      3);
  const ProcessResult recover = run_avo({"recover", path_of("cut.h5.part")});
  EXPECT_EQ(recover.exit_code, 3);
  EXPECT_NE(recover.err.find("cut off or damaged"), std::string::npos) << recover.err;
}

TEST(Refusals, of_another_number_of_robots_than_its_scene_has) {
  const std::string h5 = recorded_circle();
  const auto with_scene = [&h5](const std::string& override) {
    set_attribute(h5, "override.0", override);
  };
  with_scene("groups.0.number=7");
  expect_refused(h5, "found 6 robots, must be 7, those of its scene");
  with_scene("groups.0.number=5");
  expect_refused(h5, "found 6 robots, must be 5, those of its scene");
  with_scene("groups.0.number=1000000");  // placed, they would take 928 MB
  expect_refused(h5, "found 6 robots, must be 1000000, those of its scene");
}

/// A spool of one block that promises as many robots as its scene makes.
std::string spool_of(std::int64_t robots, bool block) {
  avo_io::RecordingHeader header{.version = "1", .build = "", .robots = robots, .scene = {}};
  header.scene.yaml = "version: 1\ngroups: [{number: " + std::to_string(robots) +
                      ", radius: 0.1, placement: {grid: {corner: [0, 0], spacing: 1, columns: "
                      "1000}}, goals: {offset: {by: [1, 0]}}}]\n";
  header.scene.name = "many";
  const std::string path = path_of("many.h5.part");
  unlink(path.c_str());
  avo_io::SpoolWriter writer(path, header);
  const avo_io::BlockShape shape{static_cast<std::size_t>(robots)};
  if (block) writer.write({{0.0, 0.1}, std::vector<std::string>(shape.chunks(), "x")});
  write_file(path_of("kept.h5.part"), read_file(path));  // without rows the writer removes its own
  return path_of("kept.h5.part");
}

TEST(Refusals, of_a_million_robots_that_its_scene_has_but_not_the_file) {
  expect_refused(spool_of(1'000'000, true), "found a damaged block, must be whole");
  expect_refused(spool_of(1'000'000, false), "found no whole block, must be one or more");
}

avo_io::Hdf5Handle properties() {
  return {H5Pcreate(H5P_DATASET_CREATE), H5Pclose};
}

TEST(Refusals, of_chunks_larger_than_a_block) {
  const auto expect = [](const char* table, const std::vector<hsize_t>& chunk,
                         const std::string& message) {
    const std::string h5 = recorded_circle();
    const avo_io::Hdf5Handle layout = properties();
    ASSERT_GE(H5Pset_chunk(layout.id(), static_cast<int>(chunk.size()), chunk.data()), 0);
    ASSERT_GE(H5Pset_deflate(layout.id(), 1), 0);
    lay_out(h5, table, layout);
    expect_refused(h5, table + message);
  };
  expect("state", {1U << 16U, 6, 1},
         ": found chunks of 65536 x 6 x 1, must be of 64 x 1024 x 1 at "
         "most");
  expect("state", {64, 6, 2}, ": found chunks of 64 x 6 x 2, must be of 64 x 1024 x 1 at most");
  expect("clearance", {65, 6}, ": found chunks of 65 x 6, must be of 64 x 1024 at most");
  expect("status", {1U << 20U, 6}, ": found chunks of 1048576 x 6, must be of 64 x 1024 at most");
  expect("time", {1U << 24U}, ": found chunks of 16777216, must be of 64 at most");
}

// HDF5 itself reads on behind a chunk that is shorter once it is inflated than the table says.
TEST(Refusals, of_chunks_of_another_length_than_the_table_says) {
  const std::string zeros_26("\x78\x9c\x63\x60\xc0\x05\x00\x00\x1a\x00\x01", 11);  // deflated
  const auto expect = [](const char* table, std::size_t rank, unsigned left_out,
                         const std::string& bytes) {
    const std::string h5 = recorded_circle();
    {
      const avo_io::Hdf5Handle file = open_to_edit(h5);
      const avo_io::Hdf5Handle set(H5Dopen2(file.id(), table, H5P_DEFAULT), H5Dclose);
      const std::vector<hsize_t> offset(rank, 0);
      ASSERT_GE(H5Dwrite_chunk(set.id(), H5P_DEFAULT, left_out, offset.data(), bytes.size(),
                               bytes.data()),
                0);
    }
    expect_refused(h5, "found damaged rows from time 0 of 91 on, must be whole");
  };
  constexpr unsigned kEveryFilter = 0, kNone = ~0U;
  expect("state", 3, kEveryFilter, zeros_26);
  expect("status", 2, kEveryFilter, zeros_26);
  expect("clearance", 2, kEveryFilter, zeros_26);
  expect("state", 3, kNone, zeros_26);  // neither deflated nor as long as a chunk
  expect("state", 3, kEveryFilter, std::string(11, '\x78'));
}

TEST(Refusals, not_of_smaller_chunks_or_none) {
  const std::string h5 = recorded_circle();
  lay_out(h5, "state", properties());
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 0);
  const avo_io::Hdf5Handle layout = properties();
  const hsize_t chunk[3] = {7, 2, 1};
  ASSERT_GE(H5Pset_chunk(layout.id(), 3, chunk), 0);
  lay_out(h5, "state", layout);
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 0);
  ASSERT_GE(H5Pset_shuffle(layout.id()), 0);
  ASSERT_GE(H5Pset_deflate(layout.id(), 9), 0);
  lay_out(h5, "state", layout);
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 0);
}

TEST(Refusals, of_rows_in_other_files) {
  std::string h5 = recorded_circle();
  const avo_io::Hdf5Handle outside = properties();
  ASSERT_GE(H5Pset_external(outside.id(), path_of("rows").c_str(), 0, H5F_UNLIMITED), 0);
  lay_out(h5, "state", outside);
  expect_refused(h5, "state: found rows in other files, must be in this one");
  h5 = recorded_circle();
  lay_out(h5, "time", outside);
  expect_refused(h5, "time: found rows in other files, must be in this one");
  const std::string other = recorded_circle({}, "other.h5");
  h5 = recorded_circle();
  {
    const avo_io::Hdf5Handle file = open_to_edit(h5), layout = properties();
    ASSERT_GE(H5Ldelete(file.id(), "clearance", H5P_DEFAULT), 0);
    const hsize_t size[2] = {91, 6};
    const avo_io::Hdf5Handle space(H5Screate_simple(2, size, nullptr), H5Sclose);
    ASSERT_GE(H5Pset_virtual(layout.id(), space.id(), other.c_str(), "clearance", space.id()), 0);
    const avo_io::Hdf5Handle table(H5Dcreate2(file.id(), "clearance", H5T_IEEE_F32LE, space.id(),
                                              H5P_DEFAULT, layout.id(), H5P_DEFAULT),
                                   H5Dclose);
    ASSERT_TRUE(table);
  }
  expect_refused(h5, "clearance: found rows in other files, must be in this one");
  h5 = recorded_circle();
  {
    const avo_io::Hdf5Handle file = open_to_edit(h5);
    ASSERT_GE(H5Ldelete(file.id(), "state", H5P_DEFAULT), 0);
    ASSERT_GE(
        H5Lcreate_external(other.c_str(), "state", file.id(), "state", H5P_DEFAULT, H5P_DEFAULT),
        0);
  }
  expect_refused(h5, "state: found another table, must be one of 91 x 6 x 4");
}

TEST(Refusals, of_another_format_or_other_columns) {
  std::string h5 = recorded_circle();
  set_attribute(h5, "format", "avo recording 2");
  expect_refused(h5, "format: found \"avo recording 2\", must be avo recording 1");
  set_attribute(h5, "format", 1);
  expect_refused(h5, "format: found none, must be avo recording 1");
  remove_attribute(h5, "format");
  expect_refused(h5, "format: found none, must be avo recording 1");
  h5 = recorded_circle();
  set_attribute(h5, "columns", "y,x,vy,vx", "state");
  expect_refused(h5, "state: columns: found \"y,x,vy,vx\", must be x,y,vx,vy");
  set_attribute(h5, "columns", "x,y,vx,vy,heading,speed", "state");
  expect_refused(h5, "state: columns: found \"x,y,vx,vy,heading,speed\", must be x,y,vx,vy");
  remove_attribute(h5, "columns", "state");
  expect_refused(h5, "state: columns: found none, must be x,y,vx,vy");
}

TEST(Refusals, of_scenes_in_recordings_begin_with_the_recording) {
  const std::string h5 = recorded_circle();
  const auto expect = [&h5](const std::string& message) { expect_refused(h5, message); };
  set_attribute(h5, "override.0", "duration=often");
  expect("its scene: --set duration=often: duration: found \"often\", must be a number (s)");
  set_attribute(h5, "override.0", "nothing");
  expect("its scene: --set nothing: found no key=value, must be such as time_step=0.1");
  set_attribute(h5, "override.0", "duration=9");
  const ProcessResult theirs = run_avo({"check", h5, "--set", "duration=often"});
  EXPECT_EQ(theirs.exit_code, 2) << "of the command line, that is another fault";
  set_attribute(h5, "scene", "robots: [");
  for (const Strings& verb :
       {Strings{"check", h5}, Strings{"replay", h5}, Strings{"report", h5, path_of("out.html")}}) {
    const ProcessResult result = run_avo(verb);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_TRUE(result.err.starts_with(h5 + ": its scene: circle-6:1:")) << result.err;
  }
  EXPECT_EQ(run_avo({"check", h5, "--scene", "circle-6"}).exit_code, 0) << "does without it";
}

TEST(Refusals, of_scenes_whose_map_is_not_in_the_recording) {
  const std::string h5 = path_of("run.h5");
  write_file(path_of("room.map"), "type octile\nheight 3\nwidth 3\nmap\n...\n...\n...\n");
  write_file(path_of("room.yaml"),
             "version: 1\nname: room\nduration: 2\nobstacles:\n  - {map: room.map, cell: 3, "
             "origin: [0, 0]}\nrobots:\n  - {position: [3, 3], goal: [6, 6], radius: 0.3}\n");
  ASSERT_EQ(run_avo({"run", path_of("room.yaml"), "--record", h5, "-q"}).exit_code, 0);
  ASSERT_EQ(run_avo({"check", h5}).exit_code, 0);
  const std::string file = "file." + path_of("room.map");
  set_attribute(h5, file.c_str(), "type octile\n");
  ProcessResult result = run_avo({"check", h5});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(result.err.starts_with(h5 + ": its scene: ")) << result.err;
  remove_attribute(h5, file.c_str());
  result = run_avo({"check", h5});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(result.err.starts_with(h5 + ": its scene: ")) << result.err;
}

}  // namespace
}  // namespace avo_test
