// SPDX-License-Identifier: Apache-2.0
// One robot's decision: from what it senses to its new velocity (paper §III-C, §IV-D).
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "avo/export.h"
#include "avo/geometry.h"
#include "avo/horizon.h"
#include "avo/method.h"
#include "avo/robot.h"
#include "avo/wall.h"

namespace avo {

struct DecisionTrace;

/// How the velocity changes between two decisions.
enum class Motion : std::uint8_t {
  held,         ///< the acceleration (v' - v)/δ is held over the step (§III-C's cycle)
  exponential,  ///< Eqs. (8), (9) exactly
};

/// When the robots under a certificate decide.
enum class Clock : std::uint8_t {
  common,  ///< all at the same times
  free,    ///< each robot at its own times, one time_step of its own apart
};

/// Bounds on the errors of the positions and velocities that are sensed of neighbors.
struct SensingError {
  double position = 0.0;  ///< m, >= 0
  double velocity = 0.0;  ///< m/s, >= 0
  friend constexpr bool operator==(const SensingError&, const SensingError&) = default;
};

/// Gaussian errors of each sensed coordinate, for the half-planes. The half-planes keep a margin
/// that the errors exceed only with the probability 1 - Φ(quantile). Certificates use SensingError
/// instead.
struct SensingNoise {
  double position = 0.0;  ///< [σ_p] m, >= 0
  double velocity = 0.0;  ///< [σ_v] m/s, >= 0
  double quantile = 1.0;  ///< [q] standard deviations, >= 0
  friend constexpr bool operator==(const SensingNoise&, const SensingNoise&) = default;
};

/// Returns the name that scene files use.
AVO_API const char* to_string(Motion motion);
AVO_API const char* to_string(Clock clock);

/// Options that a planner is given once. All robots must agree on the options that others count on
/// (docs/certificate.md, "What has to be common"). The usual values follow the method at
/// construction, PlannerOptions{.method = Method::orca}; a method that is set later changes no
/// other option.
struct PlannerOptions {
  Method method = Method::avo;
  Motion motion = Motion::held;
  /// [δ] s, >= 1e-6 unless v' is adopted at once, Eq. (7). Where v' is reached within a step,
  /// Planner::options() has time_step here.
  double control_time = usual_control_time(method);
  double time_horizon = usual_time_horizon(method);  ///< [τ] s, > 0, Definition 2
  /// [κ] >= 0, in units of T = v_max/a_max; 0 except with method avo. The robot approaches v' with
  /// the time constant response_time_of(), and its preferred velocity with twice that time
  /// constant. The acceleration rises from 0 to a_max in 0.8 of the time constant. The certificate
  /// may ask for more (docs/smoothness.md). 0: v' is adopted at once.
  double response_time = usual_response_time(method);
  /// m/s², > 0, of method avo: the part of a_max that is used unless the certificate asks for more.
  /// The certificate counts on all of a_max. Unset: all. Airplanes use all.
  std::optional<double> comfort_acceleration = {};
  /// m/s³, > 0, of method avo: the largest change of the acceleration in a second. Exceptions are a
  /// certificate that asks for more, and a robot that begins to come to rest (docs/smoothness.md).
  /// Unset: a_max in 0.8 of the response time.
  std::optional<double> comfort_jerk = {};
  /// [m] m, >= 0; 0 except with method avo: the clearance from others that is preferred beyond the
  /// radius. It fades in narrow places and near the robot's goal, and no promise depends on it
  /// (docs/scenes.md, "Margin").
  double margin = 0.0;
  /// [Δt] s, > 0, <= time_horizon, <= control_time where motion is held, else <= 700 control_time
  double time_step = 0.1;
  /// none except with method avo, and with methods that reach v' within a step
  Certificate certificate = usual_certificate(method);
  /// >= 1: only the nearest so many neighbors get a half-plane, except neighbors that walls keep
  /// away; unset: all. A certificate covers all neighbors in any case.
  std::optional<int> max_neighbors = {};
  SensingError sensing_error = {};  ///< for braking_trajectories; each robot declares its own error
  SensingNoise sensing_noise = {};  ///< for the half-planes
  /// [ε] m, >= 0: the error of the robot's own position among the walls. The robot must sense its
  /// neighbors relative to its true position. A certificate keeps clear of walls in spite of the
  /// error, and needs the walls that are so much farther away.
  double localization_error = 0.0;
  /// m, >= 0, from the robot's disc: all walls within this range are given, where it is farther
  /// than the certificate needs; infinite: all walls. A longer range gives a robot more evasive
  /// maneuvers before movers (docs/movers.md).
  double wall_range = 0.0;
  /// free: motion held (docs/certificate/clocks.md).
  Clock clock = Clock::common;
  /// s, >= 0, with a free clock: the largest time_step of any other robot; 0: the time_step of this
  /// robot.
  double longest_step = 0.0;
  /// m, > 0, of the robot's goal. Beside others, a robot of method avo that has been there rests
  /// within 0.9 of this distance. It rests within 3.9 of this distance where the others leave it no
  /// route back (docs/arrival.md, rule 2).
  double arrival_distance = 0.5;
  /// For method avo. true: a mover that moves as predicted touches a robot only at rest, always.
  /// false: where braking comes too late, a robot alone among movers that keep their acceleration
  /// may pass in front of a mover. It may then be unable to stop before the mover (docs/movers.md,
  /// "Rule").
  bool never_swerves = false;
};

/// Returns the usual options of the method.
AVO_API PlannerOptions default_options(Method method);

/// [T_e] s, the time constant with which a robot of these limits (m/s, m/s²) approaches v'. It is
/// min(max(response_time v_max/a_max, 2 Δt), δ), or a/(0.8 comfort_jerk) where that is more; a is
/// the used part of a_max. 0: v' is adopted at once.
AVO_API double response_time_of(const PlannerOptions& options, double max_speed,
                                double max_acceleration);

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

/// Scratch memory of a Planner; reuse it, and nothing is allocated once it has grown. Use one per
/// thread. Where memory runs out while it grows, plan() throws std::bad_alloc; the workspace can be
/// used again.
class AVO_API PlanWorkspace {
 public:
  PlanWorkspace();
  ~PlanWorkspace();
  PlanWorkspace(PlanWorkspace&&) noexcept;
  PlanWorkspace& operator=(PlanWorkspace&&) noexcept;

