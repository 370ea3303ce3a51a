// SPDX-License-Identifier: Apache-2.0
// avo video: a recording as a video, by ffmpeg.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments/files.h"
#include "avo_io/frames.h"
#include "avo_io/output_file.h"
#include "avo_io/recording.h"
#include "avo_io/space_frames.h"
#include "exit_codes.h"
#include "figures/picture.h"
#include "figures/space_views.h"
#include "system/child_process.h"
#include "system/signals.h"
#include "system/terminal.h"
#include "verbs/space_verbs.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

namespace figures = avo::figures;

constexpr double kTraces = 4.0;  // s of the simulation: the duration of the shown traces

std::string ending_of(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}
bool is_gif(const std::string& path) {
  return ending_of(path) == ".gif" || ending_of(path) == ".GIF";
}
bool is_mp4(const std::string& path) {
  return ending_of(path) == ".mp4" || ending_of(path) == ".MP4";
}

void check_arguments(const VideoArguments& arguments) {
  if (!is_mp4(arguments.output) && !is_gif(arguments.output))
    throw UsageError(fmt::format("the video {}: found the ending \"{}\", must be .mp4 or .gif",
                                 arguments.output, ending_of(arguments.output)));
  const auto require = [](const char* option, double value, double most) {
    if (!(value > 0.0 && value <= most))
      throw UsageError(fmt::format("{}: found {}, must be > 0, <= {}", option, value, most));
  };
  require("--fps", arguments.fps, 240.0);
  require("--speed", arguments.speed, 1e6);
  if (arguments.size < 16 || arguments.size > 8192 || arguments.size % 2 != 0)
    throw UsageError(
        fmt::format("--size: found {}, must be an even number from 16 to 8192", arguments.size));
}

avo::Scenario scenario_of(const VideoArguments& arguments) {
  if (!arguments.scene.scene.empty())
    return load(arguments.scene, {{"the video", arguments.output}});
  auto own = avo_io::read_recorded_scene(arguments.recording, arguments.scene.overrides);
  if (!own)
    throw UsageError(arguments.recording +
                     ": found no scene in it, must be a recording as HDF5, or --scene");
  return std::move(own->scenario);
}

/// The box of everything in the recording at any time, and the recording's times.
struct Extent {
  figures::Box world;
  double first = 0.0, last = 0.0;  // s
};
Extent extent_of(const VideoArguments& arguments, const avo::Scenario& scenario) {
  Extent extent{figures::world_of(scenario)};
  avo_io::RecordingReader reader(arguments.recording,
                                 static_cast<std::int64_t>(scenario.robots.size()));
  avo_io::RecordedTime moment;
  for (bool begun = false; reader.next(moment); begun = true) {
    if (!begun) extent.first = moment.time;
    extent.last = moment.time;
    for (const avo::CheckedState& row : moment.rows) {
      const avo::RobotSetup& robot = scenario.robots[static_cast<std::size_t>(row.robot)];
      extent.world =
          enclosing(extent.world, figures::enclosing(avo::Disc{row.position, disc_radius(robot)}));
    }
  }
  return extent;
}

void check_frames(const VideoArguments& arguments, const Extent& extent) {
  constexpr double kMostVideoFrames = 1e6;
  const double frames =
      std::floor((extent.last - extent.first) / arguments.speed * arguments.fps + 1e-6) + 1.0;
  if (frames > kMostVideoFrames)
    throw UsageError(
        fmt::format("--fps {} and --speed {}: found {:.0f} frames, must be {:.0f} at most",
                    arguments.fps, arguments.speed, frames, kMostVideoFrames));
}

/// The size of the picture: the longer side has `size` pixels; both sides are even.
struct Pixels {
  int width, height;
};
Pixels pixels_of(const figures::Box& world, int size) {
  const avo::Vec2 sides = world.upper - world.lower;
  const double longer = std::max(sides.x, sides.y);
  const auto even = [size, longer](double side) {
    return std::max(2 * static_cast<int>(std::lround(0.5 * size * side / longer)), 16);
  };
  return {even(sides.x), even(sides.y)};
}

std::vector<std::string> ffmpeg(const VideoArguments& arguments, const Pixels& pixels,
                                const std::string& file) {
  std::vector<std::string> command{"ffmpeg",
                                   "-nostdin",
                                   "-y",
                                   "-loglevel",
                                   "error",
                                   "-f",
                                   "rawvideo",
                                   "-pix_fmt",
                                   "bgr0",
                                   "-s",
                                   fmt::format("{}x{}", pixels.width, pixels.height),
                                   "-r",
                                   fmt::format("{}", arguments.fps),
                                   "-i",
                                   "-"};
  // a palette for each frame: that of the whole video would be known only at its end
  const std::vector<std::string> gif{
      "-filter_complex",
      "split[a][b];[a]palettegen=stats_mode=single:max_colors=128[p];[b][p]paletteuse=new=1", "-f",
      "gif"};
  const std::vector<std::string> mp4{"-c:v",      "libx264",    "-preset",  "veryfast",
                                     "-crf",      "20",         "-pix_fmt", "yuv420p",
                                     "-movflags", "+faststart", "-f",       "mp4"};
  const std::vector<std::string>& format = is_gif(arguments.output) ? gif : mp4;
  command.insert(command.end(), format.begin(), format.end());
  command.push_back("file:" + file);
  return command;
}

