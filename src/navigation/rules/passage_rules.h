// SPDX-License-Identifier: Apache-2.0
// What rules 7 to 10 of docs/arrival.md share, and these rules themselves, each in a file of its
// own. All lengths are in radii of the passage, so that robots of any size agree on them.
#pragma once
#include <span>

#include "navigation/right_of_way.h"

namespace avo::inline navigation {

/// Radii: a robot that rests farther away has come to its own goal, or makes room.
inline constexpr double kRestsNear = 5.0;

/// The mouth of the robots that enter there.
struct Mouth {
  Vec2 center, inward, aside;  // m; unit; unit, to the side of the bay
};
Mouth mouth_of(const Passage& passage, bool forward);

/// The precedence between robots at equal distances; all robots can see it.
bool comes_first(Vec2 p, Vec2 q);

/// Returns whether there is no room at their goals for both: they come to rest side by side.
bool share_goal(const Claimant& a, const Claimant& b);

/// Returns whether the other claimant matters to the robot. A claimant at the robot's place is the
/// robot itself.
bool senses(const Claimant& robot, const Claimant& other, double sensing_radius);

/// Returns whether the other robot rests too far away to block the robot.
bool rests_apart(const Passage& passage, const Claimant& robot, const Claimant& other);

/// The robot of one direction that has come farthest.
struct Foremost {
  double advance = -1.0;  // m, from where it entered; < 0: none is inside
  Vec2 position = {};

  void include(const Passage& passage, const Claimant& robot);
  [[nodiscard]] bool goes_on_before(const Foremost& other) const;
};

/// Where a robot inside goes that must clear the path of robots that come out. They come out of the
/// mouth where that direction enters.
Vec2 place_outside(const Passage& passage, bool forward, Vec2 position);

/// Rule 7.
bool may_enter(const Passage& passage, const Claimant& robot, std::span<const Claimant> claimants,
               double sensing_radius);
/// Rule 8. braking: m/s^2, with which the robot slows down.
Course wait_beside(const Passage& passage, const Claimant& robot, double braking);
/// Rule 9.
Course go_on_or_back(const Passage& passage, const Claimant& robot,
                     std::span<const Claimant> claimants, double sensing_radius);
/// Rule 10.
Course make_room(const Passage& passage, const Claimant& robot, std::span<const Claimant> claimants,
                 double sensing_radius);

}  // namespace avo::inline navigation
