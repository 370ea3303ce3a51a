// SPDX-License-Identifier: Apache-2.0
// Decisions in stages, each for all robots: half-planes, wishes, Eq. (23), certificate.
#include "planner/together.h"

#include <algorithm>
#include <utility>

#include "lp/linear_program.h"
#include "planner/methods/buffered_voronoi.h"
#include "planner/methods/clamped.h"
#include "planner/options.h"
#include "planner/rules/behind_walls.h"
#include "planner/rules/wishes.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "planner/stages/choice.h"
#include "planner/stages/contact.h"
#include "planner/stages/decide.h"
#include "planner/stages/demands.h"
#include "planner/stages/execution.h"
#include "planner/stages/steer.h"
#include "planner/validity.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

// The plans of the other methods, without a certificate.
void adopt(const Planner& planner, Tile& tile, const PlanWorkspace::Scratch& scratch) {
  const DecisionColumns& decisions = scratch.decisions;
  for (std::size_t i = 0; i < tile.robots.count; ++i) {
    Plan& plan = *tile.plan[i];
    if (decisions.state[i] == ProgramState::discs_disjoint) {
      plan = brake(planner, tile.robots.robot(i), PlanStatus::braking, decisions.violation[i]);
      continue;
    }
    const Vec2 target{decisions.target_x[i], decisions.target_y[i]};
    const SoftPlanes& soft = scratch.soft;
    double worst = decisions.violation[i];
    if (soft.exceeding) worst = with_excess(soft.of(i), soft.excess_of(i), target, worst);
    plan = plan_of(planner.options(), tile.robots.velocity(i), target, status_of(worst), worst);
    if (method_traits(planner.options().method).clamps)
      plan = clamped(planner, tile.robots.robot(i), plan, soft.of(i));
    if (soft.overlapping[i] != 0)
      tell(deepest_contact(tile.robots.robot(i), tile.robots.neighbors[i], tile.walls_of(i),
                           certificate_law(planner).step),
           plan);
  }
}

// Limits plans made without a certificate to velocities that the robots can follow.
void keep_within_models(const Planner& planner, Tile& tile) {
  if (planner.options().certificate != Certificate::none || !tile.robots.has_models) return;
  for (std::size_t i = 0; i < tile.plan.size(); ++i) {
    if (tile.robots.model[i] == nullptr) continue;
    *tile.plan[i] = as_followed(planner, tile.robots.robot(i), *tile.plan[i]);
  }
}

// Returns whether the robot decides by a rule other than half-planes; it then decides here.
template <typename Trace>
bool decides_otherwise(const Planner& planner, const Tile& tile, std::size_t i,
                       PlanWorkspace::Scratch& scratch, Trace trace) {
  const PlannerOptions& options = planner.options();
  const RobotColumns& robots = tile.robots;
  const Neighbors& neighbors = robots.neighbors[i];
  const bool valid = tile.trusted || all_valid(robots.robot(i), neighbors);
  const NeighborColumns& columns = *robots.neighbors[i].columns;
  const bool can_follow_any =
      robots.model[i] == nullptr && !columns.has_loiterers && !columns.has_footprints;
  if (!valid || !(can_follow_any || can_follow(robots.robot(i), neighbors, options))) {
    *tile.plan[i] = brake(planner, robots.robot(i), PlanStatus::invalid_input, 0.0);
    remember(*tile.plan[i], *tile.detour[i]);
    return true;
  }
  const bool has_movers = tile.neighbors.has_movers || avoids_union(options.method);
  if (!has_movers || flies(robots, i) || !is_among_movers(options, neighbors)) return false;
  list(neighbors, scratch.listed);
  *tile.plan[i] = decide_among_movers(planner, robots.robot(i), scratch.listed, tile.walls_of(i),
                                      scratch, trace);
  *tile.detour[i] = {};
  remember(*tile.plan[i], *tile.detour[i]);
  return true;
}

// Moves these robots to the end; the others are then the robots of the tile.
template <typename Trace>
void set_apart(const Planner& planner, Tile& tile, PlanWorkspace::Scratch& scratch, Trace trace) {
  for (std::size_t i = 0; i < tile.robots.count;) {
    if (!decides_otherwise(planner, tile, i, scratch, trace)) {
      ++i;
      continue;
    }
    const std::size_t last = --tile.robots.count;
    tile.robots.swap(i, last);
    std::swap(tile.detour[i], tile.detour[last]);
    std::swap(tile.plan[i], tile.plan[last]);
    std::swap(tile.slot[i], tile.slot[last]);
    if (!tile.walls.empty()) std::swap(tile.walls[i], tile.walls[last]);
    if (!tile.maneuvers.empty()) std::swap(tile.maneuvers[i], tile.maneuvers[last]);
  }
}

}  // namespace

template <typename Trace>
void plan_together(const Planner& planner, Tile& tile, PlanWorkspace::Scratch& scratch,
                   StageClock& clock, Trace trace) {
  const PlannerOptions& options = planner.options();
  if (tile.robots.has_models) steer(options, certificate_law(planner).step, tile, scratch.steering);
  trace.prefers(tile.robots);
  set_apart(planner, tile, scratch, trace);
  leave_out_hidden(options, certificate_law(planner).step, tile);
  collect_soft_planes(options, planner.horizon(), certificate_law(planner).step, tile,
                      scratch.soft);
  clock.lap(Stage::half_planes);
  make_wishes(planner, tile, scratch.decisions, trace);
  if (method_traits(options.method).stays_in_cell) {
    wish_within_cells(options, tile.robots, scratch);
    trace.stays_in_cell(tile, scratch.decisions);
  }
  const Execution execution = execution_of(planner, tile.remembers);
  make_aims(planner, execution, tile, scratch.decisions);
  clock.lap(Stage::certificate);
  solve_programs(planner, tile.robots, scratch);
  if ((tile.robots.has_models || !tile.walls.empty()) && !is_external(options.method))
    keep_to_demands(planner, tile, scratch);
  trace.chooses(tile, scratch);
  clock.lap(Stage::program);
  if (goes_through_certificate(options)) {
    decide(planner, execution, tile, scratch, trace);
  } else {
    adopt(planner, tile, scratch);
  }
  keep_within_models(planner, tile);
  clock.lap(Stage::certificate);
}

template void plan_together(const Planner&, Tile&, PlanWorkspace::Scratch&, StageClock&, NoTrace);
template void plan_together(const Planner&, Tile&, PlanWorkspace::Scratch&, StageClock&, Recorder);

namespace {
constexpr std::size_t kMostNear = 2048;  // pairs; memory for more is allocated when it is needed
}  // namespace

void reserve_together(std::size_t robots, std::size_t planes_each, std::size_t planes,
                      std::size_t neighbors_each, std::size_t neighbors, std::size_t braking_steps,
                      PlanWorkspace::Scratch& scratch) {
  scratch.reserve_choice(neighbors_each, braking_steps);
  scratch.certified.constraints.near.reserve(robots, std::min(neighbors, kMostNear));
  scratch.decisions.reserve(robots);
  scratch.rows.reserve(program_rows(planes_each));
  if (robots > 1) scratch.programs.reserve(robots, planes_each, planes);
  reserve(robots, planes, scratch.soft);
}

}  // namespace avo::inline planner