/// What a video shows: a run of the plane, or two views of one in space.
struct Film {
  avo::Scenario scenario;
  Extent extent;
  /// Returns the moment of that time, s, and which robots are there; none after the last time.
  std::function<std::optional<figures::TrajectoryFrame>(double time)> at;
  std::size_t views = 1;
};

Film film_of(const VideoArguments& arguments) {
  if (auto in_space = space_run_of(arguments.recording, arguments.scene)) {
    const figures::ViewsInPlane views = views_in_plane(in_space->scenario, in_space->frames);
    const std::vector<avo_io::RecordedMoment>& moments = in_space->run.moments;
    Film film{views.scenario,
              {figures::world_of(views.scenario), moments.front().time, moments.back().time},
              {}};
    for (const figures::SpaceRecorder::Frame& frame : in_space->frames)
      for (const avo::Vec2 place : views.places(frame.position))
        film.extent.world = enclosing(film.extent.world, figures::enclosing(avo::Disc{place, 0.0}));
    const auto reader =
        std::make_shared<avo_io::SpaceFrameReader>(arguments.recording, in_space->scenario);
    film.views = 2;
    film.at = [reader, views,
               scene = in_space->scenario](double time) -> std::optional<figures::TrajectoryFrame> {
      const auto frame = reader->at(time);
      if (!frame) return std::nullopt;
      return figures::TrajectoryFrame{
          .time = frame->time,
          .position = views.places(frame->position),
          .mover_position = views.places(figures::movers_at(scene, frame->time)),
          .there = views.twice(frame->there)};
    };
    return film;
  }
  Film film{scenario_of(arguments), {}, {}};
  film.extent = extent_of(arguments, film.scenario);
  const auto reader = std::make_shared<avo_io::FrameReader>(arguments.recording, film.scenario);
  film.at = [reader](double time) -> std::optional<figures::TrajectoryFrame> {
    const auto frame = reader->at(time);
    if (!frame) return std::nullopt;
    return figures::TrajectoryFrame{frame->time, frame->position, frame->heading,
                                    frame->mover_position, frame->there};
  };
  return film;
}

/// Draws frame after frame until the recording ends; returns the number of frames.
std::int64_t draw_frames(const VideoArguments& arguments, const Film& film,
                         figures::MomentPainter& painter, ChildProcess& child) {
  Progress progress(film.scenario.duration, true);
  std::vector<figures::TrajectoryFrame> frames;
  const double step = arguments.speed / arguments.fps;
  const auto kept = static_cast<std::size_t>(std::ceil(kTraces / step)) + 1;
  std::int64_t count = 0;
  while (signal_caught() == 0) {
    const double time = film.extent.first + step * static_cast<double>(count);
    std::optional<figures::TrajectoryFrame> frame = film.at(time);
    if (!frame) break;
    const std::vector<bool> there = std::exchange(frame->there, {});
    if (frames.size() == kept) frames.erase(frames.begin());
    frames.push_back(std::move(*frame));
    ++count;
    if (!child.write(painter.paint(frames, there))) break;
    progress.show(time);
  }
  return count;
}

}  // namespace

int video(const VideoArguments& arguments) {
  check_arguments(arguments);
  require_distinct({{"the recording", arguments.recording}, file_of(arguments.scene)},
                   {{"the video", arguments.output}});
  catch_signals();
  const Film film = film_of(arguments);
  check_frames(arguments, film.extent);
  const figures::Box& world = film.extent.world;
  const Pixels pixels = pixels_of(world, arguments.size);
  figures::MomentPainter painter(film.scenario, world, pixels.width, pixels.height, film.views);
  avo_io::OutputFile file(arguments.output);
  if (file.temporary().empty())
    throw avo_io::FileError(arguments.output + ": found no regular file, a video must be one");
  ChildProcess child(ffmpeg(arguments, pixels, file.temporary()));
  const std::int64_t count = draw_frames(arguments, film, painter, child);
  if (const int caught = signal_caught(); caught != 0) {
    say("stopped by a signal; there is no video");
    return kSignal + caught;
  }
  child.finish();
  file.commit();
  print_results(fmt::format("{}: {} frames of {} x {} pixels, {:.1f} s\n", arguments.output, count,
                            pixels.width, pixels.height,
                            static_cast<double>(count) / arguments.fps));
  return kDone;
}

}  // namespace avo_cli
