// SPDX-License-Identifier: Apache-2.0
// Columns of robots: adding, changing, removing and reordering.
#include "sim/columns/fleet.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include "avo/error.h"
#include "fields/robot_fields.h"
#include "robots/footprint.h"
#include "robots/model.h"

namespace avo::inline sim {
namespace {

// The fields from this one on have no columns of their own.
constexpr std::size_t kFirstRare = 21;
static_assert(kFields<RobotSetup>[kFirstRare].key == "time_horizon");
constexpr std::span<const RobotField> kRareFields =
    std::span(kFields<RobotSetup>).subspan(kFirstRare);

void copy_rare(const RobotSetup& from, RobotSetup& to) {
  for_each_member(kRareFields, [&](const RobotField&, auto member) { to.*member = from.*member; });
}

// A column is empty where all its entries are default ones. Only room may take memory.
template <typename Entry>
void make_room(std::vector<Entry>& column, std::size_t size, const Entry& entry) {
  if (!column.empty() || !(entry == Entry{})) column.resize(size);
}
template <typename Entry>
void put(std::vector<Entry>& column, std::size_t k, const Entry& entry) {
  if (!column.empty()) column[k] = entry;
}

RobotSetup rare_of(const RobotSetup& setup) {
  RobotSetup rare;
  copy_rare(setup, rare);
  return rare;
}

}  // namespace

template <typename Action>
void Fleet::for_each_column(const Action& action) {
  action(id), action(rank), action(traits), action(conduct), action(range), action(nearest);
  action(goal), action(position), action(velocity), action(heading), action(detour), action(plan),
      action(applied_acceleration);
  action(has_stood), action(cell);
}

void Fleet::reserve(std::size_t count) {
  for_each_column([&](auto& column) { column.reserve(count); });
  slot_of.reserve(count);
}

void Fleet::add(RobotId robot, const RobotSetup& setup, std::uint32_t own_pace) {
  const std::size_t slot = size();
  // everything that may throw comes before any change
  bool full = slot_of.capacity() == slot;
  for_each_column([&](auto& column) { full = full || column.capacity() == slot; });
  if (full) reserve(2 * slot + 8);
  if (has_clocks) clock.resize(slot + 1);
  if (!models.empty() || !is_holonomic(setup.model)) {
    for (std::size_t k = own_radius.size(); k < slot; ++k)
      own_radius.push_back(traits[slot_of[k]].radius);  // of the holonomic robots
    own_radius.resize(slot + 1);
    models.resize(slot + 1);
  }
  if (!flights.empty() || !can_rest(setup.model)) flights.resize(slot + 1);
  const RobotSetup own_rare = rare_of(setup);
  make_room(pace, slot + 1, own_pace), make_room(rare, slot + 1, own_rare);
  if (!told.empty()) told.resize(slot + 1);
  if (!host_motion.empty()) host_motion.resize(slot + 1);
  for_each_column([&](auto& column) { column.resize(slot + 1); });
  id[slot] = robot;
  rank[slot] = static_cast<int>(slot);
  traits[slot] = traits_of(setup);
  conduct[slot] = conduct_of(setup, usual);
  put(pace, slot, own_pace), put(rare, slot, own_rare);
  goal[slot] = setup.goal;
  position[slot] = disc_center(setup);
  velocity[slot] = start_velocity(setup);
  nearest[slot] = std::numeric_limits<float>::infinity();
  heading[slot] = traits[slot].has_model ? setup.heading : 0.0;
  if (!models.empty()) models[slot] = setup.model, own_radius[slot] = setup.radius;
  has_footprints = has_footprints || has_footprint(setup.model);
  if (Flight* own = flight(slot)) *own = {*circle_of(setup.model, position[slot], velocity[slot])};
  slot_of.push_back(static_cast<std::uint32_t>(slot));
}

void Fleet::change(std::size_t slot, const RobotSetup& setup, std::uint32_t own_pace) {
  const auto place = static_cast<std::size_t>(rank[slot]);
  const RobotSetup own_rare = rare_of(setup);
  make_room(pace, size(), own_pace), make_room(rare, size(), own_rare);
  put(pace, place, own_pace), put(rare, place, own_rare);
  traits[slot] = traits_of(setup);
  conduct[slot] = conduct_of(setup, usual);
  nearest[slot] = std::numeric_limits<float>::infinity();
  if (!models.empty()) own_radius[place] = setup.radius;
}

void Fleet::remove(std::size_t slot) {
  slot_of.erase(slot_of.begin() + rank[slot]);
  if (!models.empty()) {
    models.erase(models.begin() + rank[slot]);
    own_radius.erase(own_radius.begin() + rank[slot]);
  }
  if (!flights.empty()) flights.erase(flights.begin() + rank[slot]);
  if (has_clocks) clock.erase(clock.begin() + rank[slot]);
  if (!pace.empty()) pace.erase(pace.begin() + rank[slot]);
  if (!rare.empty()) rare.erase(rare.begin() + rank[slot]);
  if (!told.empty()) told.erase(told.begin() + rank[slot]);
  if (!host_motion.empty()) host_motion.erase(host_motion.begin() + rank[slot]);
  bases.remove(static_cast<std::size_t>(rank[slot]));
  const std::size_t last = size() - 1;  // it takes over the slot
  for (auto k = static_cast<std::size_t>(rank[slot]); k < slot_of.size(); ++k) --rank[slot_of[k]];
  if (slot != last)
    slot_of[static_cast<std::size_t>(rank[last])] = static_cast<std::uint32_t>(slot);
  for_each_column([&](auto& column) {
    column[slot] = column[last];
    column.pop_back();
  });
}

std::vector<Wall> Fleet::parked_walls(std::optional<std::size_t> changed,
                                      const std::optional<Wall>& own) const {
  std::vector<Wall> walls;
  for (const std::uint32_t slot : slot_of) {
    if (changed == slot) {
      walls.insert(walls.end(), own ? 1 : 0, own.value_or(Wall{}));
    } else if (is_parked(slot)) {
      walls.push_back(parked_wall(model(slot), position[slot], traits[slot].radius, heading[slot]));
    }
  }
  return walls;
}

// A robot's rank is its number, less the number of removed robots before it.
std::optional<std::size_t> Fleet::slot(RobotId robot) const {
  const std::uint64_t number = robot.value;
  if (slot_of.empty()) return std::nullopt;
  const std::size_t most = slot_of.size() - 1;
  const std::uint64_t last = id[slot_of[most]].value;
  if (number > last) return std::nullopt;
  const std::uint64_t gone = last - most;
  const auto begin =
      slot_of.begin() + static_cast<std::ptrdiff_t>(number > gone ? number - gone : 0);
  const auto end =
      slot_of.begin() + static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(number, most));
  const auto place = std::lower_bound(
      begin, end, number, [&](std::uint32_t own, std::uint64_t b) { return id[own].value < b; });
  if (!(id[*place] == robot)) return std::nullopt;
  return *place;
}

