// SPDX-License-Identifier: Apache-2.0
#include "planner/stages/decide.h"

#include <algorithm>

#include "lp/linear_program.h"
#include "planner/methods/flight.h"
#include "planner/rules/evasion.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "planner/stages/choice.h"
#include "planner/stages/contact.h"
#include "planner/stages/execution.h"
#include "planner/stages/state.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

// m/s: the program's violation, or the larger excess of a neighbor with which everything within
// reach collides.
double most_violation(const SoftPlanes& soft, std::size_t i, double violation) {
  if (!soft.exceeding) return violation;
  for (const double excess : soft.excess_of(i)) violation = std::max(violation, excess);
  return violation;
}

// The inputs of the plans of method avo.
template <typename Trace>
struct Deciding {
  const Planner& planner;
  const Execution& execution;
  Tile& tile;
  PlanWorkspace::Scratch& scratch;
  CertificateLaw law;
  Trace trace;

  bool is_certified() const { return law.kind != Certificate::none; }
  SafetyState state_if_free() const {
    return is_certified() ? SafetyState::safe : SafetyState::unknown;
  }
  double violation(std::size_t i) const {
    return most_violation(scratch.soft, i, scratch.decisions.violation[i]);
  }
  void tell_contact(std::size_t i, Deepest neighbor, Deepest wall) const {
    const RobotColumns& robots = tile.robots;
    tell(deepest_contact(robots.robot(i), robots.neighbors[i], tile.walls_of(i), law.step, neighbor,
                         wall),
         *tile.plan[i]);
  }
};

// Returns whether no neighbor can refuse the robot's choice, neither now nor on a detour that it
// still follows.
template <typename Trace>
bool is_unhindered(const Deciding<Trace>& deciding, std::size_t i) {
  const Tile& tile = deciding.tile;
  if (deciding.law.kind == Certificate::braking_trajectories) {
    if (deciding.scratch.certified.constraints.near.admits[i] == 0) return false;
  } else if (deciding.is_certified()) {
    return false;
  }
  return tile.robots.model[i] == nullptr && tile.detour[i]->angle == 0.0;
}

// Without a certificate walls demand nothing.
template <typename Trace>
void begin_walls(const Deciding<Trace>& deciding, std::size_t i) {
  const RobotColumns& robots = deciding.tile.robots;
  CertificateConstraints& constraints = deciding.scratch.certified.constraints;
  const std::span<const Wall> near = deciding.tile.walls_of(i);
  if ((near.empty() && robots.model[i] == nullptr) || !deciding.is_certified()) {
    constraints.walls.clear();
    constraints.footprint.count = 0;
  } else {
    begin_walls_of(robots.robot(i), near, deciding.law, constraints);
  }
}

// The haste of a robot of any model. A robot that maneuvers must not leave its clear arc, and
// robots with wheels come to rest by their own rule.
template <typename Trace>
Haste haste_of_any(const Deciding<Trace>& deciding, std::size_t i, const Robot& robot) {
  const Execution& execution = deciding.execution;
  Haste haste = haste_of(robot, execution);
  if (is_holonomic(robot.model)) return haste;
  if (deciding.tile.maneuvers[i] != 0 || is_landing(robot, haste, execution))
    haste = haste_at_once(robot, execution);
  const double reach = model_traits(robot.model).reach;
  haste.most *= reach;
  haste.jerk = std::min(haste.jerk * reach, kUnlimited);
  return haste;
}

// Keeps an evasive maneuver beside movers.
template <typename Trace>
void evade(const Deciding<Trace>& deciding, std::size_t i, const FlightConstraints* flight) {
  const auto& [planner, execution, tile, scratch, law, trace] = deciding;
  if (!tile.neighbors.has_movers) return;
  list(tile.robots.neighbors[i], scratch.listed);
  const Sight sight{scratch.listed, tile.walls_of(i), planner.options().wall_range, flight};
  const Robot robot = tile.robots.robot(i);
  Plan& plan = *tile.plan[i];
  keep_evasion(law, robot, sight, false, scratch.evasion, plan);
  trace.evades(law, robot, scratch.listed, scratch.evasion, plan);
  if (flight != nullptr && plan.state == SafetyState::safe &&
      !may_go_on(law, robot, sight, scratch.evasion))
    plan.state = SafetyState::unknown;
}

