// SPDX-License-Identifier: Apache-2.0
// The assignment of robots to slots by the Hungarian method, with shortest augmenting paths
// (R. Jonker, A. Volgenant, Computing 38, 1987).
#include <algorithm>
#include <limits>
#include <string>

#include "avo/teams.h"
#include "core/ranges.h"

namespace avo {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The costs and the prices of both sides; each robot that has a slot pays what no other slot
/// undercuts.
struct Market {
  std::span<const Vec2> positions, slots;
  double longest = 0.0;  // m, of the lines from robots to slots
  std::vector<double> robot_price, slot_price;
  std::vector<std::size_t> owner;  // of each slot, a robot

  /// m. If two assignments have equal sums, the one with the shorter longest lines costs less. So
  /// robots in a row that move along the row keep their order.
  [[nodiscard]] double cost(std::size_t robot, std::size_t slot) const {
    const double length = norm(slots[slot] - positions[robot]);
    constexpr double kSlight = 1.0 / (1 << 20);
    return longest > 0.0 ? length + kSlight * length * length / longest : 0.0;
  }
};

// Gives the robot a slot; robots that lose theirs to others on the cheapest chain take the next.
void take_in(std::size_t robot, Market& market) {
  const std::size_t slots = market.slots.size();
  std::vector<double> least(slots, kInfinite);    // of the chain to each slot
  std::vector<std::size_t> before(slots, kNone);  // the slot from which the chain comes
  std::vector<bool> is_reached(slots, false);
  std::size_t at = kNone, current = robot;
  double length = 0.0;
  while (true) {
    std::size_t next = kNone;
    for (std::size_t slot = 0; slot < slots; ++slot) {
      if (is_reached[slot]) continue;
      const double through = length + market.cost(current, slot) - market.robot_price[current] -
                             market.slot_price[slot];
      if (through < least[slot]) least[slot] = through, before[slot] = at;
      if (next == kNone || least[slot] < least[next]) next = slot;
    }
    length = least[next];
    is_reached[next] = true;
    at = next;
    if (market.owner[next] == kNone) break;
    current = market.owner[next];
  }
  market.robot_price[robot] += length;
  for (std::size_t slot = 0; slot < slots; ++slot) {
    if (!is_reached[slot] || slot == at) continue;
    market.robot_price[market.owner[slot]] += length - least[slot];
    market.slot_price[slot] -= length - least[slot];
  }
  while (before[at] != kNone) {
    market.owner[at] = market.owner[before[at]];
    at = before[at];
  }
  market.owner[at] = robot;
}

}  // namespace

std::vector<std::size_t> assign_slots(std::span<const Vec2> positions,
                                      std::span<const Vec2> slots) {
  if (slots.size() < positions.size())
    refuse("slots", std::to_string(slots.size()),
           "at least " + std::to_string(positions.size()) + ", one for each robot");
  for (const Vec2 point : positions) require("positions", point, "m");
  for (const Vec2 point : slots) require("slots", point, "m");
  Market market{positions,
                slots,
                0.0,
                std::vector<double>(positions.size(), 0.0),
                std::vector<double>(slots.size(), 0.0),
                std::vector<std::size_t>(slots.size(), kNone)};
  for (const Vec2 position : positions)
    for (const Vec2 slot : slots) market.longest = std::max(market.longest, norm(slot - position));
  for (std::size_t robot = 0; robot < positions.size(); ++robot) take_in(robot, market);
  std::vector<std::size_t> chosen(positions.size());
  for (std::size_t slot = 0; slot < slots.size(); ++slot)
    if (market.owner[slot] != kNone) chosen[market.owner[slot]] = slot;
  return chosen;
}

}  // namespace avo
