// SPDX-License-Identifier: Apache-2.0
#include "space/fleet.h"

#include <optional>

#include "core/response_law.h"
#include "planner/rules/arrival.h"
#include "space/boxes.h"
#include "space/certificate.h"
#include "space/horizons.h"
#include "space/own_space.h"
#include "space/step_law.h"
#include "space/validity.h"

namespace avo::space {

SpaceFleet::SpaceFleet(const Scenario& scene, int threads)
    : scenario(scene),
      options(planner_options(scene)),
      horizons(horizons_of(options)),
      law(step_law(options, horizons.front())),
      landing{response_law(options), law.lag, law.braking_time},
      sensing_radius(sensing_radius_of(scene)),
      executor(make_executor(static_cast<std::size_t>(std::max(threads, 0)))),
      cells(sensing_radius),
      senses(senses_of(scene)),
      detours(scene.robots.size()),
      plans(scene.robots.size()),
      touched(scene.robots.size()),
      solids(scene.boxes),
      workers(executor->workers()) {
  validate_in_space(options);
  for (const RobotSetup& setup : scene.robots) {
    robots.push_back(robot_of(setup));
    tempos.push_back(tempo_of(robots.back(), landing));
    has_downwash = has_downwash || robots.back().downwash > 0.0;
    const double range = space::box_range(robots.back(), options);
    trips.push_back({setup.goal, setup.preferred_speed,
                     scene.moving_obstacles.empty() ? range : std::max(range, options.wall_range)});
  }
  for (std::size_t m = 0; m < scene.moving_obstacles.size(); ++m) movers.add(0);
  movers.move_to(steps, scenario.moving_obstacles, scenario.time_step);
  for (std::size_t m = 0; m < movers.now.size(); ++m) movers.begin(m);
  bodies.reserve(robots.size());
  has_stood.resize(robots.size());
  routes = SpaceRoutes(scene.boxes, robots, goals(), scene.navigation);
}

std::vector<Vec3> SpaceFleet::goals() const {
  std::vector<Vec3> all;
  for (const Trip& trip : trips) all.push_back(trip.goal);
  return all;
}

void SpaceFleet::sort() {
  cells.sort(robots);
  bodies.clear();
  for (const std::uint32_t k : cells.order()) bodies.add(neighbor_of(robots[k]), k);
  fill_braking(law, bodies);
}

bool SpaceFleet::is_in_range(Vec3 place, std::size_t k) const {
  return norm_squared(place - robots[k].position) <= sensing_radius * sensing_radius;
}

void SpaceFleet::sense_movers(std::size_t k, SpaceWorker& worker) const {
  worker.movers.clear();
  worker.mover_ids.clear();
  if (movers.now.empty()) return;
  const Observer observer(senses, k, scenario.boxes, solids);
  for (std::size_t m = 0; m < movers.now.size(); ++m) {
    const Mover& mover = movers.now[m];
    if (!is_in_range(mover.position, k)) continue;
    const std::optional<Mover> seen =
        senses.are_exact() ? mover : observer.look_at(m, movers.id[m], mover);
    if (!seen) continue;
    worker.movers.push_back(*seen);
    worker.mover_ids.push_back(movers.id[m]);
  }
}

void SpaceFleet::sense_robots(std::size_t k, std::size_t runs, SpaceWorker& worker) const {
  Bodies& seen = worker.scratch.bodies;
  seen.clear();
  const Observer observer(senses, k, scenario.boxes, solids);
  for (const Run& run : std::span(worker.runs).first(runs)) {
    seen.reserve(seen.count + (run.last - run.first));
    for (std::size_t place = run.first; place < run.last; ++place) {
      const std::size_t other = cells.order()[place];
      if (other == k || !is_in_range(robots[other].position, k)) continue;
      if (const auto neighbor = observer.look_at(other, robots[other])) seen.add(*neighbor, other);
    }
  }
  fill_braking(law, seen);
}

ObstacleId SpaceFleet::obstacle_of(std::size_t box) const {
  const std::vector<std::int64_t>& named = scenario.obstacle_of_box;
  return {box < named.size() ? static_cast<std::uint64_t>(named[box]) : box};
}

void SpaceFleet::find_boxes(std::size_t k, SpaceWorker& worker) const {
  const Vec3 place = robots[k].position;
  worker.lost = senses.own_error(k);
  worker.boxes.clear();
  worker.box_ids.clear();
  solids.find_near(place, trips[k].box_range, worker.near_boxes);
  for (const std::uint32_t b : worker.near_boxes) {
    const Box& box = scenario.boxes[b];
    if (nearest(place, place, box).distance - box.radius > trips[k].box_range) continue;
    worker.boxes.push_back(senses.know_places() ? box : moved(box, -worker.lost));
    worker.box_ids.push_back(obstacle_of(b));
  }
}

void SpaceFleet::head_for_goal(std::size_t k, const BodiesAround& around, SpaceWorker& worker) {
  worker.neighbors.clear();
  const bool looks = !routes.passages().empty() || shares_goal(k);
  for (const Run& run : looks ? around.runs : std::span<const Run>()) {
    for (std::size_t place = run.first; place < run.last; ++place) {
      const Neighbor other = around.bodies.neighbor(place);
      if (static_cast<double>(place) != around.self && is_in_range(other.position, k))
        worker.neighbors.push_back(other);
    }
  }
  const Travelling own{robots[k], routes.memory(k), detours[k], has_stood[k]};
  head_for_goal(k, worker.neighbors, own, worker);
}

Guide SpaceFleet::head_for_goal(std::size_t k, std::span<const Neighbor> company,
                                const Travelling& own, SpaceWorker& worker) const {
  Robot& robot = own.robot;
  const double speed = trips[k].preferred_speed;
  const SpaceHeading heading = heading_of(k, company, own, worker);
  robot.distance_to_goal = heading.left;
  SpaceAtSharedGoal at;
  if (shares_goal(k) && heading.guide != Guide::passage) at = near_goal(k, company, own, worker);
  own.detour.goal_taken = at.is_taken, own.has_stood = at.has_stood ? 1 : 0;
  robot.preferred_velocity = at.has_place
                                 ? preferred_velocity(robot, at.place, speed, landing, tempos[k])
                                 : preferred_velocity(robot, heading.goal - worker.lost,
                                                      heading.speed, landing, tempos[k]);
  return at.has_place ? Guide::place : heading.guide;
}

// Routes are on the map, where the robot takes itself to be at its place with an error.
SpaceHeading SpaceFleet::heading_of(std::size_t k, std::span<const Neighbor> company,
                                    const Travelling& own, SpaceWorker& worker) const {
  const double speed = trips[k].preferred_speed;
  const auto heading = [&](const Robot& robot, std::span<const Neighbor> others) {
    return routes.heading(k, robot, trips[k].goal, speed, view_of(k, others), own.route,
                          worker.routes);
  };
  if (senses.know_places()) return heading(own.robot, company);
  Robot there = own.robot;
  there.position = there.position + worker.lost;
  worker.on_map.assign(company.begin(), company.end());
  for (Neighbor& other : worker.on_map) other.position = other.position + worker.lost;
  return heading(there, worker.on_map);
}

SpaceAtSharedGoal SpaceFleet::near_goal(std::size_t k, std::span<const Neighbor> company,
                                        const Travelling& own, SpaceWorker& worker) const {
  const Robot& robot = own.robot;
  const Vec3 goal = trips[k].goal - worker.lost;
  const SpaceRoute* known = routes.route(k);
  const bool is_kept_out = known != nullptr && !known->reaches;
  if (is_kept_out || routes.is_behind_box(k, robot.position + worker.lost, trips[k].goal))
    return {};
  const SpaceSeeker seeker{
      .position = robot.position,
      .goal = goal,
      .radius = robot.radius,
      .max_speed = robot.max_speed,
      .downwash = robot.downwash,
      .range = arrival_range(numbers_of(robot), robot.radius),
      // it finds no place in the downwash of others, nor beside moving obstacles
      .is_content = has_downwash || !worker.movers.empty(),
      .has_stood = own.has_stood != 0,
      .is_at_rest = robot.velocity == Vec3{},
      .is_near = shares.of(k) == SpaceShares::goal &&
                 norm(goal - robot.position) <= scenario.arrival_distance};
  look_at_goal(seeker, company, worker.occupied);
  return at_shared_goal(seeker, worker.boxes, worker.occupied);
}

bool SpaceFleet::rests_at_place(std::size_t k) const {
  return has_stood[k] != 0 && robots[k].velocity == Vec3{} && shares_goal(k);
}

void SpaceFleet::name_touched(std::size_t k, const SpaceWorker& worker) {
  Plan& plan = plans[k];
  touched[k] = {};
  // the step knows neighbors by their numbers, which are their ids
  if (plan.neighbor >= 0) touched[k].robot = {static_cast<std::uint64_t>(plan.neighbor)};
  if (plan.box >= 0) touched[k].obstacle = worker.box_ids[static_cast<std::size_t>(plan.box)];
  if (plan.mover >= 0)
    touched[k].moving_obstacle = worker.mover_ids[static_cast<std::size_t>(plan.mover)];
  plan.neighbor = plan.box = plan.mover = -1;
}

void SpaceFleet::decide(std::size_t at, SpaceWorker& worker) {
  const std::size_t k = cells.order()[at];
  find_boxes(k, worker);
  const std::size_t runs = cells.around(robots[k].position, worker.runs);
  sense_movers(k, worker);
  const auto decide = [&](const BodiesAround& around) {
    head_for_goal(k, around, worker);
    plans[k] = space::decide(options, horizons, law, robots[k], tempos[k], around, true,
                             worker.scratch, detours[k], NoTrace{});
    if (plans[k].status == PlanStatus::overlapping) name_touched(k, worker);
  };
  if (senses.are_exact())
    return decide({.bodies = bodies,
                   .runs = std::span(worker.runs).first(runs),
                   .self = static_cast<double>(at),
                   .range = sensing_radius,
                   .boxes = worker.boxes,
                   .movers = worker.movers,
                   .is_free = plans[k].status == PlanStatus::optimal});
  sense_robots(k, runs, worker);
  const Run all{0, worker.scratch.bodies.count};
  decide({.bodies = worker.scratch.bodies,
          .runs = std::span(&all, 1),
          .boxes = worker.boxes,
          .movers = worker.movers});
}

void SpaceFleet::find_routes() {
  if (!routes.has_boxes()) return;
  for_all([&](std::size_t k, SpaceWorker& worker) {
    routes.look(k, robots[k], trips[k].goal, worker.routes);
  });
}

void SpaceFleet::move() {
  for (std::size_t k = 0; k < robots.size(); ++k) {
    Robot& robot = robots[k];
    const Vec3 next = plans[k].next_velocity;
    robot.position = robot.position + (law.lag * robot.velocity + (law.time_step - law.lag) * next);
    robot.velocity = next;
  }
}

void SpaceFleet::begin_step() {
  if (has_new_goals) shares.set(robots, goals());
  has_new_goals = false;
  shares.note(robots, has_stood);
  sort();
  senses.note(robots, movers.now, steps);
  routes.begin_step(robots);
}

void SpaceFleet::step() {
  begin_step();
  for_all([&](std::size_t at, SpaceWorker& worker) { decide(at, worker); });
  move();
  for (std::size_t m = 0; m < movers.now.size(); ++m) movers.begin(m);
  ++steps;
  movers.move_to(steps, scenario.moving_obstacles, scenario.time_step);
}

}  // namespace avo::space
