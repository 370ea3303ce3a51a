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
#include "avo/robot.h"
#include "avo/wall.h"

namespace avo {

/// How new velocities are chosen.
enum class Method : std::uint8_t {
  avo,                ///< the paper's half-planes, a certificate, and rules for arriving
  avo_paper,          ///< the paper alone: acceleration-velocity obstacles, reciprocal half-planes
  velocity_obstacle,  ///< the paper's §III-A: others keep their velocity, v' is adopted at once
  orca,               ///< the limit δ -> 0, δ a_max -> infinity: v' is adopted at once
  orca_clamped,       ///< orca's choice, and of the way there what a_max allows within a step
  reciprocal_velocity_obstacle,  ///< velocity obstacles with their apex between v_A and v_B
  buffered_voronoi,              ///< the robot's Voronoi cell less its radius, braking within it
};

/// True of the methods without acceleration limit and δ: v' is adopted at once.
constexpr bool adopts_at_once(Method method) {
  return method == Method::velocity_obstacle || method == Method::orca ||
         method == Method::reciprocal_velocity_obstacle;
}

/// True of the methods whose v' keeps a_max and is reached at the end of the step: δ is Δt.
constexpr bool reaches_within_step(Method method) {
  return method == Method::orca_clamped || method == Method::buffered_voronoi;
}

/// True of the methods that choose a velocity whatever acceleration it takes to get there.
constexpr bool disregards_acceleration(Method method) {
  return adopts_at_once(method) || method == Method::orca_clamped;
}

/// True of the methods that choose outside the union of all neighbors' obstacles (§III-A).
constexpr bool avoids_union(Method method) {
  return method == Method::velocity_obstacle || method == Method::reciprocal_velocity_obstacle;
}

/// What no decision may break, whatever the half-planes ask for (docs/certificate.md).
enum class Certificate : std::uint8_t {
  none,
  stopping_capsules,     ///< disjoint areas to stop in, whenever
  braking_trajectories,  ///< disjoint places at every time while braking
};

/// What happens between two decisions.
enum class Motion : std::uint8_t {
  held,         ///< the acceleration (v' - v)/δ is held over the step (§III-C's cycle)
  exponential,  ///< Eqs. (8), (9) exactly
};

/// When the robots that a certificate speaks of decide.
enum class Clock : std::uint8_t {
  common,  ///< all at the same times
  free,    ///< each at times of its own, a time_step of its own apart
};

/// Bounds on how far the neighbors are from where, and as fast as, they are sensed.
struct SensingError {
  double position = 0.0;  ///< m, >= 0
  double velocity = 0.0;  ///< m/s, >= 0
  friend constexpr bool operator==(const SensingError&, const SensingError&) = default;
};

/// Gaussian errors of each coordinate of what is sensed, for the half-planes: they keep what the
/// errors exceed with the probability 1 - Φ(quantile) only. Certificates know SensingError instead.
struct SensingNoise {
  double position = 0.0;  ///< [σ_p] m, >= 0
  double velocity = 0.0;  ///< [σ_v] m/s, >= 0
  double quantile = 1.0;  ///< [q] standard deviations, >= 0
  friend constexpr bool operator==(const SensingNoise&, const SensingNoise&) = default;
};

/// As in scene files.
AVO_API const char* to_string(Method method);
AVO_API const char* to_string(Certificate certificate);
AVO_API const char* to_string(Motion motion);
AVO_API const char* to_string(Clock clock);

/// What is customary for a method: δ 2 s, τ 3 s, a response time of 0.1 T and braking_trajectories
/// for avo, the paper's δ 4 s and τ 10 s for the others (§VI-A), which have neither.
constexpr double usual_control_time(Method method) {
  return method == Method::avo ? 2.0 : 4.0;
}
constexpr double usual_time_horizon(Method method) {
  return method == Method::avo ? 3.0 : 10.0;
}
constexpr double usual_response_time(Method method) {
  return method == Method::avo ? 0.1 : 0.0;
}
constexpr Certificate usual_certificate(Method method) {
  return method == Method::avo ? Certificate::braking_trajectories : Certificate::none;
}

/// What a planner is told once; all robots have to agree on what others count on
/// (docs/certificate.md, "What has to be common"). What is customary follows the method that they
/// are made with, PlannerOptions{.method = Method::orca}; a method that is set later changes no
/// other option.
struct PlannerOptions {
  Method method = Method::avo;
  Motion motion = Motion::held;
  /// [δ] s, >= 1e-6 unless v' is adopted at once, Eq. (7); Planner::options() has time_step where
  /// v' is reached within a step.
  double control_time = usual_control_time(method);
  double time_horizon = usual_time_horizon(method);  ///< [τ] s, > 0, Definition 2
  /// [κ] >= 0, of T = v_max/a_max; 0 but with method avo: v' is approached with the time constant
  /// response_time_of(), a wish with twice that one, and the acceleration goes from none to a_max
  /// in 0.8 of it, but where the certificate asks for more (docs/smoothness.md). 0: at once.
  double response_time = usual_response_time(method);
  /// m/s², > 0, of method avo: what is used of a_max but where the certificate asks for more, which
  /// counts on all of a_max; unset: all. Airplanes use all.
  std::optional<double> comfort_acceleration = {};
  /// m/s³, > 0, of method avo: by how much the acceleration changes in a second at most, but where
  /// the certificate asks for more, and where a robot begins to come to rest (docs/smoothness.md);
  /// unset: a_max in 0.8 of the response time.
  std::optional<double> comfort_jerk = {};
  /// [m] m, >= 0; 0 but with method avo: a clearance from others that is wished for beyond the
  /// radius. It fades in narrow places and near the robot's goal, and no promise depends on it
  /// (docs/scenes.md, "Margin").
  double margin = 0.0;
  /// [Δt] s, > 0, <= time_horizon, <= control_time where motion is held, else <= 700 control_time
  double time_step = 0.1;
  int samples = 0;  ///< 0: exact half-planes; 2 to 1000: the paper's boundary samples
  Certificate certificate = usual_certificate(method);  ///< none but with method avo
  /// >= 1: the nearest so many get a half-plane, but those of them that walls keep away; unset:
  /// all. A certificate covers all in any case.
  std::optional<int> max_neighbors = {};
  SensingError sensing_error = {};  ///< of braking_trajectories; each robot declares its own
  SensingNoise sensing_noise = {};  ///< of the half-planes
  /// [ε] m, >= 0: how far the robot may be from where it takes itself to be among the walls, as
  /// long as it senses its neighbors from where it is. A certificate keeps clear of walls all the
  /// same, and needs those that are so much farther away.
  double localization_error = 0.0;
  /// m, >= 0, from the robot's disc: all walls within it are given, where that is farther than
  /// those that the certificate needs; infinite: all of them. The farther, the more ways out a
  /// robot has before movers (docs/movers.md).
  double wall_range = 0.0;
  /// free: motion held, no stopping_capsules (docs/certificate/clocks.md).
  Clock clock = Clock::common;
  /// s, >= 0, of a free clock: the largest time_step that any of the others has; 0: that of this
  /// one.
  double longest_step = 0.0;
  /// m, > 0: of its goal. Beside others, a robot of method avo that has been there rests within 0.9
  /// of it, or, where they leave it no way back, within 3.9 times of it (docs/arrival.md, rule 2).
  double arrival_distance = 0.5;
  /// Of method avo: a mover that keeps to what is known of it touches a robot at rest only, always.
  /// false: where braking comes too late, a robot alone among movers that keep their acceleration
  /// may pass in front of one without being able to stop before it (docs/movers.md, "Rule").
  bool never_swerves = false;
};

/// All that is customary for the method.
AVO_API PlannerOptions default_options(Method method);

/// [T_e] s, the time constant with which a robot of these limits (m/s, m/s²) approaches v':
/// min(max(response_time v_max/a_max, 2 Δt), δ), or a/(0.8 comfort_jerk) where that is more, a
/// being what is used of a_max; 0: at once.
AVO_API double response_time_of(const PlannerOptions& options, double max_speed,
                                double max_acceleration);

/// How a decision was made.
enum class PlanStatus : std::uint8_t {
  /// With method avo, v' is the target that the paper's program chose, see Plan::new_velocity.
  optimal,       ///< v' lies in CA_A: no collision before τ if all do likewise (Definition 4)
  least_unsafe,  ///< CA_A is empty: v' violates it by as little as the limits allow
  candidate,     ///< the certificate refused that choice and admitted another one near it
  braking,       ///< it admitted none but braking, or |v| exceeds v_max by more than a decision
  /// In contact, or braking no longer avoids it, by more than rounding and the declared errors can
  /// feign: an assumption is broken. Plan says with whom; v' separates if it can.
  overlapping,
  invalid_input,  ///< a number known or sensed is not finite or out of range: brakes
};
AVO_API const char* to_string(PlanStatus status);

/// What is proved of a state before anything is decided, against each of the others and each wall
/// by itself (docs/states.md).
enum class SafetyState : std::uint8_t {
  unknown,  ///< neither is proved, or nobody has asked
  safe,     ///< its fallback avoids contact in motion: what the certificate's invariant says
  doomed,   ///< contact is inevitable, whatever A does within its limits
};
AVO_API const char* to_string(SafetyState state);

/// One decision.
struct Plan {
  /// [v'_A] m/s, Eqs. (14), (23). Of method avo, which approaches its target as fast as it may: the
  /// command that leads to the next velocity by Eq. (7); it may lie beyond v_max, which that does
  /// not.
  Vec2 new_velocity = {};
  /// m/s, at the end of the step, of cars too: what to send to a base that takes velocities. 0
  /// where the robot's own velocity or limits are out of range.
  Vec2 next_velocity = {};
  Vec2 acceleration = {};                   ///< [a_A] m/s^2 at the start of the step, Eq. (7)
  PlanStatus status = PlanStatus::optimal;  ///< how the decision was made
  /// Of the state in which it was made, as Planner::state() says; unknown without a certificate.
  SafetyState state = SafetyState::unknown;
  /// Whether what would have been chosen was put aside for a way out: see Planner::evasion().
  bool evading = false;
  /// If overlapping, with whom most deeply: an index into the neighbors given. -1: none, and in a
  /// simulation, which gives it none.
  int neighbor = -1;
  int wall = -1;           ///< or one into the walls given, likewise
  float depth = 0.0F;      ///< m: if overlapping, by how much, see SafetyReport::depth
  double violation = 0.0;  ///< m/s: by how much CA_A is missed; 0 if optimal
};

/// The way out that a robot beside movers takes in place of what it would have chosen
/// (docs/movers.md). It approaches a velocity, and then it brakes to rest.
struct Evasion {
  int neighbor = -1;    ///< index into the neighbors given: who made the robot put its choice aside
  Vec2 velocity = {};   ///< m/s, that the way approaches, or holds; 0: it brakes from the start
  double duration = 0;  ///< s, from the decision, after which it brakes, if nothing else is decided
};

/// A's half-plane against one neighbor, in v'_A, Eqs. (17)-(20).
struct NeighborPlane {
  int neighbor = 0;  ///< index into the neighbors given
  HalfPlane plane;
  double excess = 0.0;  ///< m/s, A's share of RelativeHalfPlane::excess
};

/// The half-planes of one decision.
struct HalfPlanes {
  std::vector<NeighborPlane> planes;  ///< those that cut into what the robot may choose
  bool overlapping = false;           ///< a neighbor is in contact already
};

/// A's half-plane in v'_A against one wall.
struct WallPlane {
  int wall = 0;  ///< index into the walls given
  HalfPlane plane;
  double excess = 0.0;  ///< m/s, by how much more than the acceleration allows it asks for
};

/// The half-planes of walls in one decision.
struct WallPlanes {
  /// Method avo: no more speed towards a wall than braking takes off before it.
  std::vector<WallPlane> speeds;
  /// Of the walls' obstacles: what the other methods choose in. Method avo does not look at them.
  std::vector<WallPlane> obstacles;
  bool overlapping = false;  ///< a wall is in contact already
};

/// What a robot remembers from one decision to the next, to get around a jam and to come to rest.
/// Method avo only. Whoever gives the robot another goal begins anew, but for the congestion.
struct Detour {
  float angle = 0.0F;  ///< rad, how far it has turned off its way, to the right
  /// v_max/a_max, 0 to 200: for how long others have been beside it near its goal; less as it is
  /// alone.
  float beside = 0.0F;
  float congestion = 0.0F;   ///< robots ahead that it is used to, 0 to 2.8
  bool has_arrived = false;  ///< that it was within arrival_distance of its goal, beside others
  /// That others are at rest on its goal, so that it comes to rest near them: it neither gives way,
  /// nor keeps right, nor makes a detour. Who is sent to a goal that others have says so in each
  /// decision (docs/on_board.md).
  bool goal_taken = false;
  /// m/s², of its last step; 0 of one that has not moved
  float acceleration_x = 0.0F, acceleration_y = 0.0F;
};

/// What a neighbor's certificate demands of A on one interval between steps:
/// normal . q >= offset. For braking_trajectories q = y - x, m: from the point x of A's braking
/// path to the point y of its path, sufficient for the three Bézier points of the interval;
/// interval 0 is the step decided upon. For stopping_capsules q is any point of where A would next
/// stop, m; interval is 0.
struct CertificateConstraint {
  int neighbor = 0;  ///< index into the neighbors given
  int interval = 0;
  Vec2 normal;  ///< unit, from B to A
  double offset = 0.0;
};

/// What the certificate demands of A beside one wall: neither its next step nor braking from there
/// on comes nearer to the wall's segment than `held`.
struct WallConstraint {
  int wall = 0;           ///< index into the walls given
  double held = 0.0;      ///< m, of A's center: both radii, or what braking still keeps of them
  double distance = 0.0;  ///< m, of what A needs to stop now, from the segment
  Vec2 normal;            ///< unit, from the segment to there; 0 where they meet
};

/// What Planner::state() proves of a state.
struct SafetyReport {
  SafetyState state = SafetyState::unknown;
  /// If doomed, with whom contact comes first; if unknown, with whom it is in contact most deeply,
  /// or comes to be while all fall back: an index into the neighbors given,
  int neighbor = -1;
  int wall = -1;      ///< or one into the walls given; -1: none
  double time = 0.0;  ///< s: if doomed, when the two are in contact
  /// m, >= 0: by how much the two overlap, or come to while all fall back, for all that the
  /// declared errors may hide. A depth that rounding may feign is told as well (docs/on_board.md,
  /// "Contact").
  double depth = 0.0;
};

/// Scratch memory of a Planner; reuse it and nothing is allocated once it has grown. One per
/// thread. Where memory runs out while it grows, plan() throws std::bad_alloc; it can be used
/// again.
class AVO_API PlanWorkspace {
 public:
  PlanWorkspace();
  ~PlanWorkspace();
  PlanWorkspace(PlanWorkspace&&) noexcept;
  PlanWorkspace& operator=(PlanWorkspace&&) noexcept;

