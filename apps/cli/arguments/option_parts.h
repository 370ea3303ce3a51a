// SPDX-License-Identifier: Apache-2.0
// Options that several verbs share, and the verbs that have a separate file.
#pragma once
#include <string>

#include "arguments/options.h"
#include "verbs/verbs.h"

namespace CLI {
class Option;
}

namespace avo_cli {

inline constexpr const char* kScene =
    "name of a built-in scene, see avo scenes, or a YAML file; - is stdin";

/// Refuses an empty word: for these options it would look like no word.
CLI::Option* not_empty(CLI::Option* option);

/// Adds --quiet and --verbose.
void add_volume(CLI::App& verb);

/// Adds --KEY VALUE for --set KEY=VALUE.
CLI::Option* add_shorthand(CLI::App& verb, const std::string& key, const std::string& value,
                           SceneArguments& arguments);
/// Adds --set and --seed.
void add_overrides(CLI::App& verb, SceneArguments& arguments);
/// Adds --start-at-rest and --limit-speed.
void add_remedies(CLI::App& verb, SceneArguments& arguments);

/// Adds avo lab.
void add_lab(CLI::App& app, Action& action);
/// Adds avo sweep, avo compare and avo report.
void add_many_runs(CLI::App& app, Action& action);

}  // namespace avo_cli
