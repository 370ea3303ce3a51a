// SPDX-License-Identifier: Apache-2.0
// The options of avo sweep, and of the verbs for its results: avo compare and avo report.
#include <CLI/CLI.hpp>

#include "arguments/option_parts.h"
#include "arguments/own_methods.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

void add_sweep(CLI::App& app, Action& action) {
  CLI::App* verb =
      app.add_subcommand("sweep", "many runs: scenes x methods x parameters x seeds, as one table");
  static SweepArguments arguments;
  not_empty(verb->add_option("SPEC", arguments.spec, "what varies, see docs/experiments.md"))
      ->type_name("FILE.yaml")
      ->required();
  not_empty(verb->add_option("--out", arguments.output,
                             "table of the runs; what was interrupted goes on from there"))
      ->type_name("FILE.csv|.h5")
      ->required();
  not_empty(verb->add_option("--summary", arguments.summary,
                             "medians, 95th percentiles and 95 % intervals; - is stdout"))
      ->type_name("FILE.csv");
  verb->add_option("--jobs", arguments.jobs, "runs at a time; 0: as many as there are processors")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  CLI::Option* shard =
      not_empty(verb->add_option("--shard", arguments.shard, "part I of N of the runs"))
          ->type_name("I/N");
  not_empty(
      verb->add_option("--merge", arguments.tables, "runs nothing: joins the tables of all shards"))
      ->type_name("FILE.csv|.h5")
      ->excludes(shard);
  add_own_methods(*verb, arguments.own_methods, true);
  add_volume(*verb);
  verb->footer("Example: avo sweep sweep.yaml --out runs.csv --summary summary.csv");
  verb->callback([&action] { action = [] { return sweep(arguments); }; });
}

void add_compare(CLI::App& app, Action& action) {
  CLI::App* verb =
      app.add_subcommand("compare", "print the table of sweeps and recordings, and draw them");
  static CompareArguments arguments;
  not_empty(verb->add_option("FILES", arguments.files,
                             "as avo sweep --out and avo run --record FILE.h5 write them"))
      ->type_name("FILE.csv|.h5")
      ->required();
  not_empty(verb->add_option("--by", arguments.by,
                             "what rows differ in: method, a parameter, table, scene; without it "
                             "the first of these that does"))
      ->type_name("KEY");
  not_empty(verb->add_option("--columns", arguments.columns, "of which means are shown"))
      ->type_name("NAME,...")
      ->delimiter(',');
  const auto add_figure = [&](const char* name, std::string& path, const char* text) {
    not_empty(verb->add_option(name, path, text))->type_name("FILE.svg|.png|.pdf");
  };
  add_figure("--arrival", arguments.arrival, "how many have arrived over time");
  add_figure("--clearance", arguments.clearance, "least clearance over time, of recordings");
  add_figure("--traces", arguments.traces, "trajectories side by side, of recordings");
  add_figure("--scaling", arguments.scaling, "time of a step over the number of robots");
  add_volume(*verb);
  verb->footer("Example: avo compare runs.csv --by method --arrival arrival.svg");
  verb->callback([&action] { action = [] { return compare(arguments); }; });
}

void add_report(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand(
      "report", "make one page of a recording or a sweep: figures, results, a replay");
  static ReportArguments arguments;
  not_empty(verb->add_option("INPUT", arguments.input,
                             "as avo run --record FILE.h5 and avo sweep --out write them"))
      ->type_name("FILE.h5|.csv")
      ->required();
  not_empty(verb->add_option("PAGE", arguments.output, "what to make; - is stdout"))
      ->type_name("FILE.html")
      ->required();
  not_empty(verb->add_option("--spec", arguments.spec,
                             "of the sweep: one of its runs is simulated again, and shown"))
      ->type_name("FILE.yaml");
  verb->add_option("--run", arguments.run, "the number of that run, with --spec; 0")
      ->type_name("K");
  not_empty(verb->add_option("--line", arguments.line,
                             "of a recording: tell the flow across this line, its ends in m"))
      ->type_name("X,Y,X,Y");
  add_own_methods(*verb, arguments.own_methods, true);
  add_volume(*verb);
  verb->footer("Example: avo report out.h5 out.html");
  verb->callback([&action] { action = [] { return report(arguments); }; });
}

}  // namespace

void add_many_runs(CLI::App& app, Action& action) {
  add_sweep(app, action);
  add_compare(app, action);
  add_report(app, action);
}

}  // namespace avo_cli
