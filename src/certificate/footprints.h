// SPDX-License-Identifier: Apache-2.0
// Lines between what two robots fall back on, one of which loiters: each keeps its part of the gap
// (docs/certificate/airplanes.md).
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "avo/robot.h"
#include "avo/wall.h"
#include "certificate/braking_path.h"
#include "certificate/pair.h"
#include "certificate/stopping_capsules.h"
#include "core/neighbor_columns.h"
#include "robots/airplane.h"

namespace avo::inline certificate {

/// A robot that decides nothing better leaves it no more: a segment with a radius.
struct Footprint {
  Vec2 start, way;         ///< m: where it brakes; the center of its circle, and nowhere
  double radius = 0.0;     ///< m, of all that it covers about that
  double intervals = 0.0;  ///< until rest
};
Footprint footprint_of(const Robot& robot, const StepLaw& law);
Footprint footprint_of(const Neighbor& neighbor, const StepLaw& law);

/// m, between two of them; < 0 where they overlap.
double gap_of(const Footprint& a, const Footprint& b);

/// Of one neighbor.
struct SeparatingLine {
  int neighbor = 0;
  Vec2 normal;        ///< unit, from B's footprint to A's
  double part = 0.0;  ///< m, that A may come nearer along it: its part of the gap
};

/// Of robots that brake: appends the constraints of the neighbors that loiter.
void collect_loiterers(const Robot& robot, const Neighbors& neighbors, const StepLaw& law,
                       std::vector<CapsuleConstraint>& constraints, Invariant& invariant);

/// What neighbors and walls demand of an airplane. Scratch memory; allocates only while it grows.
struct FlightConstraints {
  std::vector<SeparatingLine> lines;
  std::vector<Wall> walls;  ///< each with all that is kept from its middle line for a radius
  double slack = 0.0;       ///< m, see Invariant
  Deepest broken = {}, broken_wall = {};  ///< of those that its circle does not keep clear of

  bool are_broken() const { return broken.any() || broken_wall.any(); }
};
void collect_flight(const Robot& robot, const Neighbors& neighbors, std::span<const Wall> walls,
                    const StepLaw& law, FlightConstraints& constraints);

/// Whether the step, and the circle after it, keep to all of them. Where the circle stays as it is,
/// nobody needs to ask.
bool keeps_flight(const FlightConstraints& constraints, const Robot& robot, const FlightStep& step);

/// m, what covers all rounding of an airplane beside a wall.
double flight_margin(const Wall& wall, double radius, double circle);

}  // namespace avo::inline certificate