  /// Room for so many neighbors, each of which brakes for so many steps: a crowd that thickens then
  /// allocates nothing, and plan() throws nothing. To plan among obstacles takes more, which comes
  /// as it is needed. Throws std::bad_alloc.
  void reserve(std::size_t neighbors, std::size_t braking_steps);

  struct AVO_LOCAL Scratch;

 private:
  std::unique_ptr<Scratch> scratch_;
};

/// Decides for one robot. Immutable after construction and safe to share between threads: plan()
/// is pure, it knows no time, ids, files or threads. It throws nothing but std::bad_alloc, and only
/// while its workspace grows: see PlanWorkspace::reserve().
class AVO_API Planner {
 public:
  /// Throws Error on options out of range.
  explicit Planner(const PlannerOptions& options);

  /// Reciprocal collision avoidance (§IV-D): neighbors that decide are taken to do so likewise, at
  /// the same times unless PlannerOptions::clock is free. Neighbors may come in any order, which
  /// changes no bit but where two are equally far away; those that come nearest first need not be
  /// sorted. A robot among movers none of which decides plans as in plan_among_obstacles, and so
  /// does any of methods velocity_obstacle and reciprocal_velocity_obstacle. detour: what the robot
  /// remembers, kept by the caller from decision to decision; updated, or unchanged where this
  /// throws. Without one it decides as for the first time. One that is not finite, or out of range,
  /// counts as none. walls: what does not move, near the robot; a certificate keeps clear of it.
  /// The robot needs all whose surface is within r + S Δt + l(S) of its position, and a billionth
  /// more for rounding: S = max(|v|, v_max), l is the stopping length with planned_braking().
  /// Others change no bit. A neighbor that decides and is behind such a wall does not count where
  /// nobody can come round an end of it before both have stopped: it is taken to keep clear of that
  /// wall as well (docs/certificate/walls.md, "Neighbors behind walls"). A wall that is not finite
  /// is invalid_input. Without a certificate walls only slow the target of method avo. The other
  /// methods choose in the half-planes of the walls' obstacles, to which those of neighbors yield;
  /// they need all walls within r + τ max(|v|, v_max), count all neighbors, and promise nothing.
  [[nodiscard]] Plan plan(const Robot& robot, std::span<const Neighbor> neighbors,
                          PlanWorkspace& workspace, Detour* detour = nullptr,
                          std::span<const Wall> walls = {}) const;

