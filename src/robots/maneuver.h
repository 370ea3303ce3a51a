// SPDX-License-Identifier: Apache-2.0
// The parts of a maneuvering car's path: moves on arcs or straight, and the last leg to its goal
// (docs/arrival.md, "Cars").
#pragma once
#include <optional>

#include "robots/car.h"
#include "robots/maneuver_memory.h"

namespace avo::inline robots {

/// The cost of stopping and starting again, in radii of the turning circle, as length of path.
inline constexpr double kGearChange = 1.0;

/// From a pose to a place: an arc, and then straight on.
struct ArcLeg {
  double arc = 0.0, straight = 0.0;  // m
};

AxlePose after(const AxlePose& pose, const Move& move, double length, KnownTurns& turns);

/// None for places inside the circle.
std::optional<ArcLeg> leg_to(const AxlePose& pose, const Move& move, Vec2 place);

/// One car that searches for a path.
struct Maneuvering {
  const Car& car;
  const Robot& robot;
  const ClearPlaces& is_clear;
  double turning;  // m, the radius of the turning circle
  double planned;  // m, radius of the circles in planned paths
  double lead;     // m, straight distance at its start, before it turns
  Vec2 goal;       // m, of the axle
  AxlePose pose;
  double speed;  // m/s, along the heading
  KnownTurns& turns;

  bool goes_on(double gear) const { return gear * speed > 0.0; }
  double stopping_vector() const { return 0.5 * speed * speed / robot.max_acceleration; }
  /// m, the remaining part of the lead
  double lead_left(double gear) const;
  int gears() const { return car.reverse ? 2 : 1; }
  /// m, distance that the car can drive before it comes too near to an obstacle
  double clear_length(const AxlePose& from, const Move& move, double most, Nearness nearness) const;
  /// Returns whether the examined part of the leg is clear.
  bool is_clear_leg(const AxlePose& from, const Move& move, const ArcLeg& leg,
                    Nearness nearness) const;
  /// m: the cost to stop, to come back as far, and to start again
  double change_from_now(double gear) const {
    return gear * speed < 0.0 ? 2.0 * stopping_vector() + kGearChange * turning : 0.0;
  }
};

/// The first part of a path.
struct Beginning {
  Move move;
  double turn = 0.0;       // rad, of this move
  double length = 0.0;     // m, until the car changes gear; infinite: it does not
  bool is_direct = false;  // the last leg alone
};

/// The shortest path that is found; none where none is found.
std::optional<Beginning> begin_maneuver(const Maneuvering& maneuvering, ManeuverMemory& memory);

}  // namespace avo::inline robots
