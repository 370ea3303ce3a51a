// SPDX-License-Identifier: Apache-2.0
// Pairs of robots, and pairs of a robot and a moving obstacle: contacts, and the least clearance.
#pragma once
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "avo/check.h"
#include "check/duty.h"
#include "check/step.h"

namespace avo::judge {

/// A pair counts once.
class PairJudge {
 public:
  void add_robot(const CheckedRobot& robot) { kinds_.add(robot); }
  /// Two bodies over the step; robots come first, by number.
  void meet(const MovingDisc& a, const MovingDisc& b, const JudgedStep& step);
  /// m: no pair farther apart than this changes the result.
  [[nodiscard]] double reach() const;
  /// Writes all results.
  void write(CheckReport& report) const;

 private:
  using Pairs = std::unordered_set<std::uint64_t>;

  // Robots that ever touched a body that does not avoid them, by their pair.
  struct Contacts {
    std::unordered_map<std::uint64_t, CheckedHit> hits;
    CheckCount in_motion;  // of those robots among them that moved
  };

  void meet_robots(const MovingDisc& a, const MovingDisc& b, const JudgedStep& step);
  void meet_mover(const MovingDisc& robot, const MovingDisc& other, const JudgedStep& step,
                  Contacts& contacts);

  DutyKinds kinds_;
  Pairs overlapping_;
  CheckCount overlaps_;
  Contacts with_movers_, one_sided_;
  std::optional<double> least_clearance_;
};

}  // namespace avo::judge
