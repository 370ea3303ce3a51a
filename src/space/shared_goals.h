// SPDX-License-Identifier: Apache-2.0
// Goals that leave no room for all robots that have them (docs/arrival.md, rule 4).
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/space/robot.h"
#include "space/cells.h"

namespace avo::space {

/// What a robot has in common with another one, where both may not be in one place.
enum class SpaceShares : std::uint8_t {
  nothing,
  room,  ///< their goals are so close that they cannot both be there
  goal,  ///< the same goal, bit for bit
};

/// What robots share, by their numbers. Robots that find no room at their goals rest around them,
/// and may stand on the goals of others: these then have no room either.
class SharedGoals {
 public:
  /// The robots have these goals from now on, m.
  void set(std::span<const Robot> robots, std::span<const Vec3> goals);
  /// Notes whose goals are taken by robots that have come to rest at such places. Allocates
  /// nothing. Another call with the same robots changes nothing.
  void note(std::span<const Robot> robots, std::span<const std::uint8_t> has_stood);

  [[nodiscard]] SpaceShares of(std::size_t k) const {
    return shares_.empty() ? SpaceShares::nothing : shares_[k];
  }

 private:
  void note_taken_by(std::size_t k, const Robot& robot);

  std::vector<Robot> there_;         // the robots, at their goals
  SpaceCells cells_{1.0};            // of there_
  std::vector<SpaceShares> shares_;  // empty where none shares anything
  std::vector<std::uint8_t> noted_;  // the robot stands where it was noted
};

}  // namespace avo::space
