// SPDX-License-Identifier: Apache-2.0
// Two robots that may have to brake for each other: how far each gets, and what rounding costs.
#pragma once
#include <algorithm>

#include "avo/robot.h"
#include "certificate/braking_path.h"
#include "certificate/deepest.h"

namespace avo::inline certificate {

/// The point of a segment nearest to the origin; odd in (a, b), bit for bit.
inline Vec2 nearest_on_segment(Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double length_squared = norm_squared(ab);
  if (!(length_squared > 0.0)) return a;
  return a + std::clamp(-dot(a, ab) / length_squared, 0.0, 1.0) * ab;
}

/// A robot that brakes.
struct Braking {
  BrakingProfile profile;
  double increment = 0.0;  ///< [u_a] m/s, see increment()
  Vec2 direction;          ///< unit, or 0 at rest
  double length = 0.0;     ///< [l] m until rest
  double reach = 0.0;      ///< m that no candidate's path leaves
  double intervals = 0.0;  ///< in which it or one of its candidates may move
};
Braking braking_of(Vec2 velocity, const Ability& ability, const StepLaw& law);

/// How far any candidate's path gets from A's braking path, m, by interval: ahead and to a side of
/// A's direction, and anyhow, growing with the distance that braking from the candidates' largest
/// speed has covered where the interval begins (ahead: what that is more than for their least).
struct Deviation {
  struct Line {
    double start = 0.0, per_distance = 0.0;
  };
  Line ahead, across, anyhow;
  BrakingProfile fast, slow;
  double most_ahead = 0.0, most_aside = 0.0;  ///< of all intervals: ahead; across and anyhow
};

/// Pairs whose braking takes more intervals than this are not looked at but braked for.
inline constexpr double kMostIntervals = 65536.0;

/// Robot A and one neighbor B. Whatever both must agree on is odd in the exchange of the two, bit
/// for bit.
struct BrakingPair {
  Vec2 p;           ///< [p_A - p_B] m
  double contact;   ///< [r_A + r_B] m
  double inflated;  ///< m, contact and what covers all rounding (docs/certificate/rounding.md)
  double error;     ///< [e] m, most that B's path is off from what is sensed, at its end
  double
      share;  ///< [β] of the free gap that is A's, room_share(), 1 against one that does not decide
  bool decides;  ///< B does
  Braking a, b;
};
BrakingPair braking_pair(const Robot& robot, const Neighbor& neighbor, const Braking& a,
                         const StepLaw& law);

/// m/s²: by which the neighbor's acceleration may differ from the one that it is carried on with.
double top_acceleration(const Neighbor& neighbor);

/// How far the neighbor may be from how it is given: by the errors that A declares, and by whatever
/// else it may have done since it was sensed (docs/certificate/errors.md, "Age").
SensingError error_against(const Neighbor& neighbor, const StepLaw& law);

/// Whether no candidates of the two, followed by braking, can bring them into contact.
bool cannot_meet(const BrakingPair& pair, const Neighbor& neighbor, const StepLaw& law);

/// Whether two in contact, at that distance, are so deep in it that they nearly coincide.
inline bool nearly_coincide(double distance, double contact) {
  return distance < 0.5 * contact;
}

/// The state of a robot's pairs before it decides.
struct Invariant {
  /// m, least distance beyond contact while all brake, of pairs and intervals that are near enough
  /// to refuse anything; infinite if none is
  double slack = 0.0;
  Deepest broken =
      {};  ///< of the neighbors with which braking collides, for all that errors may hide
  /// One that does not decide is in contact, or braking does not avoid it: brake, and stay at rest.
  bool touched = false;
  bool unknown = false;   ///< one brakes for longer than kMostIntervals: brake
  bool doubtful = false;  ///< braking collides, or errors may hide that it does
};

/// The invariant held by a pair, and the distance that it is held to from now on: contact where it
/// can be, and where braking cannot keep that, what braking does keep.
double held_distance(const BrakingPair& pair, double distance, int index, Invariant& invariant);

}  // namespace avo::inline certificate
