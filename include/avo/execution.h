// SPDX-License-Identifier: Apache-2.0
// A base that executes velocity commands late, in steps, or not below some speed. It declares this,
// and bounds say how far it is from the decided motion. Commands keep it within these bounds
// (docs/certificate/execution.md). SI units.
#pragma once
#include <memory>

#include "avo/export.h"
#include "avo/planner.h"
#include "avo/robot.h"
#include "avo/vec.h"

namespace avo {

/// How a base executes velocity commands: T dv/dt = w(t - d) + e - v, with the command w and an
/// error |e| <= velocity_error. T and d are constant, and known with the errors given. Each
/// coordinate is executed by itself: x and y of a holonomic base, the wheels of a differential
/// drive.
struct ExecutionModel {
  double time_constant = 0.0;        ///< [T] s, >= 0, of the velocity's first-order lag
  double time_constant_error = 0.0;  ///< [ΔT] s, 0 to T
  double dead_time = 0.0;            ///< [d] s, >= 0, from command to effect; <= 1000 time steps
  double dead_time_error = 0.0;      ///< [Δd] s, 0 to d
  double deadband = 0.0;        ///< [v_d] m/s, >= 0: the base executes a slower coordinate as 0
  double quantum = 0.0;         ///< [q] m/s, >= 0: coordinates are whole multiples; 0: any
  double velocity_error = 0.0;  ///< [e] m/s, >= 0: slip, scale, and all that is not above
  /// [h] s, >= 0, of a differential drive: how old the heading of drive_command() is at most while
  /// the wheels execute the command
  double heading_age = 0.0;
  /// [μ_p] m, [μ_v] m/s, >= 0: how wrong the measured position and velocity of the body may be
  double measured_position_error = 0.0, measured_velocity_error = 0.0;
  friend constexpr bool operator==(const ExecutionModel&, const ExecutionModel&) = default;
};

/// How far a base is from its reference at most, if ReferenceTracker commands it.
struct ExecutionError {
  double position = 0.0;  ///< [ε] m: the robot's disc is larger by this, for itself and for others
  double velocity = 0.0;  ///< [η] m/s: others that sense the base add both to their SensingError
  double command = 0.0;   ///< m/s: the base, or each wheel, must accept commands of this speed
};

/// The bounds for a holonomic robot or a differential drive of these limits (docs/on_board.md,
/// "Bases that do not execute exactly"). Throws Error on values out of range, on other robots, and
/// where the base is known too badly for a bound. For a bound, 2 ΔT/max(Δt, T - ΔT) + 2 Δd/Δt must
/// be below 1. A drive must not turn too fast for heading_age and ΔT.
AVO_API ExecutionError execution_error(const ExecutionModel& model, const Robot& robot,
                                       double time_step);

/// What a base is told for the next time_step.
struct BaseCommand {
  /// [w] m/s: a holonomic base gets this velocity, a differential drive gets drive_command() of it
  Vec2 velocity = {};
  Vec2 next_reference = {};  ///< m, where the reference is at the next decision
  /// m/s, its velocity then. Others that are told both have no error of this robot to declare.
  Vec2 next_velocity = {};
  double deviation = 0.0;  ///< [|p_body - p_reference|] m, at the decision
  /// Whether the deviation was more than ExecutionError::position and μ_p. The reference then
  /// begins anew at the body. Nothing is promised to others until the robot has been at rest.
  bool has_left = false;
};

/// What a differential drive is told.
struct DriveCommand {
  double speed = 0.0;         ///< m/s, of the middle of its axle
  double turning_rate = 0.0;  ///< rad/s, counter-clockwise
};
/// Turns a command into those of both wheels, which the wheels can execute. To be called at each
/// cycle of the wheels' controller, with the present body. Throws Error unless body.model is
/// a differential drive.
AVO_API DriveCommand drive_command(const ExecutionModel& model, const Robot& body, Vec2 velocity);

/// Keeps the reference of one robot, and makes its base follow the reference. The reference moves
/// exactly as decided. It begins at the body, and never returns to it while the deviation is within
/// ExecutionError::position.
class AVO_API ReferenceTracker {
 public:
  /// Throws Error on values out of range, and unless motion is held.
  ReferenceTracker(const ExecutionModel& model, const Planner& planner);
  ~ReferenceTracker();
  ReferenceTracker(ReferenceTracker&&) noexcept;
  ReferenceTracker& operator=(ReferenceTracker&&) noexcept;

  /// The robot to plan for in place of the measured body. It has the state of the reference, the
  /// heading of the body, and a radius larger by ExecutionError::position. Throws Error as
  /// execution_error() does.
  [[nodiscard]] Robot reference(const Robot& body) const;
  /// The command for the plan that was made for reference(body): to be called once every time_step.
  BaseCommand follow(const Robot& body, const Plan& plan);
  /// The reference begins anew at the body, as when the robot was moved by hand.
  void forget();
  /// For the largest limits that the robot has had so far.
  [[nodiscard]] ExecutionError error(const Robot& body) const;

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo
