// SPDX-License-Identifier: Apache-2.0
// One decision in space: wish, target (soft), certificate (hard), detour. The stages are those of
// the plane (ARCHITECTURE.md, "One step").
#include "space/decide.h"

#include <algorithm>
#include <cmath>

#include "core/ranges.h"
#include "core/response_law.h"
#include "planner/execution_kernel.h"
#include "planner/stages/execution.h"
#include "space/arrival.h"
#include "space/choice.h"
#include "space/evasion.h"
#include "space/horizons.h"
#include "space/own_space.h"
#include "space/target.h"
#include "space/trace.h"
#include "space/workspace.h"

namespace avo::space {
namespace {

bool is_sound(const Detour& detour) {
  avo::Detour plane{detour.angle, detour.beside, detour.congestion};
  return avo::is_sound(plane) && is_finite(detour.acceleration);
}

using Lane = scalar::Pack<double>;

scalar::Vec<Lane, 3> in_lane(Vec3 a) {
  return scalar::constant<Lane>(a);
}

Vec3 executed(const Deciding& decision, Vec3 own_target, double gain) {
  const scalar::PackHaste<Lane> haste{gain, decision.haste.most, decision.haste.jerk};
  return scalar::plain(scalar::executed(in_lane(decision.own_velocity),
                                        in_lane(decision.own_last_change), in_lane(own_target),
                                        haste));
}
// The velocity after one step towards v, without haste, in the robot's own space.
Vec3 reached(const Deciding& decision, Vec3 own_target) {
  return scalar::plain(scalar::approach(in_lane(decision.own_velocity), in_lane(own_target),
                                        Lane(decision.haste.most)));
}

// The velocity that Eq. (23) is given for a wish, m/s (docs/smoothness.md).
Vec3 aim_of(Deciding& decision, Vec3 own_wish) {
  if (decision.haste.gain >= 1.0) return own_wish;
  const Vec3 change = own_wish - decision.own_velocity;
  if (!(decision.robot.distance_to_goal < decision.tempo.landing))
    return decision.own_velocity + decision.tempo.unhurried * change;
  const Vec3 aim = decision.own_velocity + change / decision.haste.gain;
  // an acceleration against the aim has to end at once
  if (dot(decision.own_last_change, aim - decision.own_velocity) < 0.0)
    decision.own_last_change = {};
  return aim;
}

// The part of the velocity along the wish that is left, where `next` is chosen.
double part_left(const Deciding& decision, const Choice& choice, Vec3 own_target, Vec3 own_aim,
                 Vec3 own_wish) {
  const auto part = [&](Vec3 own_next, Vec3 own_free) {
    const double unhindered = dot(own_free, own_wish);
    return unhindered > 0.0 ? dot(own_next, own_wish) / unhindered : 1.0;
  };
  const Vec3 unhindered = reached(decision, own_aim);
  if (choice.chosen != Chosen::wanted) return part(decision.own(choice.next_velocity), unhindered);
  return part(reached(decision, own_target), unhindered);
}

void turn(Detour& detour, const Deciding& decision, double rate, bool among_boxes) {
  avo::Detour plane{.angle = detour.angle};
  const avo::Robot same = numbers_of(decision.robot);
  if (rate > 0.0)
    turn_off(plane, same, decision.options.time_step, among_boxes);
  else
    turn_back(plane, same, decision.options.time_step);
  detour.angle = plane.angle;
}

// The choice of a robot with a known target, and its detour, docs/arrival.md, rule 3.
template <typename Trace>
Choice choose_and_arrive(const Deciding& decision, Vec3 wish, Vec3 own_aim, const Target& target,
                         Detour& detour, Trace trace) {
  PlanWorkspace::Scratch& scratch = decision.scratch;
  const Robot& robot = decision.robot;
  const auto choose_near = [&](Vec3 wanted) {
    return choose(robot, wanted, decision.law, scratch.choice, trace);
  };
  const auto turned_off = [&] {
    const Vec3 axis = turn_axis(robot, decision.around.boxes);
    return decision.own(turned_right(wish, axis, detour.angle));
  };
  // a robot that stays where others are at rest on its goal stops, whatever pushes it
  const bool stops = detour.goal_taken && robot.preferred_velocity == Vec3{};
  const Vec3 proposal =
      stops ? backup_velocity(robot, decision.law)
            : decision.in_space(executed(decision, target.own, decision.haste.gain));
  trace.asks(proposal);
  const Choice choice = choose_near(proposal);
  if (!may_detour(numbers_of(robot)) || detour.goal_taken) {
    detour.angle = 0.0F;
    return choice;
  }
  const Vec3 own_wish = decision.own(wish);
  const double left = part_left(decision, choice, target.own, own_aim, own_wish);
  if (left >= kBlocked) turn(detour, decision, -1.0, false);
  const bool turns = left > kStuck && detour.angle > 0.0F;
  Choice next = choice;
  if (turns) {
    const Vec3 turned = turned_off();
    const Target off = target_of(decision, all_half_spaces(decision), turned);
    const Vec3 wanted = decision.in_space(executed(decision, off.own, decision.haste.gain));
    trace.asks_off(wanted);
    next = choose_near(wanted);
  }
  if (left < kFree) {
    const Vec3 turned = turned_off();
    const Target off = target_of(decision, scratch.hard, turned);
    const double kept = std::clamp((left - kStuck) / (kFree - kStuck), 0.0, 1.0);
    const Vec3 smooth = executed(decision, off.own, 1.0);
    const Vec3 before = decision.own(next.next_velocity);
    const Vec3 wanted = decision.in_space(smooth + kept * (before - smooth));
    trace.asks_off(wanted);
    next = choose_near(wanted);
    if (left < kBlocked && part_left(decision, next, off.own, turned, turned) < kBlocked)
      turn(detour, decision, 1.0, scratch.hard.count > 0);
  }
  if ((turns || left < kFree) && next.is_as_wanted()) next.chosen = Chosen::detour;
  return next;
}

PlanStatus status_of(const Choice& choice, double violation) {
  if (choice.chosen == Chosen::backup) return PlanStatus::braking;
  if (choice.chosen == Chosen::detour) return PlanStatus::detour;
  if (!choice.is_as_wanted()) return PlanStatus::refused;
  return violation > 0.0 ? PlanStatus::least_unsafe : PlanStatus::optimal;
}

double radius_of(const Bodies& bodies, int number) {
  const auto at = std::find(bodies.number.begin(), bodies.number.end(), number);
  return bodies.radius[static_cast<std::size_t>(at - bodies.number.begin())];
}

// m: of the present contact, with the possible errors subtracted
double depth_of(const Robot& robot, const Mover& mover, const StepLaw& law) {
  return robot.radius + mover.radius - norm(robot.position - mover.position) -
         error_against(mover, law).position;
}

// Names the deepest contact, where rounding cannot have caused it.
void tell_contact(const Deciding& decision, const BodiesAround& around, Plan& plan) {
  const Constraints& constraints = decision.scratch.choice.constraints;
  double deepest = 0.0;
  const auto tell = [&](const Deepest& found, double radius, int& index) {
    const double feigned = feigned_depth(decision.robot.radius + radius, constraints.own.reach);
    if (!(found.depth > deepest) || !(found.depth > feigned)) return;
    deepest = found.depth;
    plan.status = PlanStatus::overlapping;
    plan.depth = static_cast<float>(found.depth);
    plan.neighbor = plan.box = plan.mover = -1;
    index = found.index;
  };
  const Deepest& neighbor = constraints.invariant.broken;
  if (neighbor.any()) tell(neighbor, radius_of(around.bodies, neighbor.index), plan.neighbor);
  const Deepest& box = constraints.boxes.broken;
  if (box.any()) tell(box, 0.0, plan.box);
  const Deepest& mover = constraints.movers.invariant.broken;
  if (mover.any())
    tell(mover, around.movers[static_cast<std::size_t>(mover.index)].radius, plan.mover);
  // the certificate asks for nothing of a robot at rest
  for (int k = 0; const Mover& other : around.movers)
    tell({k++, depth_of(decision.robot, other, decision.law)}, other.radius, plan.mover);
}

// Eq. (7)
Plan plan_to(Vec3 velocity, Vec3 next_velocity, const StepLaw& law) {
  const double rate = law.braking_time / law.control_time;
  Plan plan;
  plan.next_velocity = next_velocity;
  plan.new_velocity = velocity + (next_velocity - velocity) / rate;
  plan.acceleration = (plan.new_velocity - velocity) / law.control_time;
  return plan;
}

// What one look at the bodies finds.
Viewer look_around(const PlannerOptions& options, std::span<const Horizon> horizons,
                   const StepLaw& law, const Robot& robot, const Tempo& tempo,
                   const BodiesAround& around, PlanWorkspace::Scratch& scratch) {
  Constraints& constraints = scratch.choice.constraints;
  const bool is_known = around.self >= 0.0;
  const Braking own = is_known ? around.bodies.braking(static_cast<std::size_t>(around.self))
                               : braking_of(robot, law);
  begin_constraints(robot, own, law, constraints);
  Viewer look{.robot = robot,
              .braking = constraints.own,
              .deviation = constraints.deviation,
              .law = law,
              .horizon = horizon_of(robot, horizons),
              .control_time = options.control_time,
              .self = around.self,
              .range = around.range,
              .traffic_range = tempo.traffic_range,
              .certified = options.certificate != Certificate::none};
  look_at(look, around.bodies, around.runs, options.max_neighbors, scratch.looked);
  return look;
}

void collect_all_constraints(const PlannerOptions& options, const StepLaw& law, const Robot& robot,
                             const BodiesAround& around, PlanWorkspace::Scratch& scratch) {
  const bool certified = options.certificate != Certificate::none;
  collect_constraints(robot, around.bodies, scratch.looked.near,
                      certified ? around.boxes : std::span<const Box>{}, law,
                      scratch.choice.constraints);
  Constraints& constraints = scratch.choice.constraints;
  if (certified && !around.movers.empty())
    begin_movers(robot, around.movers, constraints.own, constraints.own_direction,
                 constraints.deviation, law, constraints.movers);
}

}  // namespace

template <typename Trace>
Plan decide(const PlannerOptions& options, std::span<const Horizon> horizons, const StepLaw& law,
            const Robot& robot, const Tempo& tempo, const BodiesAround& around, bool remembers,
            PlanWorkspace::Scratch& scratch, Detour& detour, Trace trace) {
  const Viewer look = look_around(options, horizons, law, robot, tempo, around, scratch);
  if (!is_sound(detour)) detour = {};
  Deciding decision{robot,
                    options,
                    law,
                    tempo,
                    haste_at(tempo, robot.distance_to_goal, remembers),
                    horizons.front(),
                    to_own(robot.velocity, robot.vertical),
                    law.braking_time * to_own(detour.acceleration, robot.vertical),
                    look,
                    around,
                    scratch};
  if (!response_law(options).is_gentle()) decision.own_last_change = {};
  collect_hard(decision, around.boxes);
  const Vec3 wish =
      wish_of(look, around.bodies, around.boxes, scratch.looked, options, tempo, detour, trace);
  const Vec3 own_aim = aim_of(decision, to_own(wish, robot.vertical));
  const Target target = target_of_aim(decision, own_aim);
  trace.chooses(decision, own_aim, target);
  collect_all_constraints(options, law, robot, around, scratch);
  Choice choice = choose_and_arrive(decision, wish, own_aim, target, detour, trace);
  const bool is_certified = options.certificate != Certificate::none;
  const bool is_alone = scratch.looked.seen.count == 0;
  const Sight sight{around.movers, around.boxes, is_alone && !options.never_swerves};
  const bool evades = is_certified && keep_evasion(options, law, robot, sight, scratch.evasions,
                                                   scratch.choice, choice.next_velocity);
  if (evades) {
    choice = {choice.next_velocity, Chosen::candidate};
    trace.evades(options, law, robot, sight, scratch);
  }
  Plan plan = plan_to(robot.velocity, choice.next_velocity, law);
  plan.violation = target.violation;
  plan.evading = evades;
  plan.status = status_of(choice, target.violation);
  tell_contact(decision, around, plan);
  const Constraints& constraints = scratch.choice.constraints;
  const bool keeps_clear = !constraints.invariant.doubtful && !constraints.invariant.unknown &&
                           !constraints.boxes.broken.any() && !constraints.boxes.doubtful;
  if (is_certified && keeps_clear && plan.mover < 0) plan.state = SafetyState::safe;
  detour.acceleration = plan.acceleration;
  return plan;
}

template Plan decide(const PlannerOptions&, std::span<const Horizon>, const StepLaw&, const Robot&,
                     const Tempo&, const BodiesAround&, bool, PlanWorkspace::Scratch&, Detour&,
                     NoTrace);
template Plan decide(const PlannerOptions&, std::span<const Horizon>, const StepLaw&, const Robot&,
                     const Tempo&, const BodiesAround&, bool, PlanWorkspace::Scratch&, Detour&,
                     Recorder);

Constraints& admission_of(const PlannerOptions& options, std::span<const Horizon> horizons,
                          const StepLaw& law, const Robot& robot, const BodiesAround& around,
                          PlanWorkspace::Scratch& scratch) {
  const Landing planner{response_law(options), law.lag, law.braking_time};
  look_around(options, horizons, law, robot, tempo_of(robot, planner), around, scratch);
  collect_all_constraints(options, law, robot, around, scratch);
  return scratch.choice.constraints;
}

Plan braking_plan(const Robot& robot, const StepLaw& law) {
  return plan_to(robot.velocity, backup_velocity(robot, law), law);
}

}  // namespace avo::space
