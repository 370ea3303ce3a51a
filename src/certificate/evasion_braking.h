// SPDX-License-Identifier: Apache-2.0
// Full braking from a state of an evasive maneuver: of A's position, and of the discs of its
// footprint.
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>

#include "certificate/braking_path.h"
#include "certificate/evasion_discs.h"
#include "certificate/evasions.h"

namespace avo::inline certificate {

/// Full braking from a state.
struct FullBraking {
  BrakingProfile profile;
  Vec2 position;   // m, where it begins
  Vec2 direction;  // unit, or 0
  double steps = 0.0;
  Vec2 end;                                     // m
  std::span<const BrakingDisc> footprint = {};  // of a robot with a footprint

  // Returns whether all of A's discs pass the test, where A's position moves on that path.
  template <typename Test>
  bool all_discs(const Hull& path, const Test& test) const {
    if (footprint.empty()) return test(path);
    return std::all_of(footprint.begin(), footprint.end(),
                       [&](const BrakingDisc& disc) { return test(path_of(disc, path)); });
  }
};

FullBraking braking_from(const EvasionOptions& options, const EvasionState& state,
                         EvasionDiscs& discs);

/// Interval m of it.
Hull interval_of(const FullBraking& braking, const StepLaw& law, std::size_t m);

/// Tests (C1) of rest after it, from that time on.
bool stays_clear(const Predicted& other, const FullBraking& braking, double time);

}  // namespace avo::inline certificate
