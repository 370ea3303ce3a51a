// SPDX-License-Identifier: Apache-2.0
// Two robots that may have to brake for each other: how far each moves, and the margin for
// rounding.
#pragma once
#include <algorithm>

#include "avo/robot.h"
#include "certificate/braking_path.h"
#include "certificate/deepest.h"
#include "core/vector_of.h"

namespace avo::inline certificate {

/// The point of a segment nearest to the origin; odd in (a, b), bit for bit.
inline Vec2 nearest_on_segment(Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double length_squared = norm_squared(ab);
  if (!(length_squared > 0.0)) return a;
  return a + std::clamp(-dot(a, ab) / length_squared, 0.0, 1.0) * ab;
}

/// A robot that brakes.
template <int D>
struct BrakingOf {
  BrakingProfile profile;
  double increment = 0.0;  ///< [u_a] m/s, see increment()
  VectorOf<D> direction;   ///< unit, or 0 at rest
  double length = 0.0;     ///< [l] m until rest
  double reach = 0.0;      ///< m, the radius that no candidate's path leaves
  /// number of intervals in which the robot or one of its candidates may move
  double intervals = 0.0;
};
using Braking = BrakingOf<2>;
Braking braking_of(Vec2 velocity, const Ability& ability, const StepLaw& law);

/// The largest distance of any candidate's path from A's braking path, m, by interval: ahead of A's
/// direction, to a side of it, and in any direction. It grows with the distance that braking from
/// the candidates' largest speed has covered at the start of the interval. For `ahead` only the
/// excess over the least speed of the candidates counts.
struct Deviation {
  struct Line {
    double start = 0.0, per_distance = 0.0;
  };
  Line ahead, across, anyhow;
  BrakingProfile fast, slow;
  /// maxima over all intervals: ahead; across and in any direction
  double most_ahead = 0.0, most_aside = 0.0;
};

/// Pairs with more braking intervals than this are not computed: the robot brakes for them.
inline constexpr double kMostIntervals = 65536.0;

/// Robot A and one neighbor B. Each value on which both must agree is odd in the exchange of the
/// two, bit for bit.
template <int D>
struct BrakingPairOf {
  VectorOf<D> p;    ///< [p_A - p_B] m
  double contact;   ///< [r_A + r_B] m
  double inflated;  ///< m, contact and a margin for all rounding (docs/certificate/rounding.md)
  double error;     ///< [e] m, the largest error of B's path relative to the sensed one, at its end
  double
      /// [β] A's share of the free gap, room_share(), 1 against a neighbor that does not decide
      share;
  bool decides;  ///< whether B decides
  BrakingOf<D> a, b;
};
using BrakingPair = BrakingPairOf<2>;
BrakingPair braking_pair(const Robot& robot, const Neighbor& neighbor, const Braking& a,
                         const StepLaw& law);

/// m/s²: the largest difference of the neighbor's acceleration from the one used for extrapolation.
double top_acceleration(const Neighbor& neighbor);

/// The error of the given state of the neighbor: by the errors that A declares, and by any motion
/// since it was sensed (docs/certificate/errors.md, "Age").
SensingError error_against(const Neighbor& neighbor, const StepLaw& law);

/// Returns whether no candidates of the two, followed by braking, can bring them into contact.
bool cannot_meet(const BrakingPair& pair, const Neighbor& neighbor, const StepLaw& law);

/// Returns whether two robots in contact, at that distance, are so deep that they nearly coincide.
inline bool nearly_coincide(double distance, double contact) {
  return distance < 0.5 * contact;
}

/// The state of a robot's pairs before it decides.
struct Invariant {
  /// m, the least distance beyond contact while all brake, over pairs and intervals that are near
  /// enough to refuse a candidate; infinite if there is none
  double slack = 0.0;
  Deepest broken =
      /// the deepest neighbor with which braking collides, with the possible errors subtracted
      {};
  /// A neighbor that does not decide is in contact, or braking does not avoid it: brake, and stay
  /// at rest.
  bool touched = false;
  bool unknown = false;   ///< a neighbor brakes for longer than kMostIntervals: brake
  bool doubtful = false;  ///< braking collides, or errors may hide that it does
};

/// Returns the distance that the pair must keep from now on: contact where possible, and the
/// distance that braking keeps where braking cannot keep contact. It also updates the invariant.
template <int D>
double held_distance(const BrakingPairOf<D>& pair, double distance, int index,
                     Invariant& invariant) {
  invariant.slack = std::min(invariant.slack, distance - pair.contact);
  if (!(distance < pair.contact + pair.error)) return pair.inflated;
  invariant.doubtful = true;
  if (!(distance < pair.contact - pair.error)) return pair.inflated;
  invariant.broken.take(index, (pair.contact - pair.error) - distance);
  return distance;
}

}  // namespace avo::inline certificate
