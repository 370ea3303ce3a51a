// SPDX-License-Identifier: Apache-2.0
// Which discs of robots overlap those of moving obstacles at the instants that are observed.
#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "spatial/point_grid.h"

namespace avo::inline metrics {

struct MoverContact {
  std::uint64_t robot = 0, obstacle = 0;  // their ids
  std::size_t row = 0;                    // of the robot, at present
};

class MoverContacts {
 public:
  /// Takes the discs of the robots; call it where the roster has changed.
  void take(const FleetView& fleet);
  /// Finds the contacts of the present instant; positions: the column of the fleet.
  void observe(const Simulation& simulation, std::span<const Vec2> positions);
  /// Present contacts that the observation before did not find, by robot and obstacle.
  [[nodiscard]] std::span<const MoverContact> begun() const { return begun_; }

 private:
  struct RowDisc {
    std::uint64_t robot = 0;
    bool parked = false;
    double radius = 0.0;      // m
    double offset = 0.0;      // m, from the robot's place to the disc's center
    bool is_covered = false;  // it has a footprint, which the disc covers at any heading
  };
  void meet(const Simulation& simulation, Vec2 position, std::size_t row, double reach);

  std::vector<RowDisc> discs_;
  PointGrid movers_;
  std::vector<std::uint32_t> near_;  // places in the grid
  std::vector<MoverContact> now_, before_, begun_;
};

}  // namespace avo::inline metrics
