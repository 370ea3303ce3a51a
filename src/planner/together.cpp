// SPDX-License-Identifier: Apache-2.0
// Decisions in stages, each for all robots: half-planes, wishes, Eq. (23), certificate.
#include "planner/together.h"

#include <algorithm>
#include <utility>

#include "core/response_time_kernel.h"
#include "lp/linear_program.h"
#include "planner/arrival.h"
#include "planner/behind_walls.h"
#include "planner/buffered_voronoi.h"
#include "planner/certify.h"
#include "planner/choice.h"
#include "planner/clamped.h"
#include "planner/contact.h"
#include "planner/demands.h"
#include "planner/execution.h"
#include "planner/flight.h"
#include "planner/scratch.h"
#include "planner/state.h"
#include "planner/steer.h"
#include "planner/validity.h"
#include "robots/model.h"

namespace avo {
namespace {

// Beside walls a robot on its way does not give way: pushed back from them and from others at rest
// it would stand still for ever.
Vec2 push_among_walls(const Tile& tile, std::size_t i, const StepLaw& law, Vec2 push) {
  const std::span<const Wall> walls = tile.walls_of(i);
  if (walls.empty() || push == Vec2{}) return push;
  const Robot robot = tile.robots.robot(i);
  return !is_near_goal(robot) && is_beside(robot, walls, law) ? Vec2{} : push;
}

// What each robot wishes for.
void make_wishes(const Planner& planner, const Tile& tile, DecisionColumns& decisions) {
  const PlannerOptions& options = planner.options();
  const RobotColumns& robots = tile.robots;
  decisions.reserve(robots.count);
  if (options.method != Method::avo) {
    std::copy_n(robots.preferred_x.begin(), robots.count, decisions.wish_x.begin());
    std::copy_n(robots.preferred_y.begin(), robots.count, decisions.wish_y.begin());
    return;
  }
  look_around(robots, decisions);
  for (std::size_t i = 0; i < robots.count; ++i) {
    decisions.ahead[i] =
        unusual_congestion(decisions.ahead[i], robots.max_speed[i], robots.max_acceleration[i],
                           options.time_step, *tile.detour[i]);
  }
  keep_right(robots, decisions);
  const StepLaw law = certificate_law(planner).step;
  for (std::size_t i = 0; i < robots.count; ++i) {
    if (robots.has_models && tile.maneuvers[i] != 0) {
      decisions.wish_x[i] = robots.preferred_x[i], decisions.wish_y[i] = robots.preferred_y[i];
      continue;
    }
    Traffic traffic = decisions.traffic(i);
    Detour& detour = *tile.detour[i];
    if (!traffic.is_beside && detour.beside == 0.0F) continue;
    traffic.push = push_among_walls(tile, i, law, traffic.push);
    const Vec2 wish = wish_of(robots.robot(i), decisions.wish(i), traffic, options, detour);
    decisions.wish_x[i] = wish.x, decisions.wish_y[i] = wish.y;
  }
}

// Whom nobody can refuse its choice, neither now nor on a detour that it is still on.
bool is_unhindered(const CertificateLaw& law, const Tile& tile, const NearPairs& near,
                   std::size_t i) {
  if (law.kind == Certificate::braking_trajectories) {
    if (near.admits[i] == 0) return false;
  } else if (law.kind != Certificate::none) {
    return false;
  }
  return tile.robots.model[i] == nullptr && tile.detour[i]->angle == 0.0;
}

// m/s: the program's, and by how much a neighbor with which everything within reach collides asks
// for more.
double most_violation(const SoftPlanes& soft, std::size_t i, double violation) {
  if (!soft.exceeding) return violation;
  for (const double excess : soft.excess_of(i)) violation = std::max(violation, excess);
  return violation;
}

// With no certificate there is nothing that they demand.
void begin_walls(const RobotColumns& robots, const Tile& tile, std::size_t i,
                 const CertificateLaw& law, WallConstraints& walls) {
  const std::span<const Wall> near = tile.walls_of(i);
  if (near.empty() || law.kind == Certificate::none) {
    walls.clear();
  } else {
    begin_walls(robots.robot(i), near, law.step, walls);
  }
}

// Of any model. Who maneuvers leaves no arc that is clear, and those with wheels have their own way
// to come to rest.
Haste haste_of_any(const Robot& robot, bool maneuvers, const Execution& execution) {
  Haste haste = haste_of(robot, execution);
  if (is_holonomic(robot.model)) return haste;
  if (maneuvers || is_landing(robot, haste, execution))
    haste = {1.0, execution.braking_time * robot.max_acceleration, kUnlimited};
  haste.most *= reach_of(robot.model);
  haste.jerk = std::min(haste.jerk * reach_of(robot.model), kUnlimited);
  return haste;
}

// Whether is_landing() surely says no, told without a division: nearly always.
bool is_far_from_goal(const RobotColumns& robots, std::size_t i, const Execution& execution) {
  if (execution.comfort_jerk < kUnlimited) return false;
  const double v = robots.max_speed[i], a = robots.max_acceleration[i];
  const double fewest = v * (1.0 / (scalar::kFewestSteps * execution.braking_time));
  const double b = std::min({a, robots.max_braking[i], execution.comfort_acceleration, fewest});
  const double response = execution.response_time * v + 2.0 * execution.time_step * a;  // times a
  return 2.0 * a * b * robots.distance_to_goal[i] > 1.01 * v * (v * a + 4.0 * b * response);
}

// What the last steps have done, and what the program is given for the wishes.
void make_aims(const Execution& execution, bool is_gentle, const Tile& tile,
               DecisionColumns& decisions) {
  const RobotColumns& robots = tile.robots;
  std::copy_n(decisions.wish_x.begin(), robots.count, decisions.aim_x.begin());
  std::copy_n(decisions.wish_y.begin(), robots.count, decisions.aim_y.begin());
  if (!is_gentle) return;
  for (std::size_t i = 0; i < robots.count; ++i) {
    const Detour& detour = *tile.detour[i];
    decisions.last_x[i] = execution.braking_time * detour.acceleration_x;
    decisions.last_y[i] = execution.braking_time * detour.acceleration_y;
    if (robots.model[i] != nullptr || is_far_from_goal(robots, i, execution)) continue;
    const Robot robot = robots.robot(i);
    const Haste haste = haste_of(robot, execution);
    if (!is_landing(robot, haste, execution)) continue;
    const Vec2 v = robot.velocity, aim = v + (decisions.wish(i) - v) / haste.gain;
    // what still drives it on has to end at once
    if (dot(decisions.last_change(i), aim - v) < 0.0)
      decisions.last_x[i] = decisions.last_y[i] = 0.0;
    decisions.aim_x[i] = aim.x, decisions.aim_y[i] = aim.y;
  }
}

void remember(const Plan& plan, Detour& detour) {
  detour.acceleration_x = static_cast<float>(plan.acceleration.x);
  detour.acceleration_y = static_cast<float>(plan.acceleration.y);
}

// The plans of method avo: of nearly all robots in lanes, of the others one by one.
void decide(const Planner& planner, const Execution& execution, Tile& tile,
            PlanWorkspace::Scratch& scratch) {
  const CertificateLaw law = certificate_law(planner);
  const RobotColumns& robots = tile.robots;
  const SoftPlanes& soft = scratch.soft;
  DecisionColumns& decisions = scratch.decisions;
  NearPairs& near = scratch.certified.constraints.near;
  const SafetyState state_if_free =
      law.kind == Certificate::none ? SafetyState::unknown : SafetyState::safe;
  find_near(robots, law, scratch.certified.constraints);
  decide_freely(law.step, execution, robots, decisions);
  if (law.kind == Certificate::braking_trajectories) {
    admit_next(robots, decisions.next_x, decisions.next_y, law.step, near);
  }
  for (std::size_t i = 0; i < robots.count; ++i) {
    Plan& plan = *tile.plan[i];
    const bool overlapping = soft.overlapping[i] != 0;
    const double violation = most_violation(soft, i, decisions.violation[i]);
    if (robots.model[i] != nullptr && passes_goal(*robots.model[i])) {
      const Vec2 target{decisions.target_x[i], decisions.target_y[i]};
      const FlightConstraints& flight = scratch.flight;
      plan = fly_towards(planner, robots.robot(i), robots.neighbors[i], tile.walls_of(i),
                         {target, violation}, scratch.flight);
      plan.state = flight.are_broken() ? SafetyState::unknown : state_if_free;
      const bool certified = law.kind != Certificate::none;
      if (overlapping || (certified && flight.are_broken()))
        tell(deepest_contact(robots.robot(i), robots.neighbors[i], tile.walls_of(i), law.step,
                             certified ? flight.broken : Deepest{},
                             certified ? flight.broken_wall : Deepest{}),
             plan);
      continue;
    }
    WallConstraints& walls = scratch.certified.constraints.walls;
    begin_walls(robots, tile, i, law, walls);
    if (decisions.is_free[i] != 0.0 && is_unhindered(law, tile, near, i) && walls.near.empty()) {
      plan.new_velocity = {decisions.new_x[i], decisions.new_y[i]};
      plan.acceleration = {decisions.a_x[i], decisions.a_y[i]};
      plan.violation = violation;
      plan.status = status_of(violation);
      plan.state = state_if_free;
      plan.neighbor = plan.wall = -1, plan.depth = 0.0F;
      if (overlapping)
        tell(deepest_contact(robots.robot(i), robots.neighbors[i], tile.walls_of(i), law.step),
             plan);
      continue;
    }
    std::span<const HalfPlane> planes = soft.of(i), hard;
    if (has_demands(tile, i, decisions)) {
      planes = collect_hard_and_soft(planner, robots.robot(i), tile, i, law.step, scratch);
      hard = scratch.demands.planes;
    }
    const Robot robot = robots.robot(i);
    const bool maneuvers = robots.has_models && tile.maneuvers[i] != 0;
    const Haste haste = haste_of_any(robot, maneuvers, execution);
    Wished wished{planes,
                  hard,
                  decisions.wish(i),
                  decisions.aim(i),
                  decisions.target(i),
                  {decisions.next_x[i], decisions.next_y[i]},
                  decisions.last_change(i),
                  violation,
                  soft.coinciding[i] != 0};
    if (robots.model[i] != nullptr)
      wished.next =
          within_own_limits(robot, law.step.braking_time,
                            executed(robot.velocity, wished.last_change, wished.target, haste));
    plan = certify(planner, law, robots, i, haste, wished, scratch.certified, *tile.detour[i]);
    const CertificateConstraints& constraints = scratch.certified.constraints;
    if (overlapping || collides(constraints))
      tell(deepest_contact(robots.robot(i), robots.neighbors[i], tile.walls_of(i), law.step,
                           constraints.invariant.broken, constraints.walls.broken),
           plan);
    plan.state =
        braking_keeps_clear(constraints) && !tile.neighbors.has_movers
            ? state_if_free
            : state_of(robots.robot(i), robots.neighbors[i], tile.walls_of(i), law, constraints)
                  .state;
  }
}

// The plans of the other methods.
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
    if (planner.options().method == Method::orca_clamped)
      plan = clamped(planner, tile.robots.robot(i), plan, soft.of(i));
    if (soft.overlapping[i] != 0)
      tell(deepest_contact(tile.robots.robot(i), tile.robots.neighbors[i], tile.walls_of(i),
                           certificate_law(planner).step),
           plan);
  }
}

