// SPDX-License-Identifier: Apache-2.0
// avo compare: the table of sweeps and recordings, and their figures.
#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

#include "arguments/files.h"
#include "avo_io/output_file.h"
#include "avo_io/recording.h"
#include "exit_codes.h"
#include "reports/comparison.h"
#include "system/signals.h"
#include "system/terminal.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

struct ComparisonFigure {
  NamedFile file;
  std::string (*draw)(const Comparison& comparison, const std::string& role,
                      const std::string& path);
};

std::vector<ComparisonFigure> figures_of(const CompareArguments& arguments) {
  std::vector<ComparisonFigure> figures{{{"--arrival", arguments.arrival}, draw_arrivals},
                                        {{"--clearance", arguments.clearance}, draw_clearances},
                                        {{"--traces", arguments.traces}, draw_traces},
                                        {{"--scaling", arguments.scaling}, draw_scaling}};
  std::erase_if(figures, [](const ComparisonFigure& figure) { return figure.file.path.empty(); });
  return figures;
}

/// Reads a recording, or else a table.
void read_into(Comparison& comparison, const std::string& path) {
  const bool is_table = path.ends_with(".csv") || avo_io::is_sweep_hdf5(path);
  if (!is_table && avo_io::read_recording_header(path))
    comparison.recordings.emplace_back(path, avo_io::read_run(path));
  else
    comparison.tables.emplace_back(path, avo_io::read_sweep(path));
}

/// Refuses options that have no effect on recordings alone.
void require_table(const CompareArguments& arguments, const Comparison& comparison) {
  if (!comparison.tables.empty() || (arguments.by.empty() && arguments.columns.empty())) return;
  throw UsageError(fmt::format("{}: found without a table of avo sweep, must be with one or more",
                               arguments.by.empty() ? "--columns" : "--by"));
}

}  // namespace

int compare(const CompareArguments& arguments) {
  catch_signals(Patience::none);
  const std::vector<ComparisonFigure> figures = figures_of(arguments);
  std::vector<NamedFile> inputs, outputs;
  for (const std::string& file : arguments.files) inputs.push_back({"the input", file});
  for (const ComparisonFigure& figure : figures) {
    require_figure(figure.file);
    outputs.push_back(figure.file);
  }
  require_distinct(inputs, outputs);
  Comparison comparison;
  comparison.tables.reserve(arguments.files.size());  // because cases point into it
  for (const std::string& file : arguments.files) read_into(comparison, file);
  require_table(arguments, comparison);
  comparison.by = arguments.by;
  const std::string text =
      readable(cases_of(comparison), arguments.by, arguments.columns) + readable(comparison);
  std::vector<std::unique_ptr<avo_io::OutputFile>> files;
  std::vector<avo_io::OutputFile*> written;
  for (const ComparisonFigure& figure : figures) {
    written.push_back(
        files.emplace_back(std::make_unique<avo_io::OutputFile>(figure.file.path)).get());
    written.back()->write(
        drawn([&] { return figure.draw(comparison, figure.file.role, figure.file.path); }));
  }
  commit_all(written);
  print_results(text);
  return kDone;
}

}  // namespace avo_cli
