// SPDX-License-Identifier: Apache-2.0
// What avo bench found, as text and as JSON.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "avo/scenario.h"
#include "avo/simulation.h"

namespace avo_cli {

struct BenchResults {
  int threads = 1;
  int runs = 1;                      ///< of the same steps
  std::vector<double> milliseconds;  ///< of each step: the median of its runs
  avo::StepProfile profile;          ///< of one more run
  std::size_t bytes = 0;             ///< that the simulation holds; 0: unknown
};

/// The keys are a contract: scripts read them.
std::string to_json(const avo::Scenario& scenario, const BenchResults& results);
std::string readable(const avo::Scenario& scenario, const BenchResults& results);

/// Of not empty values; of an even number the lower of the two in the middle.
double median(std::vector<double> values);

/// Of not empty values.
double mean(const std::vector<double>& values);

/// The largest median of so many steps in a row; of all, where there are fewer.
double densest(const std::vector<double>& milliseconds, std::size_t in_a_row);

}  // namespace avo_cli
