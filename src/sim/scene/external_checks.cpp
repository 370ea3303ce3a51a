// SPDX-License-Identifier: Apache-2.0
// Checks of a scene's external method.
#include <algorithm>
#include <cstddef>
#include <string>

#include "core/ranges.h"
#include "planner/options.h"
#include "sim/scene/scene_checks.h"

namespace avo {

bool has_external(const Scenario& scenario) {
  return is_external(scenario.method) ||
         std::any_of(scenario.robots.begin(), scenario.robots.end(), [&](const RobotSetup& robot) {
           return is_external(method_of(scenario, robot));
         });
}

}  // namespace avo

namespace avo::inline sim {

// The function of an external method decides for all its robots at once, and saved states and
// tables name it.
void check_external(const Scenario& scenario) {
  if (!has_external(scenario)) return;
  constexpr std::size_t kMostBytes = 64;
  const std::string& name = scenario.external_method;
  const char* const external = to_string(Method::external);
  if (name.empty() || name.size() > kMostBytes)
    refuse("external_method", name.empty() ? "none" : std::to_string(name.size()) + " bytes",
           "a name of 1 to " + std::to_string(kMostBytes) + " bytes, for robots of method " +
               external);
  if (std::any_of(name.begin(), name.end(),
                  [](unsigned char letter) { return letter < 0x20 || letter == 0x7f; }))
    refuse("external_method", "a control character", "printable");
  for (std::size_t k = 0; k < kNames<Method>.size(); ++k)
    if (name == kNames<Method>[k]) refuse("external_method", name, "another name than avo's own");
  if (scenario.clock == Clock::free)
    refuse("clock", to_string(scenario.clock),
           std::string("common, for robots of method ") + external);
}

}  // namespace avo::inline sim
