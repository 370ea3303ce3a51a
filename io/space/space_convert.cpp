// SPDX-License-Identifier: Apache-2.0
// Recordings of space from one format to another.
#include <fmt/format.h>
#include <memory>
#include <optional>

#include "avo/error.h"
#include "avo_io/errors.h"
#include "avo_io/space.h"
#include "io/space/space_export.h"
#include "io/space/space_recording.h"
#include "io/space/space_rows.h"

namespace avo_io {
namespace {

void count(const SpaceMoment& moment, Converted& result) {
  ++result.times;
  result.rows += static_cast<std::int64_t>(moment.rows.size());
}

Converted write_csv(SpaceRows& rows, const std::string& output) {
  OutputFile file(output);
  Converted result;
  std::string lines;
  while (const SpaceMoment* moment = rows.next()) {
    lines.clear();
    if (result.times == 0) lines = space_csv_header(moment->every);
    append_csv_lines(*moment, lines);
    file.write(lines);
    count(*moment, result);
  }
  file.commit();
  return result;
}

/// Refuses rows that are not of the scene.
struct MomentChecks {
  const avo::space::Scenario& scene;
  double last = -1.0;  // s

  void check(const SpaceRows& rows, const SpaceMoment& moment) {
    if (!(moment.time > last))
      rows.fail(fmt::format("found the time {} s, must be more than that before", moment.time));
    last = moment.time;
    if (moment.time > scene.duration * (1.0 + kOfStep))
      rows.fail(fmt::format("found {} s, must be <= {} s, the duration of the scene", moment.time,
                            scene.duration));
    rows.require_known(moment, scene.robots.size());
  }
};

Converted write_recording(SpaceRows& rows, const std::string& output,
                          const RecordedSpaceScene& scene) {
  std::optional<SpaceHdf5Recording> recording;
  Converted result;
  MomentChecks checks{scene.scenario};
  while (const SpaceMoment* moment = rows.next()) {
    checks.check(rows, *moment);
    if (!recording)
      recording.emplace(output, scene.scenario, scene.header.scene,
                        RecordingOptions{.every = moment->every}, true);
    recording->add(*moment);
    count(*moment, result);
  }
  if (!recording) rows.fail("found no rows, must be of two times or more");
  recording->finish();
  recording->file().commit();
  return result;
}

Converted write_export(SpaceRows& rows, const std::string& output, ExportFormat format,
                       const avo::space::Scenario& scene) {
  OutputFile file(output);
  const std::unique_ptr<SpaceExport> target =
      format == ExportFormat::mcap ? export_mcap(file, scene) : export_gltf(file, scene);
  MomentChecks checks{scene};
  Converted result;
  while (const SpaceMoment* moment = rows.next()) {
    checks.check(rows, *moment);
    try {
      target->add(*moment);
    } catch (const RecordingError& error) {
      rows.fail(error.what());
    }
    count(*moment, result);
  }
  if (result.times == 0) rows.fail("found no rows, must be of one time or more");
  target->finish();
  file.commit();
  return result;
}

}  // namespace

Converted convert_in_space(const std::string& input, const std::string& output,
                           const SpaceConvertOptions& options) {
  SpaceRows rows(input);
  if (options.format == ExportFormat::csv) return write_csv(rows, output);
  const bool is_recording = options.format == ExportFormat::recording;
  if (!is_recording && options.format != ExportFormat::mcap && options.format != ExportFormat::gltf)
    throw avo::Error(
        "format: found one of the plane, must be csv, mcap, gltf or recording in space");
  const std::optional<RecordedSpaceScene> scene =
      options.scene ? options.scene : read_recorded_space_scene(input);
  if (!scene) throw avo::Error("the scene: found none, must be given with a recording as CSV");
  if (is_recording) return write_recording(rows, output, *scene);
  return write_export(rows, output, options.format, scene->scenario);
}

}  // namespace avo_io
