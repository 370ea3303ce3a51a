// SPDX-License-Identifier: Apache-2.0
#include "guidance/at_goal.h"

#include "certificate/braking_path.h"
#include "planner/stages/certify.h"
#include "robots/model.h"

namespace avo::inline guidance {

Seeker seeker_of(const Comer& robot, const RobotTraits& traits, const Heading& heading) {
  const bool sees_goal = heading.next == robot.end;
  return {.position = robot.position,
          .goal = robot.goal,
          .next = sees_goal ? robot.goal : heading.next - robot.lost,
          .beyond = sees_goal ? robot.goal : heading.goal - robot.lost,
          .radius = traits.radius,
          .max_speed = traits.max_speed,
          .range = robot.range,
          .steers = traits.has_model,
          .yields = heading.yields};
}

AtSharedGoal at_shared_goal(const Seeker& seeker, Occupied& occupied, const Routes& routes,
                            std::span<const Wall> walls, Detour& detour) {
  const bool sees_goal = seeker.next == seeker.goal, taken = is_taken(occupied);
  const bool is_near = sees_goal && seeker.is_near;
  if (seeker.yields || !(is_near || taken)) return {};
  const auto is_among_them = [&] { return is_at_crowd(seeker, occupied, &routes); };
  // a robot with wheels reaches few of the places beside it, and no robot reaches those right
  // beside a mover
  const bool is_content = seeker.steers || occupied.has_movers;
  const bool stays = is_near || (is_content && is_among_them());
  const Vec2 place = place_of(seeker, occupied, walls, stays, detour);
  const bool is_there = place == seeker.position;
  const bool may_stand =
      is_there && (stays || ((seeker.is_at_rest || !sees_goal) && is_among_them()));
  if (is_there && !sees_goal && !may_stand) {  // another robot is in its path
    detour.goal_taken = false;
    return {};
  }
  const bool stood = is_there && seeker.has_stood;
  const bool has_stood = stood || (may_stand && seeker.is_at_rest);
  const Vec2 heads_for = place == seeker.next ? seeker.beyond : place;
  if (stood && seeker.is_at_rest && detour.goal_taken)
    return {heads_for, has_stood, !occupied.has_movers};
  // once it has stood it yields to others as all do
  return {heads_for, has_stood, is_near && (!has_stood || detour.goal_taken)};
}

Plan stop_of(const Planner& planner, const StepResponse& response, const Robot& robot) {
  const CertificateLaw law = certificate_law(planner);
  const Vec2 next = braked(robot.velocity, decrement_of(robot, law.step));
  Plan plan = plan_under(law, robot, next, PlanStatus::optimal, 0.0);
  const MotionState state{{}, robot.velocity, robot.heading};
  const MotionStep step = is_holonomic(robot.model)
                              ? advance(state, plan, response)
                              : advance(robot.model, {planned_braking(robot), robot.max_speed},
                                        state, plan, response.time_step);
  plan.next_velocity = step.next.velocity;
  return plan;
}

}  // namespace avo::inline guidance
