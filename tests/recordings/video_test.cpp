// SPDX-License-Identifier: Apache-2.0
// avo video: frames by ffmpeg, looked at by ffprobe; and the moments that it draws.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <sys/stat.h>

#include "avo_io/frames.h"
#include "avo_io/recording.h"
#include "avo_io/scene.h"
#include "recorded.h"
#include "verdicts.h"

namespace avo_test {
namespace {

/// What a program says on its standard output.
std::string said_by(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 256> part{};
  while (std::fgets(part.data(), part.size(), pipe.get()) != nullptr) text += part.data();
  return text;
}

/// "width,height,frames a second,frames".
std::string probed(const std::string& video) {
  return said_by(
      "ffprobe -v error -count_frames -select_streams v:0 -of csv=p=0 -show_entries "
      "stream=width,height,r_frame_rate,nb_read_frames " +
      video);
}

TEST(Video, has_the_frames_and_pixels_asked_for) {
  const std::string h5 = recorded({"circle-4", "--duration", "2"}), mp4 = path_of("out.mp4");
  const ProcessResult result = run_avo({"video", h5, mp4, "--size", "240"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, mp4 + ": 61 frames of 240 x 240 pixels, 2.0 s\n");
  EXPECT_EQ(probed(mp4), "240,240,30/1,61\n");
  const std::string gif = path_of("out.gif");
  EXPECT_EQ(run_avo({"video", h5, gif, "--size=120", "--fps=10", "--speed=2"}).exit_code, 0);
  EXPECT_EQ(probed(gif), "120,120,10/1,11\n");
  EXPECT_EQ(files_in(folder()), (Strings{"out.gif", "out.mp4", "run.h5"}));
}

TEST(Video, of_csv_needs_the_scene) {
  const std::string csv = path_of("run.csv"), mp4 = path_of("out.mp4");
  ASSERT_EQ(run_avo({"run", "corridor", "--duration=1", "--record", csv, "-q"}).exit_code, 0);
  const ProcessResult none = run_avo({"video", csv, mp4});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_EQ(none.err,
            "avo: " + csv + ": found no scene in it, must be a recording as HDF5, or --scene\n");
  const ProcessResult result =
      run_avo({"video", csv, mp4, "--scene", "corridor", "--size=200", "--fps=5"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(probed(mp4).ends_with(",5/1,6\n")) << probed(mp4);
}

TEST(Video, shows_the_robots_where_they_are) {
  const std::string h5 = recorded({"circle-4", "--duration", "1"}), mp4 = path_of("out.mp4");
  ASSERT_EQ(run_avo({"video", h5, mp4, "--size", "200", "--fps", "10"}).exit_code, 0);
  // robot 0 starts at the right end of the circle: the only color there, but for a goal's cross
  const std::string first = path_of("first.rgb");
  said_by("ffmpeg -v error -i " + mp4 + " -frames:v 1 -f rawvideo -pix_fmt rgb24 " + first);
  const std::string pixels = read_file(first);
  ASSERT_EQ(pixels.size(), 200U * 200U * 3U);
  int colored = 0, elsewhere = 0;
  for (std::size_t k = 0; k < 200 * 200; ++k) {
    const auto level = [&](std::size_t c) { return static_cast<unsigned char>(pixels[3 * k + c]); };
    const int low = std::min({level(0), level(1), level(2)});
    const int high = std::max({level(0), level(1), level(2)});
    const std::size_t x = k % 200, y = k / 200;
    if (high - low < 60) continue;
    if (x > 180 && y > 90 && y < 110) ++colored;
    if (x > 60 && x < 140 && y > 60 && y < 140) ++elsewhere;
  }
  EXPECT_GT(colored, 8);
  EXPECT_EQ(elsewhere, 0) << "nobody is in the middle";
}

TEST(Video, without_ffmpeg_is_one_clear_line) {
  const std::string h5 = recorded({"circle-4", "--duration", "1"});
  const ProcessResult result =
      run_avo({"video", h5, path_of("out.mp4")}, {.before = [] { setenv("PATH", "/nowhere", 1); }});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.err, "ffmpeg: found no such program, must be installed\n");
  EXPECT_EQ(files_in(folder()), Strings{"run.h5"});
}

TEST(Video, says_what_is_wrong_and_leaves_nothing) {
  const std::string h5 = recorded({"circle-4", "--duration", "1"});
  const auto refused = [&](const Strings& more, int code, const std::string& message) {
    Strings command{"video", h5};
    command.insert(command.end(), more.begin(), more.end());
    const ProcessResult result = run_avo(command);
    EXPECT_EQ(result.exit_code, code);
    EXPECT_EQ(result.err, message + "\n");
  };
  refused({"x.avi"}, 2, "avo: the video x.avi: found the ending \".avi\", must be .mp4 or .gif");
  refused({"x"}, 2, "avo: the video x: found the ending \"\", must be .mp4 or .gif");
  refused({"x.mp4", "--size=99"}, 2,
          "avo: --size: found 99, must be an even number from 16 to 8192");
  refused({"x.mp4", "--fps=0"}, 2, "avo: --fps: found 0, must be > 0, <= 240");
  refused({"x.mp4", "--speed=nan"}, 2, "avo: --speed: found nan, must be > 0, <= 1000000");
  EXPECT_EQ(run_avo({"video", path_of("none.h5"), "x.mp4"}).exit_code, 4);
  // a program of that name that fails
  write_file(path_of("ffmpeg"),
             "#!/bin/sh\necho 'no room' >&2\necho 'so there is no video' >&2\nexit 1\n");
  ASSERT_EQ(chmod(path_of("ffmpeg").c_str(), 0755), 0);
  const std::string here = folder();
  const ProcessResult result =
      run_avo({"video", h5, path_of("x.mp4")},
              {.before = [here] { setenv("PATH", (here + ":/bin").c_str(), 1); }});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.err, "ffmpeg: no room\n");
  EXPECT_EQ(files_in(folder()), (Strings{"ffmpeg", "run.h5"}));
}

TEST(Frames, are_the_rows_and_the_cubics_between_them) {
  const std::string h5 = recorded({"mixed-yard", "--set", "duration=3"});
  avo_io::SceneSource source = avo_io::read_recording_header(h5)->scene;
  const avo::Scenario scenario = avo_io::parse_scenario(source);
  avo_io::RecordingReader rows(h5);
  avo_io::FrameReader frames(h5, scenario);
  avo_io::RecordedTime before, now;
  ASSERT_TRUE(rows.next(before));
  while (rows.next(now)) {
    const auto between = frames.at(0.5 * (before.time + now.time));
    ASSERT_TRUE(between);
    for (std::size_t i = 0; i < now.rows.size(); ++i) {
      const double step = now.time - before.time;
      const avo::Vec2 middle = 0.5 * (before.rows[i].position + now.rows[i].position) +
                               (step / 8.0) * (before.rows[i].velocity - now.rows[i].velocity);
      EXPECT_NEAR(norm(between->position[i] - middle), 0.0, 1e-12);
    }
    const auto there = frames.at(now.time);
    ASSERT_TRUE(there);
    for (std::size_t i = 0; i < now.rows.size(); ++i) {
      EXPECT_NEAR(norm(there->position[i] - now.rows[i].position), 0.0, 1e-12);
      if (now.rows[i].heading) {
        EXPECT_NEAR(std::cos(there->heading[i] - now.rows[i].heading->angle), 1.0, 1e-12);
      }
    }
    before = now;
  }
  EXPECT_FALSE(frames.at(before.time + 0.01));
}

TEST(Frames, have_moving_obstacles_where_the_simulation_has_them) {
  const std::string h5 = recorded({"person", "--set", "duration=12"});
  const avo::Scenario scenario = avo_io::parse_scenario(avo_io::read_recording_header(h5)->scene);
  avo::Simulation simulation(scenario, 1);
  avo_io::FrameReader frames(h5, scenario);
  ASSERT_FALSE(scenario.moving_obstacles.empty());
  while (simulation.can_step_by(scenario.duration)) {
    const auto frame = frames.at(simulation.time());
    ASSERT_TRUE(frame);
    for (std::size_t k = 0; k < frame->mover_position.size(); ++k)
      EXPECT_EQ(frame->mover_position[k], simulation.moving_obstacles().position[k]);
    simulation.step();
  }
}

}  // namespace
}  // namespace avo_test
