// SPDX-License-Identifier: Apache-2.0
// The verbs and options of the command line, as a tree.
#include "arguments/options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <system_error>

#include "arguments/figure_words.h"
#include "arguments/option_parts.h"
#include "arguments/own_methods.h"
#include "arguments/words.h"
#include "avo/version.h"
#include "avo_io/printable.h"
#include "completion/generate.h"
#include "exit_codes.h"
#include "system/terminal.h"
#include "verbs/verbs.h"

namespace avo_cli {

namespace {

void add_scene(CLI::App& verb, SceneArguments& arguments) {
  not_empty(verb.add_option("SCENE", arguments.scene, kScene))->required();
  add_overrides(verb, arguments);
  add_own_methods(verb, arguments.own_method, false);
  add_remedies(verb, arguments);
}

void add_threads(CLI::App& verb, int& threads) {
  verb.add_option("--threads", threads, "0: as many as the machine has")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
}

/// Reads a whole number of steps. Throws UsageError.
std::int64_t whole_steps(const std::string& word) {
  constexpr std::int64_t kMost = 100'000'000;  // the limit of a run
  std::int64_t steps = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), steps);
  if (error == std::errc() && end == word.data() + word.size() && steps >= 1 && steps <= kMost)
    return steps;
  throw UsageError(fmt::format("--every: found {}, must be a whole number from 1 to {}",
                               avo_io::printable(word, kLongestWord), kMost));
}

void add_run(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand("run", "simulate a scene to its end");
  static RunArguments arguments;
  add_scene(*verb, arguments.scene);
  not_empty(
      verb->add_option("--record", arguments.record, "every state of every robot; - is stdout"))
      ->type_name("FILE.csv|.h5");
  verb->add_option_function<std::string>(
          "--every", [](const std::string& steps) { arguments.every = whole_steps(steps); },
          "the recording has the rows of every so many steps only, and of the last")
      ->type_name("STEPS");
  CLI::Option* summary =
      not_empty(verb->add_option("--summary", arguments.summary, "results; - is stdout"))
          ->type_name("FILE.json");
  verb->add_flag_callback(
          "--json", [] { arguments.summary = "-"; }, "the same as --summary -")
      ->excludes(summary);
  CLI::Option* figure =
      not_empty(verb->add_option("--figure", arguments.figure, "time-lapse of the trajectories"))
          ->type_name("FILE.svg|.png|.pdf");
  const auto of_figure = [&](const char* name, const char* type, const char* text, auto set) {
    verb->add_option_function<std::string>(name, set, text)->type_name(type)->needs(figure);
  };
  of_figure("--figure-size", "WIDTH[xHEIGHT]", "of the figure, pt; a PNG has two pixels a point",
            [](const std::string& word) { arguments.figure_size = figure_size(word); });
  of_figure("--figure-time", "FROM:TO", "the figure shows this part of the run, s",
            [](const std::string& word) { arguments.figure_time = figure_time(word); });
  of_figure("--figure-robots", "I,J-K", "the figure shows these robots alone",
            [](const std::string& word) { arguments.figure_robots = figure_robots(word); });
  add_shorthand(*verb, "duration", "S", arguments.scene);
  verb->add_flag("--until-arrived", arguments.until_arrived,
                 "ends as soon as every robot has arrived, at the latest after the duration");
  add_threads(*verb, arguments.threads);
  add_volume(*verb);
  verb->footer("Example: avo run circle-100 --record out.csv --summary out.json --figure out.svg");
  verb->callback([&action] { action = [] { return run(arguments); }; });
}

void add_explain(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand("explain", "why a robot chooses its velocity");
  static ExplainArguments arguments;
  add_scene(*verb, arguments.scene);
  verb->add_option("--robot", arguments.robot, "its number")->type_name("I")->required();
  verb->add_option("--time", arguments.time, "the last step until then is explained")
      ->type_name("T");
  CLI::Option* json = verb->add_flag("--json", arguments.json, "as JSON");
  not_empty(verb->add_option("--figure", arguments.figure, "velocity space"))
      ->type_name("FILE.svg|.png|.pdf")
      ->excludes(json);
  not_empty(verb->add_option("--states", arguments.states,
                             "where it would be safe or doomed with its velocity"))
      ->type_name("FILE.svg|.png|.pdf")
      ->excludes(json);
  add_volume(*verb);
  verb->footer("Example: avo explain circle-10 --robot 3 --time 4.2 --figure why.svg");
  verb->callback([&action] { action = [] { return explain(arguments); }; });
}

