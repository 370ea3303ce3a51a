// SPDX-License-Identifier: Apache-2.0
#include "planner/stages/state.h"

#include <cstddef>
#include <optional>

#include "certificate/inevitable.h"
#include "planner/decision.h"
#include "planner/methods/flight.h"
#include "planner/rules/evasion.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "planner/stages/contact.h"
#include "planner/validity.h"
#include "robots/footprint.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

// The earliest of the inevitable contacts.
struct FirstContact {
  SafetyReport report;

  void take(std::optional<double> time, int neighbor, int wall) {
    if (!time || (report.state == SafetyState::doomed && !(*time < report.time))) return;
    report = {SafetyState::doomed, neighbor, wall, *time};
  }
  // Returns whether no other contact can come earlier: the rest of a crowd is not tested.
  bool is_now() const { return report.state == SafetyState::doomed && !(report.time > 0.0); }
};

// The law that state() uses: a robot without a certificate could brake as others do.
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
  // it may accelerate more than its limit says
  if (may_exceed_reach(model_traits(robot.model))) return first.report;
  for (std::size_t k = 0; k < neighbors.size() && !first.is_now(); ++k) {
    const Neighbor neighbor = neighbors[k];
    if (is_safe && neighbor.behavior == Behavior::decides) continue;
    if (neighbor.loiter) continue;  // it turns faster than its acceleration says
    if (neighbor.footprint || has_footprint(robot.model)) continue;  // their discs may turn aside
    first.take(inevitable_contact(robot, neighbor, law.step), static_cast<int>(k), -1);
  }
  // the robot may be elsewhere, or its discs turn aside
  const bool lost = law.step.localization_error > 0.0 || has_footprint(robot.model);
  for (std::size_t k = 0; !is_safe && !lost && !first.is_now() && k < walls.size(); ++k)
    first.take(inevitable_contact(robot, walls[k]), -1, static_cast<int>(k));
  return first.report;
}

}  // namespace avo::inline planner

namespace avo {
namespace {

void name(const Contact& contact, SafetyReport& report) {
  report.neighbor = contact.neighbor, report.wall = contact.wall, report.depth = contact.depth;
}

SafetyReport state_of_flight(const Robot& robot, const Sight& sight, const CertificateLaw& law,
                             PlanWorkspace::Scratch& scratch) {
  const Neighbors seen = in_columns(sight.neighbors, scratch.alone.neighbors);
  const FlightConstraints& flight = scratch.flight;
  collect_flight(with_circle(robot), seen, sight.walls, law.step, scratch.flight);
  if (!flight.are_broken() && may_go_on(law, robot, sight, scratch.evasion))
    return {SafetyState::safe};
  SafetyReport report;
  name(deepest_contact(robot, seen, sight.walls, law.step, flight.broken, flight.broken_wall),
       report);
  return report;
}

Contact deepest_contact(const Robot& robot, std::span<const Neighbor> neighbors,
                        std::span<const Wall> walls, const CertificateLaw& law,
                        const CertificateConstraints& constraints) {
  return deepest_contact(robot, neighbors, walls, law.step, constraints.invariant.broken,
                         constraints.walls.broken);
}

// The element k, or none.
template <typename T>
std::span<const T> one_of(std::span<const T> all, int k) {
  return k < 0 ? std::span<const T>{} : all.subspan(static_cast<std::size_t>(k), 1);
}

}  // namespace

SafetyReport Planner::state(const Robot& robot, std::span<const Neighbor> neighbors,
                            PlanWorkspace& workspace, std::span<const Wall> walls) const {
  if (!can_decide(robot, neighbors, walls, options_)) return {};
  const CertificateLaw law = law_of_state(*this);
  PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
  if (!can_rest(robot.model))
    return state_of_flight(robot, {neighbors, walls, options_.wall_range}, law, scratch);
  CertificateConstraints& constraints = scratch.certified.constraints;
  collect_constraints(robot, neighbors, law, constraints, walls);
  SafetyReport report = state_of(robot, constraints.alone.neighbors[0], walls, law, constraints);
  if (report.state == SafetyState::unknown)
    name(deepest_contact(robot, neighbors, walls, law, constraints), report);
  if (report.state != SafetyState::doomed) return report;
  // for the depth of the contact with this body
  const auto other = one_of(neighbors, report.neighbor);
  const auto wall = one_of(walls, report.wall);
  collect_constraints(robot, other, law, constraints, wall);
  report.depth = deepest_contact(robot, other, wall, law, constraints).depth;
  return report;
}

}  // namespace avo
