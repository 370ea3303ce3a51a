// SPDX-License-Identifier: Apache-2.0
#include "planner/stages/choice.h"

#include <algorithm>
#include <limits>

#include "lp/linear_program.h"
#include "lp/programs.h"
#include "planner/stages/certify.h"
#include "planner/stages/demands.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

// Solves one program: for the robots that lanes leave out, and for robots that decide alone.
ProgramResult solve_program(const Planner& planner, const Robot& robot,
                            std::span<const HalfPlane> planes, Vec2 wish, ProgramRows& rows) {
  return nearest_point(planes, planner.acceleration_disc(robot), robot.max_speed, wish, rows);
}

}  // namespace

void solve_programs(const Planner& planner, const RobotColumns& robots,
                    PlanWorkspace::Scratch& scratch) {
  const SoftPlanes& soft = scratch.soft;
  DecisionColumns& decisions = scratch.decisions;
  const auto solve = [&](std::size_t i) {
    decisions.take(
        i, solve_program(planner, robots.robot(i), soft.of(i), decisions.aim(i), scratch.rows));
  };
  if (robots.count == 1) return solve(0);
  ProgramBatch& batch = scratch.programs;
  batch.clear();
  const bool unlimited = disregards_acceleration(planner.options().method);
  const double control_time = planner.options().control_time;
  for (std::size_t i = 0; i < robots.count; ++i) {
    const MotionModel* model = robots.has_models ? robots.model[i] : nullptr;
    const double reach = model == nullptr ? 1.0 : model_traits(*model).reach;
    const Disc acceleration =
        unlimited ? Disc{{}, std::numeric_limits<double>::infinity()}
                  : Disc{robots.velocity(i), reach * control_time * robots.max_acceleration[i]};
    batch.add(acceleration, robots.max_speed[i], decisions.aim(i), soft.of(i));
  }
  nearest_points(batch);
  for (std::size_t i = 0; i < robots.count; ++i) {
    if (!batch.settled(i)) {
      solve(i);
      continue;
    }
    const double violation = batch.violation(i);
    decisions.take(i, {batch.point(i), violation,
                       violation > 0.0 ? ProgramState::least_unsafe : ProgramState::optimal});
  }
}

bool has_demands(const Tile& tile, std::size_t i, const DecisionColumns& decisions) {
  if (!tile.walls_of(i).empty()) return true;
  const MotionModel* model = tile.robots.model[i];
  if (model == nullptr || !model_traits(*model).has_own_half_planes) return false;
  const Vec2 target{decisions.target_x[i], decisions.target_y[i]};
  const bool rests = target == Vec2{} && decisions.wish(i) == target &&
                     tile.robots.velocity(i) == target && tile.detour[i]->angle == 0.0;
  return !rests;  // every robot can rest
}

std::span<const HalfPlane> collect_hard_and_soft(const Planner& planner, const Robot& robot,
                                                 const Tile& tile, std::size_t i,
                                                 const StepLaw& law,
                                                 PlanWorkspace::Scratch& scratch) {
  collect_demands(planner, robot, tile.walls_of(i), law, scratch.demands);
  const std::vector<HalfPlane>& hard = scratch.demands.planes;
  const std::span<const HalfPlane> soft = scratch.soft.of(i);
  std::vector<HalfPlane>& planes = scratch.hard_and_soft;
  planes.assign(hard.begin(), hard.end());
  planes.insert(planes.end(), soft.begin(), soft.end());
  return planes;
}

void keep_to_demands(const Planner& planner, const Tile& tile, PlanWorkspace::Scratch& scratch) {
  const StepLaw law = certificate_law(planner).step;
  DecisionColumns& decisions = scratch.decisions;
  for (std::size_t i = 0; i < tile.robots.count; ++i) {
    if (!has_demands(tile, i, decisions) || decisions.state[i] == ProgramState::discs_disjoint)
      continue;
    const Robot robot = tile.robots.robot(i);
    const Vec2 target{decisions.target_x[i], decisions.target_y[i]};
    const auto planes = collect_hard_and_soft(planner, robot, tile, i, law, scratch);
    const Demands& demands = scratch.demands;
    if (demands.overlapping) scratch.soft.overlapping[i] = 1;
    if (demands.out != Vec2{})  // first out of walls
      decisions.aim_x[i] = decisions.wish_x[i] = demands.out.x,
      decisions.aim_y[i] = decisions.wish_y[i] = demands.out.y;
    else if (is_kept(demands, target))
      continue;
    ProgramResult result = solve_program(planner, robot, planes, decisions.aim(i), scratch.rows);
    if (result.state == ProgramState::least_unsafe) {
      result = solve_program(planner, robot, demands.planes, target, scratch.rows);
      for (const HalfPlane& plane : scratch.soft.of(i))
        result.violation = std::max(result.violation, violation(plane, result.point));
    }
    result.violation = with_excess(demands.planes, demands.excess, result.point, result.violation);
    decisions.take(i, result);
  }
}

}  // namespace avo::inline planner
