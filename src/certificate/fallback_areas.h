// SPDX-License-Identifier: Apache-2.0
// Lines between the fallback areas of two robots, one of which loiters: each robot keeps its part
// of the gap (docs/certificate/airplanes.md).
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "avo/robot.h"
#include "avo/wall.h"
#include "certificate/braking_path.h"
#include "certificate/pair.h"
#include "core/neighbor_columns.h"
#include "robots/flight.h"

namespace avo::inline certificate {

/// The area that a robot does not leave if it decides nothing better: a segment with a radius.
struct FallbackArea {
  /// m: start and displacement of braking; for a robot that flies the center of its circle, and 0
  Vec2 start, to_stop;
  double radius = 0.0;     ///< m, of the area about that segment
  double intervals = 0.0;  ///< number of intervals until rest
};
FallbackArea fallback_area_of(const Robot& robot, const StepLaw& law);
FallbackArea fallback_area_of(const Neighbor& neighbor, const StepLaw& law);

/// m, between two fallback areas; < 0 where they overlap.
double gap_of(const FallbackArea& a, const FallbackArea& b);

/// The separating line of one neighbor.
struct SeparatingLine {
  int neighbor = 0;
  Vec2 normal;        ///< unit, from B's fallback area to A's
  double part = 0.0;  ///< m, how much nearer A may come along the normal: its part of the gap
};

/// The line of a neighbor that loiters, for a robot A that brakes: normal . x >= offset for all of
/// A's next fallback area, relative to p_A.
struct LoiterLine {
  int neighbor = 0;
  Vec2 normal;          ///< unit, from the neighbor's circle to A's fallback area
  double offset = 0.0;  ///< m
  double begin = 0.0;   ///< m, the start of A's present fallback area
};

/// For robots that brake: appends the lines of the neighbors that loiter.
void collect_loiterers(const Robot& robot, const Neighbors& neighbors, const StepLaw& law,
                       std::vector<LoiterLine>& lines, Invariant& invariant);

/// Returns whether the fallback area after the candidate's first step, and with it that step, keeps
/// to all lines.
bool keeps_loiterers(std::span<const LoiterLine> lines, const CandidatePath& path,
                     const StepLaw& law);

/// Appends the lines as half-planes in v_1, which suffice while |v_1| <= top_speed.
void append_half_planes(std::span<const LoiterLine> lines, const Robot& robot, const StepLaw& law,
                        double top_speed, std::vector<HalfPlane>& half_planes);

/// The demands of neighbors and walls on a robot that flies. Scratch memory; allocates only while
/// it grows.
struct FlightConstraints {
  std::vector<SeparatingLine> lines;
  /// each with the distance that the robot keeps from its middle line as radius
  std::vector<Wall> walls;
  double slack = 0.0;  ///< m, see Invariant
  /// the deepest of the neighbors and of the walls that its circle does not keep clear of
  Deepest broken = {}, broken_wall = {};

  bool are_broken() const { return broken.any() || broken_wall.any(); }
};
void collect_flight(const Robot& robot, const Neighbors& neighbors, std::span<const Wall> walls,
                    const StepLaw& law, FlightConstraints& constraints);

/// Returns whether the step, and the circle after it, keep all constraints. The call is not needed
/// where the circle stays.
bool keeps_flight(const FlightConstraints& constraints, const Robot& robot, const FlightStep& step);

/// m, covers all rounding of a robot that flies beside a wall.
double flight_margin(const Wall& wall, double radius, double circle);

}  // namespace avo::inline certificate
