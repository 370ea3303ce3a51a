// SPDX-License-Identifier: Apache-2.0
// Adds and removes robots and static obstacles. Everything that may throw comes before any change.
#include "sim/host/edits.h"

#include <algorithm>
#include <limits>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "core/ranges.h"
#include "robots/model.h"
#include "sim/clocks.h"
#include "sim/floors.h"
#include "sim/scene/edit_checks.h"
#include "sim/scene/scene_checks.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// Adds the clock of the last added robot.
void add_clock(World& world, const RobotSetup& setup) {
  if (!world.fleet.has_clocks) return;
  const std::size_t slot = world.fleet.size() - 1;
  OwnClock& clock = world.fleet.clock_of(slot);
  clock.time_step = time_step_of(world.settings, setup);
  start_clock(world, slot);
}

}  // namespace

void join(World& world, const RobotSetup& setup, RobotId robot) {
  const std::uint32_t pace = world.pace_of(setup, true);
  world.senses.reserve_one(
      knots_needed(world.settings, world.planner().options().longest_step, setup));
  world.fleet.add(robot, setup, pace);
  add_clock(world, setup);
  world.senses.add(world.moment());
  world.senses.note(world.fleet, world.steps);
  ++world.next_id;
  world.changed = world.has_new_goals = true;
  try {
    if (world.kinds) world.kinds->add(world.fleet.setup(world.fleet.size() - 1));
    note_late(world.bystanders, robot, disc_center(setup));
  } catch (const std::bad_alloc&) {
    world.kinds.reset();
    forget(world.bystanders);
  }
}

void go_around_resting(World& world) {
  if (world.movers.rest_as(world.routes.front().resting())) return;
  catch_up(world);
  adopt(world, routes_among(world, world.statics));
}

namespace {

// Makes room for one more, rarely.
template <typename Entry>
void reserve_one(std::vector<Entry>& column) {
  if (column.size() == column.capacity()) column.reserve(2 * column.size() + 8);
}

}  // namespace

namespace {

RobotId add_reference(World& world, const RobotSetup& setup) {
  const RobotId robot{world.next_id};
  catch_up(world);
  check_values(world, setup, robot, world.statics.has_walls);
  if (is_parked(setup)) {
    add_parked(world, setup, robot);
    return robot;
  }
  const std::uint32_t floor = floor_for(world, setup.layers);
  if (!world.kinds) world.kinds.emplace(world.fleet);
  look_around_starts(world);
  check_newcomer(world, setup, robot);
  Travel travel;
  if (world.has_routes()) {
    travel =
        world.routes[floor].plan(route_radius(setup.model, disc_radius(setup)), disc_center(setup),
                                 setup.goal, arrival_distance_of(world.settings, setup));
    reserve_one(world.travels);
  }
  if (!world.floor.empty()) reserve_one(world.floor);
  const double sensing_radius = sensing_radius_with(world, setup);
  join(world, setup, robot);
  if (!world.floor.empty()) world.floor.push_back(floor);  // there is room
  if (world.has_routes()) world.travels.push_back(std::move(travel));
  world.sensing_radius = sensing_radius;
  return robot;
}

}  // namespace

RobotId add_robot(World& world, const RobotSetup& setup) {
  Bases& bases = world.fleet.bases;
  if (bases.are_exact()) return add_reference(world, setup);
  check_body(*bases.model, bases.time_step, setup, method_of(world.settings, setup),
             name_of(RobotId{world.next_id}) + ": ");
  bases.reserve_one();
  const RobotId robot = add_reference(world, bases.reference_of(setup));
  bases.add(robot, setup);
  return robot;
}

void remove_robot(World& world, RobotId robot) {
  const std::size_t slot = world.fleet.find(robot);
  catch_up(world);
  if (world.fleet.is_parked(slot)) take_away_parked(world, slot);
  if (world.kinds) world.kinds->remove(world.fleet.setup(slot));
  std::vector<Travel>& travels = world.travels;
  if (!travels.empty()) travels.erase(travels.begin() + world.fleet.rank[slot]);
  if (!world.floor.empty()) world.floor.erase(world.floor.begin() + world.fleet.rank[slot]);
  world.senses.remove(static_cast<std::size_t>(world.fleet.rank[slot]));
  world.fleet.remove(slot);
  world.changed = world.has_new_goals = true;
}

namespace {

// The name of a robot's goal in messages.
struct GoalOf {
  RobotId robot;

