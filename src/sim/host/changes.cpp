// SPDX-License-Identifier: Apache-2.0
// Changes of one robot between steps, by the host: what it can do, and where it wants to go.
#include <algorithm>
#include <new>
#include <string>
#include <utility>

#include "core/ranges.h"
#include "fields/robot_fields.h"
#include "robots/model.h"
#include "sim/floors.h"
#include "sim/host/edits.h"
#include "sim/scene/edit_checks.h"
#include "sim/scene/scene_checks.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// Refuses what only a new robot may have.
void check_same_kind(const RobotSetup& now, const RobotSetup& changed, RobotId robot) {
  if (!(changed.model == now.model))
    refuse(name_of(robot) + ": model", "another one", "the one that it has");
  if (changed.time_step && changed.time_step != now.time_step)
    refuse(name_of(robot) + ": time_step", text(*changed.time_step),
           "left out, or the one that it has");
}

// Refuses what a robot cannot change while the host moves it.
void check_host_motion(const HostMotion& motion, const RobotSetup& now, const RobotSetup& changed,
                       RobotId robot) {
  const std::string name = name_of(robot) + ": ";
  const double speed = motion.ends ? 0.0 : norm(motion.velocity);
  if (is_parked(changed)) refuse(name + "behavior", "parked", "another one: the host moves it");
  if (!(changed.avoids == now.avoids))
    refuse(name + "avoids", "a change while the host moves it", "the same, nobody");
  if (speed > changed.max_speed * (1.0 + kSpeedRounding))
    refuse(name + "max_speed", text(changed.max_speed),
           ">= " + text(speed) + " m/s, the velocity that the host gave");
}

// Returns whether all robots count on all others to decide: then no robot counts on the top speed
// of another one.
bool all_decide(const Fleet& fleet) {
  return std::all_of(fleet.conduct.begin(), fleet.conduct.end(), [&](const Conduct& conduct) {
    const Conduct& first = fleet.conduct.front();
    return conduct.layers == first.layers && conduct.avoids == first.avoids &&
           promises(conduct.behavior) && conduct.method == first.method;
  });
}

// Returns whether the braking of the robot, what others count on, or the others that it keeps clear
// of, are others than before. A smaller disc is where the disc was.
bool affects_certificate(const Fleet& fleet, const RobotSetup& now, const RobotSetup& changed) {
  RobotSetup same = changed;
  if (changed.radius <= now.radius) same.radius = now.radius;
  if (changed.max_speed <= now.max_speed || all_decide(fleet)) same.max_speed = now.max_speed;
  copy_wants(now, same);
  same.priority = now.priority, same.time_horizon = now.time_horizon;
  return !(same == now);
}

// Takes the robot's kind out of the kinds of the others until a change is checked or refused.
class KindAlone {
 public:
  KindAlone(World& world, RobotSetup setup) : world_(world), setup_(std::move(setup)) {
    if (!world_.kinds) world_.kinds.emplace(world_.fleet);
    world_.kinds->remove(setup_);
  }
  KindAlone(const KindAlone&) = delete;
  KindAlone& operator=(const KindAlone&) = delete;
  ~KindAlone() {
    try {
      world_.kinds->add(setup_);
    } catch (const std::bad_alloc&) {
      world_.kinds.reset();  // they are found anew when they are wanted
    }
  }

  void becomes(const RobotSetup& setup) { setup_ = setup; }

 private:
  World& world_;
  RobotSetup setup_;
};

// A robot that is faster than its new max_speed slows down, with its new brakes. It has to be seen,
// and has to see, as a robot of its present speed.
RobotSetup slowing(const RobotSetup& now, RobotSetup changed) {
  changed.max_speed = std::max(changed.max_speed, norm(now.velocity));
  return changed;
}

// The setup is that of a body: makes it that of its reference, which its base can follow.
void take_body(const World& world, std::size_t slot, const RobotSetup& now, RobotSetup& changed) {
  const std::string name = name_of(world.fleet.id[slot]) + ": ";
  if (is_parked(changed) != is_parked(now))
    refuse(name + "behavior", "a change to or from parked", "the same in a scene with execution");
  RobotSetup at_rest = changed;
  at_rest.velocity = {};
  const Bases& bases = world.fleet.bases;
  check_body(*bases.model, bases.time_step, at_rest, method_of(world.settings, changed), name);
  if (!is_holonomic(now.model) && changed.max_speed != now.max_speed)
    refuse(name + "max_speed", text(changed.max_speed),
           text(now.max_speed) + " m/s, for which the execution of its wheels is known");
  if (change_limit(changed) != change_limit(now))
    refuse(name + "the larger one of max_acceleration and max_braking", text(change_limit(changed)),
           text(change_limit(now)) + " m/s^2, for which its execution is known");
  changed.radius += world.fleet.base(slot).added;
}

