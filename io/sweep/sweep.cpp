// SPDX-License-Identifier: Apache-2.0
// Simulates all runs of a sweep, several at a time.
#include "avo_io/sweep.h"

#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>

#include "io/sweep/journal.h"
#include "io/sweep/parallel_work.h"
#include "io/sweep/runs.h"

namespace avo_io {
namespace {

/// The runs of a shard that are to be simulated, and their sweep.
struct SweepPlan {
  const SweepSpec& spec;
  std::vector<std::uint64_t> sources;  // hash_sources()
  std::string sweep;                   // fingerprint()
  std::vector<std::int64_t> runs;
  std::vector<double> cost;  // for each of `runs`: the largest number of robot-steps

  /// Throws also if a file has changed since the sweep began: otherwise one sweep would have rows
  /// of two scenes.
  [[nodiscard]] SweepScenario scenario(const SweepRun& run) const {
    SceneSource source;
    SweepScenario scenario = scenario_of(spec, run, source);
    if (hash_of(source) != sources[static_cast<std::size_t>(run.number / runs_of_one_kind(spec))])
      throw SceneError(fmt::format("{}: {}: found another scene than when the sweep began",
                                   spec.name, run_name(spec, run.number)));
    return scenario;
  }
};

double cost_of(const SweepScenario& scenario) {
  return std::visit(
      [](const auto& own) {
        return static_cast<double>(own.robots.size()) * (own.duration / own.time_step);
      },
      scenario);
}

/// Checks every remaining run, and sorts the runs that may take longest to the front. Otherwise the
/// last run may keep all but one processor waiting.
void prepare(SweepPlan& plan, int jobs, const SweepOptions& options) {
  plan.cost.resize(plan.runs.size());
  std::atomic<std::int64_t> done = 0;
  work_through(
      plan.runs.size(), jobs,
      [&](std::size_t i) {
        plan.cost[i] = cost_of(plan.scenario(run_of(plan.spec, plan.runs[i])));
        ++done;
      },
      options.stops,
      [&] {
        const std::int64_t before = std::ssize(plan.sources);
        if (options.preparing) options.preparing(before + done, before + std::ssize(plan.runs));
      });
  std::vector<std::size_t> order(plan.runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return plan.cost[a] > plan.cost[b]; });
  std::vector<std::int64_t> sorted;
  sorted.reserve(order.size());
  for (const std::size_t i : order) sorted.push_back(plan.runs[i]);
  plan.runs = std::move(sorted);
}

std::vector<std::int64_t> runs_of(const SweepSpec& spec, const SweepShard& shard) {
  std::vector<std::int64_t> runs;
  for (std::int64_t k = shard.index - 1; k < run_count(spec); k += shard.count) runs.push_back(k);
  return runs;
}

std::int64_t number_of(const std::vector<std::string>& row) {
  constexpr std::size_t kRun = 1;  // its column
  return std::stoll(row[kRun]);
}

}  // namespace

SweepResult run_sweep(const SweepSpec& spec, const SweepOptions& options) {
  const int jobs = jobs_for(options.jobs);
  SweepPlan plan{spec, {}, {}, runs_of(spec, options.shard), {}};
  plan.sources = hash_sources(spec, jobs, [&](std::int64_t done) {
    const std::int64_t kinds = run_count(spec) / runs_of_one_kind(spec);
    if (options.preparing) options.preparing(done, kinds + std::ssize(plan.runs));
  });
  plan.sweep = fingerprint(spec, plan.sources);
  SweepResult result;
  result.table.columns = sweep_columns(spec);
  result.runs = std::ssize(plan.runs);
  std::optional<SweepJournal> journal;
  if (!options.journal.empty())
    journal.emplace(options.journal, plan.sweep,
                    fmt::format("{}/{}", options.shard.index, options.shard.count),
                    result.table.columns.size());
  std::map<std::int64_t, std::vector<std::string>> rows;  // by number of the run
  if (journal)
    for (const std::vector<std::string>& row : journal->rows()) rows[number_of(row)] = row;
  result.resumed = std::ssize(rows);
  std::erase_if(plan.runs, [&](std::int64_t run) { return rows.contains(run); });
  prepare(plan, jobs, options);

  std::mutex guard;  // protects rows and journal
  const auto simulate = [&](std::size_t i) {
    const SweepRun run = run_of(spec, plan.runs[i]);
    const SweepScenario scenario = plan.scenario(run);
    const RunOutcome outcome = simulate_run(spec, scenario);
    std::vector<std::string> row = sweep_row(spec, plan.sweep, run, scenario, outcome);
    const std::lock_guard lock(guard);
    if (journal) journal->add(row);
    rows[run.number] = std::move(row);
  };
  const auto tell = [&] {
    if (!options.progress) return;
    const std::lock_guard lock(guard);
    options.progress(std::ssize(rows), result.runs);
  };
  work_through(plan.runs.size(), jobs, simulate, options.stops, tell);
  for (auto& [run, row] : rows) result.table.rows.push_back(std::move(row));
  return result;
}

}  // namespace avo_io
