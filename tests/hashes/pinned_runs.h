// SPDX-License-Identifier: Apache-2.0
// The state hashes of these runs are pinned. A change of any bit of motion shows here.
#pragma once
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "avo/scenario.h"

namespace avo_test {

struct PinnedRun {
  std::string name;
  std::string scene;
  std::vector<std::string> overrides;  // as --set takes them
  std::int64_t steps = 0;              // 0: to the end of the scene's duration
  std::uint64_t hash = 0;              // Simulation::state_hash() after the last step
};

inline std::ostream& operator<<(std::ostream& out, const PinnedRun& run) {
  return out << run.name;
}

const std::vector<PinnedRun>& pinned_runs();

/// Returns the number of steps of `run`, which has the scene `scenario`.
std::int64_t steps_of(const PinnedRun& run, const avo::Scenario& scenario);

/// The hash that `run` has now. threads as Simulation takes them.
std::uint64_t state_hash(const PinnedRun& run, int threads);

}  // namespace avo_test
