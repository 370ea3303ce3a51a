// SPDX-License-Identifier: Apache-2.0
// Recordings of space as HDF5: the columns, the judge, the replay, CSV there and back, refusals.
#include "avo_io/space.h"

#include <algorithm>
#include <cstdint>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <limits>
#include <string>
#include <vector>

#include "avo_io/space_frames.h"
#include "edit_hdf5.h"
#include "recorded.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

// 5 s of nine drones under a ceiling, one of them with downwash and unequal limits.
const std::string kScene = R"(version: 1
space: 3
duration: 5
groups:
  - {count: 8, sphere: {radius: 5}, goal: antipodal, jitter: 0.1}
robots:
  - {position: [0, -9, 1], goal: [2, 9, 1], vertical: 0.5, downwash: 1}
obstacles:
  - {ceiling: 8}
)";

std::string scene_file() {
  write_file(path_of("drones.yaml"), kScene);
  return path_of("drones.yaml");
}

std::vector<double> column_of(const std::string& path, hsize_t robots, hsize_t column,
                              hsize_t times) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t table = H5Dopen2(file, "state", H5P_DEFAULT);
  std::vector<double> all(times * robots * 6), values;
  EXPECT_GE(H5Dread(table, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), 0);
  for (std::size_t k = column; k < all.size(); k += 6) values.push_back(all[k]);
  H5Dclose(table);
  H5Fclose(file);
  return values;
}

std::vector<std::uint8_t> statuses_of(const std::string& path, std::size_t count) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t table = H5Dopen2(file, "status", H5P_DEFAULT), type = H5Dget_type(table);
  std::vector<std::uint8_t> all(count, 99);
  EXPECT_GE(H5Dread(table, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), 0);
  H5Tclose(type);
  H5Dclose(table);
  H5Fclose(file);
  return all;
}

TEST(SpaceHdf5, has_the_states_of_the_run_and_explains_itself) {
  const std::string h5 = recorded({scene_file()}, "space.h5");
  avo::space::Simulation simulation(avo_io::parse_space_scenario(kScene, "drones.yaml"));
  const std::vector<double> z = column_of(h5, 9, 2, 51), vy = column_of(h5, 9, 4, 51);
  const std::vector<std::uint8_t> status = statuses_of(h5, z.size());
  for (std::size_t k = 0; k < z.size(); ++k) {
    if (k > 0 && k % 9 == 0) simulation.step();
    ASSERT_EQ(z[k], simulation.robots()[k % 9].position.z) << k;
    ASSERT_EQ(vy[k], simulation.robots()[k % 9].velocity.y) << k;
    ASSERT_EQ(status[k], static_cast<std::uint8_t>(simulation.plans()[k % 9].status)) << k;
  }
  EXPECT_GT(std::count_if(status.begin(), status.end(), [](std::uint8_t s) { return s != 0; }), 0);
  const auto own = avo_io::read_recorded_space_scene(h5);
  ASSERT_TRUE(own);
  EXPECT_EQ(own->header.state_hash, simulation.state_hash());
  EXPECT_EQ(own->scenario.robots, simulation.scenario().robots);
  const ProcessResult check = run_avo({"check", h5, "--json"});
  ASSERT_EQ(check.exit_code, 0) << check.err;
  EXPECT_EQ(Json::parse(check.out)["robots"], 9);
  const ProcessResult slower = run_avo({"check", h5, "--set", "groups.0.max_speed=0.5", "--set",
                                        "groups.0.preferred_speed=0.5", "--json"});
  EXPECT_EQ(slower.exit_code, 1) << slower.err;
  EXPECT_GT(Json::parse(slower.out)["speeds"]["count"], 0);
}

