// SPDX-License-Identifier: Apache-2.0
// Ranges of what a scene says of sensing, in the plane and in space.
#pragma once
#include <string>

#include "avo/scenario.h"
#include "core/ranges.h"

namespace avo::inline core {

template <typename Noise>
void check_noise(const std::string& key, const Noise& noise) {
  require(key + ".position", noise.position, kNoise, "m");
  if constexpr (requires { noise.velocity; })
    require(key + ".velocity", noise.velocity, kNoise, "m/s");
  if (!noise.truncated) return;
  require(key + ".truncated", *noise.truncated, kTruncation, "");
  if (noise.distribution == NoiseDistribution::uniform)
    refuse(key + ".truncated", text(*noise.truncated),
           "left out with distribution uniform, which stays within what is given");
}

/// Throws Error that names the first value out of range.
inline void check_sensing(const SensingModel& sensing) {
  check_noise("sensing.noise", sensing.noise);
  check_noise("sensing.localization", sensing.localization);
  require("sensing.delay", sensing.delay, Range{0.0, kMostDelay, false}, "steps");
  require("sensing.dropped", sensing.dropped, kShareMissed, "");
}

}  // namespace avo::inline core