  explicit operator std::string() const { return name_of(robot) + ": goal"; }
};

}  // namespace

void set_goal(World& world, RobotId robot, Vec2 goal) {
  const std::size_t slot = world.fleet.find(robot);
  if (world.fleet.is_parked(slot))
    refuse(name_of(robot), "a goal for it", "one that is not parked");
  require(GoalOf{robot}, goal, "m");           // everything else was checked when the robot came
  if (goal == world.fleet.goal[slot]) return;  // it continues as before
  if (world.has_routes()) {
    put_in_place(world, slot);
    world.travels[static_cast<std::size_t>(world.fleet.rank[slot])] =
        world.routes_of(slot).plan(world.fleet.traits[slot].route_radius,
                                   world.fleet.position[slot], goal, world.arrival_distance(slot));
  }
  world.fleet.goal[slot] = goal;
  world.has_new_goals = true;
  Detour& detour = world.fleet.detour[slot];
  // the rest belongs to the route to the old goal
  detour = {.congestion = detour.congestion,
            .acceleration_x = detour.acceleration_x,
            .acceleration_y = detour.acceleration_y};
  world.fleet.has_stood[slot] = 0;
  if (Flight* flight = world.fleet.flight(slot)) flight->has_arrived = false;
}

void move_robot(World& world, RobotId robot, Vec2 position) {
  Fleet& fleet = world.fleet;
  const std::size_t slot = fleet.find(robot);
  catch_up(world);
  if (fleet.is_parked(slot))
    refuse(name_of(robot), "another place for it", "one that is not parked");
  RobotSetup setup = fleet.setup(slot);
  setup.position = position;
  if (can_rest(setup.model)) setup.velocity = {};
  check_values(world, setup, robot, world.statics.has_walls);
  look_around_starts(world);
  check_start(world, setup, robot);
  if (world.bystanders.is_made) world.bystanders.late.reserve(world.bystanders.late.size() + 1);
  const auto rank = static_cast<std::size_t>(fleet.rank[slot]);
  if (world.has_routes())
    world.travels[rank] = world.routes_of(slot).plan(route_radius(setup.model, disc_radius(setup)),
                                                     disc_center(setup), setup.goal,
                                                     arrival_distance_of(world.settings, setup));
  note_late(world.bystanders, robot, disc_center(setup));  // there is room
  fleet.position[slot] = disc_center(setup);
  fleet.velocity[slot] = start_velocity(setup);
  fleet.nearest[slot] = std::numeric_limits<float>::infinity();
  fleet.detour[slot] = {};
  fleet.has_stood[slot] = 0;
  fleet.plan[slot] = {};
  fleet.applied_acceleration[slot] = 0.0;
  if (Flight* own = fleet.flight(slot))
    *own = {*circle_of(setup.model, fleet.position[slot], fleet.velocity[slot])};
  if (fleet.has_clocks) start_clock(world, slot);
  fleet.bases.put_down(rank, disc_center(setup));
  world.senses.renew(rank, world.moment());
  world.senses.note(fleet, world.steps);
  world.changed = world.has_new_goals = true;
}

ObstacleId add_obstacle(World& world, const StaticObstacle& obstacle) {
  const ObstacleId id{world.statics.next_id};
  catch_up(world);
  Scenario scene = settings_for(world, {});
  scene.obstacles = {obstacle};
  validate_as(scene, "obstacles.0.", name_of(id));
  check_newly_static(world, obstacle, name_of(id));
  std::vector<ObstacleId> ids = world.statics.id;
  std::vector<StaticObstacle> obstacles = world.statics.obstacles;
  ids.push_back(id), obstacles.push_back(obstacle);
  replace(world, StaticWorld(std::move(obstacles), std::move(ids), id.value + 1,
                             world.statics.parked, layers_of(world.fleet)));
  return id;
}

void remove_obstacle(World& world, ObstacleId obstacle) {
  catch_up(world);
  std::vector<ObstacleId> ids = world.statics.id;
  const auto place = std::find(ids.begin(), ids.end(), obstacle);
  if (place == ids.end()) throw Error(name_of(obstacle) + ": found none of that id");
  std::vector<StaticObstacle> obstacles = world.statics.obstacles;
  obstacles.erase(obstacles.begin() + (place - ids.begin()));
  ids.erase(place);
  replace(world, StaticWorld(std::move(obstacles), std::move(ids), world.statics.next_id,
                             world.statics.parked, layers_of(world.fleet)));
}

}  // namespace avo::inline sim