void add_check(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand("check", "judge recorded motion of any program");
  static CheckArguments arguments;
  not_empty(verb->add_option("RECORDING", arguments.recording,
                             "as avo run --record writes it, or trajectories of pedestrians; - is "
                             "stdin, of CSV"))
      ->type_name("FILE.csv|.h5|.sqlite|.txt")
      ->required();
  not_empty(verb->add_option("--scene", arguments.scene.scene, kScene))->type_name("SCENE");
  add_overrides(*verb, arguments.scene);
  verb->add_option("--radius", arguments.radius,
                   "of all robots, where there is no scene, or none of its own robots")
      ->type_name("M");
  verb->add_option("--max-acceleration", arguments.max_acceleration,
                   "of all robots; without it accelerations are unknown; inf: no limit")
      ->type_name("M/S^2");
  verb->add_option("--max-speed", arguments.max_speed,
                   "of all robots; without it speeds are unknown; inf: no limit")
      ->type_name("M/S");
  verb->add_option("--max-braking", arguments.max_braking,
                   "of all robots, where it is more than --max-acceleration")
      ->type_name("M/S^2");
  verb->add_option("--tolerance", arguments.tolerance, "of distances and limits, 1e-9 of them")
      ->type_name("FRACTION");
  verb->add_option(
          "--movers-at-rest", arguments.movers_at_rest,
          "a robot at rest that somebody runs over who does not avoid it: collision, or ok")
      ->type_name("ok|collision");
  verb->add_flag("--require-arrival", arguments.require_arrival,
                 "a robot that never arrives fails");
  verb->add_flag("--json", arguments.json, "as JSON");
  add_volume(*verb);
  verb->footer(
      "Exit code 0: safe, 1: not, 7: rows are missing. Example: avo check out.csv --scene "
      "circle-100");
  verb->callback([&action] { action = [] { return check(arguments); }; });
}

void add_replay(CLI::App& app, Action& action) {
  CLI::App* verb =
      app.add_subcommand("replay", "simulate a recording's scene again, and compare bit by bit");
  static ReplayArguments arguments;
  not_empty(verb->add_option("RECORDING", arguments.recording, "as avo run --record writes it"))
      ->type_name("FILE.h5")
      ->required();
  add_own_methods(*verb, arguments.own_method, false);
  verb->add_flag("--json", arguments.json, "as JSON");
  add_threads(*verb, arguments.threads);
  add_volume(*verb);
  verb->footer("Exit code 0: equal, 1: not. Example: avo replay out.h5");
  verb->callback([&action] { action = [] { return replay(arguments); }; });
}

void add_recover(CLI::App& app, Action& action) {
  CLI::App* verb =
      app.add_subcommand("recover", "make a recording of what a run has left that was killed");
  static RecoverArguments arguments;
  not_empty(verb->add_option("SPOOL", arguments.spool, "what the run has left"))
      ->type_name("FILE.h5.part")
      ->required();
  not_empty(verb->add_option("--output", arguments.output, "without it the name before .part"))
      ->type_name("FILE.h5");
  add_volume(*verb);
  verb->footer("Exit code 0: nothing is lost, 7: the end is. Example: avo recover out.h5.part");
  verb->callback([&action] { action = [] { return recover(arguments); }; });
}

void add_convert(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand("convert", "write a recording for other programs");
  static ConvertArguments arguments;
  not_empty(verb->add_option("RECORDING", arguments.recording,
                             "as avo run --record writes it, or its spool, or trajectories of "
                             "pedestrians; - is stdin, of CSV"))
      ->type_name("FILE.csv|.h5|.h5.part|.sqlite|.txt")
      ->required();
  not_empty(verb->add_option("OUTPUT", arguments.output, "its ending says the format; - is stdout"))
      ->type_name("FILE.csv|.sqlite|.mcap|.glb|.h5|.txt")
      ->required();
  not_empty(verb->add_option(
                "--to", arguments.to,
                "csv, sqlite, mcap, gltf, recording, pedestrian-hdf5, pedestrian-text, obsmat or "
                "set-points"))
      ->type_name("FORMAT");
  not_empty(verb->add_option("--name", arguments.name,
                             "with --to recording: of the method that made the motion; without it "
                             "the file's name"))
      ->type_name("NAME");
  verb->add_option("--radius", arguments.radius,
                   "with --to recording: m, of robots that --scene does not have; 0.3")
      ->type_name("M");
  verb->add_option("--rate", arguments.rate, "with --to set-points: so many a second; 50")
      ->type_name("HZ");
  not_empty(verb->add_option("--autopilot", arguments.autopilot,
                             "with --to set-points: px4 or crazyflie, in its frame and columns"))
      ->type_name("AUTOPILOT");
  not_empty(verb->add_option("--scene", arguments.scene.scene, kScene))->type_name("SCENE");
  add_overrides(*verb, arguments.scene);
  add_volume(*verb);
  verb->footer("Example: avo convert out.h5 out.mcap");
  verb->callback([&action] { action = [] { return convert(arguments); }; });
}

