// SPDX-License-Identifier: Apache-2.0
// What the options of several verbs have in common, and the verbs that have a file of their own.
#pragma once
#include <string>

#include "options.h"
#include "verbs/verbs.h"

namespace CLI {
class Option;
}

namespace avo_cli {

inline constexpr const char* kScene =
    "name of a built-in scene, see avo scenes, or a YAML file; - is stdin";

/// For options whose empty word could not be told from none.
CLI::Option* not_empty(CLI::Option* option);

/// --quiet and --verbose.
void add_volume(CLI::App& verb);

/// --KEY VALUE for --set KEY=VALUE.
CLI::Option* add_shorthand(CLI::App& verb, const std::string& key, const std::string& value,
                           SceneArguments& arguments);
/// --set and --seed.
void add_overrides(CLI::App& verb, SceneArguments& arguments);
/// --start-at-rest and --limit-speed.
void add_remedies(CLI::App& verb, SceneArguments& arguments);

/// avo lab.
void add_lab(CLI::App& app, Action& action);
/// avo sweep, avo compare and avo report.
void add_many_runs(CLI::App& app, Action& action);

}  // namespace avo_cli
