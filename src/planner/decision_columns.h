// SPDX-License-Identifier: Apache-2.0
// What robots of method avo make of their state by themselves, in lanes: traffic, wish, and the
// plan of whom nobody hinders.
#pragma once
#include <cstddef>
#include <vector>

#include "certificate/braking_path.h"
#include "core/robot_columns.h"
#include "lp/linear_program.h"
#include "planner/execution.h"
#include "planner/rules/arrival.h"

namespace avo::inline planner {

/// One entry a robot. Scratch memory; allocates only while it grows.
struct DecisionColumns {
  using Column = std::vector<double>;
  Column range;                             // m, by look_around()
  Column ahead, is_beside, push_x, push_y;  // likewise, see Traffic
  Column push_at_rest_x, push_at_rest_y;    // likewise
  Column wish_x, wish_y;                    // m/s, by keep_right(), and then by wish_of()
  Column aim_x, aim_y;    // m/s, what Eq. (23) is given in place of the wish, see aim()
  Column last_x, last_y;  // m/s, by how much the last step has changed the velocity
  // [v'], m/s: what Eq. (23) made of the wish, by how much it misses CA_A, and how
  Column target_x, target_y, violation;
  std::vector<ProgramState> state;
  Column next_x, next_y;  // [v_1] m/s, by decide_freely(): what one step makes of the target
  Column new_x, new_y, a_x, a_y;  // m/s, m/s², likewise: the decision for it
  Column is_free;                 // likewise: 1 where neither limits nor being blocked object, or 0

  void reserve(std::size_t robots);
  void take(std::size_t i, const ProgramResult& result) {
    target_x[i] = result.point.x, target_y[i] = result.point.y;
    violation[i] = result.violation, state[i] = result.state;
  }
  [[nodiscard]] Traffic traffic(std::size_t i) const {
    return {ahead[i],
            is_beside[i] != 0.0,
            {push_x[i], push_y[i]},
            {push_at_rest_x[i], push_at_rest_y[i]}};
  }
  [[nodiscard]] Vec2 wish(std::size_t i) const { return {wish_x[i], wish_y[i]}; }
  [[nodiscard]] Vec2 aim(std::size_t i) const { return {aim_x[i], aim_y[i]}; }
  [[nodiscard]] Vec2 target(std::size_t i) const { return {target_x[i], target_y[i]}; }
  [[nodiscard]] Vec2 last_change(std::size_t i) const { return {last_x[i], last_y[i]}; }
};

/// What each sees of its traffic.
void look_around(const RobotColumns& robots, DecisionColumns& columns);

/// The preferred velocity turned to the right by how congested the way ahead is; as it is on the
/// last of the way to the goal.
void keep_right(const RobotColumns& robots, DecisionColumns& columns);

/// From a wish, and the target that the program has made of it, to the plan of one to whom no
/// certificate objects.
void decide_freely(const StepLaw& law, const Execution& execution, const RobotColumns& robots,
                   DecisionColumns& columns);

}  // namespace avo::inline planner
