// SPDX-License-Identifier: Apache-2.0
// The views of a simulation's robots and obstacles.
#include <optional>

#include "avo/simulation.h"
#include "core/ranges.h"
#include "sim/clocks.h"
#include "sim/simulation_state.h"

namespace avo {
namespace {

// The columns that do not depend on where robots are.
constexpr Columns kUnmoved =
    Columns::id | Columns::goal | Columns::detour | Columns::plan | Columns::applied_acceleration;

Columns without(Columns all, Columns some) {
  return static_cast<Columns>(static_cast<unsigned>(all) & ~static_cast<unsigned>(some));
}

std::vector<RobotId> ids_at(const Fleet& fleet, const std::vector<std::size_t>& ranks) {
  std::vector<RobotId> ids;
  ids.reserve(ranks.size());
  for (const std::size_t rank : ranks) ids.push_back(fleet.id[fleet.slot_of[rank]]);
  return ids;
}

}  // namespace

FleetView Simulation::fleet(Columns wanted) const {
  State& state = *state_;
  if (!includes(state.mirrored, wanted)) {
    if (without(wanted, kUnmoved) != Columns{}) state.catch_up();
    const Lock lock(state.looking);
    state.mirror.copy(state.fleet, without(wanted, state.mirrored));
    state.mirrored = state.mirrored | wanted;
  }
  return state.mirror.view(wanted);
}

std::size_t Simulation::size() const {
  return state_->fleet.size();
}

std::uint64_t Simulation::roster() const {
  return state_->roster;
}

RobotState Simulation::robot(RobotId robot) const {
  const Fleet& fleet = state_->fleet;
  const std::size_t slot = fleet.find(robot);
  const MotionState present = present_state(*state_, slot);
  const bool exact = fleet.bases.are_exact();
  return {.id = fleet.id[slot],
          .position = exact ? fleet.place(slot, present) : fleet.base(slot).place(),
          .velocity = exact ? present.velocity : fleet.base(slot).velocity,
          .heading = present.heading,
          .goal = fleet.goal[slot],
          .detour = fleet.detour[slot],
          .plan = fleet.plan[slot],
          .applied_acceleration = fleet.applied_acceleration[slot]};
}

RobotSetup Simulation::setup(RobotId robot) const {
  const std::size_t slot = state_->fleet.find(robot);
  RobotSetup setup = state_->fleet.setup(slot, present_state(*state_, slot));
  if (state_->fleet.bases.are_exact()) return setup;
  const Base& base = state_->fleet.base(slot);
  setup.position = base.place(), setup.velocity = base.velocity, setup.radius = base.radius;
  return setup;
}

std::optional<std::size_t> Simulation::index_of(RobotId robot) const {
  const Fleet& fleet = state_->fleet;
  const auto slot = fleet.slot(robot);
  return slot ? std::optional(static_cast<std::size_t>(fleet.rank[*slot])) : std::nullopt;
}

std::vector<RobotId> Simulation::robots_within(Vec2 center, double radius) const {
  require("robots_within: center", center, "m");
  require("robots_within: radius", radius, kNotNegative, "m");
  return ids_at(state_->fleet, avo::robots_within(state_->nearby_now(), center, radius));
}

std::vector<RobotId> Simulation::nearest_robots(Vec2 position, std::size_t count) const {
  require("nearest_robots: position", position, "m");
  return ids_at(state_->fleet, avo::nearest_robots(state_->nearby_now(), position, count));
}

bool Simulation::is_free(Vec2 position, double radius, LayerSet layers) const {
  require("is_free: position", position, "m");
  require("is_free: radius", radius, kPositive, "m");
  return avo::is_free(*state_, state_->nearby_now(), position, radius, layers);
}

std::optional<Simulation::Hit> Simulation::cast_ray(Vec2 from, Vec2 to, double radius,
                                                    LayerSet layers) const {
  require("cast_ray: from", from, "m");
  require("cast_ray: to", to, "m");
  require("cast_ray: radius", radius, kNotNegative, "m");
  return first_hit(*state_, state_->nearby_now(), from, to, radius, layers);
}

bool Simulation::is_in_sight(Vec2 from, Vec2 to, double radius, LayerSet layers) const {
  require("is_in_sight: from", from, "m");
  require("is_in_sight: to", to, "m");
  require("is_in_sight: radius", radius, kNotNegative, "m");
  return avo::is_in_sight(*state_, state_->walls_now(), from, to, radius, layers);
}

MovingObstacleView Simulation::moving_obstacles() const {
  const MoverColumns& o = state_->movers;
  return {o.position, o.velocity, o.setup, o.next_point, o.id};
}

std::optional<Vec2> Simulation::preferred_velocity(RobotId robot) const {
  const Fleet& fleet = state_->fleet;
  return fleet.told_velocity(fleet.find(robot));
}

bool Simulation::is_moved(RobotId robot) const {
  const Fleet& fleet = state_->fleet;
  return fleet.moved_by_host(fleet.find(robot)) != nullptr;
}

std::optional<Vec2> Simulation::host_velocity(RobotId robot) const {
  const Fleet& fleet = state_->fleet;
  const HostMotion* motion = fleet.moved_by_host(fleet.find(robot));
  return motion != nullptr && !motion->ends ? std::optional(motion->velocity) : std::nullopt;
}

StaticObstacleView Simulation::obstacles() const {
  return {state_->statics.id, state_->statics.obstacles};
}

}  // namespace avo
