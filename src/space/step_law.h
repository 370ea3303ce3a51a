// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "avo/horizon.h"
#include "avo/planner.h"
#include "certificate/braking_path.h"

namespace avo::space {

/// The law of one step of robots with these options, as in the plane.
inline StepLaw step_law(const PlannerOptions& options, const Horizon& horizon) {
  const bool held = options.motion == Motion::held;
  return {.time_step = options.time_step,
          .lag = held ? 0.5 * options.time_step : horizon.step().lag,
          .braking_time = held ? options.time_step : horizon.step().rate * options.control_time,
          .sensing_error = options.sensing_error,
          .control_time = options.control_time,
          .localization_error = options.localization_error};
}

}  // namespace avo::space
