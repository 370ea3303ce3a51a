// SPDX-License-Identifier: Apache-2.0
// Scenes of space as YAML (`space: 3`), and their recordings.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo/export.h"
#include "avo/space/check.h"
#include "avo/space/scenario.h"
#include "avo/space/simulation.h"
#include "avo_io/convert.h"
#include "avo_io/judgement.h"
#include "avo_io/output_file.h"
#include "avo_io/recording.h"
#include "avo_io/replay.h"
#include "avo_io/scene.h"

namespace avo_io {

/// Returns the scene called `name_or_path` (see load_scenario()), if it has `space: 3`; none if it
/// is a scene of the plane. `source`, where it is given, is set to the inputs of the scene. Throws
/// SceneError, OverrideError or FileError; the returned scene has passed avo::space::validate.
AVO_API std::optional<avo::space::Scenario> load_space_scenario(
    const std::string& name_or_path, const std::vector<std::string>& overrides = {},
    SceneSource* source = nullptr);

/// Makes a scenario from text with `space: 3`. Error messages begin with `file`.
AVO_API avo::space::Scenario parse_space_scenario(std::string_view yaml, const std::string& file,
                                                  const std::vector<std::string>& overrides = {});

/// Makes the same scenario again; reads no file.
AVO_API avo::space::Scenario parse_space_scenario(const SceneSource& source);

/// Does the same for a source with `space: 3`; returns none if it is a scene of the plane.
AVO_API std::optional<avo::space::Scenario> space_scenario_in(const SceneSource& source);

/// A file for the states of a run in space.
class AVO_API SpaceRecording {
 public:
  virtual ~SpaceRecording() = default;
  /// Adds the present state: a row of each robot. Throws FileError.
  virtual void add(const avo::space::Simulation& simulation) = 0;
  /// Call it once after the last add(), before the file is committed.
  virtual void finish(const avo::space::Simulation& simulation) = 0;
  OutputFile& file() { return file_; }

 protected:
  explicit SpaceRecording(const std::string& path) : file_(path) {}
  OutputFile file_;
};

/// Opens HDF5 where is_hdf5_path() (docs/recordings.md), else CSV with header
/// "time,robot,x,y,z,vx,vy,vz" and, where options.every > 1, a last column "every". CSV has the
/// shortest digits that read back to the same bits, rows by time then robot. Throws FileError.
AVO_API std::unique_ptr<SpaceRecording> open_space_recording(const std::string& path,
                                                             const avo::space::Scenario& scenario,
                                                             const SceneSource& source,
                                                             const RecordingOptions& options = {});

/// A recording's own scene of space, and its description.
struct RecordedSpaceScene {
  RecordingHeader header;  ///< `scene` with the overrides
  avo::space::Scenario scenario;
};
/// Reads the scene of an HDF5 recording or a spool of space, with the overrides applied; none for
/// any other file. Throws as read_recorded_scene().
AVO_API std::optional<RecordedSpaceScene> read_recorded_space_scene(
    const std::string& path, const std::vector<std::string>& overrides = {});

/// Judges a recording of space by the limits of the scene. movers_at_rest: see avo::CheckOptions.
/// Throws RecordingError, FileError.
AVO_API Judgement judge_in_space(const std::string& recording, const avo::space::Scenario& scene,
                                 double tolerance, bool require_arrival,
                                 bool movers_at_rest = false);

/// Simulates a recording of space again, and compares it bit by bit, see replay().
AVO_API Replay
replay_in_space(const std::string& recording, int threads = 0,
                const std::function<void(const avo::space::Simulation&)>& observe = {});

/// Options of convert_in_space().
struct SpaceConvertOptions {
  ExportFormat format = ExportFormat::csv;  ///< csv, recording, mcap or gltf
  /// The scene of the recording, and the inputs of the scene; unset: the scene that the recording
  /// contains, if any.
  std::optional<RecordedSpaceScene> scene = {};
};

/// Writes the rows of a recording of space in another format; `output` is whole or not there.
/// Throws RecordingError, FileError, and Error where a format other than CSV lacks a scene.
AVO_API Converted convert_in_space(const std::string& input, const std::string& output,
                                   const SpaceConvertOptions& options);

/// Returns whether it is a regular file with a recording of space: HDF5, a spool, or CSV with such
/// columns.
AVO_API bool is_space_recording(const std::string& path);

/// Whose frame, units and columns a file of set points has (docs/exports.md, "Set points").
enum class Autopilot : std::uint8_t {
  any,        ///< the frame of the scene
  px4,        ///< see avo::space::Px4SetPoint
  crazyflie,  ///< see avo::space::CrazyflieSetPoint
};
/// Writes the set points of a recording's quadrotors as CSV, `rate` (Hz) times a second. Rows are
/// in order of time, then robot. `output` is whole or not there. All robots of the scene must be
/// quadrotors. Returns the number of rows. Throws Error, RecordingError, FileError.
AVO_API std::int64_t write_set_points(const std::string& recording, const std::string& output,
                                      const avo::space::Scenario& scene, double rate,
                                      Autopilot autopilot = Autopilot::any);

}  // namespace avo_io
