// SPDX-License-Identifier: Apache-2.0
// Motion models in a saved state.
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include "avo/scenario.h"
#include "robots/footprint.h"
#include "sim/state/archive.h"

namespace avo::inline sim {

template <bool kReads>
void describe(Archive<kReads>&, Holonomic&) {}

template <bool kReads>
void describe(Archive<kReads>& archive, Car& car) {
  bool has_body = car.body.has_value();
  double curvature = car.max_curvature.value_or(0.0);  // 0: unbounded
  auto set = static_cast<std::uint8_t>(car.acceleration_set);
  describe(archive, car.wheelbase), describe(archive, curvature);
  describe(archive, has_body), describe(archive, car.reverse), describe(archive, set);
  if (set > static_cast<std::uint8_t>(AccelerationSet::exact))
    refuse_saved("an unknown set of accelerations", "a known one");
  if (curvature != 0.0) car.max_curvature = curvature;
  car.acceleration_set = static_cast<AccelerationSet>(set);
  if (!has_body) return;
  if (kReads) car.body.emplace();
  describe(archive, car.body->offset), describe(archive, car.body->radius);
}

template <bool kReads>
void describe(Archive<kReads>& archive, DifferentialDrive& drive) {
  describe(archive, drive.track), describe(archive, drive.offset);
  describe(archive, drive.wheel_speed), describe(archive, drive.wheel_acceleration);
}

template <bool kReads>
void describe(Archive<kReads>& archive, Airplane& model) {
  auto after = static_cast<std::uint8_t>(model.after_goal);
  describe(archive, model.min_speed), describe(archive, model.lateral_acceleration);
  describe(archive, after);
  if (after > static_cast<std::uint8_t>(AfterGoal::leave))
    refuse_saved("an unknown after_goal", "a known one");
  model.after_goal = static_cast<AfterGoal>(after);
}

template <bool kReads>
void describe(Archive<kReads>& archive, Footprint& footprint) {
  auto discs = static_cast<std::uint64_t>(footprint.discs);
  archive.word(discs);
  if (discs == 0 || discs > static_cast<std::uint64_t>(Footprint::kMostDiscs))
    refuse_saved("a footprint of " + std::to_string(discs) + " discs", "1 to 5");
  footprint.discs = static_cast<int>(discs);
  describe(archive, footprint.radius), describe(archive, footprint.first);
  describe(archive, footprint.spacing);
}

// Makes it a model of that kind with its default values; an unknown kind changes nothing.
template <std::size_t... kKinds>
void become(MotionModel& model, std::uint64_t kind, std::index_sequence<kKinds...> /*all*/) {
  (static_cast<void>(kind == kKinds ? (model.emplace<kKinds>(), 0) : 0), ...);
}

// The kind and then its values, and those of its footprint.
template <bool kReads>
void describe(Archive<kReads>& archive, MotionModel& model) {
  constexpr std::uint64_t kCovered = 1U << 8;  // the kind of a model with a footprint has this bit
  const Footprint* own = own_footprint(model);
  auto kind = static_cast<std::uint64_t>(model.index()) |
              (own != nullptr && *own ? kCovered : std::uint64_t{0});
  archive.word(kind);
  const bool is_covered = (kind & kCovered) != 0;
  kind &= ~kCovered;
  if (kReads) become(model, kind, std::make_index_sequence<std::variant_size_v<MotionModel>>());
  if (kind != model.index()) refuse_saved("an unknown motion model", "a known one");
  std::visit([&](auto& known) { describe(archive, known); }, model);
  if (!is_covered) return;
  Footprint* footprint = own_footprint(model);
  if (footprint == nullptr) refuse_saved("a footprint of another model", "one of a car or a drive");
  describe(archive, *footprint);
}

}  // namespace avo::inline sim
