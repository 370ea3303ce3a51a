// SPDX-License-Identifier: Apache-2.0
// What a Check has seen so far, and its judgement of the next rows.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/check.h"
#include "check/course.h"
#include "check/own_clock.h"
#include "check/pair_judge.h"
#include "check/step.h"
#include "check/sweep.h"
#include "check/wall_judge.h"

namespace avo {
namespace judge {

/// The last observation of a robot.
struct SeenRobot {
  CheckedState row;
  std::int64_t at = -1;  // number of the time, -1: never
  bool arrived = false, at_goal = false;
  JudgedClock clock;
};

}  // namespace judge

struct Check::State {
  std::vector<CheckedRobot> robots;
  std::vector<CheckedMover> movers;
  // of each mover: its place at the last time, and at the next one, if it is placed there
  std::vector<std::optional<judge::PlacedMover>> placed_before, placed;
  CheckOptions options;
  CheckReport report;  // the part that is not derived from other data
  std::vector<judge::SeenRobot> seen;
  std::int64_t times = 0;
  double last_time = 0.0, last_arrival = 0.0;
  judge::PairJudge pairs;
  judge::WallJudge walls;

  // of the present step
  bool skipped = false;  // its rows in between are missing
  double duration = 0.0;
  std::vector<judge::MovingDisc> discs;  // of robots, then of movers
  std::vector<judge::BoundingBox> boxes;

  void require_sound(double time, std::span<const CheckedState> rows) const;
  void add_newcomer(const CheckedRobot& robot, const CheckedState& row);
  void judge_row(double time, const CheckedState& row);
  void judge_step(const CheckedRobot& robot, const CheckedState& before, const CheckedState& now,
                  double time);
  void judge_limits(const CheckedRobot& robot, const CheckedState& before, const CheckedState& now,
                    double time);
  void judge_changes(const CheckedRobot& robot, const CheckedState& now, double time);
  [[nodiscard]] bool passes(const judge::MovingDisc& disc, Vec2 goal, double within) const;
  void judge_arrival(double time, const CheckedState& row, const judge::MovingDisc& disc);
  [[nodiscard]] std::vector<std::optional<Vec2>> places_at_rest() const;
};

}  // namespace avo
