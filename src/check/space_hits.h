// SPDX-License-Identifier: Apache-2.0
// Contacts of robots of space with moving obstacles, told apart by whether the robot moved.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "avo/check.h"
#include "check/space_path.h"

namespace avo::judge {

/// A robot and a moving obstacle in one step.
struct SpaceEncounter {
  std::int64_t robot = 0, other = 0;
  double start = 0.0, duration = 0.0;  ///< s
  double contact = 0.0;                ///< m, nearer is contact
  double at_rest = 0.0;                ///< m/s, the robot rests up to this speed
};

class SpaceHits {
 public:
  /// path: of the robot; relative: to the moving obstacle.
  void meet(const SpaceEncounter& encounter, const Cubic& path, const Cubic& relative);
  void write(CheckReport& report) const;

 private:
  std::map<std::pair<std::int64_t, std::int64_t>, CheckedHit> hits_;
  CheckCount in_motion_;
};

}  // namespace avo::judge
