// SPDX-License-Identifier: Apache-2.0
// Parts that the pages of recordings share, in the plane and in space.
#pragma once
#include <optional>
#include <string>

#include "avo/metrics.h"
#include "avo_io/judgement.h"
#include "avo_io/recorded_run.h"
#include "avo_io/recording.h"
#include "verbs/verbs.h"

namespace avo_cli {

/// Returns "safe", "unsafe" or "incomplete", as HTML.
std::string verdict_of(const avo_io::Judgement& judgement);
/// Returns the results, as HTML. For a measuring line, it gives the number of crossings instead of
/// their times.
std::string results_of(const avo::RunSummary& summary);
/// Returns charts over time: the least clearance, the arrived robots, the highest speed.
std::string charts_of(const avo_io::RecordedRun& run);
/// Returns the text of the scene, with the names of its files.
std::string scene_text_of(const avo_io::SceneSource& scene);
/// Returns the origin of the recording, as HTML.
std::string provenance_of(const avo_io::RecordingHeader& header, const std::string& recording);
/// Returns the command that makes the recording again. ended: s, if something else than the scene
/// or the arrivals has ended the run.
std::string command_of(const avo_io::RecordingHeader& header, const ReportArguments& arguments,
                       std::optional<double> ended);

}  // namespace avo_cli
