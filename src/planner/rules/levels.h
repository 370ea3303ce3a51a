// SPDX-License-Identifier: Apache-2.0
// The margins of evasive maneuvers, and how long they are, in the plane and in space
// (docs/movers.md).
#pragma once
#include <array>
#include <limits>

namespace avo::inline planner {

/// The margins of an evasive maneuver.
struct Level {
  double part;        ///< of a_max that the evasive maneuver uses
  double margin;      ///< part of the contact distance
  double reaction;    ///< in T
  bool stops = true;  ///< whether (C2) is required
  /// The time for which rest must be clear, in longest evasive maneuvers.
  double until = std::numeric_limits<double>::infinity();
  double likely = 0.0;  ///< part of likely deviations
};

// The first levels are early, gentle and far off. Each level is tried where the one before has
// none, and keeps less than that by more than rounding may cost.
inline constexpr std::array<Level, 6> kLevels{{{0.6, 0.05, 0.5},
                                               {0.6, 0.035, 0.5},
                                               {1.0, 0.025, 0.25},
                                               {1.0, 0.015, 0.125},
                                               {1.0, 0.005, 0.0},
                                               {1.0, 0.0, 0.0}}};
// Where braking is too late, the evasive maneuver itself is proof that A is not touched.
inline constexpr std::array<Level, 2> kLastLevels{{{1.0, 0.025, 0.0, false},  //
                                                   {1.0, 0.0025, 0.0, false}}};
// Where no place is clear for ever, rest must be clear for so long.
inline constexpr std::array<Level, 1> kForAWhile{{{1.0, 0.0, 0.0, true, 2.0}}};

inline constexpr double kLongestEvasion = 2.0;      // T, until an evasive maneuver brakes,
inline constexpr double kWideEvasion = 3.0;         // or so many for wide neighbors,
inline constexpr double kMostEvasionSteps = 400.0;  // and steps at most
// steps of braking; a robot that takes more has no evasive maneuvers
inline constexpr double kMostBraking = 1024.0;
inline constexpr int kMostWork = 200000;  // movers and intervals that a level may test

/// Bisections that bring a replacement nearer to the choice that it replaces.
inline constexpr int kNearer = 4;

/// What a search of evasive maneuvers has found after a step of the robot's own choice, or of
/// another one.
enum class EvasionFound : unsigned char { none, as_wanted, another };

}  // namespace avo::inline planner