void check_change(World& world, const RobotSetup& now, const RobotSetup& changed, RobotId robot,
                  bool may_start) {
  check_values(world, changed, robot, world.statics.has_walls);
  check_company(world, slowing(now, changed), robot);
  if (may_start || !affects_certificate(world.fleet, now, changed)) return;
  // within its own step a robot cannot brake before the step ends
  if (world.fleet.has_clocks && world.all_matter() && !world.settings.allow_broken_assumptions)
    refuse(name_of(robot), "a change that the certificate has to check, while clocks are free",
           "one of speeds, priority, time_horizon or arrival_distance");
  look_around_starts(world);
  check_start(world, slowing(now, changed), robot);
}

}  // namespace

void change_robot(World& world, RobotId robot, const RobotSetup& setup, bool may_start) {
  Fleet& fleet = world.fleet;
  const std::size_t slot = fleet.find(robot);
  catch_up(world);
  const RobotSetup now = fleet.setup(slot);
  RobotSetup changed = setup;
  changed.position = now.position, changed.velocity = now.velocity;
  changed.heading = now.heading, changed.goal = now.goal;
  if (!fleet.bases.are_exact()) take_body(world, slot, now, changed);
  if (!changed.time_step) changed.time_step = now.time_step;
  if (changed.method == fleet.usual.method) changed.method.reset();
  if (changed.max_braking == changed.max_acceleration) changed.max_braking.reset();
  check_same_kind(now, changed, robot);
  if (const HostMotion* own = fleet.moved_by_host(slot))
    check_host_motion(*own, now, changed, robot);
  if (is_parked(changed) != is_parked(now)) return park_or_free(world, slot, changed);
  if (is_parked(now))
    refuse(name_of(robot), "a change of it", "one that is not parked, or is set free");
  const std::uint32_t floor = floor_for(world, changed.layers);
  KindAlone kind(world, now);
  check_change(world, now, changed, robot, may_start);
  const double sensing_radius = sensing_radius_with(world, slowing(now, changed));
  const std::uint32_t pace = world.pace_of(changed, true);
  world.senses.reserve_one(
      knots_needed(world.settings, world.planner().options().longest_step, changed));
  if (world.bystanders.is_made) world.bystanders.late.reserve(world.bystanders.late.size() + 1);
  const auto rank = static_cast<std::size_t>(fleet.rank[slot]);
  const bool moves_otherwise = disc_radius(changed) != disc_radius(now) ||
                               changed.arrival_distance != now.arrival_distance ||
                               floor != world.floor_of(slot);
  Travel travel;
  if (world.has_routes() && moves_otherwise)
    travel = world.routes[floor].plan(route_radius(changed.model, disc_radius(changed)),
                                      fleet.position[slot], changed.goal,
                                      arrival_distance_of(world.settings, changed));
  fleet.change(slot, changed, pace);
  if (!fleet.bases.are_exact()) fleet.bases.all[rank].radius = setup.radius;
  kind.becomes(fleet.setup(slot));
  if (!world.floor.empty()) world.floor[rank] = floor;
  if (world.has_routes() && moves_otherwise) world.travels[rank] = std::move(travel);
  note_late(world.bystanders, robot, fleet.position[slot]);  // there is room
  world.sensing_radius = sensing_radius;
  world.changed = world.has_new_goals = true;
}

void set_preferred_velocity(World& world, RobotId robot, std::optional<Vec2> velocity) {
  Fleet& fleet = world.fleet;
  const std::size_t slot = fleet.find(robot);
  if (fleet.is_parked(slot))
    refuse(name_of(robot), "a preferred velocity for it", "one that is not parked");
  if (velocity) require(name_of(robot) + ": preferred_velocity", *velocity, "m/s");
  const std::optional<Vec2> before = fleet.told_velocity(slot);
  if (before == velocity) return;
  if (fleet.told.empty()) fleet.told.resize(fleet.size());
  fleet.told[static_cast<std::size_t>(fleet.rank[slot])] = velocity;
  if (before.has_value() == velocity.has_value()) return;
  Detour& detour = fleet.detour[slot];  // the rest belongs to its goal
  detour = {.congestion = detour.congestion,
            .acceleration_x = detour.acceleration_x,
            .acceleration_y = detour.acceleration_y};
  fleet.has_stood[slot] = 0;
  if (Flight* flight = fleet.flight(slot)) flight->has_arrived = false;
  world.has_new_goals = true;
}

}  // namespace avo::inline sim