std::size_t Fleet::search(RobotId robot) const {
  if (const auto own = slot(robot)) return *own;
  throw Error("robot " + std::to_string(robot.value) + ": found none of that id");
}

RobotSetup Fleet::setup(std::size_t slot, const MotionState& state) const {
  const RobotTraits& robot_traits = traits[slot];
  RobotSetup setup{.position = place(slot, state),
                   .velocity = state.velocity,
                   .goal = goal[slot],
                   .radius = models.empty() ? robot_traits.radius
                                            : own_radius[static_cast<std::size_t>(rank[slot])],
                   .max_speed = robot_traits.max_speed,
                   .max_acceleration = robot_traits.max_acceleration,
                   .preferred_speed = robot_traits.preferred_speed,
                   .model = model(slot),
                   .heading = state.heading,
                   .priority = conduct[slot].priority,
                   .layers = conduct[slot].layers,
                   .avoids = conduct[slot].avoids,
                   .max_braking = max_braking_of(robot_traits),
                   .behavior = conduct[slot].behavior};
  if (has_clocks && !is_parked(slot)) setup.time_step = clock_of(slot).time_step;
  if (conduct[slot].method != usual.method) setup.method = conduct[slot].method;
  if (!rare.empty()) copy_rare(rare[static_cast<std::size_t>(rank[slot])], setup);
  return setup;
}

Vec2 Fleet::offset(std::size_t slot, double heading_of_it) const {
  const MotionModel* own = own_model(slot);
  return own != nullptr ? disc_center(*own, {}, heading_of_it) : Vec2{};
}

Neighbor Fleet::sensed(std::size_t slot, Expectation expected) const {
  Neighbor neighbor =
      avo::sensed(traits[slot], conduct[slot], expected, position[slot], velocity[slot]);
  neighbor.loiter = circle(slot);
  return neighbor;
}

Robot limits_of(const Fleet& fleet, std::size_t slot) {
  const RobotTraits& traits = fleet.traits[slot];
  Robot robot;
  robot.radius = traits.radius;
  robot.max_acceleration = traits.max_acceleration;
  robot.max_speed = traits.max_speed;
  robot.priority = fleet.conduct[slot].priority;
  robot.max_braking = max_braking_of(traits);
  if (traits.has_model) robot.model = *fleet.own_model(slot);
  return robot;
}

void Fleet::reorder(std::span<const std::uint32_t> order, Executor& executor, bool& torn) {
  constexpr std::size_t kChunk = 4096;
  const std::size_t count = size();
  const auto for_each_chunk = [&](const auto& body) {
    parallel_for(executor, (count + kChunk - 1) / kChunk, [&](std::size_t chunk, std::size_t) {
      body(chunk * kChunk, std::min((chunk + 1) * kChunk, count));
    });
  };
  // bytes of an entry that are moved at once, which bounds the memory: a wider entry takes two
  // parts
  constexpr std::size_t kMost = 48;
  if (scratch_.size() < count * kMost) scratch_.resize(count * kMost);  // before any change
  torn = true;
  const auto move_part = [&]<std::size_t kBegin, std::size_t kWidth>(std::byte* column,
                                                                     std::size_t entry) {
    std::byte* const copy = scratch_.data();
    for_each_chunk([&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        std::memcpy(copy + k * kWidth, column + order[k] * entry + kBegin, kWidth);
    });
    for_each_chunk([&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        std::memcpy(column + k * entry + kBegin, copy + k * kWidth, kWidth);
    });
  };
  for_each_column([&](auto& column) {
    using T = typename std::decay_t<decltype(column)>::value_type;
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= 2 * kMost);
    constexpr std::size_t kFirst = std::min(sizeof(T), kMost), kRest = sizeof(T) - kFirst;
    std::byte* const bytes = reinterpret_cast<std::byte*>(column.data());
    move_part.template operator()<0, kFirst>(bytes, sizeof(T));
    if constexpr (kRest > 0) move_part.template operator()<kFirst, kRest>(bytes, sizeof(T));
  });
  for (std::size_t slot = 0; slot < count; ++slot) {
    slot_of[static_cast<std::size_t>(rank[slot])] = static_cast<std::uint32_t>(slot);
  }
  torn = false;
}

}  // namespace avo::inline sim
