// SPDX-License-Identifier: Apache-2.0
// Method avo: the paper's program gives the target (soft), the certificate limits it (hard), and
// the rules for arriving turn the wish. Behind another method the certificate limits its choice,
// and only the rule for detours turns it.
#include "planner/stages/certify.h"

#include <algorithm>

#include "planner/rules/back_out.h"
#include "planner/rules/evasion.h"
#include "planner/scratch.h"
#include "planner/stages/contact.h"
#include "planner/stages/execution.h"
#include "planner/stages/state.h"
#include "robots/model.h"

namespace avo::inline planner {

CertificateLaw certificate_law(const Planner& planner) {
  const PlannerOptions& options = planner.options();
  // Held motion uses exactly time_step: what others expect of a robot may not depend on its δ.
  const double braking_time = options.motion == Motion::held
                                  ? options.time_step
                                  : planner.step_rate() * options.control_time;
  const double longest = options.longest_step > 0.0 ? options.longest_step : options.time_step;
  const double longest_step = options.clock == Clock::free ? longest : 0.0;
  return {.kind = options.certificate,
          .step = {.time_step = options.time_step,
                   .lag = planner.step_lag(),
                   .braking_time = braking_time,
                   .sensing_error = options.sensing_error,
                   .control_time = options.control_time,
                   .longest_step = longest_step,
                   .localization_error = options.localization_error}};
}

namespace {

PlanStatus certified_status(Chosen chosen, double violation) {
  if (chosen == Chosen::backup) return PlanStatus::braking;
  if (chosen == Chosen::detour) return PlanStatus::detour;
  return chosen == Chosen::candidate ? PlanStatus::refused : status_of(violation);
}

}  // namespace

Plan plan_under(const CertificateLaw& law, const Robot& robot, Vec2 next_velocity,
                PlanStatus status, double violation) {
  Plan plan = plan_to(robot, next_velocity, law.step);
  plan.status = status;
  plan.violation = violation;
  return plan;
}

template <typename Trace>
Plan certify(const Planner& planner, const CertificateLaw& law, const RobotColumns& robots,
             std::size_t i, const Haste& haste, const Wished& wished, CertifiedWorkspace& certified,
             Detour& detour, Trace trace) {
  const Robot robot = robots.robot(i);
  const Certifying decision{robot, law, haste, planner.acceleration_disc(robot), wished, certified};
  begin_constraints(robot, robots.neighbors[i], i, law, certified.constraints);
  const CertifiedChoice choice = choose_and_arrive(decision, detour, trace);
  return plan_under(law, robot, choice.next_velocity,
                    certified_status(choice.chosen, wished.violation), wished.violation);
}

template Plan certify(const Planner&, const CertificateLaw&, const RobotColumns&, std::size_t,
                      const Haste&, const Wished&, CertifiedWorkspace&, Detour&, NoTrace);
template Plan certify(const Planner&, const CertificateLaw&, const RobotColumns&, std::size_t,
                      const Haste&, const Wished&, CertifiedWorkspace&, Detour&, Recorder);

template <typename Trace>
Plan certify_among_movers(const Planner& planner, const Robot& robot,
                          std::span<const Neighbor> neighbors, std::span<const Wall> walls,
                          const PassiveChoice& target, bool overlapping,
                          PlanWorkspace::Scratch& scratch, Trace trace) {
  CertifiedWorkspace& certified = scratch.certified;
  const CertificateLaw law = certificate_law(planner);
  std::vector<Neighbor>& movers = scratch.movers;
  movers.assign(neighbors.begin(), neighbors.end());
  for (Neighbor& mover : movers) {
    become_mover(mover);
  }
  collect_constraints(robot, movers, law, certified.constraints, walls);
  // the last acceleration is not stored here
  const Execution execution = execution_of(planner, false);
  const bool with_robots =
      std::any_of(neighbors.begin(), neighbors.end(), [](const Neighbor& n) { return shares(n); });
  Haste haste = with_robots ? haste_of(robot, execution) : haste_at_once(robot, execution);
  haste.most *= model_traits(robot.model).reach;
  const Vec2 wanted = executed(robot.velocity, {}, target.velocity, haste);
  trace.asks(wanted);
  const CertifiedChoice choice =
      choose_certified(robot, wanted, law, certified, Follows::perhaps, trace);
  Plan plan = plan_under(law, robot, choice.next_velocity,
                         certified_status(choice.chosen, target.violation), target.violation);
  const CertificateConstraints& constraints = certified.constraints;
  const Neighbors& seen = constraints.alone.neighbors[0];
  if (overlapping || collides(constraints))
    tell(deepest_contact(robot, seen, walls, law.step, constraints.invariant.broken,
                         constraints.walls.broken),
         plan);
  plan.state = state_of(robot, seen, walls, law, constraints).state;
  const bool may_swerve = !with_robots && !planner.options().never_swerves;
  keep_evasion(law, robot, {movers, walls, planner.options().wall_range}, may_swerve,
               scratch.evasion, plan);
  trace.evades(law, robot, movers, scratch.evasion, plan);
  return plan;
}

template Plan certify_among_movers(const Planner&, const Robot&, std::span<const Neighbor>,
                                   std::span<const Wall>, const PassiveChoice&, bool,
                                   PlanWorkspace::Scratch&, NoTrace);
template Plan certify_among_movers(const Planner&, const Robot&, std::span<const Neighbor>,
                                   std::span<const Wall>, const PassiveChoice&, bool,
                                   PlanWorkspace::Scratch&, Recorder);

}  // namespace avo::inline planner
