// SPDX-License-Identifier: Apache-2.0
// Converts a recording to another format: its times become frames, and its robots face a direction.
#include "avo_io/convert.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <unordered_map>
#include <utility>

#include "avo_io/errors.h"
#include "core/elementary.h"
#include "io/export/target.h"

namespace avo_io {
namespace {

bool has_frames(ExportFormat format) {
  return format != ExportFormat::csv && format != ExportFormat::mcap &&
         format != ExportFormat::recording && format != ExportFormat::gltf;
}

/// Times as whole numbers of equal steps from the first one.
struct Frames {
  double time_step = 0.0;  // s, of the scene; 0: there is none
  bool begun = false;
  double first = 0.0, step = 0.0;  // s: the first time, and from there to the second

  void set_step(double gap);
  std::optional<std::int64_t> frame_of(double time);
  [[nodiscard]] double fps() const;
};

constexpr double kOfStep = 1e-6;  // because the digits of times may be rounded

// Whole steps of the scene are free of the rounding of times.
void Frames::set_step(double gap) {
  step = gap;
  if (!(time_step > 0.0)) return;
  const double steps = std::round(gap / time_step);
  if (std::abs(gap - steps * time_step) <= kOfStep * time_step) step = steps * time_step;
}

// Returns none for a time between two frames.
std::optional<std::int64_t> Frames::frame_of(double time) {
  if (!std::exchange(begun, true)) {
    first = time;
    return 0;
  }
  if (step == 0.0) set_step(time - first);
  const double frame = std::round((time - first) / step);
  if (!(frame < 0x1p53) || std::abs(time - first - frame * step) > kOfStep * step)
    return std::nullopt;
  return static_cast<std::int64_t>(frame);
}

double Frames::fps() const {
  const double fps = 1.0 / step, whole = std::round(fps);
  return std::abs(fps - whole) <= 1e-9 * fps ? whole : fps;
}

/// The direction that a robot faces: its heading, else its motion, else its last motion, else +x.
struct Facing {
  std::unordered_map<std::int64_t, avo::Vec2> last;
  std::vector<avo::Vec2> now;

