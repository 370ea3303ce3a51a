// SPDX-License-Identifier: Apache-2.0
// The families of scenes that safety and arrival are measured over, one a row of the table.
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
  bool seeded = false;  ///< scenes differ; otherwise there is one
  std::function<Scene(std::uint64_t seed)> make;
};

/// All rows, in the order of the table. `soak_steps` is what each crush and each row of walls-
/// lasts in all its scenes, in robot-steps; mixed-crush a tenth of it.
std::vector<Family> families(double soak_steps);
/// Appends the rows in which robots sense each other wrongly, late or not at all.
void add_sensing(std::vector<Family>& all);

}  // namespace avo::safety
