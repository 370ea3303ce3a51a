// SPDX-License-Identifier: Apache-2.0
// Times are whole nanoseconds, so that instants are the same on every machine, and equal ones are
// equal.
#include "sim/clocks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/hash.h"
#include "robots/model.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

constexpr std::uint64_t kPhases = 0x70686173;  // distinguishes these random numbers from all others

MotionState state_at(const World& world, std::size_t slot, Instant instant) {
  const OwnClock& clock = world.fleet.clock_of(slot);
  if (clock.end == instant) return clock.to;
  return state_within(world, slot, clock.from, clock.to, instant - clock.begin,
                      clock.end - clock.begin);
}

void put(World& world, std::size_t slot, const MotionState& state) {
  Fleet& fleet = world.fleet;
  fleet.position[slot] = state.position;
  fleet.velocity[slot] = state.velocity;
  fleet.heading[slot] = state.heading;
}

}  // namespace

std::optional<Instant> whole_nanoseconds(double seconds) {
  if (!(std::abs(seconds) <= kMostClockTime)) return std::nullopt;
  const Instant whole = nanoseconds(seconds);
  return avo::seconds(whole) == seconds ? std::optional(whole) : std::nullopt;
}

MotionState state_within(const World& world, std::size_t slot, const MotionState& from,
                         const MotionState& to, Instant time, Instant duration) {
  if (const MotionModel* model = world.fleet.own_model(slot))
    return within(*model, from, to, seconds(time), seconds(duration));
  const bool at_once = adopts_at_once(world.fleet.conduct[slot].method);
  return within(from, to, at_once, seconds(time), seconds(duration));
}

void start_clock(World& world, std::size_t slot) {
  Fleet& fleet = world.fleet;
  OwnClock& clock = fleet.clock_of(slot);
  clock.begin = world.now;
  clock.from = clock.to = {fleet.position[slot], fleet.velocity[slot], fleet.heading[slot]};
  clock.has_decided = false;
  if (fleet.is_parked(slot)) {
    clock.end = std::numeric_limits<Instant>::max();
    return;
  }
  const std::uint64_t number =
      mixed(mixed(mixed(0, world.settings.seed), kPhases), fleet.id[slot].value);
  const auto phase = static_cast<Instant>(number % static_cast<std::uint64_t>(step_of(clock)));
  clock.end = clock.begin + phase;
  const double time = seconds(phase), speed = norm(clock.from.velocity);
  const double left = std::max(0.0, speed - fleet.traits[slot].max_braking * time);
  if (!(speed > 0.0) || phase == 0) return;
  clock.to.velocity = (left / speed) * clock.from.velocity;
  clock.to.position =
      clock.from.position + (0.5 * time) * (clock.from.velocity + clock.to.velocity);
  if (const MotionModel* model = fleet.own_model(slot))
    clock.to.heading = within(*model, clock.from, clock.to, time, time).heading;
}

void begin_step(World& world, std::size_t slot) {
  Fleet& fleet = world.fleet;
  OwnClock& clock = fleet.clock_of(slot);
  clock.begin = world.now;
  clock.end = world.now + step_of(clock);
  clock.from = clock.to;
  clock.to = {fleet.position[slot], fleet.velocity[slot], fleet.heading[slot]};
  clock.has_decided = true;
  put(world, slot, clock.from);
}

std::int64_t decisions_of(const World& world, std::size_t slot) {
  if (!world.fleet.has_clocks) return world.steps;
  return world.now / step_of(world.fleet.clock_of(slot));
}

void make_agenda(World& world) {
  const Fleet& fleet = world.fleet;
  Agenda& agenda = world.agenda;
  agenda.later.clear(), agenda.now.clear();
  agenda.later.reserve(fleet.size()), agenda.now.reserve(fleet.size());
  for (std::uint32_t rank = 0; rank < fleet.size(); ++rank) {
    if (fleet.is_parked(fleet.slot_of[rank])) continue;
    const Instant end = fleet.clock[rank].end;
    if (end > world.now)
      agenda.later.emplace_back(end, rank);
    else
      agenda.now.push_back(rank);
  }
  std::make_heap(agenda.later.begin(), agenda.later.end(), std::greater<>());
}

Instant next_instant(const World& world) {
  Instant next = std::numeric_limits<Instant>::max();
  const auto take = [&](const OwnClock& clock) {
    next = std::min(next, clock.end > world.now ? clock.end : world.now + step_of(clock));
  };
  if (world.changed) {
    std::for_each(world.fleet.clock.begin(), world.fleet.clock.end(), take);
  } else {
    if (!world.agenda.later.empty()) next = world.agenda.later.front().first;
    for (const std::uint32_t rank : world.agenda.now) take(world.fleet.clock[rank]);
  }
  if (next < std::numeric_limits<Instant>::max()) return next;
  return world.now + nanoseconds(world.settings.time_step);
}

void carry_on(World& world, Instant instant) {
  auto& [later, now] = world.agenda;
  for (const std::uint32_t rank : now) {
    later.emplace_back(world.fleet.clock[rank].end, rank);
    std::push_heap(later.begin(), later.end(), std::greater<>());
  }
  now.clear();
  while (!later.empty() && later.front().first == instant) {
    now.push_back(later.front().second);
    std::pop_heap(later.begin(), later.end(), std::greater<>());
    later.pop_back();
  }
  world.movers.advance(seconds(instant - world.now), seconds(instant));
  world.before = world.now;
  world.now = instant;
  world.is_current = false;
}

MotionState present_state(const World& world, std::size_t slot) {
  if (world.is_current || world.fleet.is_parked(slot)) return world.fleet.state(slot);
  return state_at(world, slot, world.now);
}

void put_in_place(World& world, std::size_t slot) {
  put(world, slot, present_state(world, slot));
}

void catch_up(World& world) {
  if (world.is_current) return;
  for (std::size_t slot = 0; slot < world.fleet.size(); ++slot) put_in_place(world, slot);
  world.is_current = true;
}

}  // namespace avo::inline sim