// Plans for a robot that flies, which can only turn.
template <typename Trace>
void fly(const Deciding<Trace>& deciding, std::size_t i) {
  const auto& [planner, execution, tile, scratch, law, trace] = deciding;
  FlightConstraints& flight = scratch.flight;
  Plan& plan = *tile.plan[i];
  plan = fly_towards(planner, tile.robots.robot(i), tile.robots.neighbors[i], tile.walls_of(i),
                     {scratch.decisions.target(i), deciding.violation(i)}, flight, trace);
  plan.state = flight.are_broken() ? SafetyState::unknown : deciding.state_if_free();
  const bool certified = deciding.is_certified();
  if (scratch.soft.overlapping[i] != 0 || (certified && flight.are_broken()))
    deciding.tell_contact(i, certified ? flight.broken : Deepest{},
                          certified ? flight.broken_wall : Deepest{});
  evade(deciding, i, &flight);
}

// Plans for a robot that no neighbor and no wall hinders: by decide_freely().
template <typename Trace>
void go_freely(const Deciding<Trace>& deciding, std::size_t i) {
  const DecisionColumns& decisions = deciding.scratch.decisions;
  Plan& plan = *deciding.tile.plan[i];
  plan.new_velocity = {decisions.new_x[i], decisions.new_y[i]};
  plan.acceleration = {decisions.a_x[i], decisions.a_y[i]};
  plan.violation = deciding.violation(i);
  plan.status = status_of(plan.violation);
  plan.state = deciding.state_if_free();
  plan.neighbor = plan.wall = -1, plan.depth = 0.0F, plan.evading = false;
  if (deciding.scratch.soft.overlapping[i] != 0) deciding.tell_contact(i, {}, {});
}

// Plans for a robot that must ask the certificate, one by one.
template <typename Trace>
void go_certified(const Deciding<Trace>& deciding, std::size_t i) {
  const auto& [planner, execution, tile, scratch, law, trace] = deciding;
  const RobotColumns& robots = tile.robots;
  const DecisionColumns& decisions = scratch.decisions;
  const Robot robot = robots.robot(i);
  std::span<const HalfPlane> planes = scratch.soft.of(i), hard;
  if (has_demands(tile, i, decisions)) {
    planes = collect_hard_and_soft(planner, robot, tile, i, law.step, scratch);
    hard = scratch.demands.planes;
  }
  const Haste haste = haste_of_any(deciding, i, robot);
  Wished wished{planes,
                hard,
                decisions.wish(i),
                decisions.aim(i),
                decisions.target(i),
                {decisions.next_x[i], decisions.next_y[i]},
                decisions.last_change(i),
                deciding.violation(i),
                scratch.soft.coinciding[i] != 0};
  if (robots.model[i] != nullptr)
    wished.next =
        within_own_limits(robot, law.step.braking_time,
                          executed(robot.velocity, wished.last_change, wished.target, haste));
  Plan& plan = *tile.plan[i];
  plan = certify(planner, law, robots, i, haste, wished, scratch.certified, *tile.detour[i], trace);
  const CertificateConstraints& constraints = scratch.certified.constraints;
  if (scratch.soft.overlapping[i] != 0 || collides(constraints))
    deciding.tell_contact(i, constraints.invariant.broken, constraints.walls.broken);
  plan.state = braking_keeps_clear(constraints) && !tile.neighbors.has_movers
                   ? deciding.state_if_free()
                   : state_of(robot, robots.neighbors[i], tile.walls_of(i), law, constraints).state;
}

}  // namespace

template <typename Trace>
void decide(const Planner& planner, const Execution& execution, Tile& tile,
            PlanWorkspace::Scratch& scratch, Trace trace) {
  const Deciding<Trace> deciding{planner, execution, tile, scratch, certificate_law(planner),
                                 trace};
  const CertificateLaw& law = deciding.law;
  const RobotColumns& robots = tile.robots;
  DecisionColumns& decisions = scratch.decisions;
  CertificateConstraints& constraints = scratch.certified.constraints;
  find_near(robots, law, constraints);
  decide_freely(law.step, execution, robots, decisions);
  if (law.kind == Certificate::braking_trajectories)
    admit_next(robots, decisions.next_x, decisions.next_y, law.step, constraints.near);
  for (std::size_t i = 0; i < robots.count; ++i) {
    trace.proposes(Vec2{decisions.next_x[i], decisions.next_y[i]});
    if (flies(robots, i)) {
      fly(deciding, i);
    } else {
      begin_walls(deciding, i);
      const bool is_free = decisions.is_free[i] != 0.0 && is_unhindered(deciding, i);
      is_free&& constraints.walls.near.empty() ? go_freely(deciding, i) : go_certified(deciding, i);
      evade(deciding, i, nullptr);
    }
    remember(*tile.plan[i], *tile.detour[i]);
  }
}

template void decide(const Planner&, const Execution&, Tile&, PlanWorkspace::Scratch&, NoTrace);
template void decide(const Planner&, const Execution&, Tile&, PlanWorkspace::Scratch&, Recorder);

}  // namespace avo::inline planner
