// SPDX-License-Identifier: Apache-2.0
// The decision of a robot outside of the union of its obstacles (§III-C). It is for robots among
// movers alone, and for the methods that avoid a union of any neighbors.
#include <optional>
#include <span>
#include <vector>

#include "avo/half_plane.h"
#include "core/plane.h"
#include "planner/decision.h"
#include "planner/methods/clamped.h"
#include "planner/methods/passive_obstacles.h"
#include "planner/methods/reciprocal_obstacles.h"
#include "planner/options.h"
#include "planner/rules/margin.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "planner/stages/contact.h"
#include "planner/stages/demands.h"
#include "planner/stages/disc_pairs.h"
#include "planner/stages/neighbor_order.h"
#include "planner/stages/pairs.h"
#include "planner/validity.h"
#include "robots/footprint.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

// The rules of method avo towards movers, which leave all avoidance to A (docs/movers.md, "Towards
// movers"). A neighbor that decides is here only if A was asked to avoid it alone.
constexpr double kMoverHorizon = 2.0;  // τ

double horizon_of(const PlannerOptions& options) {
  const double factor = method_traits(options.method).has_rules ? kMoverHorizon : 1.0;
  return factor * options.time_horizon;
}

// radius: m, of the robot's disc, or of each disc of its footprint.
double kept_radius(const PlannerOptions& options, const Robot& robot, double radius,
                   const Pair& pair) {
  return with_margin(
      pair, margin_on_route(mover_margin(options, radius), radius, robot.distance_to_goal));
}

// The pair of the two nearest discs of both.
Pair pair_of_discs(const Discs& discs, const Neighbor& neighbor) {
  const DiscPair nearest = nearest_discs(discs, neighbor);
  return relative(nearest.robot, nearest.neighbor);
}

}  // namespace

template <typename Trace>
Plan decide_among_movers(const Planner& planner, const Robot& robot,
                         std::span<const Neighbor> given, std::span<const Wall> walls,
                         PlanWorkspace::Scratch& scratch, Trace trace) {
  const PlannerOptions& options = planner.options();
  if (!all_valid(robot, given) || !follows_heading(robot) || !can_follow(robot, given, options)) {
    return brake(planner, robot, PlanStatus::invalid_input, 0.0);
  }
  const std::span<const Neighbor> obstacles = nearest_first(robot, given, scratch);
  const Response response = disregards_acceleration(options.method)
                                ? Response::velocity()
                                : Response::proportional(options.control_time);
  std::optional<Discs> discs;  // of a footprint
  if (has_footprint(robot.model)) discs = discs_of(robot, certificate_law(planner).step);
  const double radius = discs ? route_radius(robot.model, robot.radius) : robot.radius;
  bool overlapping = false;
  scratch.obstacles.clear();
  for (const Neighbor& obstacle : obstacles) {
    Pair pair = discs ? pair_of_discs(*discs, obstacle) : relative(robot, obstacle);
    overlapping = overlapping || norm(pair.position) < pair.radius;
    pair.radius = kept_radius(options, robot, radius, pair);
    if (method_traits(options.method).is_reciprocal) {
      scratch.obstacles.push_back(reciprocal_obstacle(options, robot, obstacle));
      continue;
    }
    const double kept = shares(obstacle) ? 0.0 : 1.0;
    const Vec2 v_new_B =
        obstacle.velocity + (response.control_time() * kept) * obstacle.acceleration;
    scratch.obstacles.push_back(
        {{pair, response, horizon_of(options)}, v_new_B, options.time_step});
  }
  Demands& demands = scratch.demands;
  demands.clear();
  // in method avo the certificate itself finds a path around what it refuses
  if (!method_traits(options.method).has_rules)
    collect_demands(planner, robot, walls, certificate_law(planner).step, demands);
  overlapping = overlapping || demands.overlapping;
  // Eq. (14)
  PassiveChoice choice = choose_among_movers(scratch.obstacles, planner.acceleration_disc(robot),
                                             planner.speed_disc(robot), robot.preferred_velocity,
                                             scratch.passive, demands.planes);
  if (choice.state == PassiveState::discs_disjoint) {
    return brake(planner, robot, PlanStatus::braking, choice.violation);
  }
  if (choice.state == PassiveState::least_unsafe && method_traits(options.method).is_reciprocal)
    choice = least_penalty(scratch.obstacles, planner.speed_disc(robot), options.time_horizon,
                           robot.preferred_velocity, scratch.passive);
  if (method_traits(options.method).clamps && !goes_through_certificate(options))
    choice = clamped(choice, robot, options.time_step, scratch.passive.limits);
  trace.goes_around(choice.velocity, scratch);
  Plan plan;
  if (goes_through_certificate(options)) {
    plan =
        certify_among_movers(planner, robot, obstacles, walls, choice, overlapping, scratch, trace);
  } else {
    const double violation =
        with_excess(demands.planes, demands.excess, choice.velocity, choice.violation);
    const bool is_free = choice.state == PassiveState::free && !(violation > 0.0);
    const PlanStatus status = is_free ? PlanStatus::optimal : PlanStatus::least_unsafe;
    plan = plan_of(options, robot.velocity, choice.velocity, status, violation);
    if (overlapping)
      tell(deepest_contact(robot, obstacles, walls, certificate_law(planner).step), plan);
  }
  if (plan.neighbor >= 0)
    plan.neighbor = index_in(given, obstacles[static_cast<std::size_t>(plan.neighbor)]);
  return plan;
}

template Plan decide_among_movers(const Planner&, const Robot&, std::span<const Neighbor>,
                                  std::span<const Wall>, PlanWorkspace::Scratch&, NoTrace);
template Plan decide_among_movers(const Planner&, const Robot&, std::span<const Neighbor>,
                                  std::span<const Wall>, PlanWorkspace::Scratch&, Recorder);

}  // namespace avo::inline planner

namespace avo {

Plan Planner::plan_among_movers(const Robot& robot, std::span<const Neighbor> obstacles,
                                PlanWorkspace& workspace) const {
  Robot steering = robot;
  if (is_rest(robot.velocity)) steering.velocity = {};
  if (is_valid(robot)) steering.preferred_velocity = steered(robot, approach_of(options_));
  if (method_traits(options_.method).stays_in_cell || is_external(options_.method) ||
      !can_rest(robot.model)) {
    std::vector<Neighbor>& movers = PlanWorkspace::Scratch::of(workspace).movers;
    movers.assign(obstacles.begin(), obstacles.end());
    for (Neighbor& mover : movers) {
      if (!is_valid(mover)) continue;  // unchanged, for plan() to refuse
      become_mover(mover);
      mover.loiter.reset();
    }
    return plan(robot, movers, workspace);
  }
  const Plan plan = decide_among_movers(*this, steering, obstacles, {},
                                        PlanWorkspace::Scratch::of(workspace), NoTrace{});
  return with_next_velocity(*this, robot, as_followed(*this, robot, plan));
}

}  // namespace avo
