// SPDX-License-Identifier: Apache-2.0
// What avo run records as HDF5 explains itself: avo check needs no scene, whatever the scene was
// made of.
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <signal.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "avo_io/recording.h"
#include "edit_hdf5.h"
#include "verdicts.h"

namespace avo_test {
namespace {

Strings with(Strings words, const Strings& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// As CSV and as HDF5; what avo check says of both is the same but for the name.
void expect_same_verdict(const Strings& scene, int exit_code = 0) {
  const std::string csv = path_of("run.csv"), h5 = path_of("run.h5");
  ASSERT_EQ(run_avo(with({"run", "--record", csv, "-q"}, scene)).exit_code, 0);
  ASSERT_EQ(run_avo(with({"run", "--record", h5, "-q"}, scene)).exit_code, 0);
  const ProcessResult text = run_avo(with({"check", csv, "--json", "--scene"}, scene));
  const ProcessResult own = run_avo({"check", h5, "--json"});
  EXPECT_EQ(text.exit_code, exit_code) << text.err;
  EXPECT_EQ(own.exit_code, exit_code) << own.err;
  Json expected = Json::parse(text.out), found = Json::parse(own.out);
  EXPECT_EQ(found["recording"], h5);
  for (const char* key : {"recording", "steps", "to"}) {  // CSV has no times without robots
    found.erase(key);
    expected.erase(key);
  }
  EXPECT_EQ(found, expected);
  const ProcessResult again = run_avo({"replay", h5});
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
}

TEST(Hdf5Recording, of_a_built_in_scene_needs_no_scene) {
  expect_same_verdict({"circle-10"});
}

TEST(Hdf5Recording, keeps_overrides) {
  expect_same_verdict(
      {"circle-6", "--set", "duration=9", "--set", "method=orca", "--set", "groups.0.radius=0.75"},
      1);  // orca exceeds max_acceleration
}

TEST(Hdf5Recording, keeps_maps_and_the_scene_where_their_files_are_gone) {
  std::filesystem::create_directory(path_of("maps"));
  write_file(
      path_of("maps/room.map"),
      "type octile\nheight 12\nwidth 12\nmap\n"
      "@@@@@@@@@@@@\n@..........@\n@..........@\n@..........@\n@..........@\n@..........@\n"
      "@..........@\n@..........@\n@..........@\n@..........@\n@..........@\n@@@@@@@@@@@@\n");
  const std::string scene = path_of("room.yaml"), h5 = path_of("run.h5");
  write_file(
      scene,
      "version: 1\nname: room\nduration: 12\nobstacles:\n  - {map: maps/room.map, cell: 1, origin: "
      "[0, 0]}\n"
      "robots:\n  - {position: [3, 3], goal: [8, 8]}\n  - {position: [8, 3], goal: [3, 8]}\n");
  const ProcessResult run = run_avo({"run", scene, "--record", h5, "-q"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json with_files = Json::parse(run_avo({"check", h5, "--json"}).out);
  std::filesystem::remove_all(path_of("maps"));
  std::filesystem::remove(scene);
  const Json without = Json::parse(run_avo({"check", h5, "--json"}).out);
  EXPECT_EQ(without, with_files);
  EXPECT_EQ(without["verdict"], "safe");
  EXPECT_GT(without["least_static_clearance"], 0.0);
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 0);
}

/// The scene has one robot and a plan of many posts. The text of the plan is longer than an
/// attribute in the header of a file can be.
std::string scene_with_long_plan() {
  std::string plan = "MULTIPOLYGON (";
  for (int k = 0; k < 4000; ++k)
    plan += fmt::format("{}(({} 20, {} 21, {} 20, {} 20))", k > 0 ? ", " : "", 2 * k, 2 * k,
                        2 * k + 1, 2 * k);
  write_file(path_of("plan.wkt"), plan + ")");
  write_file(path_of("long.yaml"),
             "version: 1\nname: long\nduration: 1\nobstacles:\n  - {wkt_file: plan.wkt}\n"
             "robots:\n  - {position: [0, 0], goal: [9, 0]}\n");
  return path_of("long.yaml");
}

TEST(Hdf5Recording, keeps_long_texts_in_parts_of_any_order) {
  const std::string scene = scene_with_long_plan(), h5 = path_of("run.h5");
  ASSERT_EQ(run_avo({"run", scene, "--record", h5, "-q"}).exit_code, 0);
  const auto files_in = [&h5] { return avo_io::read_recording_header(h5)->scene.files; };
  const std::vector<avo_io::SceneFile> files = files_in();
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].text, read_file(path_of("plan.wkt")));
  std::filesystem::remove(path_of("plan.wkt"));
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 0);
  const std::string first = "part.0.file." + files[0].path;
  set_attribute(h5, first.c_str(), files[0].text.substr(0, 60'000));  // which is the last one then
  EXPECT_EQ(files_in()[0].text, files[0].text);
  remove_attribute(h5, first.c_str());
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 3) << "without its first part there is no text";
}

/// Bytes of the file's attributes outside of its header.
hsize_t attributes_elsewhere(const std::string& h5) {
  const avo_io::Hdf5Handle file = open_to_edit(h5);
  H5O_info_t info{};
  EXPECT_GE(H5Oget_info2(file.id(), &info, H5O_INFO_META_SIZE), 0);
  return info.meta_size.attr.index_size + info.meta_size.attr.heap_size;
}

TEST(Hdf5Recording, has_all_attributes_in_its_header) {
  const std::string h5 = path_of("run.h5");
  ASSERT_EQ(run_avo({"run", scene_with_long_plan(), "--record", h5, "-q"}).exit_code, 0);
  EXPECT_EQ(attributes_elsewhere(h5), 0U);
}

TEST(Hdf5Recording, of_an_older_build_with_attributes_in_a_heap_is_read) {
  const std::string h5 = path_of("older.h5");
  write_file(h5, read_file(AVO_OLDER_RECORDING));
  EXPECT_GT(attributes_elsewhere(h5), 0U);
  const auto header = avo_io::read_recording_header(h5);
  EXPECT_EQ(header->scene.name, "circle-3");
  EXPECT_EQ(header->scene.overrides, std::vector<std::string>{"duration=0.3"});
  const Json found = Json::parse(run_avo({"check", h5, "--json"}).out);
  EXPECT_EQ(found["verdict"], "safe");
  EXPECT_EQ(found["robots"], 3);
}

TEST(Hdf5Recording, keeps_remedies) {
  const std::string h5 = path_of("run.h5");
  const std::string scene = path_of("near.yaml");
  write_file(scene,
             "version: 1\nname: near\nduration: 5\nsensing_radius: 4\nrobots:\n"
             "  - {position: [0, 0], velocity: [1.9, 0], goal: [9, 0]}\n"
             "  - {position: [4, 0], velocity: [-1.9, 0], goal: [-9, 0]}\n");
  ASSERT_EQ(run_avo({"run", scene, "-q"}).exit_code, 3);
  ASSERT_EQ(run_avo({"run", scene, "--start-at-rest", "--limit-speed", "--record", h5}).exit_code,
            0);
  const ProcessResult again = run_avo({"replay", h5});
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
}

TEST(Hdf5Recording, has_headings_of_robots_with_wheels) {
  expect_same_verdict({"mixed-yard", "--set", "duration=4"});
}

TEST(Hdf5Recording, has_airplanes_while_they_are_there) {
  const std::string scene = path_of("leaving.yaml");
  const std::string more =
      ", heading: 0, radius: 3, max_speed: 15, max_acceleration: 2, airplane: {min_speed: 15, "
      "lateral_acceleration: 5, after_goal: leave}}\n";
  write_file(scene,
             "version: 1\nname: leaving\nduration: 30\nsensing_radius: 200\nrobots:\n"
             "  - {position: [0, 0], goal: [60, 0]" +
                 more + "  - {position: [0, 160], goal: [150, 160]" + more);
  expect_same_verdict({scene});
}

TEST(Hdf5Recording, that_is_thinned_says_so) {
  const std::string h5 = path_of("run.h5");
  ASSERT_EQ(run_avo({"run", "circle-4", "--every", "7", "--record", h5, "-q"}).exit_code, 0);
  const ProcessResult verdict = run_avo({"check", h5, "--json"});
  EXPECT_EQ(verdict.exit_code, 7);
  EXPECT_EQ(Json::parse(verdict.out)["every"], 7);
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 0);
}

TEST(Hdf5Recording, with_free_clocks_has_all_their_times) {
  expect_same_verdict({"circle-5", "--set", "clock=free", "--set", "duration=8"});
}

TEST(Hdf5Recording, takes_10_bytes_a_robot_step_at_most) {
  const std::string h5 = path_of("run.h5");
  ASSERT_EQ(run_avo({"run", "circle-100", "--record", h5, "-q"}).exit_code, 0);
  EXPECT_LE(static_cast<double>(std::filesystem::file_size(h5)), 10.0 * 1321 * 100);
}

TEST(Hdf5Recording, of_equal_runs_has_equal_bytes_whatever_the_time_and_the_threads) {
  const Strings names{path_of("a.h5"), path_of("b.h5")};
  for (const std::string& h5 : names) {
    const std::string threads = h5 == names[0] ? "1" : "2";
    ASSERT_EQ(
        run_avo({"run", "circle-300", "--duration=8", "--threads", threads, "--record", h5, "-q"})
            .exit_code,
        0);
    usleep(1'100'000);  // HDF5 would keep the second in which it is made
  }
  EXPECT_TRUE(read_file(names[0]) == read_file(names[1]));
}

TEST(Hdf5Recording, a_given_scene_wins_over_its_own) {
  const std::string h5 = path_of("run.h5");
  ASSERT_EQ(run_avo({"run", "circle-6", "--duration", "9", "--record", h5, "-q"}).exit_code, 0);
  const Strings strict{"--set", "groups.0.max_speed=0.5"};
  EXPECT_EQ(run_avo(with({"check", h5, "--scene", "circle-6"}, strict)).exit_code, 1);
  EXPECT_EQ(run_avo(with({"check", h5}, strict)).exit_code, 1) << "--set changes its own";
  EXPECT_EQ(
      run_avo({"check", h5, "--radius=0.5", "--max-speed=2", "--max-acceleration=1"}).exit_code, 0);
  const ProcessResult few = run_avo({"check", h5, "--scene", "circle-5"});
  EXPECT_EQ(few.exit_code, 3);
  EXPECT_EQ(few.err, h5 + ": found 6 robots, must be 5 at most, those of the scene\n");
}

TEST(Hdf5Recording, ends_where_a_signal_ends_the_run) {
  const std::string h5 = path_of("run.h5");
  const ProcessResult run = run_avo_to_its_own_end(
      {"run", "circle-30", "--duration", "1e5", "--threads", "1", "--record", h5, "-q"},
      {.meanwhile = [&h5](int pid) {
        wait_until_larger(pid, h5 + ".part", 20'000);
        kill(pid, SIGINT);
      }});
  EXPECT_EQ(run.exit_code, 130) << run.err;
  EXPECT_EQ(files_in(folder()), Strings{"run.h5"});
  const ProcessResult again = run_avo({"replay", h5});
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
}

TEST(Hdf5Recording, goes_to_regular_files_only_and_spares_what_another_run_has_left) {
  ASSERT_EQ(mkfifo(path_of("pipe.h5").c_str(), 0600), 0);
  const ProcessResult missing = run_avo({"run", "circle-4", "--record", path_of("no/run.h5")});
  EXPECT_EQ(missing.exit_code, 4);
  const std::string h5 = path_of("run.h5");
  write_file(h5 + ".part", "precious");
  const ProcessResult run = run_avo({"run", "circle-4", "--record", h5});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_EQ(run.err,
            h5 +
                ".part: found what another run has left or still writes, must be recovered "
                "(avo recover " +
                h5 + ".part) or removed first\n");
  EXPECT_EQ(read_file(h5 + ".part"), "precious");
  EXPECT_FALSE(exists(h5));
}

}  // namespace
}  // namespace avo_test
