// SPDX-License-Identifier: Apache-2.0
// Which scenes may have bases that do not execute exactly.
#include <cstddef>
#include <string>
#include <variant>

#include "avo/error.h"
#include "core/ranges.h"
#include "core/retell.h"
#include "robots/execution_bounds.h"
#include "robots/footprint.h"
#include "sim/bases/bases.h"
#include "sim/scene/scene_checks.h"

namespace avo::inline sim {

namespace {

constexpr double kMostCycles = 1000.0;  // of the wheels' controller, in a time step

void check_drive(const ExecutionModel& model, double time_step, const RobotSetup& robot,
                 const std::string& name) {
  if (has_footprint(robot.model))
    refuse(name + "footprint", "one", "left out in a scene with execution");
  const double least = time_step / kMostCycles;
  if (!(model.heading_age >= least))
    refuse("execution.heading_age", text(model.heading_age),
           ">= " + text(least) + " s with a differential drive: the period of its wheels");
  retelling<Error>([&] { bounds_of(model, robot.model, limits_of(robot), time_step); },
                   [&](const Error& error) { throw Error(name + "drive: " + error.what()); });
}

}  // namespace

void check_base(const ExecutionModel& model, double time_step, const RobotSetup& robot,
                const std::string& name) {
  if (std::holds_alternative<DifferentialDrive>(robot.model))
    return check_drive(model, time_step, robot, name);
  if (!is_holonomic(robot.model))
    refuse(name + "model", "another one",
           "holonomic or differential_drive in a scene with execution");
}

void check_body(const ExecutionModel& model, double time_step, const RobotSetup& robot,
                Method method, const std::string& name) {
  check_base(model, time_step, robot, name);
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
    check_body(*scenario.execution, scenario.time_step, scenario.robots[i],
               method_of(scenario, scenario.robots[i]), "robots." + std::to_string(i) + ".");
}

}  // namespace avo::inline sim
