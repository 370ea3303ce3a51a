// SPDX-License-Identifier: Apache-2.0
// The results of avo bench, as text and as JSON.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "avo/simulation.h"

namespace avo_cli {

struct BenchResults {
  int threads = 1;
  int runs = 1;                      ///< number of runs of the same steps
  std::vector<double> milliseconds;  ///< for each step: the median over its runs
  avo::StepProfile profile;          ///< of one additional run; in space without stages and pairs
  std::size_t bytes = 0;             ///< memory of the simulation; 0: unknown
};

/// The scene that was measured, of the plane or of space.
struct BenchScene {
  std::string name;
  std::size_t robots = 0;
  double time_step = 0.1;  ///< s
  std::string method, certificate;
};

/// The keys are a contract, because scripts read them.
std::string to_json(const BenchScene& scene, const BenchResults& results);
std::string readable(const BenchScene& scene, const BenchResults& results);

/// Returns the median; `values` must not be empty. For an even number it is the lower of the two
/// middle values.
double median(std::vector<double> values);

/// Returns the mean; `values` must not be empty.
double mean(const std::vector<double>& values);

/// Returns the largest median of so many consecutive steps, or the median of all if there are
/// fewer.
double densest(const std::vector<double>& milliseconds, std::size_t in_a_row);

}  // namespace avo_cli
