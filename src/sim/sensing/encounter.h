// SPDX-License-Identifier: Apache-2.0
// Measurements of one body by one robot: which of them succeed, and their errors.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/draws.h"
#include "sim/clocks.h"
#include "sim/sensing/senses.h"
#include "sim/world.h"

namespace avo::inline sim {

/// The state of a robot, in a generation or at an instant before now.
inline PastState before(const World& world, std::size_t rank, std::int64_t moment) {
  const Senses& senses = world.senses;
  if (!senses.by_time) return senses.at(rank, moment);
  const auto state_of = [](const MotionState& state) {
    return PastState{state.position, state.velocity};
  };
  const Track& track = senses.tracks[rank];
  std::size_t k = track.count - 1;
  while (k > 0 && track[k].at > moment) --k;
  if (k + 1 == track.count || track[k].at >= moment) return state_of(track[k].state);
  return state_of(state_within(world, world.fleet.slot_of[rank], track[k].state, track[k + 1].state,
                               moment - track[k].at, track[k + 1].at - track[k].at));
}

/// The state of a robot at that moment, or its present state.
inline PastState then(const World& world, const Present& robot, std::int64_t moment) {
  return moment == world.moment() ? robot.state : before(world, robot.rank, moment);
}

/// A robot that measures.
struct Observer {
  const World& world;
  const Present& own;
  std::uint64_t id;
  std::int64_t interval;  // from one measurement to the next
  std::int64_t latest;    // moment of its latest one
  std::uint64_t key;      // of the draws of that measurement

  Observer(const World& of_world, const Present& robot)
      : world(of_world),
        own(robot),
        id(world.fleet.id[own.slot].value),
        interval(world.senses.by_time ? step_of(world.fleet.clock[own.rank]) : 1),
        latest(world.moment() - delay()),
        key(Draws::key_of(world.settings.seed, latest, id)) {}

  const SensingModel& model() const { return world.settings.sensing; }
  std::int64_t delay() const {
    return world.senses.by_time ? model().delay * nanoseconds(world.settings.time_step)
                                : model().delay;
  }
  Draws draws(std::int64_t moment, std::uint64_t other) const {
    return {moment == latest ? key : Draws::key_of(world.settings.seed, moment, id), other};
  }
  // Returns whether a measurement of a robot in sight gives its present state.
  bool measures_the_present() const {
    const MeasurementNoise& off = model().noise;
    return model().delay == 0 && !(model().dropped > 0.0) && !(off.position > 0.0) &&
           !(off.velocity > 0.0);
  }
  double seconds_since(std::int64_t moment) const {
    if (world.senses.by_time) return seconds(world.now - moment);
    return static_cast<double>(world.steps - moment) * world.settings.time_step;
  }
  int age(std::int64_t moment) const {
    return latest > moment ? static_cast<int>((latest - moment - 1) / interval + 1) : 0;
  }
};

/// The observer and one other body.
struct Encounter {
  const Observer& observer;
  std::uint64_t other_id;
  std::int64_t first;  // moment since which both have been present

  const SensingModel& model() const { return observer.model(); }

  // Returns whether a measurement succeeds. At first no measurement fails: a start is known to all.
  // behind: see Routes::is_in_sight().
  bool succeeds(Vec2 from, Vec2 to, std::int64_t moment, const Wall*& behind) const {
    const World& world = observer.world;
    const double radius = world.sensing_radius;
    if (!(norm_squared(to - from) <= radius * radius)) return false;
    if (model().dropped > 0.0 && moment > first &&
        observer.draws(moment, other_id).uniform() < model().dropped)
      return false;
    return !model().occlusion || world.routes_of(observer.own.slot).is_in_sight(from, to, behind);
  }

  // The time of the last measurement that the observer has; place(moment): the place of the other
  // then.
  template <typename Place>
  std::optional<std::int64_t> last_measured(const Place& place,
                                            const Wall* behind = nullptr) const {
    const std::int64_t latest = std::max(observer.latest, first);
    const std::int64_t carried = model().misses() ? kMostCarried : 0;
    for (std::int64_t k = 0; k <= carried; ++k) {
      const std::int64_t moment = std::max(latest - k * observer.interval, first);
      const Vec2 from = then(observer.world, observer.own, moment).position;
      if (succeeds(from, place(moment), moment, behind)) return moment;
      if (moment == first) break;
    }
    return {};
  }

  // seen: the true state at that moment, extrapolated.
  void measure(std::int64_t moment, Sighting& seen) const {
    const double time = observer.seconds_since(moment);
    const MeasurementNoise& off = model().noise;
    if (off.position > 0.0 || off.velocity > 0.0) {
      Draws numbers = observer.draws(moment, other_id);
      numbers.uniform();  // the draw that decided whether it is missed
      const auto drawn = noise<4>(off, numbers);
      const Vec2 of_position = off.position * Vec2{drawn[0], drawn[1]};
      const Vec2 of_velocity = off.velocity * Vec2{drawn[2], drawn[3]};
      seen.position = seen.position + of_position + time * of_velocity;
      seen.velocity = seen.velocity + of_velocity;
    }
    seen.age = observer.age(moment);
    seen.distance_squared = norm_squared(seen.position - observer.own.state.position);
  }
};

}  // namespace avo::inline sim