TEST(SpaceHdf5, has_the_clearance_of_the_nearest_pair_and_of_downwash) {
  write_file(path_of("three.yaml"),
             "version: 1\nspace: 3\nduration: 0.1\nrobots:\n"
             "  - {position: [0, 0, 5], goal: [0, 0, 5], downwash: 2}\n"
             "  - {position: [1.5, 0, 3.5], goal: [1.5, 0, 3.5]}\n"
             "  - {position: [0, 3, 5], goal: [0, 3, 5], radius: 0.25}\n");
  const std::string h5 = recorded({path_of("three.yaml")}, "space.h5");
  const hid_t file = H5Fopen(h5.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t table = H5Dopen2(file, "clearance", H5P_DEFAULT);
  std::vector<float> found(6);
  EXPECT_GE(H5Dread(table, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, found.data()), 0);
  H5Dclose(table);
  H5Fclose(file);
  EXPECT_FLOAT_EQ(found[0], 0.5F);  // the robot below is beside the air that is pushed down
  EXPECT_FLOAT_EQ(found[1], 0.5F);
  EXPECT_FLOAT_EQ(found[2], 2.25F);
}

TEST(SpaceHdf5, becomes_the_csv_of_the_run_and_back) {
  const std::string scene = scene_file(), h5 = recorded({scene}, "space.h5");
  const std::string csv = recorded({scene}, "space.csv"), other = path_of("other.csv");
  ASSERT_EQ(run_avo({"convert", h5, other}).exit_code, 0);
  EXPECT_EQ(read_file(other), read_file(csv));
  const std::string again = path_of("again.h5");
  const ProcessResult back =
      run_avo({"convert", csv, again, "--to", "recording", "--scene", scene});
  ASSERT_EQ(back.exit_code, 0) << back.err;
  EXPECT_THAT(back.out, HasSubstr("51 times, 459 rows"));
  EXPECT_EQ(column_of(again, 9, 2, 51), column_of(h5, 9, 2, 51));
  EXPECT_EQ(run_avo({"check", again}).exit_code, 0);
  const ProcessResult replayed = run_avo({"replay", again});
  EXPECT_EQ(replayed.exit_code, 3) << replayed.out;
  EXPECT_THAT(replayed.err,
              HasSubstr("again.h5: found rows of avo convert, must be those of a run"));
  EXPECT_THAT(run_avo({"convert", csv, again, "--to", "recording"}).err,
              HasSubstr("--scene: found none, must be given: the format has radii"));
  EXPECT_THAT(run_avo({"convert", h5, path_of("x.sqlite")}).err,
              HasSubstr("must be csv, recording, mcap, gltf or set-points"));
}

TEST(SpaceHdf5, has_rows_of_every_third_step_and_the_last_one) {
  const std::string scene = scene_file();
  const std::string h5 = recorded({scene, "--every", "3"}, "space.h5");
  const std::string csv = recorded({scene, "--every", "3"}, "space.csv");
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 0);
  ASSERT_EQ(run_avo({"convert", h5, path_of("other.csv")}).exit_code, 0);
  EXPECT_EQ(read_file(path_of("other.csv")), read_file(csv));
  const std::vector<std::string> lines = lines_of(read_file(csv));
  EXPECT_EQ(lines.size(), 1U + 9U * 18U);  // steps 0, 3 ... 48, 50
  EXPECT_EQ(lines[0], "time,robot,x,y,z,vx,vy,vz,every");
  const ProcessResult check = run_avo({"check", csv, "--scene", scene, "--json"});
  EXPECT_EQ(check.exit_code, 7) << check.err;
  EXPECT_EQ(Json::parse(check.out)["every"], 3);
}

TEST(SpaceHdf5, is_replayed_bit_by_bit) {
  const std::string h5 = recorded({scene_file()}, "space.h5");
  const ProcessResult same = run_avo({"replay", h5, "--threads", "2"});
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("51 times of 9 robots are equal, and the state hash"));
  for (const auto& [table, offset, column] :
       {std::tuple{"state", std::vector<hsize_t>{20, 8, 2}, "z"},
        std::tuple{"state", std::vector<hsize_t>{20, 8, 5}, "vz"},
        std::tuple{"clearance", std::vector<hsize_t>{20, 8}, "clearance"}}) {
    recorded({scene_file()}, "space.h5");
    change(h5, table, offset, H5T_NATIVE_DOUBLE, 0.123);
    const ProcessResult changed = run_avo({"replay", h5});
    EXPECT_EQ(changed.exit_code, 1) << column;
    EXPECT_THAT(changed.out, HasSubstr(std::string("at 2 s, robot 8, ") + column + ": recorded"));
  }
}

