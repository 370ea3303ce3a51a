// SPDX-License-Identifier: Apache-2.0
// What a certificate assumes of a scene, and what to change where that does not hold
// (docs/scenes.md, "What a certificate assumes").
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "avo/export.h"
#include "avo/scenario.h"

namespace avo {

/// Two that overlap at the start, or that braking no longer keeps apart.
struct BrokenStart {
  int robot = 0;          ///< number of a robot
  int other = 0;          ///< of another one, greater; or -1 - k for moving obstacle k
  double distance = 0.0;  ///< m, between their centers
  /// m, <= the sum of radii: how far they overlap at worst if both brake, or circle, at once as the
  /// certificate says, or how far the areas do in which they would stop (stopping_capsules).
  double depth = 0.0;
};

/// A robot that starts too near a static obstacle, or that braking takes there.
struct WallStart {
  int robot = 0;
  int obstacle = 0;       ///< index into Scenario::obstacles
  double distance = 0.0;  ///< m, from the line of the obstacle's walls to the robot's center
  double kept = 0.0;      ///< m, what braking leaves of it
  double required = 0.0;  ///< m, both radii and what covers rounding
};

/// A robot that starts inside of a solid, or outside of bounds (Fill).
struct MisplacedStart {
  int robot = 0;
  int obstacle = 0;  ///< index into Scenario::obstacles
};

/// A robot that starts faster than its max_speed.
struct FastStart {
  int robot = 0;
  double speed = 0.0;  ///< m/s
};

/// The two that have to see each other from farthest away.
struct SensingNeed {
  double range = 0.0;  ///< m, between their centers; the sum of both parts
  int robot = 0;
  int other = 0;            ///< as in BrokenStart
  double robot_part = 0.0;  ///< m: radius, and the way of one step and of braking from max_speed
  double other_part = 0.0;  ///< m: likewise; of an obstacle the way that it covers meanwhile
};

/// All that a scene breaks, the worst first.
struct BrokenAssumptions {
  static constexpr std::size_t kNamed = 3;  ///< most entries of each list, worst first
  static constexpr int kCounted = 100'000;  ///< pairs, nobody wants to know of more

  std::vector<BrokenStart> starts;        ///< the deepest of them
  std::int64_t start_count = 0;           ///< of all such pairs; at least so many if kCounted
  std::vector<WallStart> beside;          ///< those that lack most, one obstacle a robot
  std::int64_t beside_count = 0;          ///< of all such robots
  std::vector<MisplacedStart> misplaced;  ///< the first of them
  std::int64_t misplaced_count = 0;
  std::vector<FastStart> fast;        ///< those that exceed max_speed by most
  std::int64_t fast_count = 0;        ///< of all such robots
  std::optional<SensingNeed> unseen;  ///< sensing_radius is less than its range

  /// Nothing is broken: the certificate's promise holds for the scene.
  [[nodiscard]] bool none() const {
    return start_count == 0 && beside_count == 0 && misplaced_count == 0 && fast_count == 0 &&
           !unseen.has_value();
  }
};

/// What the scene's certificate assumes and the scene does not keep; nothing where it has none.
/// A billionth of a length or speed, which decimal fractions cost, breaks nothing. The scene has to
/// pass validate().
AVO_API BrokenAssumptions broken_assumptions(const Scenario& scenario);

/// What start_at_rest() and limit_speed() are called where the lines of complaints() are read.
struct RemedyNames {
  std::string start_at_rest = "start at rest";
  std::string limit_speed = "limit speeds";
};

/// A line on each thing that broken_assumptions() finds, and what to change; none where nothing is
/// broken.
AVO_API std::vector<std::string> complaints(const Scenario& scenario,
                                            const RemedyNames& remedies = {});

/// The sensing radius that the certificate needs: two that meet first see each other so late that
/// each has moved on for a whole step at max_speed, and can still brake. Obstacles are taken at
/// their highest speed within the scene's duration. Unset without a certificate or anyone to meet.
AVO_API std::optional<SensingNeed> sensing_need(const Scenario& scenario);

/// m/s: the highest speed such that the sensing radius suffices if no robot may exceed it; to the
/// last bit, rounded down. Airplanes keep their min_speed. Infinite where the radius suffices as it
/// is, 0 where no speed is low enough.
AVO_API double admissible_speed(const Scenario& scenario);

/// All robots start at rest, airplanes at their min_speed. Returns how many did not.
AVO_API std::int64_t start_at_rest(Scenario& scenario);

/// What limit_speed() changed.
struct LimitedSpeeds {
  std::int64_t robots = 0;  ///< with max_speed > limit before
  double limit = 0.0;       ///< m/s, admissible_speed() of the scene before
  std::int64_t starts = 0;  ///< robots that started faster than their max_speed
};
/// Lowers max_speed to admissible_speed() where it is more, preferred_speed with it, and then the
/// speeds at the start to max_speed. Changes nothing of a scene without a certificate, and no limit
/// where no speed is low enough.
AVO_API LimitedSpeeds limit_speed(Scenario& scenario);

}  // namespace avo
