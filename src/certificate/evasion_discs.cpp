// SPDX-License-Identifier: Apache-2.0
#include "certificate/evasion_discs.h"

#include <cmath>
#include <cstddef>

#include "certificate/discs.h"
#include "certificate/evasions.h"
#include "robots/model.h"

namespace avo::inline certificate {
namespace {

std::size_t count_of(const Footprint& footprint) {
  return static_cast<std::size_t>(footprint.discs);
}

// For a drive, with a heading within a spread throughout the step.
void swing_with(const BrakingPose& within, const EvasionOptions& options, const EvasionState& from,
                const MotionStep& step, EvasionDiscs& discs) {
  for (int k = 0; k < options.footprint.discs; ++k) {
    const double ahead = options.footprint.ahead(k);
    const Vec2 start = from.position + ahead * within.ahead;
    discs.moving[static_cast<std::size_t>(k)] = {start, start + options.law.lag * from.velocity,
                                                 start + (step.next.position - from.position),
                                                 std::abs(ahead) * within.spread};
  }
}

}  // namespace

std::span<const Hull> move_discs(const EvasionOptions& options, const EvasionState& from,
                                 const Plan& plan, const MotionStep& step, EvasionDiscs& discs) {
  const StepLaw& law = options.law;
  const Robot& robot = *options.wheels;
  const std::size_t count = count_of(options.footprint);
  const MotionState now{from.position, from.velocity, from.heading};
  const std::span<const Hull> moving = std::span(discs.moving).first(count);
  if (const auto within = turn_within(robot.model, now, step.next, law.time_step)) {
    swing_with(*within, options, from, step, discs);
    return moving;
  }
  std::array<MotionStep, Footprint::kMostDiscs> steps;
  advance_discs(robot.model, {planned_braking(robot), robot.max_speed}, now, plan, law.time_step,
                std::span(steps).first(count));
  const Vec2 heading = braking_pose(robot.model, {}, from.heading, braking_limit(robot), law).ahead;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2 start = from.position + options.footprint.ahead(static_cast<int>(k)) * heading;
    discs.moving[k] = {start, start + law.lag * (from.velocity + steps[k].swing),
                       start + (steps[k].next.position - from.position), steps[k].bend};
  }
  return moving;
}

std::span<const BrakingDisc> brake_discs(const EvasionOptions& options, const EvasionState& from,
                                         EvasionDiscs& discs) {
  const Robot& robot = *options.wheels;
  const BrakingPose pose =
      braking_pose(robot.model, from.velocity, from.heading, braking_limit(robot), options.law);
  for (int k = 0; k < options.footprint.discs; ++k) {
    const double ahead = options.footprint.ahead(k);
    discs.braking[static_cast<std::size_t>(k)] = {ahead * pose.ahead,
                                                  std::abs(ahead) * pose.spread};
  }
  return std::span(discs.braking).first(count_of(options.footprint));
}

}  // namespace avo::inline certificate
