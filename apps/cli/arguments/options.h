// SPDX-License-Identifier: Apache-2.0
// The verbs and options of the command line, as a tree. Help, the manual page and completions come
// from it.
#pragma once
#include <functional>

namespace CLI {
class App;
}

namespace avo_cli {

/// The action that the command line asks for; it returns an exit code.
using Action = std::function<int()>;

/// Adds all verbs and options; parsing sets the action. Both arguments must live until it is
/// called.
void add_options(CLI::App& app, Action& action);

}  // namespace avo_cli
