// SPDX-License-Identifier: Apache-2.0
// A state goes on in a simulation of its own scene only.
#include "sim/state/same_scene.h"

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>

#include "core/ranges.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

template <typename Value>
std::string shown(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return to_string(value);
  } else if constexpr (std::is_same_v<Value, std::string>) {
    std::string line = value;
    std::replace_if(
        line.begin(), line.end(), [](unsigned char letter) { return letter < ' '; }, ' ');
    return '"' + line + '"';
  } else if constexpr (std::is_floating_point_v<Value>) {
    return text(value);
  } else {
    return std::to_string(value);
  }
}

std::string shown(const SensingError& error) {
  return text(error.position) + " m and " + text(error.velocity) + " m/s";
}

std::string shown(const LocalizationNoise& noise) {
  return "{position: " + text(noise.position) + ", distribution: " + to_string(noise.distribution) +
         (noise.truncated ? ", truncated: " + text(*noise.truncated) : "") + "}";
}

std::string shown(const SensingModel& model) {
  const MeasurementNoise& noise = model.noise;
  return "{noise: {position: " + text(noise.position) + ", velocity: " + text(noise.velocity) +
         ", distribution: " + to_string(noise.distribution) +
         (noise.truncated ? ", truncated: " + text(*noise.truncated) : "") +
         "}, delay: " + std::to_string(model.delay) + ", dropped: " + text(model.dropped) +
         ", occlusion: " + (model.occlusion ? "true" : "false") +
         (model.localization == LocalizationNoise{}
              ? ""
              : ", localization: " + shown(model.localization)) +
         "}";
}

template <typename Value>
std::string shown(const std::optional<Value>& value) {
  return value ? shown(*value) : "none";
}

void require_same_settings(const Scenario& saved, const World& world) {
  for_each_setting([&](const char* key, auto member) {
    const auto &theirs = saved.*member, &ours = world.settings.*member;
    if (theirs == ours) return;
    refuse(std::string("saved state: ") + key, shown(theirs),
           shown(ours) + " as in this simulation");
  });
}

void require_same_external(const Scenario& saved, const World& world) {
  if (saved.external_method == world.settings.external_method) return;
  refuse("saved state: external_method", shown(saved.external_method),
         shown(world.settings.external_method) + " as in this simulation");
}

void require_same_execution(const Bases& saved, const World& world) {
  const Bases& ours = world.fleet.bases;
  if (saved.model == ours.model && saved.declared == ours.declared) return;
  refuse("saved state: execution", "another one", "the one of this simulation");
}

}  // namespace

void require_same_scene(const SavedState& state, const World& world) {
  require_same_settings(state.scene, world);
  require_same_external(state.scene, world);
  require_same_execution(state.bases, world);
}

}  // namespace avo::inline sim