  /// One robot among movers that do not react (§III-C, Eqs. 13-14): v' outside the union of their
  /// obstacles, B's new velocity being v_B + δ a_B with the acceleration that the neighbor gives.
  /// They touch it at rest only, as long as they keep that acceleration; with neighbors that call
  /// plan() nothing is promised (docs/certificate/movers.md). Method buffered_voronoi, which has
  /// no obstacles, plans as plan() does with all of them moving on.
  [[nodiscard]] Plan plan_among_obstacles(const Robot& robot, std::span<const Neighbor> obstacles,
                                          PlanWorkspace& workspace) const;

  /// The half-planes of plan() with those walls, behind which neighbors may not count; none where
  /// plan() says invalid_input.
  void collect_half_planes(const Robot& robot, std::span<const Neighbor> neighbors,
                           PlanWorkspace& workspace, HalfPlanes& half_planes,
                           std::span<const Wall> walls = {}) const;

  /// Those of walls: of all that are in reach and may cut into what the robot may choose.
  void collect_half_planes(const Robot& robot, std::span<const Wall> walls,
                           WallPlanes& half_planes) const;

  /// Whether the certificate lets the robot have each of these velocities (m/s) at the end of the
  /// step, within its own limits: 1 or 0, in `admitted`, which is as long. Of one that is not
  /// holonomic what it can follow of them is asked about. Without a certificate the limits alone
  /// count; nothing is admitted of an airplane, which falls back on a circle, nor where plan() says
  /// invalid_input.
  void find_admitted(const Robot& robot, std::span<const Neighbor> neighbors,
                     PlanWorkspace& workspace, std::span<const Vec2> next_velocities,
                     std::span<std::uint8_t> admitted, std::span<const Wall> walls = {}) const;

