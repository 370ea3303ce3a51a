// SPDX-License-Identifier: Apache-2.0
// Measurements, and what becomes of them until a decision is made.
#include "sim/senses.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

#include "core/hash.h"
#include "robots/model.h"
#include "sim/clocks.h"
#include "sim/noise.h"
#include "sim/world.h"

namespace avo {
namespace {

constexpr std::uint64_t kMoverBit = std::uint64_t{1} << 63;  // no robot has such an id

// The random numbers of one measurement, the same whoever asks for them, and whenever.
class Draws {
 public:
  Draws(std::uint64_t seed, std::int64_t generation, std::uint64_t observer, std::uint64_t neighbor)
      : key_(mixed(mixed(mixed(mixed(0, seed), static_cast<std::uint64_t>(generation)), observer),
                   neighbor)) {}

  // In [0, 1).
  double uniform() { return uniform_number(key_, count_++); }
  void gaussian(double most, GaussianDraws& draws) {
    draw_gaussian(key_, count_, most, draws);
    count_ += 2 * GaussianDraws::kTogether;
  }

 private:
  std::uint64_t key_, count_ = 0;
};

bool is_gaussian(const MeasurementNoise& model) {
  return model.distribution == NoiseDistribution::gaussian;
}

double most_of_coordinate(const MeasurementNoise& model) {
  return is_gaussian(model) ? model.truncated.value_or(kUsualTruncation) : 1.0;
}

// Of so many coordinates, in units of what the scene gives. Gaussian noise by rejection: exactly of
// that density where it is not cut off.
template <std::size_t kCount>
std::array<double, kCount> noise(const MeasurementNoise& model, Draws& draws) {
  const double most = most_of_coordinate(model);
  std::array<double, kCount + GaussianDraws::kTogether> drawn;
  if (is_gaussian(model)) {
    GaussianDraws together;
    for (std::size_t count = 0; count < kCount;) {
      draws.gaussian(most, together);
      for (std::size_t k = 0; k < GaussianDraws::kTogether; ++k) {
        drawn[count] = together.x[k];
        count += static_cast<std::size_t>(together.taken[k]);
      }
    }
  } else {
    for (std::size_t k = 0; k < kCount; ++k) drawn[k] = most * (2.0 * draws.uniform() - 1.0);
  }
  std::array<double, kCount> noise;
  std::copy_n(drawn.begin(), kCount, noise.begin());
  return noise;
}

// Where a robot was, in a generation or at an instant.
PastState then(const World& world, std::size_t rank, std::int64_t moment) {
  const Senses& senses = world.senses;
  if (!senses.by_time || moment == world.now)
    return senses.at(rank, senses.by_time ? world.steps : moment);
  const auto state_of = [](const MotionState& state) {
    return PastState{state.position, state.velocity};
  };
  const Track& track = senses.tracks[rank];
  std::size_t k = track.count - 1;
  while (k > 0 && track[k].at > moment) --k;
  if (k + 1 == track.count || track[k].at >= moment) return state_of(track[k].state);
  return state_of(on_the_way(world, world.fleet.slot_of[rank], track[k].state, track[k + 1].state,
                             moment - track[k].at, track[k + 1].at - track[k].at));
}

// The observer and one other.
struct Encounter {
  const World& world;
  std::size_t observer;  // rank
  std::uint64_t observer_id, other_id;
  std::int64_t first;  // moment since which both were there

  const SensingModel& model() const { return world.settings.sensing; }
  Draws draws(std::int64_t moment) const {
    return {world.settings.seed, moment, observer_id, other_id};
  }

  // Of the observer: from one measurement to the next, and from the latest to now.
  std::int64_t interval() const {
    return world.senses.by_time ? step_of(world.fleet.clock[observer]) : 1;
  }
  std::int64_t delay() const {
    return world.senses.by_time ? model().delay * nanoseconds(world.settings.time_step)
                                : model().delay;
  }
  double seconds_since(std::int64_t moment) const {
    if (world.senses.by_time) return seconds(world.now - moment);
    return static_cast<double>(world.steps - moment) * world.settings.time_step;
  }
  int age(std::int64_t moment) const {
    const std::int64_t late = world.moment() - moment - delay();
    return late > 0 ? static_cast<int>((late - 1) / interval() + 1) : 0;
  }

