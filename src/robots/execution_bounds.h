// SPDX-License-Identifier: Apache-2.0
// What an ExecutionModel implies: the commands that its base executes, and how far it may be from
// its reference (docs/certificate/execution.md).
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "avo/execution.h"
#include "robots/motion.h"

namespace avo::inline robots {

/// The limits of a robot that count.
struct ExecutionLimits {
  double change = 0.0;  ///< [c] m/s², change_limit(): |dv/dt| of the reference
  double speed = 0.0;   ///< [v_max] m/s
};

/// execution_error() for a model, limits and a time_step (s) that are in range.
ExecutionError bounds_of(const ExecutionModel& model, const MotionModel& robot,
                         const ExecutionLimits& limits, double time_step);

/// Throws Error on a model out of range; `prefix` names it.
void validate(const ExecutionModel& model, double time_step,
              const std::string& prefix = "ExecutionModel.");

/// m: the largest distance of such a base from the cubic of its positions and velocities at two
/// successive decisions. For a drive both are those of the point ahead of its axle.
double off_cubic(const ExecutionModel& model, const MotionModel& robot,
                 const ExecutionLimits& limits, double time_step);

/// [w_k] m/s, before it is rounded: leads a body that is measured so to the reference `after` the
/// step. still_to_come: m, the effect of commands that do not act yet.
Vec2 command_towards(const ExecutionModel& model, const MotionState& after, Vec2 position,
                     Vec2 velocity, Vec2 still_to_come, double time_step);

/// m: how far the commands that were sent and do not act yet move a base beyond its lag, as its
/// model says. sent: m/s, cyclically, for the dead time at least; the next one goes to `next`.
Vec2 still_to_come(std::span<const Vec2> sent, std::size_t next, double dead_time,
                   double time_step);

/// m/s: the coordinate nearest to the wanted one that the base executes without change; 0 if two
/// are.
double executable(const ExecutionModel& model, double wanted);
inline Vec2 executable(const ExecutionModel& model, Vec2 wanted) {
  return {executable(model, wanted.x), executable(model, wanted.y)};
}

/// The limits of a robot, or of its setup.
template <typename Body>
ExecutionLimits limits_of(const Body& body) {
  return {change_limit(body), body.max_speed};
}

}  // namespace avo::inline robots
