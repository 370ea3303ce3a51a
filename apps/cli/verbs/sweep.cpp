// SPDX-License-Identifier: Apache-2.0
// avo sweep: many runs as one table, on all processors; it also joins the tables of several
// machines.
#include "avo_io/sweep.h"

#include <charconv>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments/files.h"
#include "arguments/own_methods.h"
#include "avo_io/output_file.h"
#include "avo_io/printable.h"
#include "avo_io/recording.h"
#include "exit_codes.h"
#include "system/signals.h"
#include "system/terminal.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

constexpr const char* kJournal = ".part";  // suffix of the table's name

/// Reads "I/N". Throws UsageError.
avo_io::SweepShard shard_of(const std::string& text) {
  avo_io::SweepShard shard{0, 0};
  const char* const last = text.data() + text.size();
  const char* at = std::from_chars(text.data(), last, shard.index).ptr;
  if (at != last && *at == '/') at = std::from_chars(at + 1, last, shard.count).ptr;
  const bool good = at == last && 1 <= shard.index && shard.index <= shard.count &&
                    shard.count <= avo_io::kMostSweepRuns;
  if (!good)
    throw UsageError(fmt::format("--shard: found {}, must be I/N, part I from 1 to N of N parts",
                                 avo_io::printable(text, kLongestWord)));
  return shard;
}

void check_sweep(const SweepArguments& arguments) {
  if (arguments.output == "-")
    throw UsageError("--out: found -, must be a file: runs are kept beside it");
  require_ending({"--out", arguments.output}, {".csv", ".h5"});
  require_ending({"--summary", arguments.summary}, {".csv"});
  std::vector<NamedFile> inputs{{"the sweep", arguments.spec}};
  for (const std::string& table : arguments.tables) inputs.push_back({"--merge", table});
  require_distinct(inputs, {{"--out", arguments.output},
                            {"--summary", arguments.summary},
                            {"what is kept of the runs", arguments.output + kJournal}});
}

/// Writes both files, or none.
void write_tables(const SweepArguments& arguments, const avo_io::SweepTable& table) {
  avo_io::OutputFile output(arguments.output);
  if (!avo_io::is_hdf5_path(arguments.output))
    output.write(to_csv(table));
  else if (output.temporary().empty())
    throw avo_io::FileError(arguments.output + ": found no regular file, must be one for HDF5");
  else
    write_sweep_hdf5(table, output.temporary(), arguments.output);
  std::vector<avo_io::OutputFile*> files{&output};
  std::optional<avo_io::OutputFile> summary;
  if (!arguments.summary.empty()) {
    summary.emplace(arguments.summary);
    summary->write(to_csv(summary_of(table)));
    files.push_back(&*summary);
  }
  commit_all(files);
}

void tell_done(const SweepArguments& arguments, const std::string& what) {
  const std::string text = fmt::format("{}: {}\n", avo_io::printable(arguments.output), what);
  if (arguments.summary != "-")
    print_results(text);
  else if (volume() != Volume::quiet)
    say(lines_of(text));
}

int merge(const SweepArguments& arguments, const avo_io::SweepSpec& spec) {
  std::vector<std::pair<std::string, avo_io::SweepTable>> tables;
  for (const std::string& table : arguments.tables)
    tables.emplace_back(table, avo_io::read_sweep(table));
  const avo_io::SweepMerge merged = merge_sweep(spec, tables);
  if (merged.missing.empty()) {
    write_tables(arguments, merged.table);
    tell_done(arguments,
              fmt::format("{} runs of {} tables", merged.table.rows.size(), tables.size()));
    return kDone;
  }
  constexpr std::size_t kNamed = 3;
  std::string names;
  for (std::size_t i = 0; i < std::min(kNamed, merged.missing.size()); ++i)
    names += fmt::format("{}{} ({})", i > 0 ? ", " : "", merged.missing[i],
                         run_name(spec, merged.missing[i]));
  say(fmt::format("{}: found {} of {} runs, must be all; missing: {}{}", spec.name,
                  merged.table.rows.size(), run_count(spec), names,
                  merged.missing.size() > kNamed ? " and others" : ""));
  return kIncomplete;
}

/// Progress of the scenes, which are made and checked before the first run, and then of the runs.
/// It prints once what a signal leads to.
class SweepProgress {
 public:
  void prepare(std::int64_t done, std::int64_t all) {
    if (all != scenes_) bar_.reset(new Progress(Progress::of_scenes(static_cast<int>(all))));
    scenes_ = all;
    bar_->show(static_cast<double>(done));
    heed_signal();
  }
  void show(std::int64_t done, std::int64_t all) {
    if (!bar_ || scenes_ != 0) {
      scenes_ = 0;
      bar_.reset();  // wiped before the next one appears
      bar_.reset(new Progress(Progress::of_parts(static_cast<int>(all - done))));
      first_ = done;
    }
    bar_->show(static_cast<double>(done - first_));
    heed_signal();
  }

 private:
  void heed_signal() {
    if (signal_caught() == 0 || told_) return;
    told_ = true;
    if (volume() != Volume::quiet)
      say("ends with the runs that are under way; a second signal ends it at once");
  }

  std::unique_ptr<Progress> bar_;
  std::int64_t scenes_ = 0;  // number of the bar's scenes; 0: the bar is that of the runs
  std::int64_t first_ = 0;   // number of runs that were done before
  bool told_ = false;
};

}  // namespace

int sweep(const SweepArguments& arguments) {
  check_sweep(arguments);
  const avo_io::SweepShard shard = shard_of(arguments.shard);
  const avo_io::SweepSpec spec =
      avo_io::load_sweep(arguments.spec, own_methods_of(arguments.own_methods));
  if (!arguments.tables.empty()) return merge(arguments, spec);
  if (shard.count > run_count(spec))  // a table without runs is not allowed
    throw UsageError(
        fmt::format("--shard: found {}, must be one of at most {} parts, as many as {} "
                    "has runs",
                    arguments.shard, run_count(spec), spec.name));
  catch_signals(Patience::until_second_signal);
  const auto start = std::chrono::steady_clock::now();
  const std::string journal = arguments.output + kJournal;
  avo_io::SweepResult result;
  {
    SweepProgress progress;
    result = run_sweep(
        spec,
        {.jobs = arguments.jobs,
         .shard = shard,
         .journal = journal,
         .progress = [&](std::int64_t done, std::int64_t all) { progress.show(done, all); },
         .preparing = [&](std::int64_t done, std::int64_t all) { progress.prepare(done, all); },
         .stops = [] { return signal_caught() != 0; }});
  }
  if (!result.complete()) {
    say(fmt::format("stopped by a signal after {} of {} runs; the same command goes on from there",
                    result.table.rows.size(), result.runs));
    return kSignal + signal_caught();
  }
  write_tables(arguments, result.table);
  std::filesystem::remove(journal);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  tell_done(
      arguments,
      fmt::format("{} runs{} in {:.1f} s", result.runs,
                  result.resumed > 0 ? fmt::format(", {} of them before,", result.resumed) : "",
                  seconds));
  return kDone;
}

}  // namespace avo_cli
