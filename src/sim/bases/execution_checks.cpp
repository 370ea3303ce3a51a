// SPDX-License-Identifier: Apache-2.0
// Which scenes may have bases that do not execute exactly.
#include <cstddef>
#include <string>

#include "core/ranges.h"
#include "robots/execution_bounds.h"
#include "sim/bases/bases.h"
#include "sim/scene/scene_checks.h"

namespace avo::inline sim {

void check_body(const RobotSetup& robot, Method method, const std::string& name) {
  if (!is_holonomic(robot.model))
    refuse(name + "model", "one that is not holonomic", "holonomic in a scene with execution");
  if (!(robot.velocity == Vec2{}))
    refuse(name + "velocity", text(robot.velocity),
           "[0, 0] in a scene with execution: bases start at rest");
  if (adopts_at_once(method))
    refuse(name + "method", to_string(method),
           "one that keeps max_acceleration in a scene with execution");
}

void check_execution(const Scenario& scenario) {
  if (scenario.execution_error) {
    require("execution_error", *scenario.execution_error, kNotNegative, "m");
    if (!scenario.execution) refuse("execution", "none", "given where execution_error is");
  }
  if (!scenario.execution) return;
  if (scenario.clock != Clock::common)
    refuse("clock", to_string(scenario.clock), "common in a scene with execution");
  if (scenario.motion != Motion::held)
    refuse("motion", to_string(scenario.motion), "held in a scene with execution");
  validate(*scenario.execution, scenario.time_step, "execution.");
  for (std::size_t i = 0; i < scenario.robots.size(); ++i)
    check_body(scenario.robots[i], method_of(scenario, scenario.robots[i]),
               "robots." + std::to_string(i) + ".");
}

}  // namespace avo::inline sim
