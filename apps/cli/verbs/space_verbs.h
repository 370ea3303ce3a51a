// SPDX-License-Identifier: Apache-2.0
// Verbs for scenes with `space: 3`.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "avo_io/convert.h"
#include "avo_io/judgement.h"
#include "avo_io/replay.h"
#include "avo_io/space.h"
#include "avo_io/space_frames.h"
#include "figures/space_views.h"
#include "verbs/verbs.h"

namespace avo_cli {

/// Returns the scene if it is one of space; `source`, where it is given, is set to its inputs.
/// Throws UsageError where an output is the scene's file.
std::optional<avo::space::Scenario> load_in_space(const SceneArguments& arguments,
                                                  const std::vector<NamedFile>& outputs,
                                                  avo_io::SceneSource* source = nullptr);

int run_in_space(const RunArguments& arguments, const avo::space::Scenario& scenario,
                 const avo_io::SceneSource& source);
int explain_in_space(const ExplainArguments& arguments, const avo::space::Scenario& scenario);
/// Judges a recording of space; none where neither --scene nor the recording has a scene of space.
std::optional<avo_io::Judgement> judge_in_space(const CheckArguments& arguments);
/// Returns none if the recording is not one of space.
std::optional<avo_io::Replay> replay_in_space(const ReplayArguments& arguments);
/// Writes the rows of a recording of space in another format; none if it is not one of space.
std::optional<avo_io::Converted> convert_in_space(const ConvertArguments& arguments,
                                                  avo_io::ExportFormat format);

/// A recording of space, with all that a report and a video show of it.
struct SpaceRecordingShown {
  avo_io::RecordingHeader header;
  avo::space::Scenario scenario;
  avo_io::SpaceRun run;
  std::vector<avo::figures::SpaceRecorder::Frame> frames;  ///< those of the run
};
/// Reads it with the scene of --scene, or else its own; none if it is not one of space.
std::optional<SpaceRecordingShown> space_run_of(const std::string& recording,
                                                const SceneArguments& scene,
                                                std::size_t most_frames = 512);
/// Returns the page of a recording as HDF5; none if it is not one of space.
std::optional<std::string> report_in_space(const ReportArguments& arguments);

/// Returns a line for each robot that boxes keep from its goal, with the place where its route
/// ends.
std::vector<std::string> told_out_of_reach(const avo::space::Scenario& scenario);

/// Writes the set points of a recording's quadrotors.
int convert_to_set_points(const ConvertArguments& arguments);

}  // namespace avo_cli
