// SPDX-License-Identifier: Apache-2.0
// Options that several verbs share.
#include "arguments/option_parts.h"

#include <CLI/CLI.hpp>

#include "system/terminal.h"

namespace avo_cli {

CLI::Option* not_empty(CLI::Option* option) {
  return option->check([](const std::string& word) {
    return word.empty() ? std::string("found an empty name, must have one") : std::string();
  });
}

void add_volume(CLI::App& verb) {
  CLI::Option* quiet = verb.add_flag_callback(
      "-q,--quiet", [] { set_volume(Volume::quiet); },
      "errors only, and what options ask for: no results to read, no warnings, no progress");
  verb.add_flag_callback(
          "-v,--verbose", [] { set_volume(Volume::verbose); },
          "also what is loaded and which settings are in use, on stderr")
      ->excludes(quiet);
}

CLI::Option* add_shorthand(CLI::App& verb, const std::string& key, const std::string& value,
                           SceneArguments& arguments) {
  return verb
      .add_option_function<std::string>(
          "--" + key,
          [key, &arguments](const std::string& given) {
            arguments.overrides.push_back(key + "=" + given);
            arguments.typed_as[arguments.overrides.back()] = "--" + key;
          },
          "the same as --set " + key + "=" + value)
      ->type_name(value);
}

void add_overrides(CLI::App& verb, SceneArguments& arguments) {
  verb.add_option("--set", arguments.overrides,
                  "changes a value of the scene, e.g. robots.0.radius=0.4; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  add_shorthand(verb, "seed", "N", arguments);
}

void add_remedies(CLI::App& verb, SceneArguments& arguments) {
  verb.add_flag("--start-at-rest", arguments.start_at_rest, "all robots start with velocity 0");
  verb.add_flag("--limit-speed", arguments.limit_speed,
                "lowers max_speed to what the sensing radius allows");
}

}  // namespace avo_cli