  /// Reserves room for so many neighbors, each of which brakes for so many steps. A crowd that
  /// grows then allocates nothing, and plan() throws nothing. Planning among obstacles needs more
  /// memory, which is allocated on demand. Throws std::bad_alloc.
  void reserve(std::size_t neighbors, std::size_t braking_steps);

  struct AVO_LOCAL Scratch;

 private:
  std::unique_ptr<Scratch> scratch_;
};

/// Decides for one robot. Immutable after construction and safe to share between threads: plan() is
/// pure, it knows no time, ids, files or threads. It throws nothing but std::bad_alloc, and only
/// while its workspace grows: see PlanWorkspace::reserve().
class AVO_API Planner {
 public:
  /// Throws Error on options out of range.
  explicit Planner(const PlannerOptions& options);

  /// Reciprocal collision avoidance (§IV-D). Neighbors that decide are assumed to plan
  /// reciprocally, at the same times unless PlannerOptions::clock is free. Neighbors may come in
  /// any order; the order changes bits only where two are equally far away. Neighbors in ascending
  /// order of distance need not be sorted. A robot among movers only, except an airplane, plans as
  /// in plan_among_movers, and so does any robot of methods velocity_obstacle and
  /// reciprocal_velocity_obstacle.
  ///
  /// detour: the memory of the robot, kept by the caller from decision to decision; updated, or
  /// unchanged where this throws. Without it the robot decides as for the first time. A detour that
  /// is not finite, or out of range, counts as none.
  ///
  /// walls: what does not move, near the robot; a certificate keeps clear of it. The robot needs
  /// all walls with a surface within r + S Δt + l(S) of its position, and a billionth more for
  /// rounding. S = max(|v|, v_max), l is the stopping length with planned_braking(). Other walls
  /// change no bit. A neighbor B that decides and is behind such a wall does not count if B cannot
  /// come round its ends before both have stopped. B is assumed to keep clear of that wall as well
  /// (docs/certificate/walls.md, "Neighbors behind walls"). A wall that is not finite is
  /// invalid_input.
  ///
  /// Without a certificate walls only slow the target of method avo. The other methods choose in
  /// the half-planes of the walls' obstacles, to which those of neighbors yield. They need all
  /// walls within r + τ max(|v|, v_max), count all neighbors, and promise nothing.
  [[nodiscard]] Plan plan(const Robot& robot, std::span<const Neighbor> neighbors,
                          PlanWorkspace& workspace, Detour* detour = nullptr,
                          std::span<const Wall> walls = {}) const;

  /// plan() with every stage of the decision (avo/decision_trace.h). Takes about twice as long, and
  /// allocates.
  [[nodiscard]] DecisionTrace explain(const Robot& robot, std::span<const Neighbor> neighbors,
                                      PlanWorkspace& workspace, Detour* detour = nullptr,
                                      std::span<const Wall> walls = {}) const;

  /// Plans for one robot among movers that do not react (§III-C, Eqs. 13-14). v' is outside the
  /// union of their obstacles. The new velocity of a mover B is v_B + δ a_B, with the acceleration
  /// that the Neighbor has. Movers touch the robot only at rest, as long as they keep that
  /// acceleration. Nothing is promised with neighbors that call plan()
  /// (docs/certificate/movers.md). Method buffered_voronoi has no obstacles, and airplanes only
  /// turn: both plan as plan() does with all of them moving on.
  [[nodiscard]] Plan plan_among_movers(const Robot& robot, std::span<const Neighbor> movers,
                                       PlanWorkspace& workspace) const;

  /// Collects the half-planes of plan() with those walls, behind which neighbors may not count;
  /// none where plan() says invalid_input.
  void collect_half_planes(const Robot& robot, std::span<const Neighbor> neighbors,
                           PlanWorkspace& workspace, HalfPlanes& half_planes,
                           std::span<const Wall> walls = {}) const;

