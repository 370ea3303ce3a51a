// SPDX-License-Identifier: Apache-2.0
// Decisions in stages, each for all robots: half-planes, wishes, Eq. (23), certificate.
#include "planner/together.h"

#include <algorithm>

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

void solve_in_lanes(const Planner& planner, std::span<const Sensing> robots, const SoftPlanes& soft,
                    std::span<const Vec2> wishes, ProgramBatch& batch, ProgramRows& rows,
                    std::vector<ProgramResult>& results) {
  batch.clear();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const Robot& robot = *robots[i].robot;
    batch.add(planner.acceleration_disc(robot), robot.max_speed, wishes[i], soft.of(i));
  }
  nearest_points(batch);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!batch.settled(i)) {
      results.push_back(solve_program(planner, *robots[i].robot, soft.of(i), wishes[i], rows));
      continue;
    }
    ProgramResult result;
    result.point = batch.point(i);
    result.violation = batch.violation(i);
    if (result.violation > 0.0) result.state = ProgramState::least_unsafe;
    results.push_back(result);
  }
}

// Eq. (23) of each.
void solve_programs(const Planner& planner, const SoftPlanes& soft,
                    PlanWorkspace::Scratch& scratch) {
  std::vector<ProgramResult>& results = scratch.results;
  results.clear();
  if (scratch.sensing.size() > 1) {
    return solve_in_lanes(planner, scratch.sensing, soft, scratch.wishes, scratch.programs,
                          scratch.rows, results);
  }
  for (std::size_t i = 0; i < scratch.sensing.size(); ++i) {
    results.push_back(solve_program(planner, *scratch.sensing[i].robot, soft.of(i),
                                    scratch.wishes[i], scratch.rows));
  }
}

// What each robot wishes for, in columns as well where it is of method avo.
void make_wishes(const PlannerOptions& options, PlanWorkspace::Scratch& scratch) {
  scratch.wishes.clear();
  if (options.method != Method::avo) {
    for (const Sensing& each : scratch.sensing) {
      scratch.wishes.push_back(each.robot->preferred_velocity);
    }
    return;
  }
  RobotColumns& columns = scratch.columns;
  columns.reserve(scratch.sensing.size());
  columns.count = 0;
  for (const Sensing& each : scratch.sensing) columns.add(*each.robot);
  look_around(scratch.sensing, columns);
  keep_right(columns);
  for (std::size_t i = 0; i < columns.count; ++i) {
    const Vec2 wish =
        wish_of(*scratch.sensing[i].robot, {columns.wish_x[i], columns.wish_y[i]},
                {columns.push_x[i], columns.push_y[i]}, options, *scratch.deciding[i].detour);
    columns.wish_x[i] = wish.x, columns.wish_y[i] = wish.y;
    scratch.wishes.push_back(wish);
  }
}

// Whom nobody can refuse anything, neither now nor on a detour that it is still on.
bool is_unhindered(const CertificateLaw& law, const Sensing& sensing, const Detour& detour,
                   const NearPairs& near, std::size_t i) {
  if (law.kind == Certificate::braking_trajectories) {
    if (!near.of(i).empty() || near.has_movers[i] != 0) return false;
  } else if (law.kind != Certificate::none) {
    return false;
  }
  return !sensing.robot->car && detour.angle == 0.0;
}

// The plans of method avo: of nearly all robots in lanes, of the others one by one.
void decide(const Planner& planner, PlanWorkspace::Scratch& scratch) {
  const CertificateLaw law = certificate_law(planner);
  find_near(scratch.sensing, law, scratch.certified.walls);
  RobotColumns& columns = scratch.columns;
  for (std::size_t i = 0; i < columns.count; ++i) {
    columns.target_x[i] = scratch.results[i].point.x;
    columns.target_y[i] = scratch.results[i].point.y;
  }
  decide_freely(law.step, columns);
  const SoftPlanes& soft = scratch.soft;
  for (std::size_t i = 0; i < columns.count; ++i) {
    const Deciding& each = scratch.deciding[i];
    const Wished wished{soft.of(i),
                        soft.excess_of(i),
                        scratch.wishes[i],
                        scratch.results[i],
                        {columns.next_x[i], columns.next_y[i]},
                        {columns.unhindered_x[i], columns.unhindered_y[i]},
                        soft.overlapping[i] != 0};
    if (columns.is_free[i] == 0.0 ||
        !is_unhindered(law, each.sensing, *each.detour, scratch.certified.walls.near, i)) {
      *each.plan = certify(planner, law, each.sensing, i, wished, scratch.certified, *each.detour);
      continue;
    }
    Plan& plan = *each.plan;
    plan.new_velocity = {columns.new_x[i], columns.new_y[i]};
    plan.acceleration = {columns.a_x[i], columns.a_y[i]};
    plan.violation = soft.exceeding ? wished.violation() : wished.result.violation;
    plan.status = status_of(wished.overlapping, plan.violation);
  }
}

}  // namespace

void plan_together(const Planner& planner, std::span<const Deciding> robots,
                   PlanWorkspace::Scratch& scratch, StageClock& clock) {
  const PlannerOptions& options = planner.options();

  scratch.sensing.clear();
  scratch.deciding.clear();
  for (const Deciding& each : robots) {
    const auto& [robot, neighbors, trusted] = each.sensing;
    const bool valid = trusted ? is_valid(*robot) : all_valid(*robot, neighbors);
    if (!valid || !can_follow(*robot, options)) {
      *each.plan = brake(planner, *robot, PlanStatus::invalid_input, 0.0);
      continue;
    }
    if ((neighbors.columns->has_movers || options.method == Method::velocity_obstacle) &&
        is_among_movers(options, neighbors)) {
      list(neighbors, scratch.listed);
      *each.plan = choose_among_obstacles(planner, *robot, scratch.listed, scratch);
      *each.detour = {};
      continue;
    }
    scratch.sensing.push_back(each.sensing);
    scratch.deciding.push_back(each);
  }
  collect_soft_planes(options, planner.horizon(), scratch.sensing, scratch.soft);
  clock.lap(Stage::half_planes);

  make_wishes(options, scratch);
  clock.lap(Stage::certificate);

  solve_programs(planner, scratch.soft, scratch);
  clock.lap(Stage::program);

  if (options.method == Method::avo) {
    decide(planner, scratch);
    return clock.lap(Stage::certificate);
  }
  for (std::size_t i = 0; i < scratch.deciding.size(); ++i) {
    const Robot& robot = *scratch.deciding[i].sensing.robot;
    const ProgramResult& result = scratch.results[i];
    Plan& plan = *scratch.deciding[i].plan;
    if (result.state == ProgramState::discs_disjoint) {
      plan = brake(planner, robot, PlanStatus::braking, result.violation);
      continue;
    }
    const double worst = worst_violation(scratch.soft, i, result);
    const PlanStatus status = status_of(scratch.soft.overlapping[i] != 0, worst);
    plan = plan_of(options, robot, result.point, status, worst);
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
  scratch.certified.walls.near.reserve(robots, std::min(neighbors, kMostNear));
  scratch.deciding.reserve(robots);
  scratch.sensing.reserve(robots);
  scratch.wishes.reserve(robots);
  scratch.columns.reserve(robots);
  scratch.results.reserve(robots);
  scratch.rows.reserve(program_rows(planes_each));
  if (robots > 1) scratch.programs.reserve(robots, planes_each, planes);
  reserve(robots, planes, scratch.soft);
}

}  // namespace avo
