// SPDX-License-Identifier: Apache-2.0
// The decision that one robot would take now.
#include <cstddef>
#include <cstdint>
#include <variant>

#include "avo_io/decision.h"
#include "avo_io/space_decision.h"
#include "host.h"

namespace avo_lab {

/// Returns the same JSON as `avo explain --json`.
AVO_EXPORT(std::size_t, explain)(std::uint32_t robot) {
  if (const auto* space = std::get_if<SpaceRun>(&run()))
    return into_room(avo_io::to_json(space->simulation->explain({robot}), space->scenario.name));
  const avo::Simulation& simulation = *plane().simulation;
  return into_room(to_json(avo_io::explain(simulation, plane().scenario.name, {robot})));
}

}  // namespace avo_lab
