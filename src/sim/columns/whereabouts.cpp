// SPDX-License-Identifier: Apache-2.0
#include "sim/columns/whereabouts.h"

#include <algorithm>
#include <utility>

#include "core/plane.h"
#include "planner/stages/relevance.h"
#include "robots/model.h"
#include "sim/clocks.h"
#include "sim/sensing/sense_query.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// Where more than one in so many decide at once, all robots are moved.
constexpr std::size_t kFewDecide = 16;
// A part of the sensing radius: no search begins with less.
constexpr double kLeastLook = 0.0625;
// A part of places and distances: more than their rounding.
constexpr double kRounding = 1e-12;
// Room for so many near robots.
constexpr std::size_t kUsuallyNear = 1024;

StepInProgress step_in_progress(const World& world, std::size_t slot) {
  const Fleet& fleet = world.fleet;
  const OwnClock& clock = fleet.clock_of(slot);
  StepInProgress step{
      clock.from.position, clock.from.velocity, clock.to.velocity - clock.from.velocity,
      clock.begin,         clock.end,           StepInProgress::Kind::held};
  if (fleet.traits[slot].has_model) {
    step.kind = StepInProgress::Kind::by_model;
  } else if (adopts_at_once(fleet.conduct[slot].method)) {
    step.kind = StepInProgress::Kind::at_once;
    step.velocity = clock.to.velocity;
    step.change = clock.to.position - clock.from.position;
  }
  return step;
}

struct PresentPlace {
  Vec2 position, velocity;
};

// Its present_state(), by the same expressions.
PresentPlace present_place(const World& world, const StepInProgress& step, std::size_t slot) {
  if (step.kind == StepInProgress::Kind::by_model || step.end == world.now) {
    const MotionState state = present_state(world, slot);
    return {state.position, state.velocity};
  }
  const double time = seconds(world.now - step.begin);
  const double part = time / seconds(step.end - step.begin);
  if (step.kind == StepInProgress::Kind::at_once)
    return {step.position + part * step.change, step.velocity};
  return {step.position + (time * step.velocity + (0.5 * time * part) * step.change),
          step.velocity + part * step.change};
}

// The speed at an interpolated time does not exceed that at both ends, up to rounding.
void note_speeds(World& world, std::size_t slot) {
  const Fleet& fleet = world.fleet;
  const OwnClock& clock = fleet.clock_of(slot);
  const double limit = (1.0 + 0.5 * kSpeedRounding) * fleet.traits[slot].max_speed;
  const double fastest =
      std::max(norm_squared(clock.from.velocity), norm_squared(clock.to.velocity));
  if (!fleet.is_parked(slot) && !(fastest <= limit * limit))
    world.whereabouts.fast_until = std::max(world.whereabouts.fast_until, clock.end);
}

// m: how far any robot may have moved since all were filed.
double drift_of(const World& world) {
  const Whereabouts& own = world.whereabouts;
  return own.top_speed * seconds(world.now - own.since);
}

// Gathers the robots within the radius at present, with the searching one. Returns their number.
std::size_t gather(World& world, Vec2 center, double radius) {
  Whereabouts& own = world.whereabouts;
  const std::span<const std::uint32_t> order = own.filed.grid.order();
  const double reach = radius + drift_of(world);
  own.filed.grid.list_within(center, reach + kRounding * (norm(center) + reach), own.read);
  const auto resize = [&](std::size_t count) {
    own.slots.resize(count), own.position.resize(count);
    own.velocity.resize(count), own.rank.resize(count);
  };
  resize(own.read.size());
  std::size_t count = 0;
  for (const std::uint32_t place : own.read) {
    const auto [position, velocity] = present_place(world, own.step[place], order[place]);
    own.slots[count] = order[place];
    own.position[count] = position, own.velocity[count] = velocity;
    own.rank[count] = own.filed.grid.index(place);
    count += norm_squared(position - center) <= radius * radius ? 1 : 0;  // counts if it is near
  }
  resize(count);
  return own.slots.size();
}

}  // namespace

void file(World& world) {
  const Fleet& fleet = world.fleet;
  Whereabouts& own = world.whereabouts;
  std::swap(own.filed, world.snapshot);
  own.since = world.now, own.decisions = 0, own.fast_until = -1, own.top_speed = 0.0;
  const std::size_t count = fleet.size(), near = std::min(count, kUsuallyNear);
  own.step.resize(count), own.place_of.resize(count);
  own.read.reserve(count), own.slots.reserve(near), own.rank.reserve(near);
  own.position.reserve(near), own.velocity.reserve(near);
  world.snapshot.sensed.reserve(near);
  world.snapshot.grid.prepare({.per_meter = 0.0}, near);
  const std::span<const std::uint32_t> order = own.filed.grid.order();
  for (std::uint32_t place = 0; place < count; ++place) {
    const std::uint32_t slot = order[place];
    own.step[place] = step_in_progress(world, slot);
    own.place_of[slot] = place;
    const double speed = (1.0 + kSpeedRounding) * fleet.traits[slot].max_speed;
    own.top_speed = std::max(own.top_speed, model_traits(fleet.model(slot)).speed_ratio * speed);
    note_speeds(world, slot);
  }
}

void unfile(World& world) {
  if (world.whereabouts.since >= 0) std::swap(world.whereabouts.filed, world.snapshot);
  world.whereabouts.since = -1;
}

bool knows_near(const World& world) {
  const Whereabouts& own = world.whereabouts;
  return !world.changed && own.since >= 0 && world.now > own.fast_until &&
         own.decisions < world.fleet.size() && drift_of(world) <= world.sensing_radius &&
         world.senses.are_exact() && !world.has_passages() && world.fleet.flights.empty() &&
         kFewDecide * world.agenda.now.size() <= std::max(kFewDecide, world.fleet.size());
}

void find_near(World& world, std::size_t slot) {
  Whereabouts& own = world.whereabouts;
  const NeighborQuery query = sought_by(world, slot);
  if (!is_finite(query.position)) return world.snapshot.grid.take({}, {}, {});
  double radius = std::min(std::max({query.near, query.guess, kLeastLook * query.far}), query.far);
  while (gather(world, query.position, radius) <= query.most && radius < query.far)
    radius = std::min(2.0 * radius, query.far);
  Snapshot& snapshot = world.snapshot;
  snapshot.cells = {.per_meter = 0.0};
  snapshot.grid.take(own.slots, own.position, own.rank);
  snapshot.circle.clear();
  snapshot.sensed.clear();
  for (std::size_t k = 0; k < own.slots.size(); ++k) {
    const RobotTraits& traits = world.fleet.traits[own.slots[k]];
    snapshot.sensed.push_back({own.velocity[k], traits.radius, traits.max_acceleration});
  }
  world.fleet.cell[slot] = snapshot.cells.key(world.fleet.position[slot]);
}

void renew_step(World& world, std::size_t slot) {
  Whereabouts& own = world.whereabouts;
  own.step[own.place_of[slot]] = step_in_progress(world, slot);
  note_speeds(world, slot);
  ++own.decisions;
}

}  // namespace avo::inline sim
