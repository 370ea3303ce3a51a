// SPDX-License-Identifier: Apache-2.0
// avo lab: a page that simulates, with a scene or a recording embedded.
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "arguments/files.h"
#include "avo_io/output_file.h"
#include "avo_io/recording.h"
#include "avo_io/scene.h"
#include "avo_io/space.h"
#include "avo_io/space_frames.h"
#include "exit_codes.h"
#include "lab_page/lab_page.h"
#include "system/open_page.h"
#include "system/signals.h"
#include "system/terminal.h"
#include "verbs/space_verbs.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

namespace fs = std::filesystem;

// A page with 128 MiB in it opens in Chromium after half a minute on two busy cores. A page of 256
// MiB has shown nothing after two minutes.
constexpr std::uintmax_t kMostBytes = 100'000'000;

void require_lab() {
  if (lab_page().empty())
    throw UsageError(
        "lab: found no page in this avo, must be built with it: run ./scripts/install --lab in "
        "the sources (docs/packages.md)");
}

bool is_csv(const std::string& path) {
  return fs::path(path).extension() == ".csv";
}

/// Returns whether the input is a recording: by --scene, which is for recordings alone, by its
/// name, or by its first bytes.
bool is_recording(const LabArguments& arguments) {
  if (!arguments.scene.scene.empty()) return true;
  const std::string& input = arguments.input;
  if (input.empty() || input == "-" || avo_io::is_builtin_scene(input)) return false;
  if (is_csv(input) || avo_io::is_hdf5_path(input)) return true;
  std::error_code error;
  return fs::is_regular_file(input, error) && avo_io::read_recording_header(input).has_value();
}

/// Returns the default output: NAME.html, in the current folder.
std::string usual_output(const std::string& input) {
  if (input.empty() || input == "-") return "lab.html";
  fs::path name = fs::path(input).filename();
  const auto drop = [&name](std::string_view ending) {
    if (name.extension() == ending) name = name.stem();
  };
  drop(".part");
  for (const char* ending : {".yaml", ".yml", ".h5", ".H5", ".csv"}) drop(ending);
  return name.string() + ".html";
}

std::string output_of(const LabArguments& arguments) {
  if (!arguments.output.empty()) {
    require_ending({"--out", arguments.output}, {".html"});
    return arguments.output;
  }
  std::string output = usual_output(arguments.input);
  std::error_code error;
  if (fs::exists(output, error) && !is_lab_page(output))
    throw UsageError(fmt::format(
        "{0}: found another file of this name, must be a page of avo lab; --out {0} writes over it",
        output));
  return output;
}

/// Returns the source of the scene. The page also shows a scene that breaks the assumptions of its
/// certificate, so such a scene is not refused.
avo_io::SceneSource source_of(const SceneArguments& arguments, const std::string& output) {
  avo_io::SceneSource source;
  if (load_in_space(arguments, {{"the page", output}}, &source)) return source;
  try {
    load(arguments, {{"the page", output}}, &source);
  } catch (const BrokenScene& broken) {
    warn(broken.lines);
  }
  return source;
}

void require_fit(const std::string& recording, std::uintmax_t bytes) {
  if (bytes > kMostBytes)
    throw avo_io::RecordingError(
        fmt::format("{}: found {:.0f} MB, must be {} MB at most for a page; avo run --every K "
                    "records every K-th step only",
                    recording, static_cast<double>(bytes) / 1e6, kMostBytes / 1'000'000));
}

/// Reads every row once, so that damaged rows do not get into a page.
void require_whole(const std::string& path, const avo_io::SceneSource& scene) {
  if (const auto of_space = avo_io::space_scenario_in(scene)) {
    (void)avo_io::read_space_run(path, *of_space, 1);
    return;
  }
  const std::size_t robots = avo_io::parse_scenario(scene).robots.size();
  avo_io::RecordingReader reader(path, static_cast<std::int64_t>(robots));
  avo_io::RecordedTime moment;
  while (reader.next(moment)) {
  }
}

/// Returns a recording as CSV.
std::string csv_text(const std::string& path, const avo_io::SceneSource& scene) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_regular_file(path, error))
    throw avo_io::RecordingError(path + ": found no regular file, must be one");
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error) require_fit(path, size);
  require_whole(path, scene);
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  require_fit(path, text.size());
  return text;
}

std::string recorded(const LabArguments& arguments, const std::string& output) {
  const std::string& path = arguments.input;
  const std::string name = fs::path(path).filename().string();
  if (path.empty()) throw UsageError("--scene: found without a recording, must be with one as CSV");
  if (path == "-")
    throw UsageError("the recording: found -, must be a file; a scene may be the standard input");
  require_distinct({{"the recording", path}, file_of(arguments.scene)}, {{"the page", output}});
  if (avo_io::is_builtin_scene(path))
    throw UsageError(path + ": found a built-in scene with --scene, must be a recording as CSV");
  const bool has_scene = avo_io::read_recording_header(path).has_value();
  const std::string& scene = arguments.scene.scene;
  if (!has_scene && scene.empty())
    throw UsageError(path + ": found no scene in it, must be a recording as HDF5, or --scene");
  if (!has_scene) {
    const avo_io::SceneSource source = source_of(arguments.scene, output);
    return recording_input(name, csv_text(path, source), &source);
  }
  const bool changes = !arguments.scene.overrides.empty() || arguments.scene.start_at_rest ||
                       arguments.scene.limit_speed;
  if (!scene.empty() || changes)
    throw UsageError(fmt::format(
        "{}: found with a recording that has its scene in itself, must be with a scene{}",
        scene.empty() ? "--set and the like" : "--scene", scene.empty() ? "" : "less one, as CSV"));
  require_fit(path, fs::file_size(path));
  // throws if the scene cannot be used
  if (!avo_io::read_recorded_space_scene(path)) (void)avo_io::read_recorded_scene(path);
  const std::string bytes = avo_io::recording_bytes(path);
  require_fit(path, bytes.size());
  return recording_input(name, bytes, nullptr);
}

std::string input_of(const LabArguments& arguments, const std::string& output) {
  if (is_recording(arguments)) return recorded(arguments, output);
  SceneArguments scene = arguments.scene;
  scene.scene = arguments.input;
  if (!scene.scene.empty()) return scene_input(source_of(scene, output));
  if (!scene.overrides.empty() || scene.start_at_rest || scene.limit_speed)
    throw UsageError("--set and the like: found without a scene, must be with one");
  return "null";
}

}  // namespace

int lab(const LabArguments& arguments) {
  require_lab();
  catch_signals(Patience::none);
  const std::string output = output_of(arguments);
  const std::string page = lab_page_with(input_of(arguments, output));
  avo_io::OutputFile file(output);
  file.write(page);
  file.commit();
  if (output == "-") return kDone;
  print_results(output + "\n");
  if (arguments.opens) open_page(output);
  return kDone;
}

}  // namespace avo_cli
