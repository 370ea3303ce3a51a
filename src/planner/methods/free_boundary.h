// SPDX-License-Identifier: Apache-2.0
// The boundaries of the limits on the free velocities of one robot among passive movers, Eq. (13),
// as exact parametrized curves.
#pragma once
#include <span>
#include <vector>

#include "planner/methods/free_limits.h"

namespace avo::inline planner {

/// A part of a boundary. The parameter is the time on a side of an obstacle, and the fraction on an
/// arc or a segment.
struct Curve {
  enum class Kind : unsigned char { side, arc, segment };
  Kind kind = Kind::segment;
  int limit = 0;
  double sign = 1.0;   ///< which of the two sides
  Disc disc;           ///< of the arc
  Vec2 first, second;  ///< unit directions of the arc's ends; ends of the segment
};

struct CurvePoint {
  static constexpr int kUnknown = -2, kFree = -1;
  double parameter = 0.0;
  Vec2 position;            ///< v'_A
  Vec2 normal;              ///< unit, across the curve
  int violated = kUnknown;  ///< index of a limit that it violates, or kFree; computed on demand
};

CurvePoint point_at(const Curve& curve, std::span<const Limit> limits, double parameter);

/// The part of a curve between two neighboring points.
struct CurvePiece {
  int curve = 0;
  int first = 0, second = 0;  ///< indices of points
  /// m/s, a lower bound of the distance of its points from the preferred velocity
  double bound = 0.0;
};

/// The limits of one decision and their boundaries. Scratch memory; allocates only while it grows.
struct PassiveWorkspace {
  std::vector<Limit> limits;
  std::vector<Curve> curves;
  std::vector<CurvePoint> points;
  std::vector<CurvePiece> pieces;
};

/// Appends the boundary of limit k as far as the discs reach, cut into points.
void append_boundary(int k, const Disc& acceleration, const Disc& speed,
                     PassiveWorkspace& workspace);

}  // namespace avo::inline planner