  /// The probability with which v' does not keep the half-plane of where the neighbor truly is, by
  /// Gaussian errors as in PlannerOptions::sensing_noise: that of the largest quantile with which
  /// it keeps the half-plane; 1 where it does not keep the one of what is sensed. 0 without noise.
  /// With half-planes only: not a probability of contact, against which there is the certificate.
  [[nodiscard]] double half_plane_risk(const Robot& robot, const Neighbor& neighbor,
                                       Vec2 new_velocity) const;

  /// The constraints of the certificate that can refuse anything, likewise; none where plan() says
  /// invalid_input.
  void collect_certificate(const Robot& robot, std::span<const Neighbor> neighbors,
                           PlanWorkspace& workspace,
                           std::vector<CertificateConstraint>& constraints,
                           std::span<const Wall> walls = {}) const;
  /// Those of walls, by index; none where there is no certificate.
  void collect_certificate(const Robot& robot, std::span<const Wall> walls,
                           PlanWorkspace& workspace,
                           std::vector<WallConstraint>& constraints) const;

  /// Whether A can go on without contact, as far as that is proved, whatever the method is
  /// (docs/states.md). safe: while A brakes, it touches no wall, none that decides and brakes too,
  /// and in motion none that keeps its acceleration. doomed: within |a| <= a_max and |v| <= v_max
  /// of A it touches one of the walls or of those that keep their acceleration, be it at rest; or
  /// one that decides, even if that does its best too. Declared errors, ages and clocks are allowed
  /// for; without them whatever is not unknown is never both, but beside one that keeps its
  /// acceleration, where doomed is said. unknown where plan() says invalid_input.
  [[nodiscard]] SafetyReport state(const Robot& robot, std::span<const Neighbor> neighbors,
                                   PlanWorkspace& workspace,
                                   std::span<const Wall> walls = {}) const;

  /// What plan() says with Plan::evading: whom A evades, and on which way; none where it does not.
  [[nodiscard]] std::optional<Evasion> evasion(const Robot& robot,
                                               std::span<const Neighbor> neighbors,
                                               PlanWorkspace& workspace,
                                               const Detour* detour = nullptr,
                                               std::span<const Wall> walls = {}) const;

  /// Whether some way out is clear of all who are predicted (docs/movers.md, invariant M), whatever
  /// the others do: A need not be touched by any of them if they keep to what is known of them.
  /// false where plan() says invalid_input, without a certificate, and of models without ways.
  [[nodiscard]] bool has_way_out(const Robot& robot, std::span<const Neighbor> neighbors,
                                 PlanWorkspace& workspace, std::span<const Wall> walls = {}) const;

  /// D(v_A, δ a_max), what the acceleration allows, Eq. (21); without bound (infinite radius) for
  /// methods that disregard it.
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
