// SPDX-License-Identifier: Apache-2.0
// Scenes of space as YAML (`space: 3`), and their recordings as CSV.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo/export.h"
#include "avo/space/check.h"
#include "avo/space/scenario.h"
#include "avo/space/simulation.h"
#include "avo_io/judgement.h"
#include "avo_io/output_file.h"
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

/// CSV with header "time,robot,x,y,z,vx,vy,vz", the shortest digits that read back to the same
/// bits, rows by time then robot.
class AVO_API SpaceCsvRecording {
 public:
  explicit SpaceCsvRecording(const std::string& path);
  /// Adds the present state: a row of each robot. Throws FileError.
  void add(const avo::space::Simulation& simulation);
  OutputFile& file() { return file_; }

 private:
  OutputFile file_;
  std::string rows_;
};

/// Judges a CSV recording of space by the limits of the scene. movers_at_rest: see
/// avo::CheckOptions. Throws RecordingError, FileError.
AVO_API Judgement judge_in_space(const std::string& recording, const avo::space::Scenario& scene,
                                 double tolerance, bool require_arrival,
                                 bool movers_at_rest = false);

/// Returns whether the first line of the file has the columns of space.
AVO_API bool is_space_csv(const std::string& path);

/// Writes the set points of a recording's quadrotors as CSV with header
/// "time,robot,x,y,z,vx,vy,vz,ax,ay,az", `rate` (Hz) times a second, rows by time then robot;
/// `output` is whole or not there. All robots of the scene must be quadrotors. Returns the number
/// of rows. Throws Error, RecordingError, FileError.
AVO_API std::int64_t write_set_points(const std::string& recording, const std::string& output,
                                      const avo::space::Scenario& scene, double rate);

}  // namespace avo_io
