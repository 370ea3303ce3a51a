// SPDX-License-Identifier: Apache-2.0
// The limits on the free velocities of one robot among passive movers, Eq. (13): obstacles, lines
// and discs, each with an exact test.
#pragma once
#include <vector>

#include "avo/geometry.h"
#include "avo/velocity_obstacle.h"

namespace avo::inline planner {

/// A mover B as an obstacle to v'_A: v'_A - v_new_B must not lie in `obstacle`.
struct PassiveObstacle {
  Obstacle obstacle;             ///< of velocities, not of accelerations
  Vec2 v_new_B;                  ///< [v'_B] m/s, v_B or v_B + δ a_B
  double shortest_window = 0.0;  ///< s: a pair that overlaps need not be apart earlier
};

/// A set that v'_A must stay outside of (an obstacle, a line) or inside of (a disc). Boundaries are
/// drawn `slack` on the safe side, and tests allow half of it. So a point of a boundary passes the
/// test of that boundary for any rounding, and is safe.
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

/// The largest change of the clearance per m/s of v_new: g(τ) for an obstacle.
double steepness(const Limit& limit);

/// The depth of v_new in the forbidden set, m/s; 0 if it is outside.
double violation(const Limit& limit, Vec2 v_new);

/// Appends the limits of one mover: its obstacle, or a line if the pair overlaps; none if it is out
/// of reach of both discs.
void append_limit(const PassiveObstacle& mover, const Disc& acceleration, const Disc& speed,
                  std::vector<Limit>& limits);

/// Appends a half-plane that v'_A must stay in.
void append_limit(const HalfPlane& plane, std::vector<Limit>& limits);

/// Appends a disc that v'_A must stay in; nothing if its radius is infinite.
void append_limit(const Disc& disc, std::vector<Limit>& limits);

/// The v'_A with the change w = 0.
inline Vec2 unchanged(const Obstacle& obstacle, Vec2 v_new_B) {
  return obstacle.pair.velocity + v_new_B;
}

/// The largest |v' - from| that both discs allow.
double reach_from(Vec2 from, const Disc& acceleration, const Disc& speed);

/// Largest time in (0, high] up to which `holds` is true; it is true at first and then false.
template <typename Holds>
double last_time(double high, const Holds& holds) {
  double low = 0.0;
  for (int k = 0; k < 60; ++k) {
    const double t = 0.5 * (low + high);
    (holds(t) ? low : high) = t;
  }
  return low;
}

}  // namespace avo::inline planner
