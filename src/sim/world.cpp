// SPDX-License-Identifier: Apache-2.0
// Makes a world, with room for all that its steps will need.
#include "sim/world.h"

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

#include "core/plane.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "planner/validity.h"
#include "sim/clocks.h"
#include "sim/floors.h"
#include "sim/scene/scene_checks.h"
#include "sim/sensing/sense.h"
#include "sim/travels.h"

namespace avo::inline sim {
namespace {

bool is_certified(const Pace& pace) {
  return pace.planner.options().certificate != Certificate::none;
}

// The largest number of steps that any robot may brake for, from the velocities that it may choose.
std::size_t most_braking_steps(const World& world) {
  if (!world.all_matter()) return 0;
  constexpr double kMostAhead = 4096.0;  // memory for more is allocated when it is needed
  double braking_time = kInfinity;       // s, of the shortest step
  for (const Pace& pace : world.paces)
    if (is_certified(pace))
      braking_time = std::min(braking_time, certificate_law(pace.planner).step.braking_time);
  const double error =
      // m/s by which a robot may be faster
      world.certified_planner().options().sensing_error.velocity;
  double most = 0.0;
  for (const RobotTraits& robot_traits : world.fleet.traits) {
    const double fastest = robot_traits.max_speed + error;
    const double a = robot_traits.max_acceleration, b = robot_traits.max_braking;
    most = std::max(most, fastest / (b * braking_time) + a / b);
  }
  if (world.settings.sensing.misses()) most += kMostCarried;
  return static_cast<std::size_t>(std::min(most + 3.0, kMostAhead));
}

constexpr std::size_t kMostAhead = 1024;  // memory for more is allocated when it is needed

// The number of neighbors that a robot may sense, among those with reserved room.
std::size_t most_seen(const World& world) {
  const std::size_t all = world.fleet.size() + world.movers.setup.size();
  const std::size_t seen = std::min(all, kMostAhead);
  return world.all_matter() ? seen : std::min(seen, world.most_nearest());
}

// Reserves room for so many within the sensing radius: a crowd that grows during a run allocates
// nothing.
void reserve(const World& world, Worker& worker) {
  const std::size_t robots = world.fleet.size(), movers = world.movers.setup.size();
  worker.movers.reserve(1, std::min(movers, kMostAhead));
  const std::size_t seen = most_seen(world);
  worker.outliers.reserve(1, seen / 4);
  worker.again.reserve(1, seen);
  const std::size_t together = std::min(kTileRobots, robots);
  worker.queries.reserve(together);
  worker.staying.reserve(together);
  worker.headings.reserve(together);
  worker.travels.reserve(together), worker.has_stood.reserve(together);
  worker.occupied.resting.reserve(seen);
  worker.occupied.worth.reserve(seen);
  worker.search.reserve(
      together, std::min(together * robots, kTileCandidates + std::min(robots, kMostAhead)));
  const std::size_t sensed = std::min(together * seen, kTileCandidates + seen);
  worker.tile.reserve(together, sensed);
  if (!world.senses.are_exact()) worker.seen.reserve(seen), worker.sightings.reserve(seen);
  if (world.planner().options().localization_error > 0.0) worker.lost.reserve(together);
  const std::size_t nearest = std::min(seen, world.most_nearest());
  reserve_together(together, nearest, std::min(together * nearest, kTileCandidates + nearest), seen,
                   sensed, most_braking_steps(world), PlanWorkspace::Scratch::of(worker.workspace));
}

void find_passages(World& world, std::size_t floor) {
  std::vector<double> radii;
  for (std::size_t slot = 0; slot < world.fleet.size(); ++slot) {
    if (!world.fleet.is_parked(slot) && world.floor_of(slot) == floor)
      radii.push_back(world.fleet.traits[slot].route_radius);
  }
  std::sort(radii.begin(), radii.end());
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  world.routes[floor].find_passages(std::move(radii));
}

void start_clocks(World& world, const Scenario& scenario) {
  if (!world.fleet.has_clocks) return;
  for (std::size_t slot = 0; slot < world.fleet.size(); ++slot) {
    OwnClock& clock = world.fleet.clock_of(slot);
    clock.time_step = time_step_of(scenario, scenario.robots[slot]);
    start_clock(world, slot);
  }
}

}  // namespace

World::World(const Scenario& scenario, std::shared_ptr<Executor> steps_by)
    : settings(scenario),
      sensing_radius(sensing_radius_of(scenario)),
      paces{Pace(planner_options(scenario))},
      movers(scenario.moving_obstacles),
      statics(static_world(scenario)),
      claims(statics.floors.size()),
      executor(std::move(steps_by)),
      workers(executor->workers()) {
  fleet.has_clocks = scenario.clock == Clock::free;
  fleet.usual = usual_method(scenario);
  fleet.reserve(scenario.robots.size());
  settings.robots = std::vector<RobotSetup>();  // {} would keep their memory
  settings.moving_obstacles = std::vector<MovingObstacle>();
  settings.obstacles = std::vector<StaticObstacle>();
  // they follow from the robots at the start
  const PlannerOptions agreed = certified_options(scenario);
  if (agreed.sensing_error != SensingError{}) settings.sensing_error = agreed.sensing_error;
  if (fleet.has_clocks) settings.longest_step = agreed.longest_step;
  senses = senses_of(scenario);
  for (const RobotSetup& setup : scenario.robots) {
    senses.reserve_one(knots_needed(scenario, planner().options().longest_step, setup));
    fleet.add({next_id++}, setup, pace_of(setup));
    senses.add(moment());
  }
  for (const Floor& own : statics.floors)
    routes.emplace_back(route_rules_of(scenario), own.walls, movers.resting());
  floor = floors_of(fleet, statics);
  start_clocks(*this, scenario);
  senses.note(fleet, steps);
  for (Worker& worker : workers) reserve(*this, worker);
}

FleetSummary summary_of(const World& world) {
  const Fleet& fleet = world.fleet;
  FleetSummary summary{.is_valid = world.sensing_radius <= kFarthestTrusted};
  for (std::size_t slot = 0; slot < fleet.size(); ++slot) {
    const RobotTraits& traits = fleet.traits[slot];
    if (!fleet.decides(slot)) ++summary.idle;
    summary.exceeds = summary.exceeds || traits.exceeds;
    summary.is_fast = summary.is_fast || world.is_fast(slot);
    summary.is_valid =
        summary.is_valid && is_valid(fleet.sensed(slot)) && traits.max_speed <= kFarthestTrusted;
  }
  return summary;
}

void World::reserve_workers() noexcept {
  try {
    for (Worker& worker : workers) reserve(*this, worker);
  } catch (const std::bad_alloc&) {
    return;
  }
}

namespace {

void find_walls(World& world, std::size_t number) {
  find_passages(world, number);
  Floor& floor = world.statics.floors[number];
  const Fleet& fleet = world.fleet;
  WallNeeds needs;
  for (std::size_t slot = 0; slot < fleet.size(); ++slot) {
    if (fleet.is_parked(slot) || world.floor_of(slot) != number) continue;
    Robot robot = limits_of(fleet, slot);
    robot.velocity = fleet.velocity[slot];
    needs.include(robot, fleet.traits[slot], world.pace(slot).planner);
  }
  // a grid for more would list more walls, and a simulation made from saved bytes would not have it
  if (floor.needs && floor.needs->is_same(needs)) return;
  floor.grid = grid_of(floor.walls, needs);
  floor.needs = needs;
}

}  // namespace

void find_walls(World& world) {
  for (std::size_t k = 0; k < world.statics.floors.size(); ++k)
    if (!world.statics.floors[k].walls.empty()) find_walls(world, k);
}

void make_room(World& world) {
  std::size_t most = 0, targets = 0;
  for (const Floor& floor : world.statics.floors) most = std::max(most, floor.grid.most());
  for (const Routes& routes : world.routes) targets = std::max(targets, routes.most_targets());
  for (Worker& worker : world.workers) {
    PlanWorkspace::Scratch::of(worker.workspace).reserve_walls(most_seen(world), most);
    worker.legs.targets.reserve(targets);
    if (world.planner().options().localization_error > 0.0)
      worker.walls.reserve(kTileRobots * most);
  }
}

bool World::all_matter() const {
  return std::any_of(paces.begin(), paces.end(), is_certified);
}

const Planner& World::certified_planner() const {
  const auto place = std::find_if(paces.begin(), paces.end(), is_certified);
  return (place != paces.end() ? *place : paces.front()).planner;
}

std::size_t World::most_nearest() const {
  const std::optional<int>& most = planner().options().max_neighbors;
  return most ? static_cast<std::size_t>(*most) : std::numeric_limits<std::size_t>::max();
}

bool World::has_routes() const {
  return avo::has_routes(statics, routes);
}

bool World::has_passages() const {
  return std::any_of(routes.begin(), routes.end(),
                     [](const Routes& own) { return !own.passages.empty(); });
}

bool World::is_fast(std::size_t slot) const {
  const double limit = (1.0 + kSpeedRounding) * fleet.traits[slot].max_speed;
  return !(norm_squared(fleet.velocity[slot]) <= limit * limit);
}

}  // namespace avo::inline sim
