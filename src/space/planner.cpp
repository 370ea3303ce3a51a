// SPDX-License-Identifier: Apache-2.0
// One decision in space: wish, target (soft), certificate (hard), detour. The stages are those of
// the plane (ARCHITECTURE.md, "One step").
#include "avo/space/planner.h"

#include <algorithm>
#include <cmath>

#include "core/response_law.h"
#include "planner/execution.h"
#include "planner/execution_kernel.h"
#include "space/arrival.h"
#include "space/choice.h"
#include "space/evasion.h"
#include "space/half_spaces.h"
#include "space/mover_planes.h"
#include "space/own_space.h"
#include "space/step_law.h"
#include "space/validity.h"
#include "space/workspace.h"

namespace avo::space {

PlanWorkspace::PlanWorkspace() : scratch_(std::make_unique<Scratch>()) {}
PlanWorkspace::~PlanWorkspace() = default;
PlanWorkspace::PlanWorkspace(PlanWorkspace&&) noexcept = default;
PlanWorkspace& PlanWorkspace::operator=(PlanWorkspace&&) noexcept = default;

namespace {

bool is_sound(const Detour& detour) {
  avo::Detour plane{detour.angle, detour.beside, detour.congestion};
  return avo::is_sound(plane) && is_finite(detour.acceleration);
}

// The inputs of a decision. Velocities with `own` in their names are in the robot's own space.
struct Decision {
  const Robot& robot;
  const PlannerOptions& options;
  StepLaw law;
  Haste haste;
  Vec3 axis;  ///< about which it turns to its right
  Vec3 own_velocity, own_last_change;
  PlanWorkspace::Scratch& scratch;

