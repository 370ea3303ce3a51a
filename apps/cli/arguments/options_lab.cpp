// SPDX-License-Identifier: Apache-2.0
// The options of avo lab.
#include <CLI/CLI.hpp>

#include "arguments/option_parts.h"
#include "verbs/verbs.h"

namespace avo_cli {

void add_lab(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand(
      "lab", "open a scene or a recording in a browser, and look into every decision");
  static LabArguments arguments;
  not_empty(verb->add_option("INPUT", arguments.input,
                             "a scene, as avo run takes it, or a recording, as avo run --record "
                             "writes it; none: the lab opens with a scene of its own"))
      ->type_name("SCENE|FILE.h5|.csv|.part");
  not_empty(verb->add_option("--scene", arguments.scene.scene, "of a recording as CSV"))
      ->type_name("SCENE");
  add_overrides(*verb, arguments.scene);
  add_remedies(*verb, arguments.scene);
  not_empty(verb->add_option("--out", arguments.output,
                             "the page; - is stdout. Without it INPUT.html in the current folder, "
                             "never in place of a file that is no such page"))
      ->type_name("FILE.html");
  verb->add_flag_callback(
      "--no-open", [] { arguments.opens = false; },
      "write the page only; without it the browser shows it, at a terminal with a display");
  add_volume(*verb);
  verb->footer("Example: avo lab circle-10");
  verb->callback([&action] { action = [] { return lab(arguments); }; });
}

}  // namespace avo_cli
