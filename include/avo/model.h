// SPDX-License-Identifier: Apache-2.0
// Motion models: how a robot can move (paper §V). SI units.
//
// A robot is known to the others by its disc alone, and by what it falls back on: it brakes, or it
// loiters. They never ask for its model. What
// is called its position in a scene is a point of its own, see disc_center().
#pragma once
#include <cstdint>
#include <optional>
#include <variant>

#include "avo/export.h"
#include "avo/vec.h"

namespace avo {

/// Accelerates in every direction.
struct Holonomic {
  friend bool operator==(const Holonomic&, const Holonomic&) = default;
};

/// Which accelerations a car may choose from, Fig. 6(b): of |a_lin| <= a_max and |v² κ| <= a_max,
/// which make a square turned by its heading,
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
/// at once. With no bound on its curvature and its disc about the axle, one that is slow may turn
/// in place.
struct Car {
  double wheelbase = 1.0;                    ///< [d] m, > 0
  std::optional<double> max_curvature = {};  ///< [κ_max] 1/m, > 0; unset: unbounded
  std::optional<CarBody> body = {};          ///< unset: about the axle
  bool reverse = false;                      ///< may drive backwards
  AccelerationSet acceleration_set = AccelerationSet::incircle;
  friend bool operator==(const Car&, const Car&) = default;
};

/// Two wheels on one axle, each driven by itself: its position is the middle of the axle, and it
/// turns about that where it stands. The limits of the wheels hold at every instant. Others sense
/// the disc about the point q that is `offset` ahead of the axle, which can accelerate in every
/// direction (docs/certificate/wheels.md, "Differential drives"). The robot's velocity, max_speed
/// and max_acceleration are those of q: max_speed <= wheel_speed; max_acceleration and max_braking
/// < most_acceleration().
struct DifferentialDrive {
  double track = 0.4;           ///< [b] m, > 0, between the wheels
  double offset = 0.5 * track;  ///< [L] m, > 0; of a small robot with wide wheels usual_offset()
  double wheel_speed = 2.0;     ///< [w_max] m/s, > 0, of each wheel on the ground
  double wheel_acceleration = 3.0;  ///< [α_w] m/s², > 0, likewise
  friend bool operator==(const DifferentialDrive&, const DifferentialDrive&) = default;
};

/// [L] m: half of the smaller one of both, m. The disc that others sense is half as large again as
/// the robot at most, and the wheels accelerate q by 0.7 α_w where the track is the smaller one.
AVO_API double usual_offset(double radius, double track);

/// m/s²: α_w/√(1 + (b/2L)²), which the wheels can make of q in every direction, at rest. A robot
/// that brakes with less has something left for turning while it brakes.
AVO_API double most_acceleration(const DifferentialDrive& drive);

/// What an airplane does once it has flown through its goal.
enum class AfterGoal : std::uint8_t {
  loiter,  ///< it turns right for ever, where it is then
  leave,   ///< it is no longer there when the next step begins
};
AVO_API const char* to_string(AfterGoal after_goal);

/// Cannot stop. It comes to its goal by passing it. What others are promised is that it can always
/// turn right at full, at the speed that it has: see LoiterCircle.
struct Airplane {
  double min_speed = 1.0;             ///< m/s, > 0
  double lateral_acceleration = 1.0;  ///< [a_lat] m/s^2, > 0; max_acceleration is along its way
  AfterGoal after_goal = AfterGoal::loiter;
  friend bool operator==(const Airplane&, const Airplane&) = default;
};

/// The circle that an airplane turns right on if it decides nothing better: its disc stays within
/// `radius` and its own radius of the center.
struct LoiterCircle {
  Vec2 center = {};     ///< [c] m, to the right of the airplane
  double radius = 0.0;  ///< [ρ] m
  friend bool operator==(const LoiterCircle&, const LoiterCircle&) = default;
};

/// Of an airplane that flies there, not at rest. It turns a millionth less than it could.
AVO_API LoiterCircle loiter_circle(const Airplane& airplane, Vec2 position, Vec2 velocity);

/// How a robot moves.
using MotionModel = std::variant<Holonomic, Car, DifferentialDrive, Airplane>;

inline bool is_holonomic(const MotionModel& model) {
  return std::holds_alternative<Holonomic>(model);
}
inline bool is_airplane(const MotionModel& model) {
  return std::holds_alternative<Airplane>(model);
}

/// m/s²: what FleetView::applied_acceleration of one whose setup says `max_acceleration`, or its
/// max_braking where that is more, never exceeds.
AVO_API double acceleration_limit(const MotionModel& model, double max_acceleration);

/// Whether the velocity of its disc is along its heading or against it, as that of a car is. Others
/// move on parabolas between decisions where acceleration is held.
AVO_API bool moves_along_heading(const MotionModel& model);

/// m: the radius of the disc that others sense, of one whose setup says `radius`.
AVO_API double disc_radius(const MotionModel& model, double radius);

/// m: the center of that disc, where the robot's position is `position`; heading in rad.
AVO_API Vec2 disc_center(const MotionModel& model, Vec2 position, double heading);

}  // namespace avo