TEST(SpaceHdf5, readers_of_the_plane_refuse_it_in_one_line) {
  const std::string h5 = recorded({scene_file()}, "space.h5");
  const ProcessResult result = run_avo({"compare", h5});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
  EXPECT_THAT(result.err, HasSubstr("found a recording of space, must be one of the plane here"));
}

TEST(SpaceHdf5, whole_blocks_of_a_run_that_was_cut_off_are_recovered) {
  avo_io::SceneSource source;
  const auto scene = avo_io::load_space_scenario(scene_file(), {"duration=20"}, &source);
  const std::string h5 = path_of("cut.h5"), spool = h5 + ".part";
  {
    const auto recording = avo_io::open_space_recording(h5, *scene, source);
    avo::space::Simulation simulation(*scene);
    for (int k = 0; k < 150; ++k, simulation.step()) recording->add(simulation);
  }
  EXPECT_FALSE(exists(h5));
  EXPECT_EQ(run_avo({"replay", spool}).exit_code, 0);
  const ProcessResult recovered = run_avo({"recover", spool});
  EXPECT_EQ(recovered.exit_code, 7) << recovered.err;
  EXPECT_THAT(recovered.out, HasSubstr("128 times, until 12.7"));
  EXPECT_EQ(run_avo({"check", h5}).exit_code, 0);
  EXPECT_THAT(run_avo({"replay", h5}).out, HasSubstr("128 times of 9 robots are equal"));
}

TEST(SpaceHdf5, forged_files_are_refused_in_one_line) {
  constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
  const std::string h5 = path_of("space.h5");
  const auto expect_refused = [&](const std::string& message) {
    for (const Strings& verb : {Strings{"check", h5},
                                {"replay", h5},
                                {"convert", h5, path_of("x.csv")},
                                {"convert", h5, path_of("x.glb")},
                                {"report", h5, path_of("x.html")}}) {
      const ProcessResult result = run_avo(verb);
      EXPECT_EQ(result.exit_code, 3) << verb[0] << result.out;
      EXPECT_THAT(result.err, HasSubstr(message)) << verb[0];
      EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
    }
    EXPECT_FALSE(exists(path_of("x.csv")) || exists(path_of("x.glb")) || exists(path_of("x.html")));
  };
  const auto record = [&] { recorded({scene_file()}, "space.h5"); };
  record();
  change(h5, "state", {20, 8, 2}, H5T_NATIVE_DOUBLE, kNoNumber);
  expect_refused("time 2 s, robot 8: z: found nan, must be a finite number");
  record();
  change(h5, "time", {50}, H5T_NATIVE_DOUBLE, 77.0);
  expect_refused("time: found 77 s, must be <= 5 s, the duration of its scene");
  record();
  set_attribute(h5, "columns", "x,y,vx,vy,heading,speed", "state");
  expect_refused("must be x,y,z,vx,vy,vz");
  record();
  set_attribute(h5, "space", 4);
  expect_refused("space: found 4, must be 2 to 3");
  record();
  std::string many = kScene;
  set_attribute(h5, "scene", many.replace(many.find("count: 8"), 8, "count: 900000"));
  expect_refused("900001 robots in all, must be at most 9");
  record();
  set_attribute(h5, "scene", many.replace(many.find("count: 900000"), 13, "count: 7"));
  expect_refused("found 9 robots, must be 8, those of its scene");
}

