// SPDX-License-Identifier: Apache-2.0
// The verbs of the command line, one file each. All return exit codes, and throw as exit_codes.h
// and avo_io/errors.h say.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "arguments/figure_words.h"
#include "avo/scenario.h"
#include "avo_io/scene.h"

namespace avo_cli {

/// A scene, and the changes that the command line makes to it.
struct SceneArguments {
  std::string scene;                   ///< "-": standard input
  std::vector<std::string> overrides;  ///< key=value
  /// for overrides that came from another option: that option
  std::map<std::string, std::string> typed_as;
  bool start_at_rest = false;
  bool limit_speed = false;
  std::vector<std::string> own_method;  ///< see own_methods.h; one, or none
};
/// A file that the command line names.
struct NamedFile {
  std::string role;  ///< "--record", "the scene"
  std::string path;  ///< "-": the standard output, or for an input the standard input; empty: none
};

/// Loads the scene with its overrides; `source` receives the texts that it is made of. A message
/// about an override names the option that was typed.
avo::Scenario with_overrides(const SceneArguments& arguments, avo_io::SceneSource& source,
                             bool may_lack_robots = false);

/// Loads the scene, changes it as asked, and warns of settings that do not fit. Throws UsageError
/// if its file is one of the outputs, or if two outputs are one file (files.h). Throws BrokenScene
/// if it breaks the assumptions of its certificate. `source`, if given, receives the texts that it
/// was made of.
avo::Scenario load(const SceneArguments& arguments, const std::vector<NamedFile>& outputs = {},
                   avo_io::SceneSource* source = nullptr);

struct RunArguments {
  SceneArguments scene;
  std::string record, summary, figure;  ///< empty: none
  std::optional<std::int64_t> every;    ///< steps between the rows of the recording; unset: 1
  bool until_arrived = false;  ///< ends with the first step after which all robots have arrived
  int threads = 0;
  // of the figure; unset: the usual size, the whole run, all robots
  std::optional<FigureSize> figure_size;
  std::optional<TimeWindow> figure_time;
  std::vector<std::size_t> figure_robots;
};
int run(const RunArguments& arguments);

struct ExplainArguments {
  SceneArguments scene;
  std::int64_t robot = 0;
  double time = 0.0;
  bool json = false;
  std::string figure, states;
};
int explain(const ExplainArguments& arguments);

struct CheckArguments {
  std::string recording;  ///< "-": standard input
  SceneArguments scene;   ///< empty: the three members below, or the recording's own values
  std::optional<double> radius, max_acceleration, max_speed, max_braking;
  double tolerance = 1e-9;
  std::string movers_at_rest = "collision";  ///< or "ok"
  bool json = false;
  bool require_arrival = false;
};
int check(const CheckArguments& arguments);

struct ReplayArguments {
  std::string recording;
  std::vector<std::string> own_method;  ///< of the recorded scene; none: it has none
  bool json = false;
  int threads = 0;
};
int replay(const ReplayArguments& arguments);

struct RecoverArguments {
  std::string spool;
  std::string output;  ///< empty: the spool's name without ".part"
};
int recover(const RecoverArguments& arguments);

inline constexpr const char* kSetPoints = "set-points";
inline constexpr double kRadiusOfPeople = 0.3;  ///< m
struct ConvertArguments {
  std::string recording;  ///< "-": standard input
  std::string output;     ///< "-": standard output
  SceneArguments scene;   ///< empty: the scene that the recording contains, if it contains one
  /// a word of avo_io::kExportFormats, or kSetPoints; empty: by the output's ending
  std::string to;
  std::string name;              ///< of the method of a recording; empty: the recording's stem
  std::optional<double> radius;  ///< m, of robots that only the motion has; unset: kRadiusOfPeople
  std::optional<double> rate;    ///< Hz, of set points; unset: 50
  std::string autopilot;         ///< of set points: px4, crazyflie; empty: any
};
int convert(const ConvertArguments& arguments);

struct VideoArguments {
  std::string recording, output;
  SceneArguments scene;  ///< empty: that of the recording
  double fps = 30.0;     ///< frames a second
  double speed = 1.0;    ///< seconds of the simulation in a second of the video
  int size = 1080;       ///< pixels, of the longer side
};
int video(const VideoArguments& arguments);

struct ReportArguments {
  std::string input;  ///< a recording, or the table of a sweep
  std::string output;
  std::string spec;  ///< for a sweep; empty: none
  /// for a sweep: the run to show in motion; unset: the first one
  std::optional<std::int64_t> run;
  std::vector<std::string> own_methods;  ///< of the recording or the sweep
  std::string line;  ///< "X,Y,X,Y", for a recording: the line of the measured flow; empty: none
};
int report(const ReportArguments& arguments);

struct LabArguments {
  std::string input;  ///< a scene, or a recording; "-": standard input; empty: none
  /// The changes of the command line to the input scene, or to the scene that --scene gives for a
  /// recording as CSV. `scene.scene` is the latter; empty: none.
  SceneArguments scene;
  std::string output;  ///< empty: derived from the input
  bool opens = true;   ///< in a browser
};
int lab(const LabArguments& arguments);

struct BenchArguments {
  SceneArguments scene;
  int threads = 0;
  std::optional<std::int64_t> steps;  ///< unset: as docs/performance.md says
  bool json = false;
};
int bench(const BenchArguments& arguments);

struct SweepArguments {
  std::string spec;
  std::vector<std::string> own_methods;  ///< see own_methods.h
  std::string output;                    ///< table of the runs
  std::string summary;                   ///< empty: none
  std::string shard = "1/1";
  std::vector<std::string> tables;  ///< tables to join; empty: the sweep is run
  int jobs = 0;
};
int sweep(const SweepArguments& arguments);

struct CompareArguments {
  std::vector<std::string> files;                   ///< tables of sweeps, recordings
  std::string by;                                   ///< empty: the key that varies
  std::vector<std::string> columns;                 ///< empty: the usual ones
  std::string arrival, clearance, traces, scaling;  ///< figures; empty: none
};
int compare(const CompareArguments& arguments);

int list_scenes(const std::string& name, bool json);
int validate_scene(const SceneArguments& arguments);
int print_schema();

}  // namespace avo_cli