// Plans made without a certificate, whose choices are made of what robots can follow.
void keep_within_models(const Planner& planner, Tile& tile) {
  if (planner.options().certificate != Certificate::none || !tile.robots.has_models) return;
  for (std::size_t i = 0; i < tile.plan.size(); ++i) {
    if (tile.robots.model[i] == nullptr) continue;
    *tile.plan[i] = as_followed(planner, tile.robots.robot(i), *tile.plan[i]);
  }
}

// Whether the robot decides by something else than half-planes: it does so here.
bool decides_otherwise(const Planner& planner, const Tile& tile, std::size_t i,
                       PlanWorkspace::Scratch& scratch) {
  const PlannerOptions& options = planner.options();
  const RobotColumns& robots = tile.robots;
  const Neighbors& neighbors = robots.neighbors[i];
  const bool valid = tile.trusted || all_valid(robots.robot(i), neighbors);
  const bool can_follow_any =
      robots.model[i] == nullptr && !robots.neighbors[i].columns->has_loiterers;
  if (!valid || !(can_follow_any || can_follow(robots.robot(i), neighbors, options))) {
    *tile.plan[i] = brake(planner, robots.robot(i), PlanStatus::invalid_input, 0.0);
    return true;
  }
  const bool has_movers = tile.neighbors.has_movers || avoids_union(options.method);
  if (!has_movers || !is_among_movers(options, neighbors)) return false;
  list(neighbors, scratch.listed);
  *tile.plan[i] =
      decide_among_obstacles(planner, robots.robot(i), scratch.listed, tile.walls_of(i), scratch);
  *tile.detour[i] = {};
  return true;
}