  // Whether a measurement succeeds. At first nobody is missed: a start is known to all.
  bool succeeds(Vec2 from, Vec2 to, std::int64_t moment) const {
    const double radius = world.sensing_radius;
    if (!(norm_squared(to - from) <= radius * radius)) return false;
    if (model().dropped > 0.0 && moment > first && draws(moment).uniform() < model().dropped)
      return false;
    return !model().occlusion || world.ways.is_in_sight(from, to);
  }

  // When the last measurement that the observer has was made; place(moment): where the other was.
  template <typename Place>
  std::optional<std::int64_t> last_measured(const Place& place) const {
    const std::int64_t latest = std::max(world.moment() - delay(), first);
    const std::int64_t carried = model().misses() ? kMostCarried : 0;
    for (std::int64_t k = 0; k <= carried; ++k) {
      const std::int64_t moment = std::max(latest - k * interval(), first);
      if (succeeds(then(world, observer, moment).position, place(moment), moment)) return moment;
      if (moment == first) break;
    }
    return {};
  }

  // seen.neighbor: as it would be by the true state at that moment, carried on.
  void measure(std::int64_t moment, int source, Sighting& seen) const {
    Neighbor& neighbor = seen.neighbor;
    const double time = seconds_since(moment);
    const MeasurementNoise& off = model().noise;
    if (off.position > 0.0 || off.velocity > 0.0) {
      Draws numbers = draws(moment);
      numbers.uniform();  // which told whether it is missed
      const auto [p_x, p_y, v_x, v_y] = noise<4>(off, numbers);
      const Vec2 of_position = off.position * Vec2{p_x, p_y};
      const Vec2 of_velocity = off.velocity * Vec2{v_x, v_y};
      neighbor.position = neighbor.position + of_position + time * of_velocity;
      neighbor.velocity = neighbor.velocity + of_velocity;
    }
    neighbor.age = age(moment);
    const Vec2 here = world.senses.at(observer, world.steps).position;
    seen.distance_squared = norm_squared(neighbor.position - here);
    seen.source = source;
  }
};

// m: how far the disc of one that had that speed so long ago, as measured, may have swung off the
// way on which it is carried on. Of one that turns in place the end of a step alone may count, in
// which it swings twice as fast as over the whole.
double swung(const World& world, std::size_t slot, const MotionModel& model, double speed,
             double time) {
  const RobotTraits& traits = world.fleet.traits[slot];
  const double off = most_noise(world.settings.sensing.noise).velocity;
  const double top = std::min(speed + off + traits.max_acceleration * time, traits.max_speed);
  const double step =
      world.senses.by_time ? 2.0 * world.fleet.clock_of(slot).time_step : world.settings.time_step;
  return time * swing_of(model, traits.max_acceleration, top, step);
}

// Adds it, if it is seen.
void look_at_robot(Encounter encounter, std::size_t rank, std::vector<Sighting>& sightings) {
  const World& world = encounter.world;
  const Senses& senses = world.senses;
  const std::uint32_t slot = world.fleet.slot_of[rank];
  const auto expected = world.fleet.expected(slot, world.fleet.slot_of[encounter.observer]);
  if (!expected) return;
  encounter.other_id = world.fleet.id[slot].value;
  encounter.first = std::max(senses.since[encounter.observer], senses.since[rank]);
  const auto moment =
      encounter.last_measured([&](std::int64_t m) { return then(world, rank, m).position; });
  if (!moment) return;
  const PastState state = then(world, rank, *moment);
  const double time = encounter.seconds_since(*moment);
  sightings.push_back({world.fleet.sensed(slot, *expected)});
  Sighting& seen = sightings.back();
  Neighbor& neighbor = seen.neighbor;
  neighbor.position = state.position + time * state.velocity;
  neighbor.velocity = state.velocity;
  // by their true states: what is sensed of two that move as one looks the same to both
  const PastState& own = senses.at(encounter.observer, world.steps);
  const PastState& now = senses.at(rank, world.steps);
  if (now.position == own.position && now.velocity == own.velocity)
    neighbor.parting = parting_direction(encounter.observer_id, encounter.other_id);
  encounter.measure(*moment, static_cast<int>(rank), seen);
  if (const MotionModel* model = world.fleet.own_model(slot))
    neighbor.position_error = swung(world, slot, *model, norm(neighbor.velocity), time);
}

// One that keeps its acceleration: the true state carried on is the present one. One on a
// trajectory is carried on straight from where it was.
void look_at_mover(Encounter encounter, std::size_t k, std::vector<Sighting>& sightings) {
  const World& world = encounter.world;
  encounter.other_id = kMoverBit | k;
  encounter.first = world.senses.since[encounter.observer];
  Neighbor now = world.obstacles.sensed(k);
  const MovingObstacle& setup = world.obstacles.setup[k];
  const auto walk_at = [&](std::int64_t m) {
    return on_trajectory(setup, world.senses.by_time
                                    ? seconds(m)
                                    : static_cast<double>(m) * world.settings.time_step);
  };
  const auto moment = encounter.last_measured([&](std::int64_t m) {
    if (!setup.trajectory.empty()) return walk_at(m).position;
    const double time = encounter.seconds_since(m);
    return now.position - time * now.velocity + (0.5 * time * time) * now.acceleration;
  });
  if (!moment) return;
  if (!setup.trajectory.empty()) {
    const PathWalk then = walk_at(*moment);
    now.position = then.position + encounter.seconds_since(*moment) * then.velocity;
    now.velocity = then.velocity;
  }
  sightings.push_back({now});
  encounter.measure(*moment, -1 - static_cast<int>(k), sightings.back());
}

MeasurementNoise as_measured(const LocalizationNoise& model) {
  return {model.position, 0.0, model.distribution, model.truncated};
}

}  // namespace

SensingError most_noise(const MeasurementNoise& model) {
  constexpr double kBoth = std::numbers::sqrt2 * (1.0 + 0x1p-40);
  const double most = kBoth * most_of_coordinate(model);
  return {most * model.position, most * model.velocity};
}

double most_lost(const LocalizationNoise& model) {
  return most_noise(as_measured(model)).position;
}

Vec2 own_error(const World& world, std::size_t slot) {
  const LocalizationNoise& model = world.settings.sensing.localization;
  if (!(model.position > 0.0)) return {};
  const std::uint64_t own = world.fleet.id[slot].value;
  Draws numbers(world.settings.seed, world.steps, own, own);
  const auto [x, y] = noise<2>(as_measured(model), numbers);
  return model.position * Vec2{x, y};
}

void look(const World& world, std::size_t slot, std::span<const NeighborHit> robots,
          std::span<const NeighborHit> movers, std::vector<Sighting>& seen) {
  seen.clear();
  const Encounter encounter{world, static_cast<std::size_t>(world.fleet.rank[slot]),
                            world.fleet.id[slot].value, 0, 0};
  for (const NeighborHit& hit : robots)
    look_at_robot(encounter, static_cast<std::size_t>(hit.index), seen);
  for (const NeighborHit& hit : movers)
    look_at_mover(encounter, static_cast<std::size_t>(hit.index), seen);
  const auto nearer = [](const Sighting& a, const Sighting& b) {
    if (a.distance_squared != b.distance_squared) return a.distance_squared < b.distance_squared;
    const bool is_mover = a.source < 0, is_other = b.source < 0;
    if (is_mover != is_other) return is_other;
    return is_mover ? a.source > b.source : a.source < b.source;
  };
  // they come as they are in truth
  if (!std::is_sorted(seen.begin(), seen.end(), nearer))
    std::sort(seen.begin(), seen.end(), nearer);
  const bool all_matter = world.all_matter();
  if (!all_matter && seen.size() > world.most_nearest()) seen.resize(world.most_nearest());
}

}  // namespace avo
