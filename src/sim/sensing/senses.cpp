// SPDX-License-Identifier: Apache-2.0
// Measurements, and their processing until a decision is made.
#include "sim/sensing/senses.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/draws.h"
#include "robots/model.h"
#include "sim/clocks.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

constexpr std::uint64_t kMoverBit = std::uint64_t{1} << 63;  // no robot has such an id

// The state of a robot, in a generation or at an instant before now.
PastState before(const World& world, std::size_t rank, std::int64_t moment) {
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

// The state of a robot at that moment, or its present state.
PastState then(const World& world, const Present& robot, std::int64_t moment) {
  return moment == world.moment() ? robot.state : before(world, robot.rank, moment);
}

// A robot that measures.
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

// The observer and one other body.
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

// m: how far the disc of a robot with that speed so long ago, as measured, may have swung off its
// extrapolated path. For a robot that turns in place the end of a step alone may count. The disc
// swings twice as fast there as over the whole step.
double swung(const World& world, std::size_t slot, const MotionModel& model, double speed,
             double time) {
  const RobotTraits& traits = world.fleet.traits[slot];
  const double off = most_noise(world.settings.sensing.noise).velocity;
  const double top = std::min(speed + off + traits.max_acceleration * time, traits.max_speed);
  const double step =
      world.senses.by_time ? 2.0 * world.fleet.clock_of(slot).time_step : world.settings.time_step;
  return time * swing_of(model, traits.max_acceleration, top, step);
}

Encounter encounter_of(const Observer& observer, const Present& robot) {
  const World& world = observer.world;
  const std::vector<std::int64_t>& since = world.senses.since;
  return {observer, world.fleet.id[robot.slot].value,
          std::max(since[observer.own.rank], since[robot.rank])};
}

std::optional<std::int64_t> last_measured(const Encounter& encounter, const Present& robot,
                                          const Wall* behind = nullptr) {
  return encounter.last_measured(
      [&](std::int64_t m) { return then(encounter.observer.world, robot, m).position; }, behind);
}

bool are_alike(const PastState& a, const PastState& b) {
  return a.position == b.position && a.velocity == b.velocity;
}

// Adds the robot, if it is sensed.
void look_at_robot(const Observer& observer, const Present& robot,
                   std::vector<Sighting>& sightings) {
  const World& world = observer.world;
  const Present& own = observer.own;
  const auto expected = world.fleet.expected(robot.slot, own.slot);
  if (!expected) return;
  const Encounter encounter = encounter_of(observer, robot);
  const auto moment = robot.is_known ? robot.measured : last_measured(encounter, robot);
  if (!moment) return;
  const PastState state = then(world, robot, *moment);
  const double time = observer.seconds_since(*moment);
  Sighting& seen = sightings.emplace_back();
  seen.source = static_cast<int>(robot.rank);
  seen.slot = robot.slot, seen.expected = *expected;
  seen.position = state.position + time * state.velocity;
  seen.velocity = state.velocity, seen.true_velocity = robot.state.velocity;
  // by their true states: two robots that move as one must see the same
  if (are_alike(robot.state, own.state))
    seen.parting = parting_direction(observer.id, encounter.other_id);
  encounter.measure(*moment, seen);
  if (const MotionModel* model = world.fleet.own_model(robot.slot))
    seen.position_error = swung(world, robot.slot, *model, norm(seen.velocity), time);
}

// Adds a mover that keeps its acceleration: its true state extrapolated is the present one. A mover
// on a trajectory is extrapolated straight from its past place.
void look_at_mover(const Observer& observer, std::size_t k, std::vector<Sighting>& sightings) {
  const World& world = observer.world;
  const Encounter encounter{observer, kMoverBit | k, world.senses.since[observer.own.rank]};
  Neighbor now = world.movers.sensed(k);
  const MovingObstacle& setup = world.movers.setup[k];
  const auto walk_at = [&](std::int64_t m) {
    return on_trajectory(setup, world.senses.by_time
                                    ? seconds(m)
                                    : static_cast<double>(m) * world.settings.time_step);
  };
  const auto moment = encounter.last_measured([&](std::int64_t m) {
    if (!setup.trajectory.empty()) return walk_at(m).position;
    const double time = observer.seconds_since(m);
    return now.position - time * now.velocity + (0.5 * time * time) * now.acceleration;
  });
  if (!moment) return;
  if (!setup.trajectory.empty()) {
    const PathWalk then = walk_at(*moment);
    now.position = then.position + observer.seconds_since(*moment) * then.velocity;
    now.velocity = then.velocity;
  }
  Sighting& seen = sightings.emplace_back();
  seen.source = -1 - static_cast<int>(k);
  seen.position = now.position, seen.velocity = now.velocity;
  encounter.measure(*moment, seen);
}

// Returns whether the robot is a usual one: it differs from most others by its measured state
// alone.
bool is_usual(const Fleet& fleet, std::size_t slot) {
  const RobotTraits& traits = fleet.traits[slot];
  return !traits.exceeds && fleet.conduct[slot].priority == 1.0 && !max_braking_of(traits) &&
         !(fleet.has_footprints && traits.has_model);
}

}  // namespace

