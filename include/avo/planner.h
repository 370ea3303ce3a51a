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
#include "avo/plan.h"
#include "avo/planner_options.h"
#include "avo/robot.h"
#include "avo/wall.h"

namespace avo {

struct DecisionTrace;

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
