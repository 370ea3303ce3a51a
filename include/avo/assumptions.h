// SPDX-License-Identifier: Apache-2.0
// What a certificate assumes of a scene, and what to change where the scene breaks an assumption
// (docs/scenes.md, "What a certificate assumes").
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/ids.h"
#include "avo/scenario.h"

namespace avo {

/// Two robots, or a robot and a moving obstacle, that overlap at the start or that braking no
/// longer keeps apart.
struct BrokenStart {
  RobotId robot;
  BodyId other;           ///< of two robots the one with the greater id
  double distance = 0.0;  ///< m, between their centers
  /// m, <= the sum of radii: the largest overlap if both brake, or circle, at once as the
  /// certificate says.
  double depth = 0.0;
};

/// A robot that starts too near a static obstacle, or that braking brings too near to one.
struct WallStart {
  RobotId robot;
  ObstacleId obstacle;
  double distance = 0.0;  ///< m, from the line of the obstacle's walls to the robot's center
  double kept = 0.0;      ///< m, the part of the distance that is left after braking
  double required = 0.0;  ///< m, the sum of both radii and a margin for rounding
};

/// A robot that starts inside a solid or outside bounds (Fill).
struct MisplacedStart {
  RobotId robot;
  ObstacleId obstacle;
};

/// A robot that starts faster than its max_speed.
struct FastStart {
  RobotId robot;
  double speed = 0.0;  ///< m/s
};

/// The two robots, or the robot and the moving obstacle, that must see each other from farthest
/// away.
struct SensingNeed {
  double range = 0.0;  ///< m, between their centers; the sum of both parts
  RobotId robot;
  BodyId other;
  /// m: the radius, the distance of one step and the braking distance from max_speed
  double robot_part = 0.0;
  /// m: the same of the other robot; for an obstacle the distance that it moves meanwhile
  double other_part = 0.0;
};

/// All assumptions that a scene breaks, the worst first. Ids are those of the robots and obstacles
/// of a Simulation of the scene.
struct BrokenAssumptions {
  static constexpr std::size_t kNamed = 3;  ///< most entries of each list, worst first
  static constexpr int kCounted = 100'000;  ///< pairs are counted up to this number

  std::vector<BrokenStart> starts;  ///< the deepest of them
  /// number of all such pairs; at least so many if it equals kCounted
  std::int64_t start_count = 0;
  std::vector<WallStart> beside;          ///< the robots that lack most, with one obstacle each
  std::int64_t beside_count = 0;          ///< number of all such robots
  std::vector<MisplacedStart> misplaced;  ///< the first such robots
  std::int64_t misplaced_count = 0;
  std::vector<FastStart> fast;        ///< the robots that exceed max_speed by most
  std::int64_t fast_count = 0;        ///< number of all such robots
  std::optional<SensingNeed> unseen;  ///< sensing_radius is less than its range

  /// Returns whether nothing is broken: the certificate's promise holds for the scene.
  [[nodiscard]] bool none() const {
    return start_count == 0 && beside_count == 0 && misplaced_count == 0 && fast_count == 0 &&
           !unseen.has_value();
  }
};

/// Finds the assumptions of the scene's certificate that the scene breaks; none without a
/// certificate. An excess of a billionth of a length or speed, as decimal fractions cause it,
/// breaks nothing. The scene must pass validate().
AVO_API BrokenAssumptions broken_assumptions(const Scenario& scenario);

/// The names of start_at_rest() and limit_speed() for the readers of the lines of complaints().
struct RemedyNames {
  std::string start_at_rest = "start at rest";
  std::string limit_speed = "limit speeds";
};

/// Returns one line for each thing that broken_assumptions() finds, with what to change; none where
/// nothing is broken.
AVO_API std::vector<std::string> complaints(const Scenario& scenario,
                                            const RemedyNames& remedies = {});

/// The sensing radius that the certificate needs. When two robots first see each other, each may
/// have moved on for a whole step at max_speed. They must still be able to brake. Obstacles are
/// taken at their highest speed within the scene's duration. The value is unset without a
/// certificate, or if there is nothing to meet.
AVO_API std::optional<SensingNeed> sensing_need(const Scenario& scenario);

/// m/s: the highest speed limit for all robots with which the sensing radius suffices, rounded down
/// to the last bit. Airplanes keep their min_speed. The value is infinite where the radius suffices
/// without a limit, and 0 where no speed is low enough.
AVO_API double admissible_speed(const Scenario& scenario);

/// Sets all robots to start at rest, airplanes at their min_speed. Returns how many robots changed.
AVO_API std::int64_t start_at_rest(Scenario& scenario);

/// What limit_speed() changed.
struct LimitedSpeeds {
  std::int64_t robots = 0;  ///< with max_speed > limit before
  double limit = 0.0;       ///< m/s, admissible_speed() of the scene before
  std::int64_t starts = 0;  ///< robots that started faster than their max_speed
};
/// Lowers max_speed to admissible_speed() where it is higher, preferred_speed with it, and then the
/// speeds at the start to max_speed. A scene without a certificate does not change. No limit
/// changes where no speed is low enough.
AVO_API LimitedSpeeds limit_speed(Scenario& scenario);

}  // namespace avo
