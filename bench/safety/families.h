// SPDX-License-Identifier: Apache-2.0
// The families of scenes over which safety and arrival are measured, one for each row of the table.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scenes.h"

namespace avo::safety {

struct Family {
  std::string name;
  std::string what;
  int scenes = 1;
  bool seeded = false;  ///< whether scenes differ; otherwise there is one
  std::function<Scene(std::uint64_t seed)> make;
};

/// Returns all rows, in the order of the table. `soak_steps` is the length in robot-steps of each
/// crush and each row of walls-, over all its scenes; mixed-crush lasts a tenth of it.
std::vector<Family> families(double soak_steps);
/// Appends the rows in which robots sense each other wrongly, late or not at all.
void add_sensing(std::vector<Family>& all);

}  // namespace avo::safety