  void turn(const RecordedTime& moment) {
    now.clear();
    for (const avo::CheckedState& row : moment.rows) {
      avo::Vec2& face = last.try_emplace(row.robot, avo::Vec2{1.0, 0.0}).first->second;
      const double speed = norm(row.velocity);
      if (row.heading)
        face = avo::elementary::direction(row.heading->angle);
      else if (speed > kAtRest)
        face = row.velocity / speed;
      now.push_back(face);
    }
  }
};

std::optional<avo::Scenario> scenario_of(const std::string& input, const ConvertOptions& options) {
  if (options.scenario) return options.scenario;
  auto own = read_recorded_scene(input);
  if (!own) return std::nullopt;
  return std::move(own->scenario);
}

std::unique_ptr<ExportTarget> target_of(ExportFormat format, const ExportPlace& place,
                                        const avo::Scenario* scenario) {
  const bool by_name = format == ExportFormat::sqlite || format == ExportFormat::pedestrian_hdf5;
  if (by_name && place.file.temporary().empty())
    throw FileError(place.name + ": found no regular file, this format must be written to one");
  switch (format) {
    case ExportFormat::csv:
      return export_csv(place);
    case ExportFormat::sqlite:
      return export_sqlite(place, scenario);
    case ExportFormat::pedestrian_hdf5:
      return export_pedestrian(place, scenario);
    case ExportFormat::pedestrian_text:
    case ExportFormat::obsmat:
      return export_text(place, format == ExportFormat::obsmat);
    case ExportFormat::mcap:
    case ExportFormat::recording:
    case ExportFormat::gltf:
      break;
  }
  return export_mcap(place, *scenario);
}

void require_fitting_scene(const std::string& input, ExportFormat format,
                           const avo::Scenario* scenario) {
  if (format == ExportFormat::gltf)
    throw RecordingError(input + ": found a recording of the plane, must be one of space for glTF");
  if (format == ExportFormat::mcap && scenario == nullptr)
    throw avo::Error("the scene: found none, must be given: MCAP shows radii and walls");
  if (format == ExportFormat::mcap && scenario->robots.empty())
    throw avo::Error("the scene: found no robots in it, must have them: MCAP shows radii");
  if (has_frames(format) && scenario != nullptr && scenario->clock == avo::Clock::free)
    throw RecordingError(input +
                         ": found free clocks, must have a common one: the format has frames at "
                         "equal times; csv and mcap have times");
}

/// The robots of the scene that are elsewhere at the first time of the recording, by number.
std::vector<OtherStart> other_starts(const avo::Scenario& scenario, const RecordedTime& first) {
  std::vector<OtherStart> others;
  auto row = first.rows.begin();
  for (std::size_t k = 0; k < scenario.robots.size(); ++k) {
    const auto robot = static_cast<std::int64_t>(k);
    const avo::Vec2 start = scenario.robots[k].position;
    if (row == first.rows.end() || row->robot != robot) {
      others.push_back({robot, std::nullopt, start});
      continue;
    }
    if (norm(row->position - start) > kSameStart) others.push_back({robot, row->position, start});
    ++row;
  }
  return others;
}

/// Turns rows of a motion into those of the scene that was made of it.
void renumber(RecordedTime& moment, const ConvertOptions& options) {
  moment.time -= options.first_time;
  for (avo::CheckedState& row : moment.rows)
    row.robot = std::ranges::lower_bound(options.robots, row.robot) - options.robots.begin();
}

/// Makes a recording of rows of any origin, for what reads recordings with their scenes.
Converted record(const std::string& input, const std::string& output,
                 const ConvertOptions& options) {
  if (!options.scenario || options.scenario->robots.empty())
    throw avo::Error("the scene: found no robots, must have those of the recording");
  const avo::Scenario& scenario = *options.scenario;
  std::optional<std::int64_t> known = static_cast<std::int64_t>(scenario.robots.size());
  if (!options.robots.empty()) known.reset();  // numbers of the motion, which may be any
  RecordingReader reader(input, known);
  std::optional<Hdf5Recording> recording;
  Converted result;
  RecordedTime moment;
  while (reader.next(moment)) {
    if (!options.robots.empty()) renumber(moment, options);
    if (moment.time > scenario.duration * (1.0 + kOfStep))
      throw RecordingError(fmt::format("{}: found {} s, must be <= {} s, the duration of the scene",
                                       reader.place(), moment.time, scenario.duration));
    for (const avo::CheckedState& row : moment.rows)
      if (!row.heading && !is_holonomic(scenario.robots[static_cast<std::size_t>(row.robot)].model))
        throw RecordingError(
            fmt::format("{}: found no heading, must have one: robot {} is not holonomic",
                        reader.place(row.robot), row.robot));
    if (!recording && options.robots.empty()) result.other_starts = other_starts(scenario, moment);
    if (!recording)
      recording.emplace(output, scenario, options.source, RecordingOptions{.every = moment.every});
    recording->add(moment);
    ++result.times;
    result.rows += static_cast<std::int64_t>(moment.rows.size());
    if (options.converted) options.converted(moment.time);
  }
  recording->finish();
  recording->commit();
  return result;
}

}  // namespace

Converted convert(const std::string& input, const std::string& output,
                  const ConvertOptions& options) {
  if (options.format == ExportFormat::recording) return record(input, output, options);
  const std::optional<avo::Scenario> scenario = scenario_of(input, options);
  const avo::Scenario* const scene = scenario ? &*scenario : nullptr;
  require_fitting_scene(input, options.format, scene);
  std::optional<std::int64_t> robots;
  if (scene != nullptr && !scene->robots.empty())
    robots = static_cast<std::int64_t>(scene->robots.size());
  RecordingReader reader(input, robots);
  OutputFile file(output);
  const auto target = target_of(options.format, {file, output}, scene);
  Converted result;
  Frames frames{robots ? scene->time_step : 0.0};
  if (const auto rate = reader.frame_rate()) frames.step = 1.0 / *rate;
  Facing facing;
  RecordedTime moment;
  while (reader.next(moment)) {
    const auto frame = has_frames(options.format) ? frames.frame_of(moment.time) : 0;
    if (result.left_out)
      throw RecordingError(fmt::format(
          "{}: found rows at {} s, must be at times {} s apart from the first: the format has "
          "frames; csv and mcap have times",
          reader.place(), *result.left_out, frames.step));
    if (!frame) {
      result.left_out = moment.time;
      continue;
    }
    facing.turn(moment);
    try {
      target->add({moment, *frame, frames.step > 0.0 ? frames.fps() : 0.0, facing.now});
    } catch (const RecordingError& error) {
      throw RecordingError(reader.place() + ": " + error.what());
    }
    ++result.times;
    result.rows += static_cast<std::int64_t>(moment.rows.size());
    if (options.converted) options.converted(moment.time);
  }
  if (has_frames(options.format)) {
    result.fps = frames.fps();
    const bool has_area =
        options.format == ExportFormat::sqlite || options.format == ExportFormat::pedestrian_hdf5;
    result.without_walls = scene == nullptr && has_area;
  }
  target->finish(result.fps.value_or(0.0));
  file.commit();
  return result;
}

}  // namespace avo_io
