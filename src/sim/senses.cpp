// SPDX-License-Identifier: Apache-2.0
// Measurements, and what becomes of them until a decision is made.
#include "sim/senses.h"

#include <algorithm>
#include <bit>
#include <numbers>
#include <optional>
#include <tuple>

#include "core/elementary.h"
#include "core/hash.h"
#include "robots/model.h"
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
  double uniform() { return 0x1p-53 * static_cast<double>(mixed(key_, count_++) >> 11); }

 private:
  std::uint64_t key_, count_ = 0;
};

bool is_gaussian(const MeasurementNoise& model) {
  return model.distribution == NoiseDistribution::gaussian;
}

double most_of_coordinate(const MeasurementNoise& model) {
  return is_gaussian(model) ? model.truncated.value_or(kUsualTruncation) : 1.0;
}

// Of a coordinate, in units of what the scene gives. Gaussian noise by rejection: exactly of that
// density where it is not cut off, and by the library's own exponential function alone.
double noise(const MeasurementNoise& model, Draws& draws) {
  const double most = most_of_coordinate(model);
  for (;;) {
    const double x = most * (2.0 * draws.uniform() - 1.0);
    if (!is_gaussian(model) || draws.uniform() < 1.0 + elementary::expm1(-0.5 * x * x)) return x;
  }
}

Vec2 noise_vector(const MeasurementNoise& model, Draws& draws) {
  const double x = noise(model, draws);
  return {x, noise(model, draws)};
}

// The observer and one other.
struct Encounter {
  const World& world;
  std::size_t observer;  // rank
  std::uint64_t observer_id, other_id;
  std::int64_t first;  // generation in which both were there

  const SensingModel& model() const { return world.settings.sensing; }
  Draws draws(std::int64_t generation) const {
    return {world.settings.seed, generation, observer_id, other_id};
  }

  // Whether a measurement succeeds. At first nobody is missed: a start is known to all.
  bool succeeds(Vec2 from, Vec2 to, std::int64_t generation) const {
    const double radius = world.settings.sensing_radius;
    if (!(norm_squared(to - from) <= radius * radius)) return false;
    if (model().dropped > 0.0 && generation > first &&
        draws(generation).uniform() < model().dropped)
      return false;
    return !model().occlusion || world.ways.is_in_sight(from, to);
  }

  // The generation of the last measurement that the observer has; place(g): where the other was.
  template <typename Place>
  std::optional<std::int64_t> last_measured(const Place& place) const {
    const std::int64_t latest = std::max(world.steps - model().delay, first);
    const std::int64_t carried = model().misses() ? kMostCarried : 0;
    for (std::int64_t g = latest; g >= std::max(first, latest - carried); --g) {
      if (succeeds(world.senses.at(observer, g).position, place(g), g)) return g;
    }
    return {};
  }

  // neighbor: as it would be by the true state at that generation, carried on.
  Sighting sighting(Neighbor neighbor, std::int64_t generation, int source) const {
    const std::int64_t steps = world.steps - generation;
    const double time = static_cast<double>(steps) * world.settings.time_step;
    const MeasurementNoise& off = model().noise;
    if (off.position > 0.0 || off.velocity > 0.0) {
      Draws numbers = draws(generation);
      numbers.uniform();  // which told whether it is missed
      const Vec2 of_position = off.position * noise_vector(off, numbers);
      const Vec2 of_velocity = off.velocity * noise_vector(off, numbers);
      neighbor.position = neighbor.position + of_position + time * of_velocity;
      neighbor.velocity = neighbor.velocity + of_velocity;
    }
    neighbor.age = static_cast<int>(std::max<std::int64_t>(steps - model().delay, 0));
    const Vec2 here = world.senses.at(observer, world.steps).position;
    return {neighbor, norm_squared(neighbor.position - here), source};
  }
};

// m: how far the disc of one that had that speed so long ago, as measured, may have swung off the
// way on which it is carried on.
double swung(const World& world, const MotionModel& model, const RobotTraits& traits, double speed,
             double time) {
  const double off = most_noise(world.settings.sensing.noise).velocity;
  const double top = std::min(speed + off + traits.max_acceleration * time, traits.max_speed);
  return time * swing_of(model, traits.max_acceleration, top, world.settings.time_step);
}

std::optional<Sighting> look_at_robot(Encounter encounter, std::size_t rank) {
  const World& world = encounter.world;
  const Senses& senses = world.senses;
  const std::uint32_t slot = world.fleet.slot_of[rank];
  const auto behavior = world.fleet.expected(slot, world.fleet.slot_of[encounter.observer]);
  if (!behavior) return {};
  encounter.other_id = world.fleet.id[slot].value;
  encounter.first = std::max(senses.since[encounter.observer], senses.since[rank]);
  const auto generation =
      encounter.last_measured([&](std::int64_t g) { return senses.at(rank, g).position; });
  if (!generation) return {};
  const PastState& state = senses.at(rank, *generation);
  const double time = static_cast<double>(world.steps - *generation) * world.settings.time_step;
  Neighbor neighbor = world.fleet.sensed(slot, *behavior);
  neighbor.position = state.position + time * state.velocity;
  neighbor.velocity = state.velocity;
  // by their true states: what is sensed of two that move as one looks the same to both
  const PastState& own = senses.at(encounter.observer, world.steps);
  const PastState& now = senses.at(rank, world.steps);
  if (now.position == own.position && now.velocity == own.velocity)
    neighbor.parting = parting_direction(encounter.observer_id, encounter.other_id);
  Sighting sighting = encounter.sighting(neighbor, *generation, static_cast<int>(rank));
  if (const MotionModel* model = world.fleet.own_model(slot))
    sighting.neighbor.position_error =
        swung(world, *model, world.fleet.traits[slot], norm(sighting.neighbor.velocity), time);
  return sighting;
}

