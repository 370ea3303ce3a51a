// SPDX-License-Identifier: Apache-2.0
// Motion models: how a robot can move (paper §V). SI units.
//
// The other robots know a robot by its disc, or by the discs of its footprint, and by its fallback:
// it brakes, or it loiters. They never ask for its model. The position of a robot in a scene is a
// point of its model, see disc_center().
#pragma once
#include <cstdint>
#include <optional>
#include <variant>

#include "avo/export.h"
#include "avo/footprint.h"
#include "avo/vec.h"

namespace avo {

/// The robot accelerates in every direction.
struct Holonomic {
  friend bool operator==(const Holonomic&, const Holonomic&) = default;
};

/// The accelerations that a car may choose from, Fig. 6(b). |a_lin| <= a_max and |v² κ| <= a_max
/// make a square that is turned by the heading. The set is
enum class AccelerationSet : std::uint8_t {
  incircle,  ///< the disc D(0, a_max) inside it,
  exact,     ///< all of it: its corners reach √2 a_max
};
AVO_API const char* to_string(AccelerationSet set);

/// The disc that covers a car's body.
struct CarBody {
  double offset = 0.0;  ///< [e] m, of its center ahead of the rear axle; < 0: behind it
  double radius = 0.5;  ///< m, > 0
  friend bool operator==(const CarBody&, const CarBody&) = default;
};

/// Car-like robot, Eqs. (24), (25): its position is the center of its rear axle. Its steering turns
/// at once. A slow car may turn in place if its curvature has no bound and its disc is about the
/// axle.
struct Car {
  double wheelbase = 1.0;                    ///< [d] m, > 0
  std::optional<double> max_curvature = {};  ///< [κ_max] 1/m, > 0; unset: unbounded
  std::optional<CarBody> body = {};          ///< unset: about the axle
  bool reverse = false;                      ///< may drive backwards
  AccelerationSet acceleration_set = AccelerationSet::incircle;
  Footprint footprint = {};  ///< from the rear axle; a car has a body or a footprint
  friend bool operator==(const Car&, const Car&) = default;
};

/// Two wheels on one axle, each driven by itself. The position is the middle of the axle, and the
/// robot turns about this point at rest. The limits of the wheels hold at every instant. Others
/// sense the disc about the point q that is `offset` ahead of the axle. q can accelerate in every
/// direction (docs/certificate/wheels.md, "Differential drives"). The robot's velocity, max_speed
/// and max_acceleration are those of q: max_speed <= wheel_speed; max_acceleration and max_braking
/// < most_acceleration().
struct DifferentialDrive {
  double track = 0.4;  ///< [b] m, > 0, between the wheels
  /// [L] m, > 0; for a small robot with wide wheels use usual_offset()
  double offset = 0.5 * track;
  double wheel_speed = 2.0;         ///< [w_max] m/s, > 0, of each wheel on the ground
  double wheel_acceleration = 3.0;  ///< [α_w] m/s², > 0, of each wheel
  Footprint footprint = {};         ///< from the middle of the axle
  friend bool operator==(const DifferentialDrive&, const DifferentialDrive&) = default;
};

/// [L] m: half of the smaller one of both, m. The disc that others sense is then at most half as
/// large again as the robot. The wheels accelerate q by 0.7 α_w where the track is the smaller one.
AVO_API double usual_offset(double radius, double track);

/// m/s²: α_w/√(1 + (b/2L)²), the acceleration that the wheels can give q in every direction, at
/// rest. A robot that brakes with less can still turn while it brakes.
AVO_API double most_acceleration(const DifferentialDrive& drive);

/// What an airplane does after it has flown through its goal.
enum class AfterGoal : std::uint8_t {
  loiter,  ///< it turns right for ever, from where it is then
  leave,   ///< it is gone when the next step begins
};
AVO_API const char* to_string(AfterGoal after_goal);

/// An airplane cannot stop. It reaches its goal by passing it. The promise to others is that it can
/// always turn right at full rate, at its present speed: see LoiterCircle.
struct Airplane {
  double min_speed = 1.0;             ///< m/s, > 0
  double lateral_acceleration = 1.0;  ///< [a_lat] m/s^2, > 0; max_acceleration is along its heading
  AfterGoal after_goal = AfterGoal::loiter;
  friend bool operator==(const Airplane&, const Airplane&) = default;
};

/// The circle on which an airplane turns right if it decides nothing better. Its disc stays within
/// `radius` and its own radius of the center.
struct LoiterCircle {
  Vec2 center = {};     ///< [c] m, to the right of the airplane
  double radius = 0.0;  ///< [ρ] m
  friend bool operator==(const LoiterCircle&, const LoiterCircle&) = default;
};

/// Returns the circle of an airplane that flies at that velocity, which is not 0. The circle turns
/// a millionth less than the airplane could.
AVO_API LoiterCircle loiter_circle(const Airplane& airplane, Vec2 position, Vec2 velocity);

/// How a robot moves.
using MotionModel = std::variant<Holonomic, Car, DifferentialDrive, Airplane>;

inline bool is_holonomic(const MotionModel& model) {
  return std::holds_alternative<Holonomic>(model);
}
/// Returns whether the robot can brake to rest. A robot that cannot rest flies: it reaches its goal
/// by passing it, and its fallback is a LoiterCircle.
inline bool can_rest(const MotionModel& model) {
  return !std::holds_alternative<Airplane>(model);
}

/// m/s²: the bound that FleetView::applied_acceleration never exceeds for a robot with this
/// max_acceleration, or with this max_braking where that is more.
AVO_API double acceleration_limit(const MotionModel& model, double max_acceleration);

/// Returns whether the velocity of the disc is along the heading or against it, as for a car. Other
/// robots move on parabolas between decisions where acceleration is held.
AVO_API bool moves_along_heading(const MotionModel& model);

/// The footprint about the center of that disc, see disc_center(); without discs where it has none.
AVO_API Footprint footprint_of(const MotionModel& model);

/// m: the radius of the disc that others sense, for a robot with `radius` in its setup. It covers
/// the footprint at any heading.
AVO_API double disc_radius(const MotionModel& model, double radius);

/// m: the center of that disc for a robot at `position`; heading in rad.
AVO_API Vec2 disc_center(const MotionModel& model, Vec2 position, double heading);

}  // namespace avo
