// SPDX-License-Identifier: Apache-2.0
// Decisions in stages, each for all robots: half-planes, wishes, Eq. (23), certificate.
#include "planner/together.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "lp/linear_program.h"
#include "lp/programs.h"
#include "planner/arrival.h"
#include "planner/certify.h"
#include "planner/scratch.h"

namespace avo {
namespace {

// The program's choice, with what no program sees: a neighbor with which everything within reach
// collides leaves CA_A empty.
double worst_violation(const SoftPlanes& soft, std::size_t i, const ProgramResult& result) {
  const std::span<const HalfPlane> planes = soft.of(i);
  const std::span<const double> excess = soft.excess_of(i);
  double worst = result.violation;
  if (!soft.exceeding) return worst;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (excess[k] > 0.0) {
      worst = std::max(worst, excess[k] + std::max(0.0, violation(planes[k], result.point)));
    }
  }
  return worst;
}

// One by one: those that lanes leave out, and robots that decide alone.
ProgramResult solve_program(const Planner& planner, const Robot& robot,
                            std::span<const HalfPlane> planes, Vec2 wish, ProgramRows& rows) {
  return nearest_point(planes, planner.acceleration_disc(robot), robot.max_speed, wish, rows);
}

// Eq. (23) of each.
void solve_programs(const Planner& planner, const RobotColumns& robots,
                    PlanWorkspace::Scratch& scratch) {
  const SoftPlanes& soft = scratch.soft;
  const auto solve = [&](std::size_t i) {
    return solve_program(planner, robots.robot(i), soft.of(i), scratch.wishes[i], scratch.rows);
  };
  scratch.results.clear();
  if (robots.count == 1) return scratch.results.push_back(solve(0));
  ProgramBatch& batch = scratch.programs;
  batch.clear();
  const bool unlimited = adopts_at_once(planner.options().method);
  const double control_time = planner.options().control_time;
  for (std::size_t i = 0; i < robots.count; ++i) {
    const Disc acceleration =
        unlimited ? Disc{{}, std::numeric_limits<double>::infinity()}
                  : Disc{robots.velocity(i), control_time * robots.max_acceleration[i]};
    batch.add(acceleration, robots.max_speed[i], scratch.wishes[i], soft.of(i));
  }
  nearest_points(batch);
  for (std::size_t i = 0; i < robots.count; ++i) {
    if (!batch.settled(i)) {
      scratch.results.push_back(solve(i));
      continue;
    }
    ProgramResult result;
    result.point = batch.point(i);
    result.violation = batch.violation(i);
    if (result.violation > 0.0) result.state = ProgramState::least_unsafe;
    scratch.results.push_back(result);
  }
}

// What each robot wishes for, in columns as well where it is of method avo.
void make_wishes(const PlannerOptions& options, const Tile& tile, PlanWorkspace::Scratch& scratch) {
  const RobotColumns& robots = tile.robots;
  scratch.wishes.clear();
  if (options.method != Method::avo) {
    for (std::size_t i = 0; i < robots.count; ++i) {
      scratch.wishes.push_back({robots.preferred_x[i], robots.preferred_y[i]});
    }
    return;
  }
  ArrivalColumns& arrival = scratch.arrival;
  arrival.reserve(robots.count);
  look_around(robots, arrival);
  keep_right(robots, arrival);
  for (std::size_t i = 0; i < robots.count; ++i) {
    Vec2 wish{arrival.wish_x[i], arrival.wish_y[i]};
    const Vec2 push{arrival.push_x[i], arrival.push_y[i]};
    Detour& detour = *tile.detour[i];
    if (push != Vec2{} || detour.yielded != 0.0) {
      wish = wish_of(robots.robot(i), wish, push, options, detour);
      arrival.wish_x[i] = wish.x, arrival.wish_y[i] = wish.y;
    }
    scratch.wishes.push_back(wish);
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
  return tile.robots.wheelbase[i] == 0.0 && tile.detour[i]->angle == 0.0;
}

// The plans of method avo: of nearly all robots in lanes, of the others one by one.
void decide(const Planner& planner, Tile& tile, PlanWorkspace::Scratch& scratch) {
  const CertificateLaw law = certificate_law(planner);
  const RobotColumns& robots = tile.robots;
  find_near(robots, law, scratch.certified.constraints);
  ArrivalColumns& arrival = scratch.arrival;
  for (std::size_t i = 0; i < robots.count; ++i) {
    arrival.target_x[i] = scratch.results[i].point.x;
    arrival.target_y[i] = scratch.results[i].point.y;
  }
  decide_freely(law.step, robots, arrival);
  NearPairs& near = scratch.certified.constraints.near;
  if (law.kind == Certificate::braking_trajectories) {
    admit_next(robots, arrival.next_x, arrival.next_y, law.step, near);
  }
  const SoftPlanes& soft = scratch.soft;
  for (std::size_t i = 0; i < robots.count; ++i) {
    const Wished wished{soft.of(i),
                        soft.excess_of(i),
                        scratch.wishes[i],
                        scratch.results[i],
                        {arrival.next_x[i], arrival.next_y[i]},
                        {arrival.unhindered_x[i], arrival.unhindered_y[i]},
                        soft.overlapping[i] != 0};
    Plan& plan = *tile.plan[i];
    if (arrival.is_free[i] == 0.0 || !is_unhindered(law, tile, near, i)) {
      plan = certify(planner, law, robots, i, wished, scratch.certified, *tile.detour[i]);
      continue;
    }
    plan.new_velocity = {arrival.new_x[i], arrival.new_y[i]};
    plan.acceleration = {arrival.a_x[i], arrival.a_y[i]};
    plan.violation = soft.exceeding ? wished.violation() : wished.result.violation;
    plan.status = status_of(wished.overlapping, plan.violation);
  }
}

// The plans of the other methods.
void adopt(const Planner& planner, Tile& tile, const PlanWorkspace::Scratch& scratch) {
  for (std::size_t i = 0; i < tile.robots.count; ++i) {
    const ProgramResult& result = scratch.results[i];
    Plan& plan = *tile.plan[i];
    if (result.state == ProgramState::discs_disjoint) {
      plan = brake(planner, tile.robots.robot(i), PlanStatus::braking, result.violation);
      continue;
    }
    const double worst = worst_violation(scratch.soft, i, result);
    const PlanStatus status = status_of(scratch.soft.overlapping[i] != 0, worst);
    plan = plan_of(planner.options(), tile.robots.velocity(i), result.point, status, worst);
  }
}

// Whether the robot decides by something else than half-planes: it does so here.
bool decides_otherwise(const Planner& planner, const Tile& tile, std::size_t i,
                       PlanWorkspace::Scratch& scratch) {
  const PlannerOptions& options = planner.options();
  const RobotColumns& robots = tile.robots;
  const Neighbors& neighbors = robots.neighbors[i];
  const bool valid = tile.trusted || all_valid(robots.robot(i), neighbors);
  const bool can_follow_any = robots.wheelbase[i] == 0.0;
  if (!valid || !(can_follow_any || can_follow(robots.robot(i), options))) {
    *tile.plan[i] = brake(planner, robots.robot(i), PlanStatus::invalid_input, 0.0);
    return true;
  }
  const bool has_movers = tile.neighbors.has_movers || options.method == Method::velocity_obstacle;
  if (!has_movers || !is_among_movers(options, neighbors)) return false;
  list(neighbors, scratch.listed);
  *tile.plan[i] = decide_among_obstacles(planner, robots.robot(i), scratch.listed, scratch);
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
  }
}

}  // namespace

void plan_together(const Planner& planner, Tile& tile, PlanWorkspace::Scratch& scratch,
                   StageClock& clock) {
  const PlannerOptions& options = planner.options();
  set_apart(planner, tile, scratch);
  collect_soft_planes(options, planner.horizon(), tile, scratch.soft);
  clock.lap(Stage::half_planes);
  make_wishes(options, tile, scratch);
  clock.lap(Stage::certificate);
  solve_programs(planner, tile.robots, scratch);
  clock.lap(Stage::program);
  if (options.method == Method::avo) {
    decide(planner, tile, scratch);
  } else {
    adopt(planner, tile, scratch);
  }
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
  scratch.wishes.reserve(robots);
  scratch.arrival.reserve(robots);
  scratch.results.reserve(robots);
  scratch.rows.reserve(program_rows(planes_each));
  if (robots > 1) scratch.programs.reserve(robots, planes_each, planes);
  reserve(robots, planes, scratch.soft);
}

}  // namespace avo
