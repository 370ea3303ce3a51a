// SPDX-License-Identifier: Apache-2.0
// What the ways of a maneuvering car are made of: moves on arcs or straight, and the last leg to
// its goal (docs/arrival.md, "Cars").
#pragma once
#include <optional>

#include "robots/car.h"
#include "robots/maneuver_memory.h"

namespace avo::inline robots {

/// Of the radius of the turning circle: m of way that standing still and starting anew is worth.
inline constexpr double kGearChange = 1.0;

/// From a pose to a place: an arc, and straight on.
struct ArcLeg {
  double arc = 0.0, straight = 0.0;  // m
};

Pose after(const Pose& pose, const Move& move, double length, KnownTurns& turns);

/// None to places inside the circle.
std::optional<ArcLeg> leg_to(const Pose& pose, const Move& move, Vec2 place);

/// One car that looks for a way.
struct Maneuvering {
  const Car& car;
  const Robot& robot;
  const ClearPlaces& is_clear;
  double turning;  // m, the radius of the turning circle
  double planned;  // m, of the circles that ways are made of
  double lead;     // m, that it drives straight where it starts, before it turns
  Vec2 goal;       // m, of the axle
  Pose pose;
  double speed;  // m/s, along the heading
  KnownTurns& turns;

  bool goes_on(double gear) const { return gear * speed > 0.0; }
  double stopping_way() const { return 0.5 * speed * speed / robot.max_acceleration; }
  /// m, of the lead, that is left of it now
  double lead_left(double gear) const;
  int gears() const { return car.reverse ? 2 : 1; }
  /// m, that the car can drive before it comes too near to something
  double clear_length(const Pose& from, const Move& move, double most, Nearness nearness) const;
  /// Whether the leg is clear, as far as it is looked at.
  bool is_clear_leg(const Pose& from, const Move& move, const ArcLeg& leg, Nearness nearness) const;
  /// m: to stop, to come back as far, and to start anew
  double change_from_now(double gear) const {
    return gear * speed < 0.0 ? 2.0 * stopping_way() + kGearChange * turning : 0.0;
  }
};

/// How a way begins.
struct Beginning {
  Move move;
  double turn = 0.0;       // rad, of this move
  double length = 0.0;     // m, until the car changes gear; infinite: it does not
  bool is_direct = false;  // the last leg alone
};

/// The shortest way that is found; none where none is found.
std::optional<Beginning> begin_way(const Maneuvering& maneuvering, ManeuverMemory& memory);

}  // namespace avo::inline robots
