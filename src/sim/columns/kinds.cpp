// SPDX-License-Identifier: Apache-2.0
#include "sim/columns/kinds.h"

#include <algorithm>
#include <bit>

#include "core/hash.h"

namespace avo::inline sim {
namespace {

RobotSetup kind_of(RobotSetup setup) {
  setup.position = setup.velocity = setup.goal = {};
  setup.heading = 0.0;
  setup.arrival_distance.reset();
  return setup;
}

// Kinds that differ only in their models are few.
std::uint64_t hash_of_kind(const RobotSetup& kind) {
  std::uint64_t hash = mixed(kind.layers.bits, kind.avoids.bits);
  for (const double value : {kind.radius, kind.max_speed, kind.max_acceleration,
                             kind.preferred_speed, kind.priority, kind.time_step.value_or(0.0),
                             kind.max_braking.value_or(0.0), kind.time_horizon.value_or(0.0)})
    hash = mixed(hash, std::bit_cast<std::uint64_t>(value));
  return hash;
}

}  // namespace

Kinds::Kinds(const Fleet& fleet) {
  for (std::size_t slot = 0; slot < fleet.size(); ++slot) add(fleet.setup(slot));
}

Kinds::Table::iterator Kinds::find(std::uint64_t hash, const RobotSetup& kind) {
  const auto [first, last] = table_.equal_range(hash);
  for (auto place = first; place != last; ++place)
    if (place->second.setup == kind) return place;
  return table_.end();
}

void Kinds::add(const RobotSetup& setup) {
  const RobotSetup kind = kind_of(setup);
  const std::uint64_t hash = hash_of_kind(kind);
  auto place = find(hash, kind);
  if (place == table_.end()) place = table_.insert({hash, {kind, 0}});
  ++place->second.robots;
}

void Kinds::remove(const RobotSetup& setup) {
  const RobotSetup kind = kind_of(setup);
  const auto place = find(hash_of_kind(kind), kind);
  if (place == table_.end()) return;
  if (--place->second.robots == 0) table_.erase(place);
}

bool Kinds::has_several(const RobotSetup& setup) const {
  const RobotSetup kind = kind_of(setup);
  const auto [first, last] = table_.equal_range(hash_of_kind(kind));
  return std::any_of(first, last, [&](const auto& place) {
    return place.second.robots > 1 && place.second.setup == kind;
  });
}

std::vector<RobotSetup> Kinds::examples() const {
  std::vector<RobotSetup> setups;
  for (const auto& [hash, kind] : table_)
    setups.insert(setups.end(), kind.robots > 1 ? 2 : 1, kind.setup);
  return setups;
}

}  // namespace avo::inline sim
