// SPDX-License-Identifier: Apache-2.0
// avo: the command line. Reads arguments, calls one verb, turns what goes wrong into exit codes.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <functional>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "avo/simd.h"
#include "avo/version.h"
#include "avo_io/errors.h"
#include "avo_io/nearest.h"
#include "avo_io/output_file.h"
#include "avo_io/printable.h"
#include "exit_codes.h"
#include "terminal.h"
#include "verbs.h"

namespace avo_cli {
namespace {

using Action = std::function<int()>;

constexpr const char* kScene = "name of a built-in scene, or a YAML file";

/// For options whose empty word could not be told from none.
CLI::Option* not_empty(CLI::Option* option) {
  return option->check([](const std::string& word) {
    return word.empty() ? std::string("found an empty name, must have one") : std::string();
  });
}

void add_overrides(CLI::App& verb, SceneArguments& arguments) {
  verb.add_option("--set", arguments.overrides,
                  "changes a value of the scene, e.g. robots.0.radius=0.4; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb.add_option_function<std::string>(
          "--seed",
          [&arguments](const std::string& seed) { arguments.overrides.push_back("seed=" + seed); },
          "the same as --set seed=N")
      ->type_name("N");
}

void add_scene(CLI::App& verb, SceneArguments& arguments) {
  not_empty(verb.add_option("SCENE", arguments.scene, kScene))->required();
  add_overrides(verb, arguments);
  verb.add_flag("--start-at-rest", arguments.start_at_rest, "all robots start with velocity 0");
  verb.add_flag("--limit-speed", arguments.limit_speed,
                "lowers max_speed to what the sensing radius allows");
}

void add_threads(CLI::App& verb, int& threads) {
  verb.add_option("--threads", threads, "0: as many as the machine has")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
}

void add_run(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand("run", "simulate a scene to its end");
  static RunArguments arguments;
  add_scene(*verb, arguments.scene);
  not_empty(
      verb->add_option("--record", arguments.record, "every state of every robot; - is stdout"))
      ->type_name("FILE.csv");
  not_empty(verb->add_option("--summary", arguments.summary, "results; - is stdout"))
      ->type_name("FILE.json");
  not_empty(verb->add_option("--figure", arguments.figure, "time-lapse of the trajectories"))
      ->type_name("FILE.svg|.png|.pdf");
  add_threads(*verb, arguments.threads);
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
  verb->footer("Example: avo explain circle-10 --robot 3 --time 4.2 --figure why.svg");
  verb->callback([&action] { action = [] { return explain(arguments); }; });
}

void add_check(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand("check", "judge recorded motion, whoever made it");
  static CheckArguments arguments;
  not_empty(verb->add_option("RECORDING", arguments.recording,
                             "as avo run --record writes it; - is stdin"))
      ->type_name("FILE.csv")
      ->required();
  not_empty(verb->add_option("--scene", arguments.scene.scene, kScene))->type_name("SCENE");
  add_overrides(*verb, arguments.scene);
  verb->add_option("--radius", arguments.radius, "of all robots, where there is no scene")
      ->type_name("M");
  verb->add_option("--max-acceleration", arguments.max_acceleration, "likewise; inf: no limit")
      ->type_name("M/S^2");
  verb->add_option("--max-speed", arguments.max_speed, "likewise; inf: no limit")->type_name("M/S");
  verb->add_option("--tolerance", arguments.tolerance, "of distances and limits, 1e-9 of them")
      ->type_name("FRACTION");
  verb->add_flag("--require-arrival", arguments.require_arrival,
                 "a robot that never arrives fails");
  verb->add_flag("--json", arguments.json, "as JSON");
  verb->footer("Exit code 0: safe, 1: not. Example: avo check out.csv --scene circle-100");
  verb->callback([&action] { action = [] { return check(arguments); }; });
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
  validate->footer("Example: avo validate my-circle.yaml --set control_time=2");
  validate->callback([&action] { action = [] { return validate_scene(scene); }; });

  CLI::App* schema = app.add_subcommand("schema", "print the JSON Schema of scenes");
  schema->footer("Example: avo schema > scene.schema.json");
  schema->callback([&action] { action = [] { return print_schema(); }; });
}

std::string did_you_mean(std::string_view given, const std::vector<std::string>& names) {
  const std::vector<std::string_view> words(names.begin(), names.end());
  const auto meant = avo_io::nearest(given, words);
  return meant ? ", did you mean " + std::string(*meant) + "?" : "";
}

// Every word that looks like a long option has to be one of `app`.
void check_options(const CLI::App& app, const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (!word.starts_with("--") || word == "--") continue;
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw UsageError(avo_io::printable(name, kLongestWord) + ": found no such option" +
                       did_you_mean(name, names));
  }
}

void check_words(CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty()) return;
  if (words[0].starts_with("-")) return check_options(app, {words[0]});
  std::vector<std::string> verbs;
  std::string list;
  for (const CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; })) {
    if (verb->get_name() == words[0]) return check_options(*verb, words);
    verbs.push_back(verb->get_name());
    list += (list.empty() ? "" : ", ") + verb->get_name();
  }
  throw UsageError(avo_io::printable(words[0], kLongestWord) + ": found no such verb, verbs are " +
                   list + did_you_mean(words[0], verbs));
}

void check_environment() {
  try {
    avo::check_simd_target();
  } catch (const avo::Error& error) {
    throw UsageError(error.what());
  }
}

int parse_and_act(int argc, char** argv) {
  CLI::App app("Multi-robot collision avoidance that respects acceleration limits");
  app.name("avo");
  app.set_version_flag("--version", std::string("avo ") + avo::kVersion);
  app.require_subcommand(1);
  app.footer("Example: avo run circle-100 --figure circle.svg");
  Action action;
  add_run(app, action);
  add_explain(app, action);
  add_check(app, action);
  add_bench(app, action);
  add_others(app, action);
  check_words(app, std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print(app.help());
    return kDone;
  } catch (const CLI::CallForVersion&) {
    print(std::string("avo ") + avo::kVersion + "\n");
    return kDone;
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + "; see avo --help");
  }
  check_environment();
  (void)avo_io::OutputFile("-");  // all verbs write there: not to find out after a long run
  return action();
}

int fail(int code, const std::string& message) {
  say(message);
  return code;
}

}  // namespace
}  // namespace avo_cli

int main(int argc, char** argv) {
  using namespace avo_cli;
  try {
    prepare_streams();
    return parse_and_act(argc, argv);
  } catch (const UsageError& error) {
    return fail(kUsage, std::string("avo: ") + error.what());
  } catch (const avo_io::OverrideError& error) {
    return fail(kUsage, error.what());
  } catch (const avo_io::FileError& error) {
    return error.broken_pipe() ? kClosedPipe : fail(kFile, error.what());
  } catch (const BrokenScene& error) {
    say(error.lines);
    return kBadScene;
  } catch (const avo::Error& error) {
    return fail(kBadScene, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kResources, "avo: found too little memory");
  } catch (const std::system_error& error) {
    return fail(kResources, std::string("avo: ") + error.what());
  } catch (const std::exception& error) {
    return fail(kOurFault,
                std::string("avo: a fault of this program, please report it: ") + error.what());
  }
}