void add_video(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand("video", "make a video of a recording, by ffmpeg");
  static VideoArguments arguments;
  not_empty(verb->add_option("RECORDING", arguments.recording, "as avo run --record writes it"))
      ->type_name("FILE.h5|.csv")
      ->required();
  not_empty(verb->add_option("VIDEO", arguments.output, "what to make"))
      ->type_name("FILE.mp4|.gif")
      ->required();
  not_empty(verb->add_option("--scene", arguments.scene.scene, kScene))->type_name("SCENE");
  add_overrides(*verb, arguments.scene);
  verb->add_option("--fps", arguments.fps, "frames a second, 30")->type_name("N");
  verb->add_option("--speed", arguments.speed, "times as fast as the simulation, 1")
      ->type_name("FACTOR");
  verb->add_option("--size", arguments.size, "pixels of the longer side, 1080")->type_name("N");
  add_volume(*verb);
  verb->footer("Example: avo video out.h5 out.mp4 --speed 4");
  verb->callback([&action] { action = [] { return video(arguments); }; });
}

void add_bench(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand("bench", "measure what a step of a scene costs");
  static BenchArguments arguments;
  add_scene(*verb, arguments.scene);
  add_threads(*verb, arguments.threads);
  verb->add_option("--steps", arguments.steps,
                   "so many after ten; without it all until everyone has arrived, of uniform-N 100")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000));
  verb->add_flag("--json", arguments.json, "as JSON");
  add_volume(*verb);
  verb->footer("Example: avo bench circle-100 --threads 1 --set method=avo_paper");
  verb->callback([&action] { action = [] { return bench(arguments); }; });
}

void add_others(CLI::App& app, Action& action) {
  CLI::App* scenes = app.add_subcommand("scenes", "list the built-in scenes, or print one");
  static std::string name;
  static bool json = false;
  not_empty(scenes->add_option("NAME", name, "prints the text of this scene"));
  scenes->add_flag("--json", json, "the list as JSON");
  scenes->footer("Example: avo scenes circle-N > my-circle.yaml");
  scenes->callback([&action] { action = [] { return list_scenes(name, json); }; });

  CLI::App* validate = app.add_subcommand("validate", "check a scene without running it");
  static SceneArguments scene;
  add_scene(*validate, scene);
  add_volume(*validate);
  validate->footer("Example: avo validate my-circle.yaml --set control_time=2");
  validate->callback([&action] { action = [] { return validate_scene(scene); }; });

  CLI::App* schema = app.add_subcommand("schema", "print the JSON Schema of scenes");
  schema->footer("Example: avo schema > scene.schema.json");
  schema->callback([&action] { action = [] { return print_schema(); }; });

  CLI::App* help = app.add_subcommand("help", "explain a verb and its options");
  static std::string topic;
  help->add_option("VERB", topic, "none: all verbs in short");
  help->footer("Example: avo help run");
  help->callback([&app, &action] { action = [&app] { return print_help(app, topic); }; });

  CLI::App* generate = app.add_subcommand("generate", "what is installed besides the program")
                           ->group("");  // for avo's own build, so help does not list it
  static std::string kind;
  generate->add_option("KIND", kind, "man, bash or zsh")->required();
  generate->callback([&app, &action] { action = [&app] { return print_generated(app, kind); }; });
}

}  // namespace

void add_options(CLI::App& app, Action& action) {
  app.name("avo");
  app.set_version_flag("-V,--version", std::string("avo ") + avo::kVersion);
  app.require_subcommand(1);
  app.footer("Example: avo run circle-100 --figure circle.svg");
  add_run(app, action);
  add_explain(app, action);
  add_check(app, action);
  add_replay(app, action);
  add_recover(app, action);
  add_convert(app, action);
  add_video(app, action);
  add_lab(app, action);
  add_bench(app, action);
  add_many_runs(app, action);
  add_others(app, action);
}

}  // namespace avo_cli