// It keeps its acceleration: the true state carried on is the present one.
std::optional<Sighting> look_at_mover(Encounter encounter, std::size_t k) {
  const World& world = encounter.world;
  encounter.other_id = kMoverBit | k;
  encounter.first = world.senses.since[encounter.observer];
  const Neighbor now = world.obstacles.sensed(k);
  const auto generation = encounter.last_measured([&](std::int64_t g) {
    const double time = static_cast<double>(world.steps - g) * world.settings.time_step;
    return now.position - time * now.velocity + (0.5 * time * time) * now.acceleration;
  });
  if (!generation) return {};
  return encounter.sighting(now, *generation, -1 - static_cast<int>(k));
}

}  // namespace

SensingError most_noise(const MeasurementNoise& model) {
  constexpr double kBoth = std::numbers::sqrt2 * (1.0 + 0x1p-40);
  const double most = kBoth * most_of_coordinate(model);
  return {most * model.position, most * model.velocity};
}

std::size_t generations_needed(const SensingModel& model) {
  if (model.is_exact()) return 0;
  return 1 + static_cast<std::size_t>(model.delay) + (model.misses() ? kMostCarried : 0);
}

double time_unseen(const Scenario& scenario) {
  const SensingModel& model = scenario.sensing;
  return (model.delay + (model.dropped > 0.0 ? kMostCarried : 0)) * scenario.time_step;
}

void Senses::reserve_one() {
  if (since.size() == since.capacity()) since.reserve(2 * since.size() + 8);
  if (past.capacity() < past.size() + depth) past.reserve(2 * past.size() + 8 * depth);
}

void Senses::add(std::int64_t generation) {
  if (are_exact()) return;
  since.push_back(generation);
  past.resize(past.size() + depth);
}

void Senses::remove(std::size_t rank) {
  if (are_exact()) return;
  const auto first = past.begin() + static_cast<std::ptrdiff_t>(rank * depth);
  past.erase(first, first + static_cast<std::ptrdiff_t>(depth));
  since.erase(since.begin() + static_cast<std::ptrdiff_t>(rank));
}

void Senses::renew(std::size_t rank, std::int64_t generation) {
  if (are_exact()) return;
  const auto first = past.begin() + static_cast<std::ptrdiff_t>(rank * depth);
  std::fill(first, first + static_cast<std::ptrdiff_t>(depth), PastState{});
  since[rank] = generation;
}

void Senses::note(const Fleet& fleet, std::int64_t generation) {
  if (are_exact()) return;
  const std::size_t place = static_cast<std::size_t>(generation) % depth;
  for (std::size_t rank = 0; rank < fleet.size(); ++rank) {
    const std::uint32_t slot = fleet.slot_of[rank];
    past[rank * depth + place] = {fleet.position[slot], fleet.velocity[slot]};
  }
}

std::uint64_t hash_of(const Senses& senses, std::uint64_t hash) {
  for (const std::int64_t generation : senses.since)
    hash = mixed(hash, static_cast<std::uint64_t>(generation));
  for (const auto& [position, velocity] : senses.past) {
    for (const double number : {position.x, position.y, velocity.x, velocity.y})
      hash = mixed(hash, std::bit_cast<std::uint64_t>(number));
  }
  return hash;
}

void look(const World& world, std::size_t slot, std::span<const NeighborHit> robots,
          std::span<const NeighborHit> movers, std::vector<Sighting>& seen) {
  seen.clear();
  const auto take = [&seen](const std::optional<Sighting>& sighting) {
    if (sighting) seen.push_back(*sighting);
  };
  const Encounter encounter{world, static_cast<std::size_t>(world.fleet.rank[slot]),
                            world.fleet.id[slot].value, 0, 0};
  for (const NeighborHit& hit : robots)
    take(look_at_robot(encounter, static_cast<std::size_t>(hit.index)));
  for (const NeighborHit& hit : movers)
    take(look_at_mover(encounter, static_cast<std::size_t>(hit.index)));
  std::sort(seen.begin(), seen.end(), [](const Sighting& a, const Sighting& b) {
    const auto key = [](const Sighting& s) {
      return std::tuple(s.distance_squared, s.source < 0, s.source < 0 ? -s.source : s.source);
    };
    return key(a) < key(b);
  });
  const bool all_matter = world.all_matter();
  if (!all_matter && seen.size() > world.most_nearest()) seen.resize(world.most_nearest());
}

}  // namespace avo
