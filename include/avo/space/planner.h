// SPDX-License-Identifier: Apache-2.0
// One robot's decision in space: from what it senses to its new velocity (docs/space.md). SI units.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "avo/export.h"
#include "avo/horizon.h"
#include "avo/planner.h"
#include "avo/space/box.h"
#include "avo/space/mover.h"
#include "avo/space/robot.h"

namespace avo::space {

/// One decision.
struct Plan {
  /// [v'_A] m/s, Eqs. (14), (23): the command that leads to next_velocity by Eq. (7)
  Vec3 new_velocity = {};
  Vec3 next_velocity = {};                  ///< m/s, at the end of the step
  Vec3 acceleration = {};                   ///< [a_A] m/s^2 at the start of the step, Eq. (7)
  PlanStatus status = PlanStatus::optimal;  ///< how the decision was made
  /// safe: while all robots brake, A touches no robot that decides and no box, and plan() names no
  /// contact. unknown: otherwise, and without a certificate
  SafetyState state = SafetyState::unknown;
  /// If overlapping, index of the deepest neighbor, in the neighbors given. -1: none. In a
  /// simulation it is -1, because no list is given: see Simulation::touched().
  int neighbor = -1;
  int box = -1;            ///< or index of the box, in the boxes given; -1: none
  int mover = -1;          ///< or index of the moving obstacle, also at rest; -1: none
  float depth = 0.0F;      ///< m: the overlap, if overlapping
  double violation = 0.0;  ///< m/s: the distance of v' from CA_A; 0 if optimal
  bool evading = false;    ///< an evasive maneuver has replaced the robot's own choice
};

/// What a robot remembers from one decision to the next, see avo::Detour. If the robot gets another
/// goal, the memory must begin anew, except the congestion.
struct Detour {
  float angle = 0.0F;        ///< rad, how far the robot has turned off its route, to the right
  float beside = 0.0F;       ///< v_max/a_max, 0 to 200: how long others have been beside it
  float congestion = 0.0F;   ///< number of robots ahead that it is used to, 0 to 2.8
  bool has_arrived = false;  ///< whether it was within arrival_distance of its goal, beside others
  /// Whether others are at rest on its goal. Such a robot goes to a place near the goal, without
  /// the rules 1, 2 and 3. Without a preferred velocity it brakes until it rests, whatever pushes
  /// it.
  bool goal_taken = false;
  Vec3 acceleration = {};  ///< m/s², of its last step; 0 for a robot that has not moved
};

/// Scratch memory of a Planner; reuse it, and nothing is allocated once it has grown. Use one per
/// thread.
class AVO_API PlanWorkspace {
 public:
  PlanWorkspace();
  ~PlanWorkspace();
  PlanWorkspace(PlanWorkspace&&) noexcept;
  PlanWorkspace& operator=(PlanWorkspace&&) noexcept;

  struct AVO_LOCAL Scratch;

 private:
  friend class Planner;
  std::unique_ptr<Scratch> scratch_;
};

struct DecisionTrace;

/// Decides for one robot of space. Immutable after construction and safe to share between threads.
class AVO_API Planner {
 public:
  /// Throws Error on options out of range, and on options that space does not have. These are a
  /// method other than avo, a free clock, and noise for the half-planes.
  explicit Planner(const PlannerOptions& options);

  /// Reciprocal collision avoidance (§IV-D) in space. All neighbors are assumed to decide at the
  /// same times, by the same options.
  ///
  /// detour: the memory of the robot, kept by the caller from decision to decision; without it the
  /// robot decides as for the first time.
  ///
  /// boxes: those within box_range() of the robot, which it does not touch. Farther boxes change no
  /// bit. Beside moving obstacles: those within PlannerOptions::wall_range as well, if that is
  /// more.
  ///
  /// movers: the moving obstacles. While they move as assumed, they touch the robot at rest only.
  /// Where the robot has had an evasive maneuver, they do not touch it at all (docs/space.md,
  /// "Moving obstacles").
  [[nodiscard]] Plan plan(const Robot& robot, std::span<const Neighbor> neighbors,
                          PlanWorkspace& workspace, Detour* detour = nullptr,
                          std::span<const Box> boxes = {},
                          std::span<const Mover> movers = {}) const;

  /// The same decision with its stages (avo/space/decision_trace.h), which it tells while it is
  /// made. The detour changes as by plan().
  [[nodiscard]] DecisionTrace explain(const Robot& robot, std::span<const Neighbor> neighbors,
                                      PlanWorkspace& workspace, Detour* detour = nullptr,
                                      std::span<const Box> boxes = {},
                                      std::span<const Mover> movers = {}) const;

  /// Returns whether the certificate lets the robot have that velocity (m/s) at the end of the
  /// step, within its own limits.
  [[nodiscard]] bool is_admitted(const Robot& robot, std::span<const Neighbor> neighbors,
                                 PlanWorkspace& workspace, Vec3 next_velocity,
                                 std::span<const Box> boxes = {},
                                 std::span<const Mover> movers = {}) const;

  [[nodiscard]] const PlannerOptions& options() const { return options_; }

  /// s: within a step of time_step, a robot moves as if it had its old velocity for so long, and
  /// next_velocity for the rest.
  [[nodiscard]] double step_lag() const;

 private:
  PlannerOptions options_;
  std::vector<Horizon> horizons_;
};

/// [τ_A] s: the horizon of the half-spaces of neighbors. Near its goal it is as short as half of
/// PlannerOptions::time_horizon.
AVO_API double own_time_horizon(const Robot& robot, const PlannerOptions& options);

/// m, from the robot's ball: boxes at a larger distance change nothing.
AVO_API double box_range(const Robot& robot, const PlannerOptions& options);

/// m: how far from its place a robot's evasive maneuvers may lead.
AVO_API double evasion_range(const Robot& robot);

/// m, between centers: within this distance the robot has to sense a moving obstacle, so that it
/// can be at rest when the obstacle comes.
AVO_API double sensing_range(const Robot& robot, const Mover& mover, const PlannerOptions& options);

/// m, between centers: the distance within which the robot has to sense a neighbor of these limits,
/// whatever their velocities.
AVO_API double sensing_range(const Robot& robot, const Robot& other, const PlannerOptions& options);

}  // namespace avo::space
