// SPDX-License-Identifier: Apache-2.0
// The decision that one robot would take now.
#include <cstddef>
#include <cstdint>

#include "avo_io/decision.h"
#include "host.h"

namespace avo_lab {

/// Returns the same JSON as `avo explain --json`.
AVO_EXPORT(std::size_t, explain)(std::uint32_t robot) {
  const avo::Simulation& simulation = *lab().simulation;
  return into_room(to_json(avo_io::explain(simulation, lab().scenario.name, {robot})));
}

}  // namespace avo_lab