// They come last, and the others are the robots of the tile from now on.
void set_apart(const Planner& planner, Tile& tile, PlanWorkspace::Scratch& scratch) {
  for (std::size_t i = 0; i < tile.robots.count;) {
    if (!decides_otherwise(planner, tile, i, scratch)) {
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

void plan_together(const Planner& planner, Tile& tile, PlanWorkspace::Scratch& scratch,
                   StageClock& clock) {
  const PlannerOptions& options = planner.options();
  if (tile.robots.has_models) steer(options, certificate_law(planner).step, tile);
  set_apart(planner, tile, scratch);
  if (options.certificate != Certificate::none && !tile.walls.empty())
    leave_out_hidden(options, certificate_law(planner).step, tile);
  collect_soft_planes(options, planner.horizon(), tile, scratch.soft);
  clock.lap(Stage::half_planes);
  make_wishes(planner, tile, scratch.decisions);
  if (options.method == Method::buffered_voronoi) wish_within_cells(options, tile.robots, scratch);
  const Execution execution = execution_of(planner, tile.remembers);
  make_aims(execution, options.method == Method::avo, tile, scratch.decisions);
  clock.lap(Stage::certificate);
  solve_programs(planner, tile.robots, scratch);
  if (tile.robots.has_models || !tile.walls.empty()) keep_to_demands(planner, tile, scratch);
  clock.lap(Stage::program);
  if (options.method == Method::avo) {
    decide(planner, execution, tile, scratch);
    for (std::size_t i = 0; i < tile.robots.count; ++i) remember(*tile.plan[i], *tile.detour[i]);
  } else {
    adopt(planner, tile, scratch);
  }
  keep_within_models(planner, tile);
  clock.lap(Stage::certificate);
}

namespace {
constexpr std::size_t kMostNear = 2048;  // pairs; of more, memory grows when it is needed
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

}  // namespace avo
