// SPDX-License-Identifier: Apache-2.0
// Robots and static obstacles come and go. All that may throw comes before anything changes.
#include "sim/edits.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "avo/assumptions.h"
#include "avo/error.h"
#include "core/ranges.h"
#include "sim/assumptions.h"
#include "sim/clocks.h"
#include "sim/one_sided.h"
#include "sim/world.h"

namespace avo {
namespace {

std::string name_of(RobotId robot) {
  return "robot " + std::to_string(robot.value);
}
std::string name_of(ObstacleId obstacle) {
  return "obstacle " + std::to_string(obstacle.value);
}

std::string rounded(double value, int digits) {
  char buffer[32];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
  return {buffer, end};
}

// validate(), of a scene with one robot or obstacle at the place, which the error calls by its
// name.
void validate_as(const Scenario& scene, std::string_view place, const std::string& name) {
  try {
    validate(scene);
  } catch (const Error& error) {
    const std::string_view what = error.what();
    if (!what.starts_with(place)) throw;
    throw Error(name + ": " + std::string(what.substr(place.size())));
  }
}

void check(const World& world, const RobotSetup& setup, RobotId robot, bool among_walls) {
  Scenario scene = world.settings;
  scene.robots = {setup};
  if (among_walls) scene.obstacles.emplace_back();  // what a robot needs beside any of them
  validate_as(scene, "robots.0.", name_of(robot));
}

// Throws Error if nobody would see this one in time, or it others.
void check_sensing(const World& world, const RobotSetup& setup, RobotId robot) {
  Scenario scene = world.settings;
  scene.moving_obstacles = world.obstacles.setup;
  for (const std::uint32_t slot : world.fleet.slot_of) {
    scene.robots.push_back(world.fleet.setup(slot));
  }
  const auto before = sensing_need(scene);
  scene.robots.push_back(setup);
  const auto need = sensing_need(scene);
  if (!need || need->range <= scene.sensing_radius * (1.0 + 1e-9)) return;
  if (before && need->range <= before->range) return;  // that was so without it
  throw Error(name_of(robot) + ": found a max_speed of " + std::to_string(setup.max_speed) +
              " m/s, has to be seen from " + std::to_string(need->range) +
              " m, sensing_radius is " + std::to_string(scene.sensing_radius) + " m");
}

// Throws Error where what all have declared is enough for those who are there, and not for this
// one.
void check_declared(const World& world, const RobotSetup& setup, RobotId robot) {
  const SensingError& declared = world.planner().options().sensing_error;
  if (world.planner().options().certificate != Certificate::braking_trajectories) return;
  Scenario scene = world.settings;
  const auto needed_by = [&scene](const RobotSetup& one) {
    scene.robots.assign(1, one);
    return declared_error(scene);
  };
  const auto suffices = [&declared](const SensingError& needed) {
    constexpr double kRounding = 1.0 + 1e-9;
    return needed.position <= kRounding * declared.position &&
           needed.velocity <= kRounding * declared.velocity;
  };
  const SensingError needed = needed_by(setup);
  if (suffices(needed) || !suffices(declared_error(world.settings))) return;
  for (std::size_t slot = 0; slot < world.fleet.size(); ++slot)
    if (!suffices(needed_by(world.fleet.setup(slot)))) return;
  const auto text_of = [](const SensingError& error) {
    return "{position: " + rounded(error.position, 6) +
           ", velocity: " + rounded(error.velocity, 6) + "}";
  };
  refuse(name_of(robot) + ": sensing_error", text_of(needed),
         "at most " + text_of(declared) + ", what all have declared");
}

// Throws Error where an airplane would come among movers.
void check_flights(const World& world, const RobotSetup& setup, RobotId robot) {
  const Fleet& fleet = world.fleet;
  if (setup.parked || (fleet.flights.empty() && !is_airplane(setup.model))) return;
  if (!world.obstacles.setup.empty())
    refuse(name_of(robot) + ": model", "airplane", "another one among moving obstacles");
}

// Throws Error where it would avoid one that does not avoid it, or the other way round, and nothing
// could be promised to the two.
void check_one_sided(const World& world, const RobotSetup& setup, RobotId robot) {
  const Fleet& fleet = world.fleet;
  std::vector<RobotSetup> robots;
  for (const std::uint32_t slot : fleet.slot_of) robots.push_back(fleet.setup(slot));
  robots.push_back(setup);
  const auto pair = find_impossible(robots);
  if (!pair || (pair->avoiding < fleet.size() && pair->avoided < fleet.size())) return;
  const auto name_at = [&](std::size_t rank) {
    return name_of(rank < fleet.size() ? fleet.id[fleet.slot_of[rank]] : robot);
  };
  refuse(name_at(pair->avoiding) + ": avoids", name_at(pair->avoided) + ", which does not avoid it",
         "both or neither: " + std::string(pair->reason));
}

// That of its time_step, which may be new.
std::uint32_t pace_for(World& world, const RobotSetup& setup) {
  return world.fleet.has_clocks ? world.pace_of(time_step_of(world.settings, setup)) : 0;
}

// Of the robot that has been added last.
void add_clock(World& world, const RobotSetup& setup, std::uint32_t pace) {
  if (!world.fleet.has_clocks) return;
  const std::size_t slot = world.fleet.size() - 1;
  OwnClock& clock = world.fleet.clock_of(slot);
  clock.time_step = time_step_of(world.settings, setup);
  clock.pace = pace;
  start_clock(world, slot);
}

// As it is now; where it is matters to nobody whose values are checked.
RobotSetup standing(const World& world, std::size_t slot) {
  RobotSetup setup = world.fleet.setup(slot);
  setup.position = setup.velocity = {};
  if (setup.parked) setup.position = setup.goal;
  return setup;
}

// Throws Error where braking does not keep the margin to it, or its Fill keeps a robot out.
void check_certificate(const World& world, const StaticObstacle& obstacle,
                       const std::string& name) {
  const CertificateLaw law = certificate_law(world.settings);
  if (law.kind == Certificate::none) return;
  const Fleet& fleet = world.fleet;
  Scenario scene = world.settings;
  scene.obstacles = {obstacle};
  for (const std::uint32_t slot : fleet.slot_of) scene.robots.push_back(fleet.setup(slot));
  BrokenAssumptions broken;
  find_wall_starts(scene, law, broken);
  const auto robot_at = [&](int rank) {
    const std::uint32_t slot = fleet.slot_of[static_cast<std::size_t>(rank)];
    const Vec2 p = fleet.position[slot];
    return name_of(fleet.id[slot]) + " at [" + rounded(p.x, 9) + ", " + rounded(p.y, 9) + "]";
  };
  if (broken.beside_count > 0) {
    const WallStart& worst = broken.beside.front();
    const double own = disc_radius(scene.robots[static_cast<std::size_t>(worst.robot)]);
    refuse(name,
           robot_at(worst.robot) + ", which is " + rounded(worst.distance, 9) + " m from it, " +
               rounded(worst.kept, 9) + " m once it has braked",
           ">= " + text(own) + " + " + text(obstacle.radius) + " m and " +
               rounded(worst.required - own - obstacle.radius, 2) + " m for rounding");
  }
  if (broken.misplaced_count > 0) {
    const bool solid = obstacle.fill == Fill::solid;
    refuse(name, robot_at(broken.misplaced.front().robot),
           solid ? "outside of the solid" : "inside of the bounds");
  }
}

// Throws Error where somebody could not keep clear of what does not move from now on. A robot in
// the midst of a step cannot brake before it ends.
void check_newly_static(const World& world, const StaticObstacle& obstacle,
                        const std::string& name) {
  if (world.fleet.has_clocks && world.all_matter())
    refuse(name, "what comes while clocks are free",
           "there from the start where there is a certificate");
  if (world.statics.walls.empty()) {  // nobody has been asked yet
    for (const std::uint32_t slot : world.fleet.slot_of)
      check(world, standing(world, slot), world.fleet.id[slot], true);
  }
  check_certificate(world, obstacle, name);
}

static_assert(std::is_nothrow_move_assignable_v<StaticWorld> &&
              std::is_nothrow_move_assignable_v<Ways>);

Ways ways_among(const World& world, const StaticWorld& statics) {
  Ways ways(world.settings, statics.walls, &world.ways);
  replan_travels(world.ways, ways, world.fleet);
  ways.forget_before();
  return ways;
}

// The same fleet among others.
void replace(World& world, StaticWorld statics) {
  Ways ways = ways_among(world, statics);
  world.statics = std::move(statics);
  world.ways = std::move(ways);
  world.changed = true;
}

}  // namespace

namespace {

// The same obstacles beside other parked robots.
StaticWorld beside(const World& world, std::vector<Wall> parked) {
  const StaticWorld& statics = world.statics;
  return {statics.obstacles, statics.id, statics.next_id, std::move(parked)};
}

void park(World& world, const RobotSetup& setup, RobotId robot) {
  const Vec2 center = disc_center(setup);
  const double radius = disc_radius(setup);
  const StaticObstacle disc{{{{center}, false}}, radius, Fill::none};
  check_newly_static(world, disc, name_of(robot));
  std::vector<Wall> parked = world.statics.parked;
  parked.push_back({center, center, radius});
  StaticWorld statics = beside(world, std::move(parked));
  Ways ways = ways_among(world, statics);
  ways.travels.reserve(world.fleet.size() + 1);
  world.fleet.add(robot, setup);
  add_clock(world, setup, 0);
  ways.travels.emplace_back();  // there is room
  world.statics = std::move(statics);
  world.ways = std::move(ways);
}

void remove_parked(World& world, std::size_t slot) {
  Fleet& fleet = world.fleet;
  std::vector<Wall> parked;
  for (const std::uint32_t other : fleet.slot_of) {
    if (fleet.conduct[other].parked && other != slot)
      parked.push_back({fleet.position[other], fleet.position[other], fleet.traits[other].radius});
  }
  replace(world, beside(world, std::move(parked)));
}

}  // namespace

RobotId add_robot(World& world, const RobotSetup& setup) {
  const RobotId robot{world.next_id};
  check(world, setup, robot, !world.statics.walls.empty());
  if (setup.parked) {
    park(world, setup, robot);
    ++world.next_id;
    world.changed = true;
    return robot;
  }
  check_sensing(world, setup, robot);
  check_declared(world, setup, robot);
  check_flights(world, setup, robot);
  check_one_sided(world, setup, robot);
  Ways& ways = world.ways;
  Travel travel;
  if (!ways.empty()) {
    travel = ways.plan(disc_radius(setup), disc_center(setup), setup.goal);
    if (ways.travels.size() == ways.travels.capacity())
      ways.travels.reserve(2 * ways.travels.size() + 8);
  }
  world.senses.reserve_one();
  const std::uint32_t pace = pace_for(world, setup);
  world.fleet.add(robot, setup);
  add_clock(world, setup, pace);
  world.senses.add(world.steps);
  world.senses.note(world.fleet, world.steps);
  if (!ways.empty()) ways.travels.push_back(std::move(travel));  // there is room
  ++world.next_id;
  world.changed = true;
  return robot;
}

void remove_robot(World& world, RobotId robot) {
  const std::size_t slot = world.fleet.find(robot);
  if (world.fleet.conduct[slot].parked) remove_parked(world, slot);
  std::vector<Travel>& travels = world.ways.travels;
  if (!travels.empty()) travels.erase(travels.begin() + world.fleet.rank[slot]);
  world.senses.remove(static_cast<std::size_t>(world.fleet.rank[slot]));
  world.fleet.remove(slot);
  world.changed = true;
}

void set_goal(World& world, RobotId robot, Vec2 goal) {
  const std::size_t slot = world.fleet.find(robot);
  if (world.fleet.conduct[slot].parked)
    refuse(name_of(robot), "a goal for it", "one that is not parked");
  RobotSetup setup = standing(world, slot);
  setup.goal = goal;
  check(world, setup, robot, !world.statics.walls.empty());
  Ways& ways = world.ways;
  if (!ways.empty()) {
    ways.travels[static_cast<std::size_t>(world.fleet.rank[slot])] =
        ways.plan(disc_radius(setup), world.fleet.position[slot], goal);
  }
  world.fleet.goal[slot] = goal;
  if (Flight* flight = world.fleet.flight(slot)) flight->has_arrived = false;
}

ObstacleId add_obstacle(World& world, const StaticObstacle& obstacle) {
  const ObstacleId id{world.statics.next_id};
  Scenario scene = world.settings;
  scene.obstacles = {obstacle};
  validate_as(scene, "obstacles.0.", name_of(id));
  check_newly_static(world, obstacle, name_of(id));
  std::vector<ObstacleId> ids = world.statics.id;
  std::vector<StaticObstacle> obstacles = world.statics.obstacles;
  ids.push_back(id), obstacles.push_back(obstacle);
  replace(world,
          StaticWorld(std::move(obstacles), std::move(ids), id.value + 1, world.statics.parked));
  return id;
}

void remove_obstacle(World& world, ObstacleId obstacle) {
  std::vector<ObstacleId> ids = world.statics.id;
  const auto place = std::find(ids.begin(), ids.end(), obstacle);
  if (place == ids.end()) throw Error(name_of(obstacle) + ": found none of that id");
  std::vector<StaticObstacle> obstacles = world.statics.obstacles;
  obstacles.erase(obstacles.begin() + (place - ids.begin()));
  ids.erase(place);
  replace(world, StaticWorld(std::move(obstacles), std::move(ids), world.statics.next_id,
                             world.statics.parked));
}

}  // namespace avo
