// SPDX-License-Identifier: Apache-2.0
// What one robot does in a cycle before it plans: a step of a simulation does the same for all
// robots (src/sim/set_out.cpp).
#include <algorithm>
#include <cmath>

#include "core/plane.h"
#include "guidance/goals.h"
#include "guidance/resting.h"
#include "guidance/ties.h"
#include "navigator/plan_routes.h"
#include "navigator/state.h"
#include "planner/rules/arrival.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "robots/model.h"

namespace avo::inline navigator {
namespace {

// T: others must have stood on the goal for as long. A robot that only waits there moves on.
constexpr double kStand = 2.0;
// The rest of a route leads to its end if it is not much longer than the straight line. It may be
// so many times as long, and so many radii more.
constexpr double kDirect = 1.5, kNearEnd = 4.0;
constexpr std::size_t kRoomFor = 64;  // neighbors; memory for more is allocated when it is needed

// m², of the two nearest neighbors.
struct Nearest {
  double first = kInfinity, second = kInfinity;
};

Nearest nearest_of(Vec2 position, std::span<const Neighbor> neighbors) {
  Nearest nearest;
  for (const Neighbor& neighbor : neighbors) {
    const double squared = norm_squared(neighbor.position - position);
    nearest.second = std::min(nearest.second, std::max(squared, nearest.first));
    nearest.first = std::min(nearest.first, squared);
  }
  return nearest;
}

// Explanations step a copy of the memory: the map of routes that both share must not change then.
bool is_copy(const NavigatorState& state, const Memory& memory) {
  return &memory != &state.memory;
}

void find_walls(NavigatorState& state, Memory& memory, const Robot& robot,
                const RobotTraits& traits) {
  if (state.map.empty()) return;
  WallNeeds needs;
  needs.include(robot, traits, state.planner);
  if (!state.needs || !state.needs->cover(needs)) {
    state.grid = grid_of(state.map, needs);
    state.needs = needs;
    PlanWorkspace::Scratch::of(state.workspace).reserve_walls(kRoomFor, state.grid.most());
  }
  if (memory.passages_for == traits.route_radius) return;
  if (is_copy(state, memory) && memory.routes == state.memory.routes)
    memory.routes = std::make_shared<Routes>(route_rules_of(state.options), state.map,
                                             state.memory.routes->resting());
  memory.passages_for = traits.route_radius;
  std::vector<double> radii = state.options.fleet_radii;
  radii.push_back(traits.route_radius);
  std::sort(radii.begin(), radii.end());
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  memory.routes->find_passages(std::move(radii));
}

// Routes lead around the movers that are at rest now.
void go_around_resting(NavigatorState& state, Memory& memory, const Robot& robot,
                       std::span<const Neighbor> neighbors) {
  std::vector<Wall>& resting = state.resting;
  resting.clear();
  for (const Neighbor& one : neighbors) {
    if (shares(one) || one.trajectory != nullptr || one.acceleration != Vec2{}) continue;
    if (const auto disc = resting_disc(one.position, one.velocity, one.radius, true))
      resting.push_back(*disc);
  }
  const std::vector<Wall>& known = memory.routes->resting();
  if (std::equal(resting.begin(), resting.end(), known.begin(), known.end(),
                 [](const Wall& a, const Wall& b) { return a.a == b.a && a.radius == b.radius; }))
    return;
  auto routes = std::make_shared<Routes>(route_rules_of(state.options), state.map, resting,
                                         memory.routes.get());
  if (memory.is_planned && memory.travel.graph != nullptr)
    memory.travel = plan_anew(*routes, robot.radius, robot.position, state.mission.goal(),
                              state.planner.options().arrival_distance, &memory.travel);
  else if (state.mission.kind != Mission::Kind::route)  // that route leads where it leads
    memory.is_planned = false;
  memory.on.back.reset();
  routes->forget_before();
  if (!is_copy(state, memory)) routes->remember_passages(*memory.routes);
  memory.passages_for = 0.0;
  memory.routes = std::move(routes);
}

// Reserves memory for the first steps of such a robot, so that later ones allocate nothing.
void make_room(NavigatorState& state, const Robot& robot) {
  const StepLaw law = certificate_law(state.planner).step;
  const double steps = braking_steps(robot.max_speed, decrement_of(robot, law));
  state.workspace.reserve(kRoomFor, static_cast<std::size_t>(std::min(steps, 4096.0)) + 3);
  state.occupied.resting.reserve(kRoomFor), state.occupied.worth.reserve(kRoomFor);
  state.claims.parts.resize(1);
  state.claims.parts.front().reserve(kRoomFor), state.claims.claimants.reserve(kRoomFor);
  state.resting.reserve(kRoomFor);
}

// The claims of the others as the robot sees them. A robot that moves on claims nothing.
void collect_claims(NavigatorState& state, const Memory& memory,
                    std::span<const Neighbor> neighbors) {
  if (memory.routes->passages.empty()) return;
  std::vector<Claimant>& claimants = state.claims.parts.front();
  claimants.clear();
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    if (!shares(neighbors[k])) continue;
    Claimant one;
    one.position = neighbors[k].position;
    one.rank = static_cast<std::uint32_t>(k);
    append_claims(*memory.routes, one, neighbors[k].velocity, claimants);
  }
  order_claims(memory.routes->passages.size(), 1, state.claims);
}

bool rests_at_place(const Memory& memory, const Robot& robot) {
  return memory.travel.ends != RouteEnd::short_of && memory.has_stood && robot.velocity == Vec2{};
}

Follower follower_of(const NavigatorState& state, const Memory& memory, const Robot& robot,
                     const RobotTraits& traits, double nearest) {
  Claimant as_seen;
  as_seen.position = robot.position;
  as_seen.rank = std::numeric_limits<std::uint32_t>::max();
  return {.place = memory.on.is_given() ? led_point(robot) : robot.position,
          .as_seen = as_seen,
          .traits = traits,
          .end = end_of(state.mission, memory),
          .own_path = own_path_of(traits.has_model ? &robot.model : nullptr),
          .nearest = nearest,
          .detour = memory.detour.angle,
          .looks_around = looks_around(state.options.id, memory.decisions),
          .rests = rests_at_place(memory, robot)};
}

// m: the target of the disc at the end of the route.
Vec2 disc_goal(const NavigatorState& state, const Memory& memory, const Robot& robot, Vec2 end) {
  const bool is_of_disc =
      memory.on.is_given() && state.mission.heading && !moves_along_heading(robot.model);
  if (is_of_disc) return end;
  return end + disc_center(robot.model, {}, robot.heading);
}

// A closed route, and stages, pass by their end before.
bool leads_to_end(const NavigatorState& state, const Memory& memory, const Robot& robot) {
  if (!memory.on.is_given() || state.mission.kind == Mission::Kind::goal) return true;
  const Vec2 place = led_point(robot);
  const double direct = norm(memory.on.end() - place);
  return memory.on.is_last() &&
         left_of(memory.on, place) <= kDirect * direct + kNearEnd * robot.radius;
}

// Where others stand on the goal, or share it, a free place beside them (docs/arrival.md, rule 4).
AtSharedGoal at_goal(NavigatorState& state, Memory& memory, const Robot& robot,
                     const RobotTraits& traits, const Heading& heading, Vec2 end,
                     std::span<const Neighbor> neighbors, std::span<const Wall> walls,
                     double time_step) {
  if (!leads_to_end(state, memory, robot)) return {};
  const PlannerOptions& options = state.planner.options();
  Seeker seeker =
      seeker_of({.position = robot.position,
                 .goal = disc_goal(state, memory, robot, end),
                 .end = end,
                 .range = options.max_neighbors ? arrival_range(robot, robot.radius) : kInfinity},
                traits, heading);
  seeker.has_stood = memory.has_stood;
  seeker.is_at_rest = robot.velocity == Vec2{};
  seeker.is_near =
      state.mission.is_shared && norm(end - place_of(robot)) <= options.arrival_distance;
  state.occupied.clear();
  for (const Neighbor& neighbor : neighbors) state.occupied.add(seeker, neighbor);
  memory.taken = is_taken(state.occupied) ? memory.taken + time_step : 0.0;
  if (!state.mission.is_shared && memory.taken < kStand * time_to_speed(robot)) return {};
  return at_shared_goal(seeker, state.occupied, *memory.routes, walls, memory.detour);
}

std::optional<Simulation::Wait> waited_for(const NavigatorState& state, const Memory& memory,
                                           const Follower& follower) {
  if (memory.on.is_given())
    return wait_of(*memory.routes, state.claims, follower, as_travel(memory.on), kInfinity);
  return wait_of(*memory.routes, state.claims, follower, memory.travel, kInfinity);
}

Headings headings_of(NavigatorState& state, Memory& memory, const Robot& robot,
                     const Follower& follower, double time_step) {
  if (memory.on.is_given())
    return follow_given(*memory.routes, state.claims, follower, robot.velocity,
                        pursuit_of(state, robot), memory.on);
  if (!memory.routes->empty())
    return guide(*memory.routes, state.claims, follower, time_step, kInfinity, memory.travel,
                 memory.routes->scratch());
  const Heading straight = straight_to(follower.end, follower.traits);
  return {straight, straight};
}

}  // namespace

