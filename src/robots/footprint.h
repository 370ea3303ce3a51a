// SPDX-License-Identifier: Apache-2.0
// The discs of a footprint: their places, and their motion in a step.
#pragma once
#include <utility>
#include <variant>

#include "avo/footprint.h"
#include "avo/model.h"
#include "robots/model.h"

namespace avo::inline robots {

/// Returns whether every number is finite and in range; also of no footprint.
bool is_valid(const Footprint& footprint);

/// The footprint as the model has it, about the robot's position. A model that has none of its own
/// has no such member: nullptr.
inline const Footprint* own_footprint(const MotionModel& model) {
  if (const Car* car = std::get_if<Car>(&model)) return &car->footprint;
  const auto* drive = std::get_if<DifferentialDrive>(&model);
  return drive != nullptr ? &drive->footprint : nullptr;
}
inline Footprint* own_footprint(MotionModel& model) {
  return const_cast<Footprint*>(own_footprint(std::as_const(model)));
}

inline bool has_footprint(const MotionModel& model) {
  const Footprint* footprint = own_footprint(model);
  return footprint != nullptr && footprint->discs > 0;
}

/// Returns whether it may turn at rest without moving anything that others know of.
inline bool turns_unnoticed(const MotionModel& model) {
  return model_traits(model).turns_in_place && !has_footprint(model);
}

}  // namespace avo::inline robots
