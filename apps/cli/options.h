// SPDX-License-Identifier: Apache-2.0
// The verbs and options of the command line, as a tree. Help, the manual page and completions are
// made from it.
#pragma once
#include <functional>

namespace CLI {
class App;
}

namespace avo_cli {

/// What the command line asks for; returns an exit code.
using Action = std::function<int()>;

/// Adds all verbs and options; parsing sets the action. Both have to live until it is called.
void add_options(CLI::App& app, Action& action);

}  // namespace avo_cli