  /// Collects the half-planes of walls: of all walls in reach that may cut into the velocities that
  /// the robot may choose.
  void collect_half_planes(const Robot& robot, std::span<const Wall> walls,
                           WallPlanes& half_planes) const;

  /// Finds whether the certificate lets the robot have each of these velocities (m/s) at the end of
  /// the step, within its own limits. `admitted` has 1 or 0 for each velocity, and is as long. For
  /// a robot that is not holonomic, the part that it can follow is judged. Without a certificate
  /// the limits alone count. Nothing is admitted for an airplane, which falls back on a circle, nor
  /// where plan() says invalid_input.
  void find_admitted(const Robot& robot, std::span<const Neighbor> neighbors,
                     PlanWorkspace& workspace, std::span<const Vec2> next_velocities,
                     std::span<std::uint8_t> admitted, std::span<const Wall> walls = {}) const;

  /// Returns the probability that v' violates the half-plane of the neighbor's true state, by
  /// Gaussian errors as in PlannerOptions::sensing_noise. It is the probability of the largest
  /// quantile with which v' keeps the half-plane. It is 1 where v' violates the half-plane of the
  /// sensed state, and 0 without noise. It applies to half-planes only, and is no probability of
  /// contact; the certificate is there against contact.
  [[nodiscard]] double half_plane_risk(const Robot& robot, const Neighbor& neighbor,
                                       Vec2 new_velocity) const;

  /// Collects the constraints of the certificate that can refuse a velocity; none where plan() says
  /// invalid_input.
  void collect_certificate(const Robot& robot, std::span<const Neighbor> neighbors,
                           PlanWorkspace& workspace,
                           std::vector<CertificateConstraint>& constraints,
                           std::span<const Wall> walls = {}) const;
  /// Collects the constraints of walls, by index; none where there is no certificate.
  void collect_certificate(const Robot& robot, std::span<const Wall> walls,
                           PlanWorkspace& workspace,
                           std::vector<WallConstraint>& constraints) const;

  /// Returns whether A can go on without contact, as far as that is proved, whatever the method is
  /// (docs/states.md).
  ///
  /// safe: while A brakes, it touches no wall and no robot that decides and brakes too. It touches
  /// no mover that keeps its acceleration while A is in motion.
  ///
  /// doomed: for any motion of A within |a| <= a_max and |v| <= v_max, A touches a wall or a mover
  /// that keeps its acceleration, even at rest. Or A touches a robot that decides, even if that
  /// robot does its best too.
  ///
  /// unknown: neither is proved, or plan() says invalid_input.
  ///
  /// Declared errors, ages and clocks are allowed for. Without them no state is both safe and
  /// doomed, except beside a mover that keeps its acceleration: doomed is said then.
  [[nodiscard]] SafetyReport state(const Robot& robot, std::span<const Neighbor> neighbors,
                                   PlanWorkspace& workspace,
                                   std::span<const Wall> walls = {}) const;

  /// Returns the evasive maneuver behind Plan::evading: the mover that A evades, and the evasive
  /// maneuver that it takes; none where A evades nothing.
  [[nodiscard]] std::optional<Evasion> evasion(const Robot& robot,
                                               std::span<const Neighbor> neighbors,
                                               PlanWorkspace& workspace,
                                               const Detour* detour = nullptr,
                                               std::span<const Wall> walls = {}) const;

  /// Returns whether some evasive maneuver is clear of all predicted neighbors (docs/movers.md,
  /// invariant M), whatever the others do. No predicted neighbor need then touch A if it moves as
  /// predicted. false where plan() says invalid_input, and without a certificate.
  [[nodiscard]] bool has_evasive_maneuver(const Robot& robot, std::span<const Neighbor> neighbors,
                                          PlanWorkspace& workspace,
                                          std::span<const Wall> walls = {}) const;

  /// Returns what others have to know of a robot with a footprint: Neighbor::ahead and
  /// Neighbor::spread. A car brakes along its heading. A differential drive may turn meanwhile.
  [[nodiscard]] BrakingPose braking_pose(const Robot& robot) const;

  /// D(v_A, δ a_max), the velocities that the acceleration allows, Eq. (21); without bound
  /// (infinite radius) for methods that disregard it.
  [[nodiscard]] Disc acceleration_disc(const Robot& robot) const;
  /// D(0, v_max).
  [[nodiscard]] Disc speed_disc(const Robot& robot) const;

  /// The part of v' - v that one step turns into velocity: Δt/δ (held), 1 - e^{-Δt/δ}
  /// (exponential), 1 where v' is adopted at once.
  [[nodiscard]] double step_rate() const;
  /// Lag of one step, s: a step from v to v_1 moves by s v + (Δt - s) v_1.
  [[nodiscard]] double step_lag() const;
  [[nodiscard]] const PlannerOptions& options() const { return options_; }
  /// The tables of (δ, τ) for half_plane().
  [[nodiscard]] const Horizon& horizon() const { return *horizon_; }

 private:
  PlannerOptions options_;
  std::shared_ptr<const Horizon> horizon_;
};

}  // namespace avo
