// SPDX-License-Identifier: Apache-2.0
// Checks of what a scene says of sensing, in the plane and in space.
#pragma once
#include <string>

#include "avo/scenario.h"
#include "core/ranges.h"
#include "fields/scene_fields.h"

namespace avo::inline fields {

template <typename Noise>
void check_noise(const Behind& names, const Noise& noise) {
  require_ranges(noise, names);
  if (noise.truncated && noise.distribution == NoiseDistribution::uniform)
    refuse(std::string(names("truncated")), core::text(*noise.truncated),
           "left out with distribution uniform, which stays within what is given");
}

/// Throws Error that names the first value out of range.
inline void check_sensing(const SensingModel& sensing) {
  check_noise({"sensing.noise."}, sensing.noise);
  check_noise({"sensing.localization."}, sensing.localization);
  require_ranges(sensing, Behind{"sensing."});
}

}  // namespace avo::inline fields
