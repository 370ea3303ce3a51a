// SPDX-License-Identifier: Apache-2.0
// Quadrotors that follow references of space (docs/space.md, "Quadrotors"). SI units.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/vec3.h"

namespace avo::space {

/// What a quadrotor can do, as far as it limits its reference. The other robots sense, or are told,
/// the reference: the motion that avo::space::Planner plans.
struct Quadrotor {
  double mass = 1.0;                      ///< [m] kg, > 0
  double max_thrust = 20.0;               ///< N, of all rotors, > its weight
  std::optional<double> min_thrust = {};  ///< N, >= 0, < its weight; unset: a tenth of its weight
  double max_tilt = 0.6;                  ///< [θ] rad, > 0, < π/2
  double attitude_time = 0.15;  ///< [T] s, > 0: the mean delay of its acceleration behind a command
  /// [ε] m, >= 0: the largest distance that was measured from the reference of T ago; unset: a_max
  /// T²
  std::optional<double> tracking_error = {};

  friend bool operator==(const Quadrotor&, const Quadrotor&) = default;
};

/// What a quadrotor's reference has to keep to.
struct QuadrotorLimits {
  double max_acceleration = 0.0;  ///< [a_max] m/s^2, of the reference
  double deviation = 0.0;  ///< [ε] m: how far the vehicle may be from the reference of `delay` ago
  double delay = 0.0;      ///< [T] s
};

/// The limits, of a quadrotor that validate() accepts.
AVO_API QuadrotorLimits limits_of(const Quadrotor& quadrotor);

/// Throws Error that names the first value out of range, after `name`.
AVO_API void validate(const Quadrotor& quadrotor, const std::string& name);

/// What an autopilot is told for one instant.
struct SetPoint {
  Vec3 position = {};  ///< m: where the vehicle shall be
  Vec3 velocity = {};  ///< m/s: of that motion
  /// m/s^2, without gravity, to feed forward. Horizontally it is the reference's, since the vehicle
  /// has it T later. Vertically it is filtered, since thrust answers at once.
  Vec3 acceleration = {};
};

/// Makes set points of the reference of one quadrotor: the reference `fleet_delay` ago, behind two
/// equal poles. They are within a_max T²/4 of the reference of that time, and exact where the
/// reference holds its acceleration over each step.
class AVO_API Filter {
 public:
  /// limits: those of the quadrotor. fleet_delay: [D] s, >= T, the largest delay of the fleet.
  /// time_step: [Δt] s, > 0. Throws Error on values out of range. Memory is allocated here alone.
  Filter(const QuadrotorLimits& limits, double fleet_delay, double time_step);

  /// Adds the next step of the reference: the state at its start, and its acceleration. The first
  /// step starts at time 0; the reference is taken to have had no acceleration before. Throws Error
  /// on values that are not finite or beyond 1e12, and adds nothing then.
  void add(Vec3 position, Vec3 velocity, Vec3 acceleration);
  /// s: the set points from begin() to end() are known. The last step lies between them.
  [[nodiscard]] double begin() const;
  [[nodiscard]] double end() const;
  /// The set point of that time, s. Throws Error on times that are not known.
  [[nodiscard]] SetPoint at(double time) const;

 private:
  /// A step of the reference, and what two lags make of its acceleration, all at its start.
  struct Step {
    Vec3 position, velocity, acceleration, once, twice;
  };
  [[nodiscard]] const Step& step(std::int64_t k) const;

  double delay_;  // [T] s
  double wait_;   // [D - T] s
  double time_step_;
  double decay_;             // of a pole over a step
  std::vector<Step> steps_;  // the last ones, step k at k modulo their number
  std::int64_t count_ = 0;   // of all steps
};

}  // namespace avo::space
