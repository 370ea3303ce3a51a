// SPDX-License-Identifier: Apache-2.0
// What one robot has decided, and what it decided by (paper §III-C, §IV-D). SI units.
#pragma once
#include <cstdint>
#include <vector>

#include "avo/export.h"
#include "avo/geometry.h"
#include "avo/vec.h"

namespace avo {

/// How a decision was made.
enum class PlanStatus : std::uint8_t {
  /// With method avo, v' is the target that the paper's program chose, see Plan::new_velocity.
  optimal,       ///< v' lies in CA_A: no collision before τ if all do so (Definition 4)
  least_unsafe,  ///< CA_A is empty: v' violates it by as little as the limits allow
  /// The certificate refused the next velocity towards the target, or that velocity left no evasive
  /// maneuver
  /// from a mover: another one was taken (docs/certificate.md, docs/movers.md).
  refused,
  /// the certificate admitted braking only, or |v| exceeds v_max by more than one decision can
  /// correct
  braking,
  /// The robot is in contact, or braking no longer avoids contact, by more than rounding and the
  /// declared errors can pretend: an assumption is broken. Plan names the other body; v' separates
  /// both if it can.
  overlapping,
  invalid_input,  ///< a known or sensed number is not finite or out of range: the robot brakes
  /// Less than 0.95 of the velocity along the wish is left, or was a while ago. The robot takes
  /// what
  /// the certificate admits, on its route and then farther and farther to the right of it
  /// (docs/arrival.md, rule 3).
  detour,
};
AVO_API const char* to_string(PlanStatus status);

/// What is proved of a state before a decision, against each of the others and each wall by itself
/// (docs/states.md).
enum class SafetyState : std::uint8_t {
  unknown,  ///< neither is proved, or the state was not asked for
  safe,     ///< the robot's fallback avoids contact in motion: this is the certificate's invariant
  doomed,   ///< contact is inevitable, whatever A does within its limits
};
AVO_API const char* to_string(SafetyState state);

/// One decision.
struct Plan {
  /// [v'_A] m/s, Eqs. (14), (23). Method avo approaches its target as fast as it may. Its
  /// new_velocity is the command that leads to the next velocity by Eq. (7). The command may lie
  /// beyond v_max, the next velocity may not.
  Vec2 new_velocity = {};
  /// m/s, at the end of the step, for cars too: send this to a base that takes velocities. It is 0
  /// where the robot's own velocity or limits are out of range.
  Vec2 next_velocity = {};
  Vec2 acceleration = {};                   ///< [a_A] m/s^2 at the start of the step, Eq. (7)
  PlanStatus status = PlanStatus::optimal;  ///< how the decision was made
  /// The state in which the decision was made, as Planner::state() says; unknown without a
  /// certificate.
  SafetyState state = SafetyState::unknown;
  /// Whether the robot takes an evasive maneuver in place of its target: see Planner::evasion().
  bool evading = false;
  /// If overlapping, index of the neighbor with the deepest overlap, in the neighbors given. -1:
  /// none. In a simulation it is -1, because no list is given.
  int neighbor = -1;
  int wall = -1;           ///< or index of the wall, in the walls given; -1: none
  float depth = 0.0F;      ///< m: the overlap, if overlapping, see SafetyReport::depth
  double violation = 0.0;  ///< m/s: the distance of v' from CA_A; 0 if optimal
};

/// The evasive maneuver that a robot beside movers takes in place of its target (docs/movers.md).
/// The robot approaches a velocity, and then it brakes to rest. An airplane circles then.
struct Evasion {
  /// index into the neighbors given: the mover that made the robot reject its target
  int neighbor = -1;
  /// m/s, the velocity that the evasive maneuver approaches, or holds; 0: it brakes from the start.
  /// The velocity of an airplane where it begins to circle
  Vec2 velocity = {};
  /// s, from the decision: the robot then brakes or circles, if nothing else is decided
  double duration = 0;
};

/// A's half-plane against one neighbor, in v'_A, Eqs. (17)-(20).
struct NeighborPlane {
  int neighbor = 0;  ///< index into the neighbors given
  HalfPlane plane;
  double excess = 0.0;  ///< m/s, A's share of RelativeHalfPlane::excess
};

/// The half-planes of one decision.
struct HalfPlanes {
  /// the half-planes that cut into the velocities that the robot may choose
  std::vector<NeighborPlane> planes;
  bool overlapping = false;  ///< a neighbor is in contact already
};

/// A's half-plane in v'_A against one wall.
struct WallPlane {
  int wall = 0;  ///< index into the walls given
  HalfPlane plane;
  double excess = 0.0;  ///< m/s, how much more it asks for than the acceleration allows
};

/// The half-planes of walls in one decision.
struct WallPlanes {
  /// For method avo: the speed towards a wall is at most what braking can take off before it.
  std::vector<WallPlane> speeds;
  /// From the walls' obstacles: the other methods choose in these. Method avo does not read them.
  std::vector<WallPlane> obstacles;
  bool overlapping = false;  ///< a wall is in contact already
};

/// What a robot remembers from one decision to the next, to get around a jam and to come to rest.
/// Method avo only. If the robot gets another goal, the memory must begin anew, except the
/// congestion.
struct Detour {
  float angle = 0.0F;  ///< rad, how far the robot has turned off its route, to the right
  /// v_max/a_max, 0 to 200: how long others have been beside the robot near its goal; it falls
  /// while the robot is alone.
  float beside = 0.0F;
  float congestion = 0.0F;   ///< number of robots ahead that it is used to, 0 to 2.8
  bool has_arrived = false;  ///< whether it was within arrival_distance of its goal, beside others
  /// Whether others are at rest on its goal, so that the robot comes to rest near them. It then
  /// neither yields, nor keeps right, nor makes a detour. A caller that sends a robot to a taken
  /// goal must set this in each decision (docs/on_board.md).
  bool goal_taken = false;
  /// m/s², of its last step; 0 for a robot that has not moved
  float acceleration_x = 0.0F, acceleration_y = 0.0F;
};

/// What a neighbor's certificate demands of A on one interval between steps: normal . q >= offset.
/// q = y - x, m: from the point x of A's braking path to the point y of its path. The constraint
/// suffices for the three Bézier points of the interval; interval 0 is the step of the decision. If
/// the neighbor loiters, q is any point of the area in which A would next stop, m, and interval is
/// 0.
struct CertificateConstraint {
  int neighbor = 0;  ///< index into the neighbors given
  int interval = 0;
  Vec2 normal;  ///< unit, from B to A
  double offset = 0.0;
};

/// What the certificate demands of A beside one wall: neither its next step nor braking after it
/// comes nearer to the wall's segment than `held`.
struct WallConstraint {
  int wall = 0;  ///< index into the walls given
  /// m, for A's center: both radii, or the part of them that braking still keeps
  double held = 0.0;
  double distance = 0.0;  ///< m, from the segment to the area that A needs to stop now
  Vec2 normal;            ///< unit, from the segment to that area; 0 where they meet
};

/// What Planner::state() proves of a state.
struct SafetyReport {
  SafetyState state = SafetyState::unknown;
  /// If doomed, the neighbor with the earliest contact; if unknown, the neighbor with the deepest
  /// present contact, or the deepest contact while all fall back. An index into the neighbors
  /// given,
  int neighbor = -1;
  int wall = -1;      ///< or index of a wall, in the walls given; -1: none
  double time = 0.0;  ///< s: if doomed, the time of contact
  /// m, >= 0: the overlap now, or while all fall back, with the declared errors subtracted. A depth
  /// that rounding may cause is told as well (docs/on_board.md, "Contact").
  double depth = 0.0;
};

/// The heading of a robot with a footprint while it brakes: within `spread` of `ahead`, see
/// Neighbor.
struct BrakingPose {
  Vec2 ahead = {};      ///< unit
  double spread = 0.0;  ///< rad
};

}  // namespace avo
