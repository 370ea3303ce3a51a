// SPDX-License-Identifier: Apache-2.0
// Measures safety and arrival over families of scenes: a table, and JSON lines.
#include <atomic>
#include <cstdio>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "avo/error.h"
#include "families.h"
#include "options.h"
#include "output.h"
#include "run.h"
#include "table.h"

namespace avo::safety {
namespace {

// A row and the outcomes of its scenes, one slot for each.
struct Row {
  Family family;
  std::vector<Outcome> outcomes;
  std::size_t missing = 0;  // number of missing outcomes
};

struct Job {
  std::size_t row, scene;
};

/// Runs all scenes on several threads. It prints a row when that row and all rows before it are
/// complete.
class Harness {
 public:
  Harness(const Options& options, std::vector<Row> rows)
      : options_(options), rows_(std::move(rows)) {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (std::size_t k = 0; k < rows_[r].missing; ++k) jobs_.push_back({r, k});
    }
    if (!options.record.empty() && jobs_.size() != 1) {
      throw UsageError("--record: found " + std::to_string(jobs_.size()) +
                       " scenes, must be one; see --row, --scenes");
    }
    if (!options.json.empty()) json_.emplace(options.json);
  }

  /// Returns true if nothing unsafe happened under a certificate.
  bool run() {
    print(table_header());
    std::vector<std::thread> threads;
    for (int t = 1; t < options_.threads; ++t) threads.emplace_back([this] { work(); });
    work();
    for (std::thread& thread : threads) thread.join();
    if (failure_) std::rethrow_exception(failure_);
    if (json_) json_->commit();
    return certified_safe_;
  }

 private:
  void work() {
    for (;;) {
      const std::size_t next = next_++;
      if (next >= jobs_.size()) return;
      try {
        run(jobs_[next]);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        next_ = jobs_.size();
      }
    }
  }

  void run(const Job& job) {
    Row& row = rows_[job.row];
    const std::uint64_t seed = options_.first_seed + job.scene;
    Scene scene = row.family.make(seed);
    apply(options_, scene.scenario);
    Outcome outcome;
    try {
      outcome = run_scene(scene, seed, options_.record);
    } catch (const Error& error) {
      throw Error(row.family.name + ": " + error.what());
    }
    const std::lock_guard lock(mutex_);
    row.outcomes[job.scene] = std::move(outcome);
    --row.missing;
    for (; shown_ < rows_.size() && rows_[shown_].missing == 0; ++shown_) show(rows_[shown_]);
  }

  void show(const Row& row) {
    std::string settings;
    for (const std::string& setting : options_.settings) settings += " " + setting;
    const RowResult result = summarize(row.family.name, row.outcomes);
    if (result.certified && result.unsafe_scenes > 0) certified_safe_ = false;
    print(table_lines(result) + failure_lines(result, row.outcomes, settings));
    if (json_) json_->write(json_line(result, row.outcomes));
  }

  static void print(const std::string& text) {
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
      throw OutputError("standard output: cannot be written");
    }
  }

  const Options& options_;
  std::vector<Row> rows_;
  std::vector<Job> jobs_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;  // protects all members below, and the rows
  std::size_t shown_ = 0;
  bool certified_safe_ = true;
  std::exception_ptr failure_;
  std::optional<Output> json_;
};

std::vector<Row> rows_asked_for(const Options& options) {
  const std::vector<Family> all = families(options.soak_steps);
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Family& family : all) names.push_back(family.name);
  std::vector<Row> rows;
  for (const Family& family : all) {
    if (!is_asked_for(options, family.name, names)) continue;
    const int scenes = family.seeded ? options.scenes.value_or(family.scenes) : 1;
    const auto count = static_cast<std::size_t>(scenes);
    rows.push_back({family, std::vector<Outcome>(count), count});
  }
  if (rows.empty()) throw UsageError("--row: found no row of that name; see --list");
  return rows;
}

int run(int count, char** arguments) {
  const Options options = parse_options(count, arguments);
  if (options.help) {
    std::fputs(usage(), stdout);
    return 0;
  }
  std::vector<Row> rows = rows_asked_for(options);
  if (options.list) {
    for (const Row& row : rows) {
      std::printf("%-18s %4zu  %s\n", row.family.name.c_str(), row.missing,
                  row.family.what.c_str());
    }
    return 0;
  }
  return Harness(options, std::move(rows)).run() ? 0 : 1;
}

int say(const char* what, int status) {
  std::fprintf(stderr, "avo_bench_safety: %s\n", what);
  return status;
}

}  // namespace
}  // namespace avo::safety

int main(int count, char** arguments) {
  try {
    return avo::safety::run(count, arguments);
  } catch (const avo::safety::UsageError& error) {
    return avo::safety::say(error.what(), 2);
  } catch (const avo::Error& error) {
    return avo::safety::say(error.what(), 3);
  } catch (const std::exception& error) {
    return avo::safety::say(error.what(), 4);
  }
}
