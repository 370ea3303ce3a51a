// SPDX-License-Identifier: Apache-2.0
// avo replay and avo recover: recordings that explain themselves.
#include <fmt/format.h>
#include <string>
#include <string_view>

#include "arguments/files.h"
#include "arguments/own_methods.h"
#include "avo_io/recording.h"
#include "avo_io/replay.h"
#include "exit_codes.h"
#include "system/signals.h"
#include "system/terminal.h"
#include "verbs/space_verbs.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

/// Returns "run.h5" for "run.h5.part".
std::string recovered_path(const RecoverArguments& arguments) {
  constexpr std::string_view kPart = ".part";
  if (!arguments.output.empty()) return arguments.output;
  if (!arguments.spool.ends_with(kPart))
    throw UsageError(fmt::format("{}: found another ending than .part, must be it, or --output",
                                 arguments.spool));
  return arguments.spool.substr(0, arguments.spool.size() - kPart.size());
}

}  // namespace

namespace {

int tell(const ReplayArguments& arguments, const avo_io::Replay& result) {
  if (arguments.json)
    print(avo_io::to_json(result));
  else
    print_results(avo_io::readable(result));
  return result.difference ? kUnsafe : kDone;
}

}  // namespace

int replay(const ReplayArguments& arguments) {
  if (const auto in_space = replay_in_space(arguments)) return tell(arguments, *in_space);
  const auto recorded = avo_io::read_recorded_scene(arguments.recording);
  if (!recorded)
    throw avo_io::RecordingError(arguments.recording +
                                 ": found no scene in it, must be a recording as HDF5");
  const avo::ExternalMethod method = method_behind(arguments.own_method, recorded->scenario);
  Progress progress(recorded->scenario.duration, true);
  const avo_io::Replay result = avo_io::replay(
      arguments.recording, arguments.threads,
      [&progress](const avo::Simulation& simulation) { progress.show(simulation.time()); }, method);
  return tell(arguments, result);
}

int recover(const RecoverArguments& arguments) {
  catch_signals(Patience::none);
  const std::string path = recovered_path(arguments);
  require_distinct({{"the spool", arguments.spool}}, {{"the recording", path}});
  const avo_io::Recovered found = avo_io::recover(arguments.spool, path);
  std::string text = fmt::format("{}: {} times, until {} s", path, found.times, found.last_time);
  text += found.complete ? "; nothing is lost"
                         : "; lost is what the run has recorded after that, 127 times at most";
  if (found.lost_bytes > 0)
    text += fmt::format(", with {} bytes that are no whole block", found.lost_bytes);
  print_results(text + "\n");
  return found.complete ? kDone : kIncomplete;
}

}  // namespace avo_cli
