// SPDX-License-Identifier: Apache-2.0
#include "space/target.h"

#include <array>
#include <vector>

#include "core/ranges.h"
#include "space/boxes.h"
#include "space/choice.h"
#include "space/half_spaces.h"
#include "space/mover_planes.h"
#include "space/program.h"

namespace avo::space {

void collect_hard(const Deciding& decision, std::span<const Box> boxes) {
  const Robot& robot = decision.robot;
  PlanWorkspace::Scratch& scratch = decision.scratch;
  std::vector<HalfSpace>& speeds = scratch.speeds;
  speeds.clear();
  append_speed_planes(robot, boxes, decision.law, speeds);
  std::vector<HalfSpace>& all = scratch.own_speeds;
  all.clear();
  append_climb(robot, all);
  for (const HalfSpace& plane : speeds) all.push_back(to_own(plane, robot.vertical));
  HalfSpaceColumns& hard = scratch.hard;
  hard.count = 0;
  hard.reserve(all.size());
  // they come before all neighbors
  for (const HalfSpace& plane : all)
    hard.add(plane, static_cast<double>(hard.count) - static_cast<double>(all.size()));
}

namespace {

// The hard half-spaces, and the soft ones of the pairs that the look has chosen last and of moving
// obstacles, in the robot's own space.
HalfSpaceColumns& collect_half_spaces(const Deciding& decision) {
  const Robot& robot = decision.robot;
  PlanWorkspace::Scratch& scratch = decision.scratch;
  HalfSpaceColumns& columns = scratch.half_spaces.columns;
  columns.count = 0;
  columns.reserve(scratch.hard.count);
  for (std::size_t k = 0; k < scratch.hard.count; ++k)
    columns.add(scratch.hard.at(k), scratch.hard.number[k]);
  const OwnLimits own{robot.velocity, robot.vertical,
                      decision.options.control_time * robot.max_acceleration, robot.max_speed};
  append_half_spaces(scratch.looked.pairs, own, decision.look.horizon, scratch.half_spaces);
  if (decision.around.movers.empty()) return columns;
  scratch.of_movers.clear();
  append_mover_planes(robot, decision.around.movers, decision.options, decision.full_horizon,
                      scratch.of_movers);
  columns.reserve(columns.count + scratch.of_movers.size());
  double number = static_cast<double>(kMostRobots);  // they come after all neighbors
  for (const HalfSpace& plane : scratch.of_movers)
    columns.add(to_own(plane, robot.vertical), number++);
  return columns;
}

}  // namespace

HalfSpaceColumns& all_half_spaces(const Deciding& decision) {
  PlanWorkspace::Scratch& scratch = decision.scratch;
  if (scratch.has_all) return scratch.half_spaces.columns;
  scratch.has_all = true;
  pairs_that_cut(decision.look, decision.around.bodies, scratch.looked);
  return collect_half_spaces(decision);
}

Target target_of(const Deciding& decision, HalfSpaceColumns& half_spaces, Vec3 own_wish) {
  const Robot& robot = decision.robot;
  const std::array<Ball, 2> balls{
      Ball{decision.own_velocity, decision.options.control_time * robot.max_acceleration},
      Ball{{}, robot.max_speed}};
  HalfSpaceColumns& hard = decision.scratch.hard;
  SpaceProgramWorkspace& program = decision.scratch.choice.program;
  const SpaceProgramResult result = nearest_point(half_spaces, balls, own_wish, program);
  Target target{result.point, result.violation};
  if (result.state == SpaceProgramState::balls_disjoint) target.own = decision.own_velocity;
  if (result.state == SpaceProgramState::least_unsafe && hard.count > 0)
    target.own = nearest_point(hard, balls, result.point, program).point;
  return target;
}

// A robot that is free mostly gets what its limits alone allow. So only those
// half-spaces are computed first that may not contain it; where one does not, all of them are.
Target target_of_aim(const Deciding& decision, Vec3 own_aim) {
  PlanWorkspace::Scratch& scratch = decision.scratch;
  scratch.has_all = false;
  const Bodies& bodies = decision.around.bodies;
  const bool has_wash = bodies.has_downwash || decision.robot.downwash > 0.0;
  if (decision.around.is_free && scratch.hard.count == 0 && !has_wash) {
    const Target alone = target_of(decision, scratch.hard, own_aim);
    pairs_without(decision.look, decision.in_space(alone.own), bodies, scratch.looked);
    HalfSpaceColumns& half_spaces = collect_half_spaces(decision);
    if (half_spaces.count == 0) return alone;
    const Target target = target_of(decision, half_spaces, own_aim);
    if (target.own == alone.own && target.violation == 0.0) return target;
  }
  return target_of(decision, all_half_spaces(decision), own_aim);
}

}  // namespace avo::space
