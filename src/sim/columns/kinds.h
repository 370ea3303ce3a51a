// SPDX-License-Identifier: Apache-2.0
// The kinds of robots in a fleet: what a new robot needs of the others depends on few of them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "sim/columns/fleet.h"

namespace avo::inline sim {

/// What robots need of each other grows with radii and top speeds. So robots that two others exceed
/// in both add nothing, if nothing else that counts differs. All of a setup counts but place,
/// velocity, goal, arrival distance and preferred speed. Top speeds of airplanes must be equal.
class Kinds {
 public:
  explicit Kinds(const Fleet& fleet);

  void add(const RobotSetup& setup);
  /// Removes a robot of that kind; there must be one. Throws nothing.
  void remove(const RobotSetup& setup);
  /// Returns whether two robots differ from this one by radii and speeds alone, and by no smaller
  /// ones: such a robot changes no examples.
  [[nodiscard]] bool exceed(const RobotSetup& setup) const;
  /// Returns whether one robot has that radius and no lower speed, and differs by nothing else.
  [[nodiscard]] bool has_faster(const RobotSetup& setup) const;
  /// The robots that fewer than two others exceed, in no order.
  [[nodiscard]] std::vector<RobotSetup> examples() const;

 private:
  struct Size {
    double max_speed = 0.0, radius = 0.0;  // m/s, m
    friend auto operator<=>(const Size&, const Size&) = default;
  };
  using Counted = std::pair<Size, std::size_t>;
  /// Robots that differ by their sizes alone.
  struct Family {
    RobotSetup setup = {};  // without sizes
    std::map<Size, std::size_t, std::greater<>> robots = {};
    // those that fewer than two robots exceed, fastest first; found when they are asked for
    mutable std::vector<Counted> front = {};
    mutable bool is_stale = false;
  };
  using Table = std::unordered_multimap<std::uint64_t, Family>;

  template <typename AnyTable>
  static auto find(AnyTable& table, std::uint64_t hash, const RobotSetup& kin);
  static const std::vector<Counted>& front_of(const Family& family);
  /// None where there is no such family.
  const std::vector<Counted>* front_of(const RobotSetup& setup) const;

  Table table_;  // by hash_of_kin()
};

}  // namespace avo::inline sim
