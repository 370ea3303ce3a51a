// SPDX-License-Identifier: Apache-2.0
// What runs of the plane and of space have in common.
#pragma once
#include <chrono>
#include <string>

#include "avo/metrics.h"
#include "system/signals.h"
#include "system/terminal.h"
#include "verbs/verbs.h"

namespace avo_cli {

/// Simulates a scene of that duration (s) to its end, or until a signal; the outputs observe the
/// start and each step.
template <class Simulation, class Metrics, class Outputs>
avo::RunSummary simulate_to_end(const RunArguments& arguments, double duration,
                                Simulation& simulation, Metrics metrics, Outputs& outputs) {
  using Clock = std::chrono::steady_clock;
  Progress progress(duration, arguments.until_arrived);
  metrics.observe(simulation);
  outputs.observe(simulation);
  bool ends = false;
  while (!ends && simulation.can_step_by(duration) && signal_caught() == 0) {
    const Clock::time_point start = Clock::now();
    simulation.step();
    metrics.add_step_time(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    metrics.observe(simulation);
    outputs.observe(simulation);
    progress.show(simulation.time());
    ends = arguments.until_arrived && metrics.all_arrived();
  }
  outputs.observe_last(simulation);
  return metrics.summary();
}

/// Prints the results of a run with finished outputs, and returns the exit code. `steps`: how many
/// of them were made, for a run that a signal has stopped.
int tell_run(const RunArguments& arguments, const std::string& results, const std::string& steps);

}  // namespace avo_cli
