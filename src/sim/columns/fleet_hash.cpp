// SPDX-License-Identifier: Apache-2.0
// The hash of all that the future of a fleet depends on.
#include <bit>
#include <cstdint>

#include "core/hash.h"
#include "sim/columns/fleet.h"

namespace avo::inline sim {
namespace {

std::uint64_t hashed(std::uint64_t hash, double value) {
  return mixed(hash, std::bit_cast<std::uint64_t>(value));
}

std::uint64_t hashed(std::uint64_t hash, Vec2 value) {
  return hashed(hashed(hash, value.x), value.y);
}

// Hashes when the robot decides again, and all data that give its place until then.
std::uint64_t hashed(std::uint64_t hash, const OwnClock& clock) {
  hash = mixed(hash, static_cast<std::uint64_t>(clock.begin));
  hash = mixed(hash, static_cast<std::uint64_t>(clock.end));
  for (const MotionState* state : {&clock.from, &clock.to})
    hash = hashed(hashed(hashed(hash, state->position), state->velocity), state->heading);
  return hashed(hash, clock.time_step);
}

}  // namespace

std::uint64_t hash_of(const Fleet& fleet, const MoverColumns& movers, std::int64_t steps) {
  std::uint64_t hash = mixed(0, static_cast<std::uint64_t>(steps));
  for (const std::uint32_t i : fleet.slot_of) {
    hash = mixed(hash, fleet.id[i].value);
    hash = hashed(hashed(hash, fleet.position[i]), fleet.velocity[i]);
    hash = hashed(hash, fleet.heading[i]);
    const Detour& detour = fleet.detour[i];
    hash = hashed(hashed(hash, detour.angle), detour.beside);
    hash = hashed(hashed(hash, detour.congestion), detour.has_arrived ? 1.0 : 0.0);
    if (fleet.has_stood[i] != 0) hash = hashed(hash, 1.0);
    if (fleet.has_clocks) hash = hashed(hash, fleet.clock_of(i));
    if (const Flight* own = fleet.flight(i)) {
      hash = hashed(hashed(hash, own->circle.center), own->circle.radius);
      hash = hashed(hash, own->has_arrived ? 1.0 : 0.0);
    }
  }
  for (std::size_t k = 0; k < movers.setup.size(); ++k) {
    hash = hashed(hashed(hash, movers.position[k]), movers.velocity[k]);
    if (!movers.setup[k].path.empty()) hash = mixed(hash, std::uint64_t{movers.next_point[k]});
  }
  return hash;
}

}  // namespace avo::inline sim
