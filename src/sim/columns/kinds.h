// SPDX-License-Identifier: Apache-2.0
// The kinds of robots in a fleet: what a new robot needs of the others depends on little more.
#pragma once
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "sim/columns/fleet.h"

namespace avo::inline sim {

/// Robots that differ only in place, velocity, goal and arrival distance are of one kind.
class Kinds {
 public:
  explicit Kinds(const Fleet& fleet);

  void add(const RobotSetup& setup);
  /// Removes a robot of that kind; there must be one. Throws nothing.
  void remove(const RobotSetup& setup);
  /// Returns whether there are at least two robots of that kind: another one changes no examples.
  [[nodiscard]] bool has_several(const RobotSetup& setup) const;
  /// At most two robots of each kind, in no order.
  [[nodiscard]] std::vector<RobotSetup> examples() const;

 private:
  struct CountedKind {
    RobotSetup setup;
    std::size_t robots = 0;
  };
  using Table = std::unordered_multimap<std::uint64_t, CountedKind>;
  Table::iterator find(std::uint64_t hash, const RobotSetup& kind);

  Table table_;  // by hash_of_kind()
};

}  // namespace avo::inline sim
