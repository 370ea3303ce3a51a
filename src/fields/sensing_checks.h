// SPDX-License-Identifier: Apache-2.0
// Checks of what a scene says of sensing, in the plane and in space.
#pragma once
#include <string>
#include <string_view>

#include "avo/scenario.h"
#include "core/ranges.h"
#include "fields/scene_fields.h"

namespace avo::inline fields {

template <typename Noise, typename Table>
void check_noise(const std::string& part, const Noise& noise, const Table& table) {
  require_ranges(noise, table, [&](std::string_view key) { return part + std::string(key); });
  if (noise.truncated && noise.distribution == NoiseDistribution::uniform)
    refuse(part + "truncated", core::text(*noise.truncated),
           "left out with distribution uniform, which stays within what is given");
}

/// Throws Error that names the first value out of range.
inline void check_sensing(const SensingModel& sensing) {
  check_noise("sensing.noise.", sensing.noise, kMeasurementNoiseFields);
  check_noise("sensing.localization.", sensing.localization, kLocalizationNoiseFields);
  require_ranges(sensing, kSensingFields,
                 [](std::string_view key) { return "sensing." + std::string(key); });
}

}  // namespace avo::inline fields
