// SPDX-License-Identifier: Apache-2.0
// The decision that one robot would take now.
#include <string>

#include "avo/error.h"
#include "avo_io/decision.h"
#include "host.h"

namespace avo_lab {

/// Returns the same JSON as `avo explain --json`.
AVO_EXPORT(std::size_t, explain)(std::uint32_t robot) {
  const avo::Simulation& simulation = *lab().simulation;
  const std::size_t index = index_of(robot);
  if (simulation.fleet().setup[index].parked)
    throw avo::Error("robot " + std::to_string(robot) +
                     ": found a parked one, must be one that decides");
  return into_room(to_json(avo_io::explain(simulation, lab().scenario.name, index)));
}

}  // namespace avo_lab
