// SPDX-License-Identifier: Apache-2.0
// Decisions in stages, each for all robots: half-planes, wishes, Eq. (23), certificate.
#include "planner/together.h"

#include <algorithm>

#include "lp/linear_program.h"
#include "lp/programs.h"
#include "planner/decision.h"
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
                            std::span<const HalfPlane> planes, Vec2 wish,
                            std::vector<HalfPlane>& projected) {
  return nearest_point({}, planes, planner.acceleration_disc(robot), planner.speed_disc(robot),
                       wish, projected);
}

template <typename Number>
void solve_in_lanes(const Planner& planner, std::span<const Sensing> robots, const SoftPlanes& soft,
                    std::span<const Vec2> wishes, ProgramBatch<Number>& batch,
                    std::vector<HalfPlane>& projected, std::vector<ProgramResult>& results) {
  batch.clear();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const Robot& robot = *robots[i].robot;
    batch.add(planner.acceleration_disc(robot), robot.max_speed, wishes[i], soft.of(i));
  }
  nearest_points(batch);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!batch.settled(i)) {
      results.push_back(solve_program(planner, *robots[i].robot, soft.of(i), wishes[i], projected));
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
template <typename Scratch>
void solve_programs(const Planner& planner, const SoftPlanes& soft, Scratch& scratch) {
  std::vector<ProgramResult>& results = scratch.results;
  results.clear();
  if (planner.options().precision == Precision::single_precision) {
    return solve_in_lanes(planner, scratch.sensing, soft, scratch.wishes, scratch.in_single,
                          scratch.projected, results);
  }
  if (scratch.sensing.size() > 1) {
    return solve_in_lanes(planner, scratch.sensing, soft, scratch.wishes, scratch.in_double,
                          scratch.projected, results);
  }
  for (std::size_t i = 0; i < scratch.sensing.size(); ++i) {
    results.push_back(solve_program(planner, *scratch.sensing[i].robot, soft.of(i),
                                    scratch.wishes[i], scratch.projected));
  }
}

}  // namespace

void plan_together(const Planner& planner, std::span<const Deciding> robots,
                   PlanWorkspace& workspace, StageClock& clock) noexcept {
  PlanWorkspace::Scratch& scratch = *workspace.scratch_;
  const PlannerOptions& options = planner.options();
  const bool certified = options.method == Method::avo;

  scratch.sensing.clear();
  scratch.deciding.clear();
  for (const Deciding& each : robots) {
    const auto& [robot, neighbors, trusted] = each.sensing;
    const bool valid = trusted ? is_valid(*robot) : all_valid(*robot, neighbors);
    if (!valid || !can_follow(*robot, options)) {
      *each.plan = planner.brake(*robot, PlanStatus::invalid_input, 0.0);
      continue;
    }
    scratch.sensing.push_back(each.sensing);
    scratch.deciding.push_back(each);
  }
  collect_soft_planes(options, *planner.horizon_, scratch.sensing, scratch.soft);
  clock.lap(Stage::half_planes);

  const CertificateLaw law = certificate_law(planner);
  scratch.wishes.clear();
  for (const Deciding& each : scratch.deciding) {
    const auto& [robot, neighbors, trusted] = each.sensing;
    scratch.wishes.push_back(certified
                                 ? wish_of(*robot, neighbors, law.step.time_step, *each.detour)
                                 : robot->preferred_velocity);
  }
  clock.lap(Stage::certificate);

  solve_programs(planner, scratch.soft, scratch);
  clock.lap(Stage::program);

  if (certified) find_near(scratch.sensing, law, scratch.certified.walls);
  for (std::size_t i = 0; i < scratch.deciding.size(); ++i) {
    const Deciding& each = scratch.deciding[i];
    const Robot& robot = *each.sensing.robot;
    const ProgramResult& result = scratch.results[i];
    const bool overlapping = scratch.soft.overlapping[i] != 0;
    if (certified) {
      const Wished wished{scratch.soft.of(i), scratch.soft.excess_of(i), scratch.wishes[i], result,
                          overlapping};
      *each.plan = planner.choose(each.sensing, i, law, wished, workspace, *each.detour);
    } else if (result.state == ProgramState::discs_disjoint) {
      *each.plan = planner.brake(robot, PlanStatus::braking, result.violation);
    } else {
      const double worst = worst_violation(scratch.soft, i, result);
      const PlanStatus status = overlapping   ? PlanStatus::overlapping
                                : worst > 0.0 ? PlanStatus::least_unsafe
                                              : PlanStatus::optimal;
      *each.plan = planner.finish(robot, result.point, status, worst);
    }
  }
  clock.lap(Stage::certificate);
}

void reserve_together(const Planner& planner, std::size_t robots, std::size_t planes_each,
                      std::size_t planes, std::size_t neighbors_each, std::size_t braking_steps,
                      PlanWorkspace& workspace) {
  PlanWorkspace::Scratch& scratch = *workspace.scratch_;
  scratch.reserve_choice(neighbors_each, braking_steps);
  scratch.deciding.reserve(robots);
  scratch.sensing.reserve(robots);
  scratch.wishes.reserve(robots);
  scratch.results.reserve(robots);
  scratch.projected.reserve(4 * planes_each);
  if (planner.options().precision == Precision::single_precision) {
    scratch.in_single.reserve(robots, planes_each, planes);
  } else if (robots > 1) {
    scratch.in_double.reserve(robots, planes_each, planes);
  }
  reserve(robots, planes, planner.options().precision, scratch.soft);
}

}  // namespace avo
