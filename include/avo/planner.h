// SPDX-License-Identifier: Apache-2.0
// One robot's decision: from what it senses to its new velocity (paper §III-C, §IV-D).
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "avo/robot.h"

namespace avo {

enum class Method : std::uint8_t {
  avo_paper,          ///< the paper: acceleration-velocity obstacles, reciprocal half-planes
  velocity_obstacle,  ///< the paper's §III-A: others keep their velocity, v' is adopted at once
  orca,               ///< the limit δ -> 0, δ a_max -> infinity: v' is adopted at once
};

/// What happens between two decisions.
enum class Motion : std::uint8_t {
  held,         ///< the acceleration (v' - v)/δ is held over the step (§III-C's cycle)
  exponential,  ///< Eqs. (8), (9) exactly
};

struct PlannerOptions {
  Method method = Method::avo_paper;
  Motion motion = Motion::held;
  double control_time = 4.0;   ///< [δ] s, > 0, Eq. (7)
  double time_horizon = 10.0;  ///< [τ] s, > 0, Definition 2
  double time_step = 0.1;      ///< [Δt] s, > 0, <= control_time where motion is held
  int samples = 0;             ///< 0: exact half-planes; N >= 2: the paper's N boundary samples
};

enum class PlanStatus : std::uint8_t {
  optimal,        ///< v' lies in CA_A: no collision before τ if all do likewise (Definition 4)
  least_unsafe,   ///< CA_A is empty: v' violates it by as little as the limits allow
  overlapping,    ///< a neighbor is in contact already; v' separates as fast as the limits allow
  braking,        ///< |v| exceeds v_max by more than one decision can undo: brakes
  invalid_input,  ///< a number known or sensed is not finite or out of range: brakes
};
const char* to_string(PlanStatus status);

struct Plan {
  Vec2 new_velocity = {};                   ///< [v'_A] m/s, Eqs. (14), (23)
  Vec2 acceleration = {};                   ///< [a_A] m/s^2 at the start of the step, Eq. (7)
  PlanStatus status = PlanStatus::optimal;  ///< how the decision was made
  double violation = 0.0;                   ///< m/s: by how much CA_A is missed; 0 if optimal
};

/// A's half-plane against one neighbor, in v'_A, Eqs. (17)-(20).
struct NeighborPlane {
  int neighbor = 0;  ///< index into the neighbors given
  HalfPlane plane;
  double excess = 0.0;  ///< m/s, A's share of RelativeHalfPlane::excess
};

/// Scratch memory of plan(); reuse it and nothing is allocated once it has grown. One per thread.
class PlanWorkspace {
 public:
  PlanWorkspace();
  ~PlanWorkspace();
  PlanWorkspace(PlanWorkspace&&) noexcept;
  PlanWorkspace& operator=(PlanWorkspace&&) noexcept;

  std::vector<NeighborPlane> planes;  ///< of the last decision, see Planner::collect_half_planes
  bool overlapping = false;           ///< a neighbor of the last decision is in contact already

 private:
  friend class Planner;
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

class Horizon;

/// Decides for one robot. Immutable after construction and safe to share between threads: plan()
/// is pure, it knows no time, ids, files or threads.
class Planner {
 public:
  /// Throws Error on options out of range.
  explicit Planner(const PlannerOptions& options);

  /// Reciprocal collision avoidance (§IV-D): neighbors with max_acceleration > 0 are taken to
  /// decide likewise, with the same δ. Nearest first is the canonical order of `neighbors`.
  /// method velocity_obstacle treats all of them as in plan_among_obstacles.
  [[nodiscard]] Plan plan(const Robot& robot, std::span<const Neighbor> neighbors,
                          PlanWorkspace& workspace) const noexcept;

  /// One robot among movers that do not react (§III-C, Eqs. 13-14): v' outside the union of their
  /// obstacles, B's new velocity being v_B + δ a_B with the acceleration that the neighbor gives.
  [[nodiscard]] Plan plan_among_obstacles(const Robot& robot, std::span<const Neighbor> obstacles,
                                          PlanWorkspace& workspace) const noexcept;

  /// The half-planes of plan() that cut into what the robot may choose, into workspace.planes.
  void collect_half_planes(const Robot& robot, std::span<const Neighbor> neighbors,
                           PlanWorkspace& workspace) const;

  /// D(v_A, δ a_max), what the acceleration allows, Eq. (21); for orca without bound (infinite
  /// radius).
  [[nodiscard]] Disc acceleration_disc(const Robot& robot) const;
  /// D(0, v_max).
  [[nodiscard]] Disc speed_disc(const Robot& robot) const;

  /// The part of v' - v that one step turns into velocity: Δt/δ (held), 1 - e^{-Δt/δ}
  /// (exponential), 1 where v' is adopted at once.
  [[nodiscard]] double step_rate() const;
  /// Lag of one step, s: a step from v to v_1 moves by s v + (Δt - s) v_1.
  [[nodiscard]] double step_lag() const;
  [[nodiscard]] const PlannerOptions& options() const { return options_; }

 private:
  Plan finish(const Robot& robot, Vec2 new_velocity, PlanStatus status,
              double violation) const noexcept;
  Plan brake(const Robot& robot, PlanStatus status, double violation) const noexcept;

  PlannerOptions options_;
  std::shared_ptr<const Horizon> horizon_;  // tables of (δ, τ)
};

}  // namespace avo
