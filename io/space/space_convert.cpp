// SPDX-License-Identifier: Apache-2.0
// Recordings of space from one format to another.
#include <fmt/format.h>
#include <optional>

#include "avo/error.h"
#include "avo_io/errors.h"
#include "avo_io/space.h"
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
    if (result.times == 0)
      lines =
          std::string(kSpaceCsvHeader) + std::string(moment->every > 1 ? kEveryColumn : "") + "\n";
    append_csv_lines(*moment, lines);
    file.write(lines);
    count(*moment, result);
  }
  file.commit();
  return result;
}

// Refuses rows that are not of the scene.
void check_moment(const SpaceRows& rows, const SpaceMoment& moment,
                  const avo::space::Scenario& scene) {
  if (moment.time > scene.duration * (1.0 + kOfStep))
    rows.fail(fmt::format("found {} s, must be <= {} s, the duration of the scene", moment.time,
                          scene.duration));
  std::int64_t last = -1;
  for (const avo::space::CheckedState& row : moment.rows) {
    if (row.robot <= last || row.robot >= static_cast<std::int64_t>(scene.robots.size()))
      rows.fail(fmt::format("found robot {}, must ascend and be less than {}, those of the scene",
                            row.robot, scene.robots.size()));
    last = row.robot;
  }
}

Converted write_recording(SpaceRows& rows, const std::string& output,
                          const RecordedSpaceScene& scene) {
  std::optional<SpaceHdf5Recording> recording;
  Converted result;
  double last = -1.0;  // s
  while (const SpaceMoment* moment = rows.next()) {
    check_moment(rows, *moment, scene.scenario);
    if (!(moment->time > last))
      rows.fail(fmt::format("found the time {} s, must be more than that before", moment->time));
    last = moment->time;
    if (!recording)
      recording.emplace(output, scene.scenario, scene.header.scene,
                        RecordingOptions{.every = moment->every});
    recording->add(*moment);
    count(*moment, result);
  }
  if (!recording) rows.fail("found no rows, must be of two times or more");
  recording->finish();
  recording->file().commit();
  return result;
}

}  // namespace

Converted convert_in_space(const std::string& input, const std::string& output,
                           const SpaceConvertOptions& options) {
  SpaceRows rows(input);
  if (options.format == ExportFormat::csv) return write_csv(rows, output);
  if (options.format != ExportFormat::recording)
    throw avo::Error("format: found one of the plane, must be csv or recording in space");
  if (options.scene) return write_recording(rows, output, *options.scene);
  const std::optional<RecordedSpaceScene> own = read_recorded_space_scene(input);
  if (!own) throw avo::Error("the scene: found none, must be given with a recording as CSV");
  return write_recording(rows, output, *own);
}

}  // namespace avo_io
