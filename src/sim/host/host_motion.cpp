// SPDX-License-Identifier: Apache-2.0
#include "sim/host/host_motion.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "avo/error.h"
#include "core/ranges.h"
#include "robots/model.h"
#include "sim/host/edits.h"
#include "sim/scene/edit_checks.h"
#include "sim/travels.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

void check(const Fleet& fleet, std::size_t slot, Vec2 velocity) {
  const std::string name = name_of(fleet.id[slot]);
  if (fleet.is_parked(slot)) refuse(name, "a velocity for it", "one that is not parked");
  if (!fleet.bases.are_exact())
    refuse(name, "a velocity for it in a scene with execution", "a preferred velocity");
  if (fleet.has_clocks)
    refuse(name, "a velocity for it while clocks are free", "a preferred velocity");
  if (fleet.traits[slot].has_model)
    refuse(name, "a velocity for one with a heading", "a preferred velocity");
  require(name + ": velocity", velocity, "m/s");
  const double speed = norm(velocity), most = fleet.traits[slot].max_speed;
  if (speed > most * (1.0 + kSpeedRounding))
    refuse(name + ": velocity", text(speed) + " m/s",
           "at most its max_speed, " + text(most) + " m/s");
}

// What it remembers belongs to its route.
void forget_route(Fleet& fleet, std::size_t slot) {
  fleet.detour[slot] = {.congestion = fleet.detour[slot].congestion};
  fleet.has_stood[slot] = 0;
}

// From now on it avoids nobody. It throws before any change.
void begin(World& world, std::size_t slot, Vec2 velocity) {
  Fleet& fleet = world.fleet;
  const auto rank = static_cast<std::size_t>(fleet.rank[slot]);
  if (fleet.host_motion.empty()) fleet.host_motion.resize(fleet.size());
  RobotSetup setup = fleet.setup(slot);
  const LayerSet avoids = setup.avoids;
  setup.avoids = {};
  change_robot(world, fleet.id[slot], setup);
  fleet.host_motion[rank] = {velocity, avoids};
  fleet.plan[slot] = {};
  forget_route(fleet, slot);
}

// Returns whether it decides again. Robots in motion have to be able to brake beside it. What it
// rests on has been touched already: both part then. Where what others may do by now does not allow
// it, it stays at rest.
bool end(World& world, std::size_t slot) {
  Fleet& fleet = world.fleet;
  const auto rank = static_cast<std::size_t>(fleet.rank[slot]);
  const HostMotion motion = *fleet.host_motion[rank];
  RobotSetup setup = fleet.setup(slot);
  setup.avoids = motion.avoids;
  if (is_in_the_way(world, setup, fleet.id[slot])) return false;
  fleet.host_motion[rank].reset();
  try {
    change_robot(world, fleet.id[slot], setup, true);
  } catch (const Error&) {  // the scene no longer allows it
    fleet.host_motion[rank] = motion;
    return false;
  } catch (...) {
    fleet.host_motion[rank] = motion;
    throw;
  }
  forget_route(fleet, slot);
  if (world.has_routes())
    world.travels[rank] =
        world.routes_of(slot).plan(fleet.traits[slot].route_radius, fleet.position[slot],
                                   fleet.goal[slot], world.arrival_distance(slot));
  return true;
}

// m/s, after one step.
Vec2 next_velocity(const HostMotion& motion, const RobotTraits& traits, Vec2 velocity,
                   double braking_time) {
  if (!motion.ends) return motion.velocity;
  const double speed = norm(velocity), change = traits.max_braking * braking_time;
  return speed <= change ? Vec2{} : (1.0 - change / speed) * velocity;
}

void move(World& world, std::size_t slot, const HostMotion& motion) {
  Fleet& fleet = world.fleet;
  const StepResponse& response = world.pace(slot).response;
  const MotionState now = fleet.state(slot);
  Plan& plan = fleet.plan[slot];
  plan = {};
  const double braking_time = response.rate < 1.0 ? response.rate * response.control_time
                                                  : response.time_step;  // adopted at once
  plan.next_velocity = next_velocity(motion, fleet.traits[slot], now.velocity, braking_time);
  const Vec2 w = (plan.next_velocity - now.velocity) / response.rate;
  plan.new_velocity = now.velocity + w, plan.acceleration = w / response.control_time;
  const MotionStep step = advance(now, plan, response);
  fleet.position[slot] = step.next.position, fleet.velocity[slot] = plan.next_velocity;
  fleet.applied_acceleration[slot] = step.acceleration;
  fleet.cell[slot] = world.snapshot.cells.key(fleet.position[slot]);
  world.workers[0].fast = world.workers[0].fast || world.is_fast(slot);
}

}  // namespace

void move_as_told(World& world) {
  if (world.summary.idle == 0) return;
  const Fleet& fleet = world.fleet;
  for (const std::uint32_t slot : fleet.slot_of)
    if (const HostMotion* motion = fleet.moved_by_host(slot)) move(world, slot, *motion);
}

bool decide_again(World& world) {
  const Fleet& fleet = world.fleet;
  bool some = false;
  for (std::size_t rank = 0; rank < fleet.host_motion.size(); ++rank) {
    const std::uint32_t slot = fleet.slot_of[rank];
    const HostMotion* motion = fleet.moved_by_host(slot);
    if (motion != nullptr && motion->ends && fleet.velocity[slot] == Vec2{})
      some = end(world, slot) || some;
  }
  return some;
}

bool set_velocity(World& world, RobotId robot, std::optional<Vec2> velocity) {
  Fleet& fleet = world.fleet;
  const std::size_t slot = fleet.find(robot);
  const bool decides = fleet.moved_by_host(slot) == nullptr;
  if (velocity) check(fleet, slot, *velocity);
  if (decides && velocity) begin(world, slot, *velocity);
  if (decides) return velocity.has_value();
  HostMotion& motion = *fleet.host_motion[static_cast<std::size_t>(fleet.rank[slot])];
  motion.ends = !velocity;
  if (velocity) motion.velocity = *velocity;
  return false;
}

}  // namespace avo::inline sim
