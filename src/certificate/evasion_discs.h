// SPDX-License-Identifier: Apache-2.0
// The discs of a robot with a footprint in its evasive maneuvers (docs/movers.md, "Footprints").
// Each disc is tested like the disc of a robot without one.
#pragma once
#include <array>
#include <span>

#include "avo/footprint.h"
#include "certificate/predicted.h"
#include "robots/motion.h"

namespace avo::inline certificate {

struct EvasionOptions;
struct EvasionState;

/// A disc of a footprint while its robot brakes straight: for as long as the heading may turn, the
/// disc is larger (docs/certificate/footprints.md, "Drives").
struct BrakingDisc {
  Vec2 offset;         // m, from the robot's position to the center
  double grown = 0.0;  // m
};

/// Scratch memory: the discs on the last step, and on the last path of braking.
struct EvasionDiscs {
  std::array<Hull, Footprint::kMostDiscs> moving;
  std::array<BrakingDisc, Footprint::kMostDiscs> braking;
};

/// The path of each disc in `step`, which begins in that state and executes the plan.
std::span<const Hull> move_discs(const EvasionOptions& options, const EvasionState& from,
                                 const Plan& plan, const MotionStep& step, EvasionDiscs& discs);

/// The discs of a robot that brakes from that state on.
std::span<const BrakingDisc> brake_discs(const EvasionOptions& options, const EvasionState& from,
                                         EvasionDiscs& discs);

/// The path of a disc where that of the robot's position is `path`.
inline Hull path_of(const BrakingDisc& disc, const Hull& path) {
  return {path.start + disc.offset, path.middle + disc.offset, path.end + disc.offset,
          path.bend + disc.grown};
}

}  // namespace avo::inline certificate