TEST(SpaceHdf5, frames_are_on_the_path_between_the_rows) {
  const std::string h5 = recorded({scene_file(), "--every", "5"}, "space.h5");
  const avo::space::Scenario scene = avo_io::read_recorded_space_scene(h5)->scenario;
  avo::space::Simulation simulation(scene);
  avo_io::SpaceFrameReader reader(h5, scene);
  EXPECT_EQ(reader.first_time(), 0.0);
  for (int k = 0; k < 10; ++k) simulation.step();
  const std::vector<avo::space::Robot> from(simulation.robots().begin(), simulation.robots().end());
  for (int k = 0; k < 5; ++k) simulation.step();
  const auto frame = reader.at(1.25);
  ASSERT_TRUE(frame);
  for (std::size_t k = 0; k < 9; ++k) {  // the frame shows the middle of a cubic
    const avo::space::Robot &a = from[k], &b = simulation.robots()[k];
    const avo::Vec3 middle =
        0.5 * (a.position + b.position) + (0.5 / 8.0) * (a.velocity - b.velocity);
    EXPECT_LT(norm(frame->position[k] - middle), 1e-9) << k;
    EXPECT_TRUE(frame->there[k]);
  }
  EXPECT_FALSE(reader.at(5.1));
}

TEST(SpaceHdf5, curves_are_those_of_the_metrics) {
  const std::string h5 =
      recorded({scene_file(), "--duration", "12", "--summary", path_of("s.json")}, "space.h5");
  const Json summary = Json::parse(read_file(path_of("s.json")));
  const auto own = avo_io::read_recorded_space_scene(h5);
  const avo_io::SpaceRun run = avo_io::read_space_run(h5, own->scenario, 8);
  ASSERT_EQ(run.moments.size(), 121U);
  EXPECT_LE(run.frames.size(), 9U);
  EXPECT_EQ(run.frames.back().time, run.moments.back().time);
  EXPECT_EQ(run.moments.back().arrived, summary["arrived"].get<std::int64_t>());
  double fastest = 0.0, least = 1e9;
  for (const avo_io::RecordedMoment& moment : run.moments) {
    fastest = std::max(fastest, moment.fastest);
    least = std::min(least, *moment.clearance);
  }
  EXPECT_NEAR(least, summary["min_clearance"].get<double>(), 0.05);  // between rows it is less
  EXPECT_GE(least, summary["min_clearance"].get<double>() - 1e-6);
  EXPECT_GT(fastest, 1.5);
}

TEST(SpaceHdf5, is_shown_from_above_and_from_the_side) {
  const std::string h5 = recorded({scene_file()}, "space.h5"), html = path_of("out.html");
  const ProcessResult report = run_avo({"report", h5, html});
  ASSERT_EQ(report.exit_code, 0) << report.err;
  const std::string page = read_file(html);
  for (const char* part :
       {"class=\"verdict safe\"", "Replay: from above, and from the side", "plan and elevation",
        "9 robots in space", "min_clearance", "avo run ", "count: 8, sphere"})
    EXPECT_THAT(page, HasSubstr(part));
  EXPECT_THAT(page, Not(HasSubstr("Simulated again, the run is another one")));
  const auto body_of = [&page](std::size_t from) {
    const std::size_t end = page.find("<title>robot 8</title>", from);
    return page.substr(page.rfind("<circle", end), end - page.rfind("<circle", end));
  };
  const std::size_t first = page.find("<title>robot 8</title>");
  EXPECT_EQ(body_of(0), body_of(first + 1)) << "the same color and radius in both views";
  const std::string gif = path_of("out.gif");
  const ProcessResult video = run_avo({"video", h5, gif, "--fps", "4", "--size", "160"});
  ASSERT_EQ(video.exit_code, 0) << video.err;
  EXPECT_THAT(video.out, HasSubstr("out.gif: 21 frames of 160 x "));
  EXPECT_THAT(read_file(gif).substr(0, 6), "GIF89a");
}

}  // namespace
}  // namespace avo_test
