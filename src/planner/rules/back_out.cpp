// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/back_out.h"

#include <algorithm>

#include "lp/linear_program.h"
#include "planner/rules/arrival.h"
#include "planner/rules/turn_to_room.h"

namespace avo::inline planner {
namespace {

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

}  // namespace

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

template CertifiedChoice choose_and_arrive(const Certifying&, Detour&, NoTrace);
template CertifiedChoice choose_and_arrive(const Certifying&, Detour&, Recorder);

}  // namespace avo::inline planner