void look(const World& world, const Present& own, std::span<const Present> robots,
          std::span<const NeighborHit> movers, std::vector<Sighting>& seen) {
  seen.clear();
  const Observer observer(world, own);
  for (const Present& robot : robots) look_at_robot(observer, robot, seen);
  for (const NeighborHit& hit : movers)
    look_at_mover(observer, static_cast<std::size_t>(hit.index), seen);
  const auto nearer = [](const Sighting& a, const Sighting& b) {
    if (a.distance_squared != b.distance_squared) return a.distance_squared < b.distance_squared;
    const bool is_mover = a.source < 0, is_other = b.source < 0;
    if (is_mover != is_other) return is_other;
    return is_mover ? a.source > b.source : a.source < b.source;
  };
  // they come in the order of their true distances
  if (!std::is_sorted(seen.begin(), seen.end(), nearer))
    std::sort(seen.begin(), seen.end(), nearer);
  const bool all_matter = world.all_matter();
  if (!all_matter && seen.size() > world.most_nearest()) seen.resize(world.most_nearest());
}

// A robot without special properties goes straight into the columns.
void append(const World& world, const Sighting& seen, NeighborColumns& to) {
  if (seen.source >= 0 && seen.expected == Expectation::decides && seen.age == 0 &&
      seen.position_error == 0.0 && seen.parting == Vec2{} && is_usual(world.fleet, seen.slot)) {
    const RobotTraits& traits = world.fleet.traits[seen.slot];
    to.add_usual(seen.position, seen.velocity, traits.radius, traits.max_acceleration);
    return;
  }
  Neighbor neighbor = neighbor_of(world, seen);
  if (seen.source >= 0 && world.fleet.has_footprints && world.fleet.own_model(seen.slot) != nullptr)
    cover(*world.fleet.own_model(seen.slot), world.snapshot.pose[seen.slot], neighbor);
  to.add(neighbor);
}

// Uses the same numbers as look() and append().
bool append_as_they_are(const World& world, const Present& own, std::span<Present> robots,
                        NeighborColumns& to) {
  const Observer observer(world, own);
  if (!observer.measures_the_present()) return false;
  const Fleet& fleet = world.fleet;
  const std::size_t first = to.count,
                    most = world.all_matter() ? robots.size() : world.most_nearest();
  to.reserve(first + std::min(robots.size(), most));
  for (Present& robot : robots) {
    const auto expected = fleet.expected(robot.slot, own.slot);
    if (!expected) continue;
    const Vec2 p = robot.state.position, v = robot.state.velocity;
    const bool is_plain = *expected == Expectation::decides && is_usual(fleet, robot.slot) &&
                          !are_alike(robot.state, own.state);
    const Encounter encounter = encounter_of(observer, robot);
    const Wall* behind = nullptr;
    const bool is_seen = encounter.succeeds(own.state.position, p, observer.latest, behind);
    robot.measured = is_seen ? observer.latest : last_measured(encounter, robot, behind);
    robot.is_known = true;
    if (!is_plain || (!is_seen && robot.measured)) {
      to.count = first;
      return false;
    }
    if (!is_seen || to.count == first + most) continue;
    const RobotTraits& traits = fleet.traits[robot.slot];
    // 0.0 * v: look() extrapolates by 0 s, which turns a place of -0 into 0
    to.add_usual(p + 0.0 * v, v, traits.radius, traits.max_acceleration);
  }
  return true;
}

Neighbor neighbor_of(const World& world, const Sighting& seen) {
  const Fleet& fleet = world.fleet;
  Neighbor neighbor;
  if (seen.source < 0) {
    neighbor = world.movers.sensed(static_cast<std::size_t>(-1 - seen.source));
  } else {
    neighbor = sensed(fleet.traits[seen.slot], fleet.conduct[seen.slot], seen.expected,
                      seen.position, seen.true_velocity);
  }
  neighbor.position = seen.position, neighbor.velocity = seen.velocity;
  neighbor.age = seen.age, neighbor.parting = seen.parting;
  neighbor.position_error = seen.position_error;
  return neighbor;
}

}  // namespace avo::inline sim
