// SPDX-License-Identifier: Apache-2.0
// What the host may call. Numbers, and places in the module's memory; of a place that a call
// returns the host makes its views anew, because memory that has grown is another one.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "avo/simulation.h"

/// Under that name; in C++ with avo_ before it, because the C library has a time() of its own.
#define AVO_EXPORT(type, name) extern "C" __attribute__((export_name(#name), used)) type avo_##name

namespace {

// One simulation an instance.
std::unique_ptr<avo::Simulation> simulation;
std::vector<std::byte> bytes;  // that the host hands over or takes

}  // namespace

/// Room for `size` bytes, until the next call that hands over or takes bytes.
AVO_EXPORT(std::byte*, room)(std::size_t size) {
  bytes.resize(size);
  return bytes.data();
}

/// Goes on from what is in the room, as Simulation::save() wrote it on any machine.
AVO_EXPORT(void, restore)() {
  simulation = std::make_unique<avo::Simulation>(std::span<const std::byte>(bytes));
}

/// Saves into the room; its size.
AVO_EXPORT(std::size_t, save)() {
  bytes = simulation->save();
  return bytes.size();
}
AVO_EXPORT(const std::byte*, saved)() {
  return bytes.data();
}

AVO_EXPORT(void, step)() {
  simulation->step();
}

/// s.
AVO_EXPORT(double, time)() {
  return simulation->time();
}

AVO_EXPORT(std::uint64_t, state_hash)() {
  return simulation->state_hash();
}

AVO_EXPORT(std::size_t, robots)() {
  return simulation->fleet().position.size();
}

/// x and y (m) of each robot in turn, by ascending ids; good until the next step.
AVO_EXPORT(const avo::Vec2*, positions)() {
  return simulation->fleet().position.data();
}
