// SPDX-License-Identifier: Apache-2.0
// What robots of method avo compute from their own state, in lanes: traffic, wish, and the plans of
// unhindered robots.
#pragma once
#include <cstddef>
#include <vector>

#include "certificate/braking_path.h"
#include "core/robot_columns.h"
#include "lp/linear_program.h"
#include "planner/rules/arrival.h"
#include "planner/stages/execution.h"

namespace avo::inline planner {

/// One entry for each robot. Scratch memory; allocates only while it grows.
struct DecisionColumns {
  using Column = std::vector<double>;
  Column range;                             // m, set by look_around()
  Column ahead, is_beside, push_x, push_y;  // set by look_around(), see Traffic
  Column push_at_rest_x, push_at_rest_y;    // set by look_around(), see Traffic
  Column wish_x, wish_y;                    // m/s, set by keep_right(), and then by wish_of()
  // m/s, the velocity that Eq. (23) is given in place of the wish, see aim()
  Column aim_x, aim_y;
  Column last_x, last_y;  // m/s, the change of velocity in the last step
  // [v'], m/s: the result of Eq. (23) for the wish, its violation of CA_A, and its state
  Column target_x, target_y, violation;
  std::vector<ProgramState> state;
  // [v_1] m/s, set by decide_freely(): the velocity after one step towards the target
  Column next_x, next_y;
  Column new_x, new_y, a_x, a_y;  // m/s, m/s², set by decide_freely(): the decision for it
  // set by decide_freely(): 1 where the limits allow the choice and the robot is not blocked, or 0
  Column is_free;

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

/// Sets each robot's view of its traffic.
void look_around(const RobotColumns& robots, DecisionColumns& columns);

/// Turns the preferred velocity to the right by the congestion of the route ahead. It stays the
/// same on the last part of the route to the goal.
void keep_right(const RobotColumns& robots, DecisionColumns& columns);

/// Makes a plan from a wish, and from the target of the program for the wish, for a robot that no
/// certificate limits.
void decide_freely(const StepLaw& law, const Execution& execution, const RobotColumns& robots,
                   DecisionColumns& columns);

}  // namespace avo::inline planner
