// SPDX-License-Identifier: Apache-2.0
// What bounds the free velocities of one robot among passive movers, Eq. (13): obstacles, lines
// and discs, each with an exact test and an exact parametrized boundary.
#pragma once
#include <limits>
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "avo/velocity_obstacle.h"

namespace avo {

/// A mover B as an obstacle to v'_A: v'_A - v_new_B must not lie in `obstacle`.
struct PassiveObstacle {
  Obstacle obstacle;             ///< of velocities, not of accelerations
  Vec2 v_new_B;                  ///< [v'_B] m/s, v_B or v_B + δ a_B
  double shortest_window = 0.0;  ///< s: a pair that overlaps need not be apart before
};

/// Something that v'_A must stay outside of (an obstacle, a line) or inside of (a disc). Boundaries
/// are drawn `slack` on the safe side of what is asked, and tests allow half of it: so a point of
/// a boundary passes the test of that boundary whatever rounding does, and is safe.
struct Limit {
  enum class Kind : unsigned char { obstacle, line, disc };
  Kind kind = Kind::disc;
  Obstacle obstacle{{}, Response::velocity(), 0.0};  ///< its radius is the drawn one
  Vec2 v_new_B;
  double true_radius = 0.0;  ///< m, of the obstacle
  HalfPlane line;            ///< in v'_A, as drawn
  Disc disc;                 ///< as drawn
  double slack = 0.0;        ///< m for obstacles, else m/s
};

/// Positive on the free side, in the unit of the slack, 0 at half the slack.
double clearance(const Limit& limit, Vec2 v_new);

/// clearance(limit, v_new) < 0, decided faster.
bool violates(const Limit& limit, Vec2 v_new);

/// The most that the clearance changes per m/s of v_new: g(τ) for an obstacle.
double steepness(const Limit& limit);

/// How deep v_new lies in what is forbidden, m/s; 0 if it does not.
double violation(const Limit& limit, Vec2 v_new);

/// A part of a boundary: a side of an obstacle by time, an arc or a segment by the part of it.
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
  int violated = kUnknown;  ///< index of a limit that it violates, or kFree; filled in on demand
};

CurvePoint point_at(const Curve& curve, std::span<const Limit> limits, double parameter);

/// Between two neighboring points of a curve.
struct Piece {
  int curve = 0;
  int first = 0, second = 0;  ///< indices of points
  double bound = 0.0;         ///< no point of it is nearer the preferred velocity, m/s
};

/// Appends the limits of one mover: its obstacle, or a line if the pair overlaps; none if out of
/// reach of both discs.
void append_limit(const PassiveObstacle& mover, const Disc& acceleration, const Disc& speed,
                  std::vector<Limit>& limits);

/// Appends a half-plane that v'_A must stay in.
void append_limit(const HalfPlane& plane, std::vector<Limit>& limits);

/// Appends a disc that v'_A must stay in; nothing if its radius is infinite.
void append_limit(const Disc& disc, std::vector<Limit>& limits);

/// The limits of one decision and their boundaries. Scratch memory; allocates only while it grows.
struct PassiveWorkspace {
  std::vector<Limit> limits;
  std::vector<Curve> curves;
  std::vector<CurvePoint> points;
  std::vector<Piece> pieces;
};

/// The boundary of limit k as far as the discs reach, cut into points.
void append_boundary(int k, const Disc& acceleration, const Disc& speed,
                     PassiveWorkspace& workspace);

}  // namespace avo
