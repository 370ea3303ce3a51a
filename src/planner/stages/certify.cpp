// SPDX-License-Identifier: Apache-2.0
// Method avo: the paper's program gives the target (soft), the certificate limits it (hard), and
// the rules for arriving turn the wish. Behind another method the certificate limits its choice,
// and only the rule for detours turns it.
#include "planner/stages/certify.h"

#include <algorithm>

#include "core/plane.h"
#include "core/ranges.h"
#include "lp/linear_program.h"
#include "planner/rules/arrival.h"
#include "planner/rules/evasion.h"
#include "planner/scratch.h"
#include "planner/stages/contact.h"
#include "planner/stages/execution.h"
#include "planner/stages/state.h"
#include "robots/footprint.h"
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

// The inputs of a decision; the constraints of the robot are in `certified`.
struct Certifying {
  const Robot& robot;
  CertificateLaw law;
  Haste haste;
  Disc acceleration;  // of v'
  const Wished& wished;
  CertifiedWorkspace& certified;

  Vec2 followed(Vec2 next) const {
    return is_holonomic(robot.model) ? next : within_own_limits(robot, law.step.braking_time, next);
  }
  // The velocity after one step towards v.
  Vec2 reached(Vec2 v) const { return followed(approach(robot.velocity, v, haste.most)); }
  // The same without haste; on a detour only the acceleration limits it.
  Vec2 gently(Vec2 v) const {
    return followed(executed(robot.velocity, wished.last_change, v, haste));
  }
  Vec2 smoothly(Vec2 v) const {
    return followed(executed(robot.velocity, wished.last_change, v, {1.0, haste.most, haste.jerk}));
  }
};

bool turns_at_rest(const Robot& robot) {
  return robot.velocity == Vec2{} && turns_unnoticed(robot.model);
}

// The choice of a robot that turns before it drives: what would be admitted once it has turned.
template <typename Trace>
CertifiedChoice choose_as_turned(const Certifying& decision, Vec2 wanted, Trace trace) {
  Robot turned = decision.robot;
  turned.model = Holonomic{};
  return choose_certified(turned, wanted, decision.law, decision.certified, Follows::perhaps,
                          trace);
}

// The admitted velocity nearest to `wanted`, one step towards the choice of Eq. (23). A car that
// turns in place does not move, so anything is admitted. It would turn in vain towards a direction
// in which it may not drive then, and back again, for ever.
template <typename Trace>
CertifiedChoice choose_admitted(const Certifying& decision, Vec2 wanted, Follows follows,
                                Trace trace) {
  if (!turns_at_rest(decision.robot) || wanted == Vec2{})
    return choose_certified(decision.robot, wanted, decision.law, decision.certified, follows,
                            trace);
  const Vec2 later = choose_as_turned(decision, wanted, trace).next_velocity;
  CertifiedChoice choice =
      choose_certified(decision.robot, later, decision.law, decision.certified);
  if (choice.chosen == Chosen::backup && later != Vec2{})
    choice = choose_certified(decision.robot, turning_first(decision.robot, later), decision.law,
                              decision.certified);
  if (later != wanted && choice.chosen == Chosen::wanted) choice.chosen = Chosen::candidate;
  return choice;
}

// [v'] m/s, Eq. (23).
Vec2 solved(const Certifying& decision, std::span<const HalfPlane> half_planes, Vec2 wish) {
  return nearest_point(half_planes, decision.acceleration, decision.robot.max_speed, wish,
                       decision.certified.rows)
      .point;
}

// The remaining part of the velocity along `wish` if v' is approached at once, as far as the
// certificate allows it. The certificate has been asked for `choice`. aim: the input for which v'
// was chosen.
double part_left(const Certifying& decision, const CertifiedChoice& choice, Vec2 v_new, Vec2 aim,
                 Vec2 wish) {
  if (choice.chosen == Chosen::wanted && v_new == aim && !turns_at_rest(decision.robot))
    return 1.0;  // part_of_wish() of the velocity that an unhindered robot would reach
  const Vec2 unhindered = decision.reached(aim);
  if (turns_at_rest(decision.robot))
    return part_of_wish(choose_as_turned(decision, unhindered, NoTrace{}).next_velocity, unhindered,
                        wish);
  if (choice.chosen != Chosen::wanted) return part_of_wish(choice.next_velocity, unhindered, wish);
  const Vec2 next = v_new == aim ? unhindered : decision.reached(v_new);
  return part_of_wish(next, unhindered, wish);
}

// The choice as far off the route as the detour has led, within the half-planes.
template <typename Trace>
CertifiedChoice choose_as_far_off(const Certifying& decision, const Detour& detour, Trace trace) {
  const Robot& robot = decision.robot;
  const Vec2 turned = within_steering(robot, turned_right(decision.wished.wish, detour.angle));
  const Vec2 v_new = solved(decision, decision.wished.half_planes, turned);
  const Vec2 off = decision.gently(v_new);
  trace.asks_off(off);
  return choose_admitted(decision, off, Follows::surely, trace);
}

// The choice on the detour that the certificate alone admits. It gradually replaces `choice` as
// less of the route is left.
template <typename Trace>
CertifiedChoice choose_detour(const Certifying& decision, const CertifiedChoice& choice,
                              double left, Detour& detour, Trace trace) {
  const Robot& robot = decision.robot;
  const std::span<const HalfPlane> walls = decision.wished.walls;
  const Vec2 turned = within_steering(robot, turned_right(decision.wished.wish, detour.angle));
  const Vec2 v_new = solved(decision, walls, turned);
  const double kept = std::clamp((left - kStuck) / (kFree - kStuck), 0.0, 1.0);
  const Vec2 off = decision.smoothly(v_new);
  const Vec2 wanted = off + kept * (choice.next_velocity - off);
  trace.asks_off(wanted);
  const CertifiedChoice next = choose_admitted(decision, wanted, Follows::perhaps, trace);
  if (left < kBlocked && part_left(decision, next, v_new, turned, turned) < kBlocked)
    turn_off(detour, robot, decision.law.step.time_step, !walls.empty());
  return next;
}

template <typename Trace>
CertifiedChoice choose_and_arrive(const Certifying& decision, Detour& detour, Trace trace) {
  const Robot& robot = decision.robot;
  const Wished& wished = decision.wished;
  trace.asks(wished.next);
  const CertifiedChoice choice = choose_admitted(decision, wished.next, Follows::surely, trace);
  // robots that coincide part by their half-planes, where that is possible at all: on detours from
  // one place to one goal they would stay together
  const bool parts = wished.coinciding && choice.next_velocity != Vec2{};
  if (!may_detour(robot) || detour.goal_taken || parts) {
    detour.angle = 0.0F;
    return choice;
  }
  const double left = part_left(decision, choice, wished.target, wished.aim, wished.wish);
  if (left >= kBlocked) turn_back(detour, robot, decision.law.step.time_step);
  const bool turns = left > kStuck && detour.angle > 0.0F;
  CertifiedChoice next = turns ? choose_as_far_off(decision, detour, trace) : choice;
  if (left < kFree) next = choose_detour(decision, next, left, detour, trace);
  if ((turns || left < kFree) && next.chosen == Chosen::wanted) next.chosen = Chosen::detour;
  return next;
}

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
  keep_a_way_out(law, robot, {movers, walls, planner.options().wall_range}, may_swerve,
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
