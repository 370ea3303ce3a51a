// SPDX-License-Identifier: Apache-2.0
// What an ExecutionModel implies: the commands that its base executes, and how far it may be from
// its reference (docs/certificate/execution.md).
#pragma once
#include "avo/execution.h"

namespace avo::inline navigator {

/// The limits of a robot that count.
struct ExecutionLimits {
  double change = 0.0;  ///< [c] m/s², change_limit(): |dv/dt| of the reference
  double speed = 0.0;   ///< [v_max] m/s
};

/// execution_error() for a model, limits and a time_step (s) that are in range.
ExecutionError bounds_of(const ExecutionModel& model, const MotionModel& robot,
                         const ExecutionLimits& limits, double time_step);

/// Throws Error on a model out of range.
void validate(const ExecutionModel& model, double time_step);

/// m/s: the coordinate nearest to the wanted one that the base executes as it is; 0 if two are.
double executable(const ExecutionModel& model, double wanted);

}  // namespace avo::inline navigator
