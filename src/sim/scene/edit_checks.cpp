// SPDX-License-Identifier: Apache-2.0
#include "sim/scene/edit_checks.h"

#include <algorithm>
#include <vector>

#include "avo/assumptions.h"
#include "avo/error.h"
#include "core/ranges.h"
#include "core/retell.h"
#include "planner/stages/certify.h"
#include "sim/scene/assumptions.h"
#include "sim/scene/one_sided.h"
#include "sim/scene/scene_checks.h"
#include "sim/world.h"

namespace avo::inline sim {

std::string name_of(RobotId robot) {
  return "robot " + std::to_string(robot.value);
}
std::string name_of(ObstacleId obstacle) {
  return "obstacle " + std::to_string(obstacle.value);
}

std::string name_of(MovingObstacleId obstacle) {
  return "moving obstacle " + std::to_string(obstacle.value);
}
std::string name_of(BodyId body) {
  return std::visit([](auto id) { return name_of(id); }, body);
}

namespace {

// Errors that begin with the place begin with the name instead.
template <typename Check>
void tell_as(std::string_view place, const std::string& name, const Check& check) {
  retelling<Error>(check, [&](const Error& error) {
    const std::string_view what = error.what();
    if (what.starts_with(place)) throw Error(name + ": " + std::string(what.substr(place.size())));
  });
}

}  // namespace

void validate_as(const Scenario& scene, std::string_view place, const std::string& name) {
  tell_as(place, name, [&] { validate(scene); });
}

Scenario settings_for(const World& world, std::span<const RobotSetup> robots) {
  Scenario scene = world.settings;
  scene.robots.assign(robots.begin(), robots.end());
  forget_undeclared_error(scene);
  return scene;
}

namespace {

// Returns whether robots that are there need as much of all others, and all others of them.
bool is_known(const World& world, const RobotSetup& setup) {
  return world.kinds && world.kinds->exceed(setup);
}

}  // namespace

void check_values(const World& world, const RobotSetup& setup, RobotId robot, bool among_walls) {
  if (world.kinds && world.kinds->has_faster(setup))
    return tell_as("robots.0.", name_of(robot),
                   [&] { check_robot(0, setup, time_step_of(world.settings, setup)); });
  Scenario scene = settings_for(world, {&setup, 1});
  if (among_walls) scene.obstacles.push_back({{{{Vec2{}}}}});  // what it needs beside any wall
  validate_as(scene, "robots.0.", name_of(robot));
}

RobotSetup standing(const World& world, std::size_t slot) {
  RobotSetup setup = world.fleet.setup(slot);
  setup.position = setup.velocity = {};
  if (is_parked(setup)) setup.position = setup.goal;
  return setup;
}

namespace {

// The present robots, for checks that do not depend on their places.
Scenario present_scene(const World& world) {
  Scenario scene = world.settings;
  scene.moving_obstacles = world.movers.setup;
  scene.robots = world.kinds->examples();
  return scene;
}

// Throws Error if the others would not see this robot in time, or it would not see them.
void check_sensing(const World& world, const RobotSetup& setup, RobotId robot) {
  if (!world.settings.sensing_radius) return;  // the radius grows
  Scenario scene = present_scene(world);
  const auto before = sensing_need(scene);
  scene.robots.push_back(setup);
  const auto need = sensing_need(scene);
  if (!need || need->range <= world.sensing_radius * (1.0 + 1e-9)) return;
  if (before && need->range <= before->range) return;  // this need existed without the robot
  throw Error(name_of(robot) + ": found a max_speed of " + std::to_string(setup.max_speed) +
              " m/s, has to be seen from " + std::to_string(need->range) +
              " m, sensing_radius is " + std::to_string(world.sensing_radius) + " m");
}

// Throws Error where the declared error is enough for the present robots, and not for this one.
void check_declared(const World& world, const RobotSetup& setup, RobotId robot) {
  const PlannerOptions& options = world.certified_planner().options();
  const SensingError& declared = options.sensing_error;
  if (options.certificate != Certificate::braking_trajectories) return;
  Scenario scene = world.settings;
  scene.execution = world.fleet.bases.model;
  scene.execution_error = world.fleet.bases.declared;
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

// Refuses a robot that flies, or a robot beside it, of which nothing could be promised.
void check_flights(const World& world, const RobotSetup& setup, RobotId robot) {
  const Fleet& fleet = world.fleet;
  if (is_parked(setup) || (fleet.flights.empty() && can_rest(setup.model))) return;
  if (!fleet.flights.empty() && setup.behavior != Behavior::decides)
    refuse(name_of(robot) + ": behavior", to_string(setup.behavior),
           std::string("decides") + kAmongFlights);
  const bool promised =
      std::all_of(fleet.conduct.begin(), fleet.conduct.end(),
                  [](const Conduct& conduct) { return promises(conduct.behavior); });
  if (!can_rest(setup.model) && !(promised && setup.behavior == Behavior::decides))
    refuse(name_of(robot) + ": model", "one that cannot stop",
           "another one among robots that cooperate");
  if (!method_traits(method_of(world.settings, setup)).has_rules ||
      std::any_of(fleet.conduct.begin(), fleet.conduct.end(),
                  [](const Conduct& other) { return !method_traits(other.method).has_rules; }))
    refuse(name_of(robot) + ": method", to_string(method_of(world.settings, setup)),
           std::string("avo, of all robots,") + kAmongFlights);
}

// Refuses a pair in which only one would avoid the other, and nothing could be promised.
void check_one_sided(const World& world, const RobotSetup& setup, RobotId robot) {
  const Fleet& fleet = world.fleet;
  std::vector<RobotSetup> robots = world.kinds->examples();
  robots.push_back(setup);
  if (!find_impossible(robots)) return;
  robots.clear();  // all robots, to name the other one
  std::vector<RobotId> id;
  for (const std::uint32_t slot : fleet.slot_of) {
    if (fleet.id[slot] == robot) continue;  // as it was before a change
    robots.push_back(fleet.setup(slot)), id.push_back(fleet.id[slot]);
  }
  robots.push_back(setup), id.push_back(robot);
  const auto pair = find_impossible(robots);
  const std::size_t own = robots.size() - 1;
  if (!pair || (pair->avoiding != own && pair->avoided != own)) return;
  const auto name_at = [&](std::size_t rank) { return name_of(id[rank]); };
  refuse(name_at(pair->avoiding) + ": avoids", name_at(pair->avoided) + ", which does not avoid it",
         "both or neither: " + std::string(pair->reason));
}

// Throws Error where braking does not keep the margin from the obstacle, or its Fill excludes a
// robot.
void check_certificate(const World& world, const StaticObstacle& obstacle, const std::string& name,
                       std::optional<RobotId> own) {
  const CertificateLaw law = certificate_law(world.certified_planner());
  if (law.kind == Certificate::none) return;
  const Fleet& fleet = world.fleet;
  Scenario scene = world.settings;
  scene.obstacles = {obstacle};
  std::vector<MotionState> states;
  for (const std::uint32_t slot : fleet.slot_of) {
    scene.robots.push_back(fleet.setup(slot));
    if (fleet.id[slot] == own) scene.robots.back().behavior = Behavior::parked;
    states.push_back(fleet.state(slot));
  }
  BrokenAssumptions broken;
  find_wall_starts(scene, states, law, broken);
  const auto robot_at = [&](RobotId in_scene) {
    const std::uint32_t slot = listed_as(in_scene, fleet.slot_of);
    const Vec2 p = fleet.position[slot];
    return name_of(fleet.id[slot]) + " at [" + rounded(p.x, 9) + ", " + rounded(p.y, 9) + "]";
  };
  if (broken.beside_count > 0) {
    const WallStart& worst = broken.beside.front();
    const double radius = disc_radius(listed_as(worst.robot, scene.robots));
    refuse(name,
           robot_at(worst.robot) + ", which is " + rounded(worst.distance, 9) + " m from it, " +
               rounded(worst.kept, 9) + " m once it has braked",
           ">= " + text(radius) + " + " + text(obstacle.radius) + " m and " +
               rounded(worst.required - radius - obstacle.radius, 2) + " m for rounding");
  }
  if (broken.misplaced_count > 0) {
    const bool solid = obstacle.fill == Fill::solid;
    refuse(name, robot_at(broken.misplaced.front().robot),
           solid ? "outside of the solid" : "inside of the bounds");
  }
}

}  // namespace

void check_company(const World& world, const RobotSetup& setup, RobotId robot) {
  if (is_known(world, setup)) return;
  check_sensing(world, setup, robot);
  check_declared(world, setup, robot);
  check_flights(world, setup, robot);
  check_one_sided(world, setup, robot);
}

void check_newcomer(const World& world, const RobotSetup& setup, RobotId robot) {
  check_company(world, setup, robot);
  check_start(world, setup, robot);
}

double sensing_radius_among(const World& world, const std::vector<MovingObstacle>& movers,
                            const std::string& name) {
  Scenario scene = present_scene(world);
  const auto covered = [&] {
    constexpr double kRounding = 1.0 + 1e-9;
    const SensingError needed = declared_error(scene);
    const SensingError& declared = world.certified_planner().options().sensing_error;
    return needed.position <= kRounding * declared.position &&
           needed.velocity <= kRounding * declared.velocity;
  };
  const auto before = sensing_need(scene);
  const bool was_covered = !world.all_matter() || covered();
  scene.moving_obstacles = movers;
  if (world.all_matter() && was_covered && !covered())
    refuse(name, "a max_deviation beyond the sensing_error that all have declared",
           "less, or in the scene from the start");
  if (!world.settings.sensing_radius)
    return std::max(world.sensing_radius, sensing_radius_of(scene));
  const auto need = sensing_need(scene);
  const bool suffices = !need || need->range <= world.sensing_radius * (1.0 + 1e-9) ||
                        (before && need->range <= before->range);
  if (!suffices && !world.settings.allow_broken_assumptions)
    throw Error(name + ": has to be seen from " + std::to_string(need->range) +
                " m, sensing_radius is " + std::to_string(world.sensing_radius) + " m");
  return world.sensing_radius;
}

double sensing_radius_with(const World& world, const RobotSetup& setup) {
  if (world.settings.sensing_radius || is_known(world, setup)) return world.sensing_radius;
  Scenario scene = present_scene(world);
  const bool is_first = std::all_of(scene.robots.begin(), scene.robots.end(), is_parked);
  scene.robots.push_back(setup);
  const double needed = sensing_radius_of(scene);
  return is_first ? needed : std::max(world.sensing_radius, needed);
}

void check_newly_static(const World& world, const StaticObstacle& obstacle, const std::string& name,
                        std::optional<RobotId> own) {
  // a robot within a step cannot brake before the step ends
  if (world.fleet.has_clocks && world.all_matter())
    refuse(name, "what comes while clocks are free",
           "there from the start where there is a certificate");
  if (!world.statics.has_walls) {  // the robots have not been checked for walls yet
    for (const std::uint32_t slot : world.fleet.slot_of)
      check_values(world, standing(world, slot), world.fleet.id[slot], true);
  }
  check_certificate(world, obstacle, name, own);
}

}  // namespace avo::inline sim