  Vec3 own(Vec3 a) const { return to_own(a, robot.vertical); }
  Vec3 in_space(Vec3 a) const { return from_own(a, robot.vertical); }
};

using Lane = scalar::Pack<double>;

scalar::Vec<Lane, 3> in_lane(Vec3 a) {
  return scalar::constant<Lane>(a);
}

Vec3 executed(const Decision& decision, Vec3 own_target, double gain) {
  const scalar::PackHaste<Lane> haste{gain, decision.haste.most, decision.haste.jerk};
  return scalar::plain(scalar::executed(in_lane(decision.own_velocity),
                                        in_lane(decision.own_last_change), in_lane(own_target),
                                        haste));
}
// The velocity after one step towards v, without haste, in the robot's own space.
Vec3 reached(const Decision& decision, Vec3 own_target) {
  return scalar::plain(scalar::approach(in_lane(decision.own_velocity), in_lane(own_target),
                                        Lane(decision.haste.most)));
}

/// A target, and by how much it violates the half-spaces.
struct Target {
  Vec3 own;  ///< [v'] m/s
  double violation = 0.0;
};

// Eq. (23) among the half-spaces of `planes`, the first `hard` of which are hard. Where nothing
// keeps all of them, the hard ones are kept, near the least unsafe point.
Target target_of(const Decision& decision, std::span<const HalfSpace> planes, std::size_t hard,
                 Vec3 own_wish) {
  const Robot& robot = decision.robot;
  const std::array<Ball, 2> balls{
      Ball{decision.own_velocity, decision.options.control_time * robot.max_acceleration},
      Ball{{}, robot.max_speed}};
  SpaceProgramWorkspace& program = decision.scratch.choice.program;
  const SpaceProgramResult result = nearest_point(planes, balls, own_wish, program);
  Target target{result.point, result.violation};
  if (result.state == SpaceProgramState::balls_disjoint) target.own = decision.own_velocity;
  if (result.state == SpaceProgramState::least_unsafe && hard > 0)
    target.own = nearest_point(planes.first(hard), balls, result.point, program).point;
  return target;
}

// The hard half-spaces and then the soft ones, in the robot's own space.
void collect_planes(const Decision& decision, std::span<const Neighbor> neighbors,
                    std::span<const Mover> movers, std::span<const Box> boxes,
                    const Horizon& horizon) {
  const Robot& robot = decision.robot;
  PlanWorkspace::Scratch& scratch = decision.scratch;
  collect_half_spaces(robot, neighbors, decision.options, horizon, scratch.half_spaces);
  append_mover_planes(robot, movers, decision.options, horizon, scratch.half_spaces.soft);
  scratch.speeds.clear();
  append_speed_planes(robot, boxes, decision.law, scratch.speeds);
  scratch.planes.clear();
  append_climb(robot, scratch.planes);
  for (const HalfSpace& plane : scratch.speeds)
    scratch.planes.push_back(to_own(plane, robot.vertical));
  scratch.hard = scratch.planes.size();
  for (const HalfSpace& plane : scratch.half_spaces.soft)
    scratch.planes.push_back(to_own(plane, robot.vertical));
}

// The velocity that Eq. (23) is given for a wish, m/s (docs/smoothness.md).
Vec3 aim_of(Decision& decision, Vec3 own_wish, const Execution& execution) {
  if (decision.haste.gain >= 1.0) return own_wish;
  const avo::Robot same = numbers_of(decision.robot);
  const Vec3 change = own_wish - decision.own_velocity;
  if (!is_landing(same, decision.haste, execution))
    return decision.own_velocity + std::min(unhurried_part(same, execution), 1.0) * change;
  const Vec3 aim = decision.own_velocity + change / decision.haste.gain;
  // an acceleration against the aim has to end at once
  if (dot(decision.own_last_change, aim - decision.own_velocity) < 0.0)
    decision.own_last_change = {};
  return aim;
}

// The part of the velocity along the wish that is left, where `next` is chosen.
double part_left(const Decision& decision, const Choice& choice, Vec3 own_target, Vec3 own_aim,
                 Vec3 own_wish) {
  const auto part = [&](Vec3 own_next, Vec3 own_free) {
    const double unhindered = dot(own_free, own_wish);
    return unhindered > 0.0 ? dot(own_next, own_wish) / unhindered : 1.0;
  };
  const Vec3 unhindered = reached(decision, own_aim);
  if (choice.chosen != Chosen::wanted) return part(decision.own(choice.next_velocity), unhindered);
  return part(reached(decision, own_target), unhindered);
}

void turn(Detour& detour, const Decision& decision, double rate, bool among_boxes) {
  avo::Detour plane{.angle = detour.angle};
  const avo::Robot same = numbers_of(decision.robot);
  if (rate > 0.0)
    turn_off(plane, same, decision.options.time_step, among_boxes);
  else
    turn_back(plane, same, decision.options.time_step);
  detour.angle = plane.angle;
}

// The choice of a robot whose target is known, and its detour, docs/arrival.md, rule 3.
Choice choose_and_arrive(const Decision& decision, Vec3 wish, Vec3 own_aim, const Target& target,
                         Detour& detour) {
  PlanWorkspace::Scratch& scratch = decision.scratch;
  const Robot& robot = decision.robot;
  const auto choose_near = [&](Vec3 own_next) {
    return choose(robot, decision.in_space(own_next), decision.law, scratch.choice);
  };
  const Choice choice = choose_near(executed(decision, target.own, decision.haste.gain));
  if (!may_detour(numbers_of(robot)) || detour.goal_taken) {
    detour.angle = 0.0F;
    return choice;
  }
  const Vec3 own_wish = decision.own(wish);
  const double left = part_left(decision, choice, target.own, own_aim, own_wish);
  if (left >= kBlocked) turn(detour, decision, -1.0, false);
  const bool turns = left > kStuck && detour.angle > 0.0F;
  Choice next = choice;
  const std::span<const HalfSpace> planes = scratch.planes;
  if (turns) {
    const Vec3 turned = decision.own(turned_right(wish, decision.axis, detour.angle));
    const Target off = target_of(decision, planes, scratch.hard, turned);
    next = choose_near(executed(decision, off.own, decision.haste.gain));
  }
  if (left < kFree) {
    const Vec3 turned = decision.own(turned_right(wish, decision.axis, detour.angle));
    const Target off = target_of(decision, planes.first(scratch.hard), scratch.hard, turned);
    const double kept = std::clamp((left - kStuck) / (kFree - kStuck), 0.0, 1.0);
    const Vec3 smooth = executed(decision, off.own, 1.0);
    const Vec3 before = decision.own(next.next_velocity);
    next = choose_near(smooth + kept * (before - smooth));
    if (left < kBlocked && part_left(decision, next, off.own, turned, turned) < kBlocked)
      turn(detour, decision, 1.0, scratch.hard > 0);
  }
  if ((turns || left < kFree) && next.chosen == Chosen::wanted) next.chosen = Chosen::detour;
  return next;
}

PlanStatus status_of(Chosen chosen, double violation) {
  if (chosen == Chosen::backup) return PlanStatus::braking;
  if (chosen == Chosen::detour) return PlanStatus::detour;
  if (chosen == Chosen::candidate) return PlanStatus::refused;
  return violation > 0.0 ? PlanStatus::least_unsafe : PlanStatus::optimal;
}

// Names the deepest contact, where rounding cannot have caused it.
void tell_contact(const Decision& decision, std::span<const Neighbor> neighbors,
                  std::span<const Mover> movers, Plan& plan) {
  const Constraints& constraints = decision.scratch.choice.constraints;
  double deepest = 0.0;
  const auto tell = [&](const Deepest& found, double radius, int& index) {
    if (!found.any() || !(found.depth > deepest)) return;
    const double feigned = feigned_depth(decision.robot.radius + radius, constraints.own.reach);
    if (!(found.depth > feigned)) return;
    deepest = found.depth;
    plan.status = PlanStatus::overlapping;
    plan.depth = static_cast<float>(found.depth);
    plan.neighbor = plan.box = plan.mover = -1;
    index = found.index;
  };
  const auto radius_in = [](const auto& bodies, const Deepest& found) {
    return found.any() ? bodies[static_cast<std::size_t>(found.index)].radius : 0.0;
  };
  const Deepest& neighbor = constraints.invariant.broken;
  const Deepest& mover = constraints.movers.invariant.broken;
  tell(neighbor, radius_in(neighbors, neighbor), plan.neighbor);
  tell(constraints.boxes.broken, 0.0, plan.box);
  tell(mover, radius_in(movers, mover), plan.mover);
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

void begin(const PlannerOptions& options, const Robot& robot, std::span<const Neighbor> neighbors,
           std::span<const Mover> movers, std::span<const Box> boxes, const StepLaw& law,
           PlanWorkspace::Scratch& scratch) {
  const bool certified = options.certificate != Certificate::none;
  Constraints& constraints = scratch.choice.constraints;
  begin_constraints(robot, certified ? neighbors : std::span<const Neighbor>{},
                    certified ? boxes : std::span<const Box>{}, law, constraints);
  if (certified && !movers.empty())
    begin_movers(robot, movers, constraints.own, constraints.own_direction, constraints.deviation,
                 law, constraints.movers);
}

}  // namespace

Planner::Planner(const PlannerOptions& options)
    : options_(options), horizon_(options.control_time, options.time_horizon, options.time_step) {
  validate_in_space(options);
}

Plan Planner::plan(const Robot& robot, std::span<const Neighbor> neighbors,
                   PlanWorkspace& workspace, Detour* detour, std::span<const Box> boxes,
                   std::span<const Mover> movers) const {
  const StepLaw law = step_law(options_, horizon_);
  Detour next = detour != nullptr && is_sound(*detour) ? *detour : Detour{};
  if (!are_valid(options_, robot, neighbors, boxes, movers)) {
    const bool is_known = is_valid(robot);
    Plan plan = is_known ? plan_to(robot.velocity, backup_velocity(robot, law), law) : Plan{};
    plan.status = PlanStatus::invalid_input;
    return plan;
  }
  PlanWorkspace::Scratch& scratch = *workspace.scratch_;
  const Execution execution{response_law(options_), law.braking_time, detour != nullptr};
  Decision decision{robot,
                    options_,
                    law,
                    haste_of(numbers_of(robot), execution),
                    axis_across(robot.preferred_velocity),
                    to_own(robot.velocity, robot.vertical),
                    law.braking_time * to_own(next.acceleration, robot.vertical),
                    scratch};
  if (!execution.law.is_gentle()) decision.own_last_change = {};
  collect_planes(decision, neighbors, movers, boxes, horizon_);
  const Vec3 wish = wish_of(robot, neighbors, options_, decision.axis, next);
  const Vec3 own_aim = aim_of(decision, to_own(wish, robot.vertical), execution);
  const Target target = target_of(decision, scratch.planes, scratch.hard, own_aim);
  begin(options_, robot, neighbors, movers, boxes, law, scratch);
  Choice choice = choose_and_arrive(decision, wish, own_aim, target, next);
  const bool is_certified = options_.certificate != Certificate::none;
  const bool evades =
      is_certified && keep_a_way_out(options_, law, robot,
                                     {movers, boxes, neighbors.empty() && !options_.never_swerves},
                                     scratch.ways, scratch.choice, choice.next_velocity);
  if (evades) choice.chosen = Chosen::candidate;
  Plan plan = plan_to(robot.velocity, choice.next_velocity, law);
  plan.violation = target.violation;
  plan.evading = evades;
  plan.status = status_of(choice.chosen, target.violation);
  tell_contact(decision, neighbors, movers, plan);
  const Constraints& constraints = scratch.choice.constraints;
  const bool keeps_clear = !constraints.invariant.doubtful && !constraints.invariant.unknown &&
                           !constraints.boxes.broken.any();
  if (is_certified && keeps_clear) plan.state = SafetyState::safe;
  next.acceleration = plan.acceleration;
  if (detour != nullptr) *detour = next;
  return plan;
}

bool Planner::is_admitted(const Robot& robot, std::span<const Neighbor> neighbors,
                          PlanWorkspace& workspace, Vec3 next_velocity,
                          std::span<const Box> boxes) const {
  if (!are_valid(options_, robot, neighbors, boxes) || !is_finite(next_velocity)) return false;
  const StepLaw law = step_law(options_, horizon_);
  PlanWorkspace::Scratch& scratch = *workspace.scratch_;
  const Vec3 own = to_own(next_velocity, robot.vertical);
  const double change = norm(own - to_own(robot.velocity, robot.vertical));
  if (change > robot.max_acceleration * law.braking_time || norm(own) > robot.max_speed ||
      next_velocity.z > robot.climb || -next_velocity.z > robot.sink)
    return false;
  begin(options_, robot, neighbors, {}, boxes, law, scratch);
  return admits(robot, next_velocity, law, Asked::until_refused, scratch.choice.constraints);
}

namespace {

StepLaw checked_law(const PlannerOptions& options) {
  validate_in_space(options);
  return step_law(options, Horizon(options.control_time, options.time_horizon, options.time_step));
}

// m: how far a robot gets in a step and in stopping from its highest speed, with its radius.
double reach_of(const Robot& robot, const StepLaw& law) {
  const double fastest = robot.max_speed * std::max(robot.vertical, 1.0);
  const Vec3 top = robot.vertical > 1.0 ? Vec3{0.0, 0.0, fastest} : Vec3{fastest, 0.0, 0.0};
  return robot.radius + robot.downwash +
         braking_of(top, robot.max_acceleration, braking_limit(robot), robot.vertical, law).reach;
}

}  // namespace

double box_range(const Robot& robot, const PlannerOptions& options) {
  return (1.0 + 1e-9) * box_reach(robot, checked_law(options));
}

double sensing_range(const Robot& robot, const Mover& mover, const PlannerOptions& options) {
  const StepLaw law = checked_law(options);
  const double steps = 3.0 + robot.max_speed / (braking_limit(robot) * law.braking_time);
  const double t = law.time_step * steps;
  const double way =
      t * norm(mover.velocity) + 0.5 * t * t * (norm(mover.acceleration) + mover.max_deviation);
  return (1.0 + 1e-9) * (reach_of(robot, law) + mover.radius + std::min(way, t * mover.max_speed)) +
         options.sensing_error.position + t * options.sensing_error.velocity;
}

double sensing_range(const Robot& robot, const Robot& other, const PlannerOptions& options) {
  const StepLaw law = checked_law(options);
  return (1.0 + 1e-9) * (reach_of(robot, law) + reach_of(other, law)) +
         options.sensing_error.position;
}

}  // namespace avo::space
