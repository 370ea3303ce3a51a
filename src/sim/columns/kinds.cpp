// SPDX-License-Identifier: Apache-2.0
#include "sim/columns/kinds.h"

#include <algorithm>
#include <bit>

#include "core/hash.h"
#include "fields/robot_fields.h"
#include "robots/model.h"

namespace avo::inline sim {
namespace {

// What is the same for all robots of a family. A faster airplane need not need more.
RobotSetup kin_of(RobotSetup setup) {
  copy_wants({}, setup);
  setup.position = setup.velocity = {};
  setup.heading = setup.radius = 0.0;
  if (can_rest(setup.model)) setup.max_speed = 0.0;
  return setup;
}

// Families that differ only in their models are few.
std::uint64_t hash_of_kin(const RobotSetup& kin) {
  std::uint64_t hash = mixed(kin.layers.bits, kin.avoids.bits);
  for (const double value :
       {kin.max_speed, kin.max_acceleration, kin.priority, kin.time_step.value_or(0.0),
        kin.max_braking.value_or(0.0), kin.time_horizon.value_or(0.0)})
    hash = mixed(hash, std::bit_cast<std::uint64_t>(value));
  return hash;
}

// Appends one of the sizes, which come fastest first and largest first, unless two robots exceed
// it. radii: m, of the two largest robots before.
template <typename Counted>
void append(const Counted& one, double (&radii)[2], std::vector<Counted>& front) {
  const double radius = one.first.radius;
  if (!(radius > radii[1])) return;
  front.push_back(one);
  for (std::size_t robot = 0; robot < std::min<std::size_t>(one.second, 2); ++robot) {
    radii[1] = std::min(radii[0], radius);
    radii[0] = std::max(radii[0], radius);
  }
}

// The front of robots in that order.
template <typename Robots, typename Counted>
void find_front(const Robots& robots, std::vector<Counted>& front) {
  front.clear();
  double radii[2] = {-1.0, -1.0};
  for (const auto& [size, count] : robots) append(Counted{size, count}, radii, front);
}

}  // namespace

Kinds::Kinds(const Fleet& fleet) {
  for (std::size_t slot = 0; slot < fleet.size(); ++slot) add(fleet.setup(slot));
}

template <typename AnyTable>
auto Kinds::find(AnyTable& table, std::uint64_t hash, const RobotSetup& kin) {
  const auto [first, last] = table.equal_range(hash);
  const auto place =
      std::find_if(first, last, [&](const auto& one) { return one.second.setup == kin; });
  return place != last ? place : table.end();
}

const std::vector<Kinds::Counted>& Kinds::front_of(const Family& family) {
  if (family.is_stale) find_front(family.robots, family.front);
  family.is_stale = false;
  return family.front;
}

const std::vector<Kinds::Counted>* Kinds::front_of(const RobotSetup& setup) const {
  const RobotSetup kin = kin_of(setup);
  const auto place = find(table_, hash_of_kin(kin), kin);
  return place != table_.end() ? &front_of(place->second) : nullptr;
}

void Kinds::add(const RobotSetup& setup) {
  const RobotSetup kin = kin_of(setup);
  const std::uint64_t hash = hash_of_kin(kin);
  auto place = find(table_, hash, kin);
  if (place == table_.end()) place = table_.insert({hash, {.setup = kin}});
  Family& family = place->second;
  const Size size{setup.max_speed, setup.radius};
  const std::size_t count = ++family.robots[size];
  if (family.is_stale || count > 2) return;
  // what two robots exceed stays outside of the front
  const auto faster = [](const Counted& a, const Size& b) { return a.first > b; };
  std::vector<Counted> front = family.front;
  const auto at = std::lower_bound(front.begin(), front.end(), size, faster);
  if (at != front.end() && at->first == size)
    at->second = count;
  else
    front.insert(at, {size, count});
  find_front(front, family.front);
}

void Kinds::remove(const RobotSetup& setup) {
  const RobotSetup kin = kin_of(setup);
  const auto place = find(table_, hash_of_kin(kin), kin);
  if (place == table_.end()) return;
  Family& family = place->second;
  const Size size{setup.max_speed, setup.radius};
  const auto robots = family.robots.find(size);
  if (robots == family.robots.end()) return;
  const std::size_t left = --robots->second;
  if (left == 0) family.robots.erase(robots);
  const auto is_it = [&](const Counted& one) { return one.first == size; };
  if (left < 2 && std::any_of(family.front.begin(), family.front.end(), is_it))
    family.is_stale = true;  // it may have hidden others
  if (family.robots.empty()) table_.erase(place);
}

bool Kinds::exceed(const RobotSetup& setup) const {
  const std::vector<Counted>* front = front_of(setup);
  if (front == nullptr) return false;
  std::size_t robots = 0;
  for (const auto& [size, count] : *front) {
    if (size.max_speed < setup.max_speed) break;
    if (size.radius >= setup.radius) robots += count;
  }
  return robots >= 2;
}

bool Kinds::has_faster(const RobotSetup& setup) const {
  const std::vector<Counted>* front = front_of(setup);
  return front != nullptr && std::any_of(front->begin(), front->end(), [&](const Counted& one) {
           return one.first.radius == setup.radius && one.first.max_speed >= setup.max_speed;
         });
}

std::vector<RobotSetup> Kinds::examples() const {
  std::vector<RobotSetup> setups;
  for (const auto& [hash, family] : table_) {
    for (const auto& [size, count] : front_of(family)) {
      RobotSetup one = family.setup;
      one.max_speed = one.preferred_speed = size.max_speed, one.radius = size.radius;
      setups.insert(setups.end(), count > 1 ? 2 : 1, one);
    }
  }
  return setups;
}

}  // namespace avo::inline sim
