// SPDX-License-Identifier: Apache-2.0
// Recordings for other programs: the output of `avo convert`.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "avo/export.h"
#include "avo/scenario.h"
#include "avo_io/scene.h"

namespace avo_io {

/// The formats, see docs/exports.md.
enum class ExportFormat {
  csv,              ///< as CsvRecording writes it
  sqlite,           ///< of JuPedSim, version 2
  pedestrian_hdf5,  ///< of the Pedestrian Dynamics Data Archive
  mcap,             ///< with the schemas of Foxglove
  pedestrian_text,  ///< of the archive, as PedPy reads it
  obsmat,           ///< of ETH and UCY
  recording,        ///< as `avo run --record FILE.h5` writes it, with the scene
  gltf,             ///< glTF 2.0 in one file, of a recording of space
};
/// The names of the formats on the command line.
inline constexpr std::array<std::pair<std::string_view, ExportFormat>, 8> kExportFormats{
    {{"csv", ExportFormat::csv},
     {"sqlite", ExportFormat::sqlite},
     {"pedestrian-hdf5", ExportFormat::pedestrian_hdf5},
     {"mcap", ExportFormat::mcap},
     {"pedestrian-text", ExportFormat::pedestrian_text},
     {"obsmat", ExportFormat::obsmat},
     {"recording", ExportFormat::recording},
     {"gltf", ExportFormat::gltf}}};

/// Options of convert().
struct ConvertOptions {
  ExportFormat format = ExportFormat::csv;
  /// The scene of the recording; unset: the scene that the recording contains, if any. A scene
  /// without robots gives the walls.
  std::optional<avo::Scenario> scenario = {};
  SceneSource source = {};  ///< of that scene; for the format `recording`
  /// For the format `recording`, see MotionScene. Empty: the robots have their numbers in the scene
  std::vector<std::int64_t> robots = {};
  double first_time = 0.0;  ///< s, of the motion: 0 s in the scene
  /// Called with each time of the recording, s, once it is converted.
  std::function<void(double time)> converted = {};
};

/// A robot with a first row elsewhere than its start in the scene.
struct OtherStart {
  std::int64_t robot = 0;
  std::optional<avo::Vec2> found = {};  ///< m; unset: it has no row at the first time
  avo::Vec2 start = {};                 ///< m, in the scene
};

/// The result of convert().
struct Converted {
  std::int64_t times = 0, rows = 0;
  /// Frames in a second; for formats that have frames.
  std::optional<double> fps = {};
  /// s: the last time, if it is no frame and has been left out.
  std::optional<double> left_out = {};
  /// The walkable area has no walls, because there is no scene.
  bool without_walls = false;
  /// Robots that the scene has start more than kSameStart away from their first rows, for the
  /// format `recording`.
  std::vector<OtherStart> other_starts = {};
};
inline constexpr double kSameStart = 1e-3;  ///< m, for the digits of recordings

/// A scene made of a motion.
struct MotionScene {
  SceneSource source;                     ///< parse_scenario() makes the scene of it
  std::vector<std::int64_t> robots = {};  ///< of each robot of the scene, its number in the motion
  double first_time = 0.0;                ///< s, of the motion: 0 s in the scene
};
/// Makes a scene of the motion in a file. Each robot starts where and when the motion has it first.
/// Its goal is its last place. Its limits are the largest speed and acceleration that it has, and
/// its radius, m, is given. Surroundings: a scene without robots, or an empty source. Throws
/// FileError, RecordingError and SceneError.
AVO_API MotionScene scene_of_motion(const std::string& input, const SceneSource& surroundings,
                                    double radius);

/// Writes the recording at `input` (CSV, HDF5, a spool, trajectories of others; "-" is the standard
/// input, of CSV) to `output`, whole or not at all. It never holds more than one time, of HDF5 64.
/// Throws FileError, RecordingError, and Error where the format needs a scene and there is none.
AVO_API Converted convert(const std::string& input, const std::string& output,
                          const ConvertOptions& options);

}  // namespace avo_io
