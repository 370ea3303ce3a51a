// SPDX-License-Identifier: Apache-2.0
#include "sim/columns/fleet_mirror.h"

#include <cstdint>
#include <span>

#include "sim/columns/fleet.h"

namespace avo::inline sim {

// Calls action(column, of) for each column; of(fleet)(slot) is a robot's entry in it.
template <typename Action>
void FleetMirror::for_each_column(Columns wanted, const Action& action) {
  const auto at = [&](Columns which, auto& column, const auto& of) {
    if (includes(wanted, which)) action(column, of);
  };
  const auto in = [](const auto Fleet::*column) {
    return [column](const Fleet& fleet) {
      return [from = (fleet.*column).data()](std::size_t slot) { return from[slot]; };
    };
  };
  at(Columns::id, id, in(&Fleet::id));
  at(Columns::position, position,
     [](const Fleet& f) { return [&f](std::size_t slot) { return f.place(slot); }; });
  at(Columns::velocity, velocity, in(&Fleet::velocity));
  at(Columns::heading, heading, in(&Fleet::heading));
  at(Columns::goal, goal, in(&Fleet::goal));
  at(Columns::setup, setup,
     [](const Fleet& f) { return [&f](std::size_t slot) { return f.setup(slot); }; });
  at(Columns::detour, detour, in(&Fleet::detour));
  at(Columns::plan, plan, in(&Fleet::plan));
  at(Columns::applied_acceleration, applied_acceleration, in(&Fleet::applied_acceleration));
}

// Shows a robot's body in place of its reference.
void FleetMirror::show_body(const Base& base, std::size_t rank, Columns wanted) {
  if (includes(wanted, Columns::position)) position[rank] = base.place();
  if (includes(wanted, Columns::velocity)) velocity[rank] = base.velocity;
  if (!includes(wanted, Columns::setup)) return;
  setup[rank].position = base.place(), setup[rank].velocity = base.velocity;
  setup[rank].radius = base.radius;
}

void FleetMirror::copy(const Fleet& fleet, Columns wanted) {
  for_each_column(wanted, [&](auto& column, const auto& of) {
    column.resize(fleet.size());
    const auto entry = of(fleet);
    auto* const to = column.data();
    const std::span<const std::uint32_t> slots = fleet.slot_of;
    for (std::size_t k = 0; k < slots.size(); ++k) to[k] = entry(slots[k]);
  });
  for (std::size_t k = 0; k < fleet.bases.all.size(); ++k) show_body(fleet.bases.all[k], k, wanted);
}

void FleetMirror::renew(const Fleet& fleet, std::size_t rank, Columns copied) {
  for_each_column(
      copied, [&](auto& column, const auto& of) { column[rank] = of(fleet)(fleet.slot_of[rank]); });
  if (!fleet.bases.are_exact()) show_body(fleet.bases.all[rank], rank, copied);
}

FleetView FleetMirror::view(Columns wanted) const {
  const auto shown = [&](Columns which, const auto& column) {
    return includes(wanted, which) ? std::span(column) : decltype(std::span(column))();
  };
  return {shown(Columns::id, id),
          shown(Columns::position, position),
          shown(Columns::velocity, velocity),
          shown(Columns::heading, heading),
          shown(Columns::goal, goal),
          shown(Columns::setup, setup),
          shown(Columns::detour, detour),
          shown(Columns::plan, plan),
          shown(Columns::applied_acceleration, applied_acceleration)};
}

}  // namespace avo::inline sim
