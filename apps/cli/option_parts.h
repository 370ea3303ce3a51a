// SPDX-License-Identifier: Apache-2.0
// What the options of several verbs have in common, and the verbs that have a file of their own.
#pragma once
#include "options.h"

namespace CLI {
class Option;
}

namespace avo_cli {

/// For options whose empty word could not be told from none.
CLI::Option* not_empty(CLI::Option* option);

/// --quiet and --verbose.
void add_volume(CLI::App& verb);

/// avo sweep and avo compare.
void add_many_runs(CLI::App& app, Action& action);

}  // namespace avo_cli