SetOut set_out(NavigatorState& state, Memory& memory, const Robot& robot,
               std::span<const Neighbor> neighbors, double time_step) {
  SetOut out{robot, {}};
  out.robot.lookahead = kInfinity;
  RobotTraits traits = traits_of(robot, state.options.preferred_speed.value_or(robot.max_speed));
  if (memory.decisions == 0) make_room(state, robot);
  go_around_resting(state, memory, robot, neighbors);
  find_walls(state, memory, robot, traits);
  if (!state.map.empty()) out.walls = state.grid.near(robot.position);
  collect_claims(state, memory, neighbors);
  memory.detour.goal_taken = false;
  const Nearest nearest = nearest_of(robot.position, neighbors);
  if (method_traits(state.planner.options().method).has_rules && nearest.second < kInfinity)
    break_tie(state.options.id, nearest.first, nearest.second, memory.detour);
  if (!state.mission.has_goal()) {
    out.robot.preferred_velocity = {}, out.robot.distance_to_goal = 0.0;
    return out;
  }
  plan_routes(state, memory, robot);
  const Follower follower = follower_of(state, memory, robot, traits, std::sqrt(nearest.first));
  const Headings found = headings_of(state, memory, robot, follower, time_step);
  const Heading& heading = found.heading;
  if (found.by_route.yields) out.wait = waited_for(state, memory, follower);
  const Vec2 end = memory.on.is_given() ? memory.on.end() : follower.end;
  const Vec2 to_disc = robot.position - follower.place;
  Vec2 goal = heading.goal == end ? disc_goal(state, memory, robot, end) : heading.goal + to_disc;
  traits.preferred_speed = heading.preferred_speed;
  out.guide = heading.guide;
  const AtSharedGoal decided =
      at_goal(state, memory, robot, traits, found.by_route, end, neighbors, out.walls, time_step);
  if (decided.heads_for) {
    goal = *decided.heads_for, traits.preferred_speed = found.by_route.preferred_speed;
    out.guide = Guide::place;
  }
  memory.has_stood = decided.has_stood;
  out.stops = decided.stops;
  out.robot.preferred_velocity =
      preferred_velocity(robot.position, robot.velocity, traits, goal, state.response);
  out.robot.distance_to_goal = norm(goal - robot.position);
  if (reach_of(traits) > 0.0 && !decided.heads_for)
    out.robot.lookahead = norm(heading.next - follower.place);
  // a car steers on the circle to the point ahead at which it aims
  if (memory.on.is_given() && heading.guide == Guide::route && !decided.heads_for &&
      turning_radius(robot.model) > 0.0)
    out.robot.distance_to_goal = norm(found.by_route.next - follower.place);
  return out;
}

}  // namespace avo::inline navigator
