// SPDX-License-Identifier: Apache-2.0
#include "planner/state.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "certificate/inevitable.h"
#include "planner/certify.h"
#include "planner/decision.h"
#include "planner/flight.h"
#include "planner/scratch.h"
#include "robots/model.h"

namespace avo {
namespace {

// With whom contact comes first, of those with whom it is inevitable.
struct FirstContact {
  SafetyReport report;

  void take(std::optional<double> time, int neighbor, int wall) {
    if (!time || (report.state == SafetyState::doomed && !(*time < report.time))) return;
    report = {SafetyState::doomed, neighbor, wall, *time};
  }
};

// What state() holds a robot against: who has no certificate could brake as others do, too.
CertificateLaw law_of_state(const Planner& planner) {
  CertificateLaw law = certificate_law(planner);
  if (law.kind == Certificate::none) law.kind = Certificate::braking_trajectories;
  if (adopts_at_once(planner.options().method)) law.step.lag = 0.5 * law.step.time_step;
  return law;
}

}  // namespace

SafetyReport state_of(const Robot& robot, const Neighbors& neighbors, std::span<const Wall> walls,
                      const CertificateLaw& law, const CertificateConstraints& constraints) {
  if (law.kind == Certificate::none) return {};
  const bool is_safe = braking_keeps_clear(constraints);
  FirstContact first{{is_safe ? SafetyState::safe : SafetyState::unknown}};
  if (may_exceed_reach(robot.model)) return first.report;  // more than its acceleration says
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const Neighbor neighbor = neighbors[k];
    if (is_safe && neighbor.behavior == Behavior::decides) continue;
    if (neighbor.loiter) continue;  // it turns faster than its acceleration says
    first.take(inevitable_contact(robot, neighbor, law.step), static_cast<int>(k), -1);
  }
  const bool lost = law.step.localization_error > 0.0;  // it may be elsewhere
  for (std::size_t k = 0; !is_safe && !lost && k < walls.size(); ++k)
    first.take(inevitable_contact(robot, walls[k]), -1, static_cast<int>(k));
  return first.report;
}

SafetyReport Planner::state(const Robot& robot, std::span<const Neighbor> neighbors,
                            PlanWorkspace& workspace, std::span<const Wall> walls) const {
  const bool walls_valid =
      std::all_of(walls.begin(), walls.end(), [](const Wall& wall) { return is_valid(wall); });
  if (!all_valid(robot, neighbors) || !walls_valid || !follows_heading(robot) ||
      !can_follow(robot, neighbors, options_))
    return {};
  const CertificateLaw law = law_of_state(*this);
  if (is_airplane(robot.model)) {
    PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
    collect_flight(with_circle(robot), in_columns(neighbors, scratch.alone.neighbors), walls,
                   law.step, scratch.flight);
    return {scratch.flight.broken ? SafetyState::unknown : SafetyState::safe};
  }
  CertificateConstraints& constraints = PlanWorkspace::Scratch::of(workspace).certified.constraints;
  collect_constraints(robot, neighbors, law, constraints, walls);
  return state_of(robot, constraints.alone.neighbors[0], walls, law, constraints);
}

}  // namespace avo
