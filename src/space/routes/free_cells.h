// SPDX-License-Identifier: Apache-2.0
// Cubic cells with a free place in each: the graph that the routes of all robots of one size share
// (docs/space.md, "Routes and passages").
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "space/routes/bounds.h"
#include "space/routes/solids.h"

namespace avo::space {

/// m: what a route keeps from boxes besides the radius of the robot, where there is room.
inline constexpr double kRouteRoom = 0.05;
/// Radii: a place that is nearer to a box is not free.
inline constexpr double kLeastRoom = 1.0 + 1e-6;

/// Cells in rows along x, then y, then z.
struct CellGrid {
  Vec3 corner;        ///< m
  double side = 1.0;  ///< m
  std::array<int, 3> count = {};

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
           static_cast<std::size_t>(count[2]);
  }
  [[nodiscard]] std::uint32_t number(const std::array<int, 3>& at) const {
    return static_cast<std::uint32_t>((at[2] * count[1] + at[1]) * count[0] + at[0]);
  }
  [[nodiscard]] std::array<int, 3> at(std::uint32_t cell) const;
  /// The cell of a place, or the nearest one.
  [[nodiscard]] std::array<int, 3> of(Vec3 place) const;
  [[nodiscard]] Vec3 middle(const std::array<int, 3>& at) const;
  [[nodiscard]] bool contains(const std::array<int, 3>& at) const;
};

/// A step to one of the 26 cells around a cell.
using CellStep = std::array<int, 3>;
const std::array<CellStep, 26>& cell_steps();

class FreeCells {
 public:
  static constexpr std::uint32_t kNoPart = 0xffffffff;

  /// radius: m, of the robots. within: where routes may lead.
  FreeCells(const Solids& solids, const Bounds& within, double radius);
  /// m: slots that are wider need no care.
  static double widest_slot(double radius);

  [[nodiscard]] const CellGrid& grid() const { return grid_; }
  /// m: what routes keep from boxes where there is room.
  [[nodiscard]] double most_room() const { return most_room_; }
  /// m: what the place of the cell keeps from boxes, at most most_room(); 0: the cell is not free.
  [[nodiscard]] double room(std::uint32_t cell) const { return room_[cell]; }
  [[nodiscard]] Vec3 place(std::uint32_t cell) const { return place_[cell]; }
  /// The part of the free space that the cell belongs to: cells of one part are joined by others.
  [[nodiscard]] std::uint32_t part(std::uint32_t cell) const { return part_[cell]; }

  /// Calls visit(number) for the cells around a cell with places to which a straight line leads.
  template <typename Visit>
  void for_each_joined(std::uint32_t cell, const Visit& visit) const;
  /// Calls visit(number) for the free cells that are at most so many cells away.
  template <typename Visit>
  void for_each_around(Vec3 place, int cells, const Visit& visit) const;

 private:
  void place_all(const Solids& solids, double radius, std::vector<double>& clearance);
  void place_in_slots(const Solids& solids, double radius, std::vector<double>& clearance);
  void join_all(const Solids& solids, const std::vector<double>& clearance);
  void find_parts();

  CellGrid grid_;
  double most_room_;
  std::vector<Vec3> place_;
  std::vector<double> room_;
  std::vector<std::uint32_t> joined_;  // one bit for each step
  std::vector<std::uint32_t> part_;
  std::array<std::int64_t, 26> jump_ = {};  // from cell to cell, of each step
};

template <typename Visit>
void FreeCells::for_each_joined(std::uint32_t cell, const Visit& visit) const {
  for (std::size_t k = 0; k < jump_.size(); ++k) {
    if ((joined_[cell] >> k & 1U) != 0) visit(static_cast<std::uint32_t>(cell + jump_[k]));
  }
}

template <typename Visit>
void FreeCells::for_each_around(Vec3 place, int cells, const Visit& visit) const {
  const std::array<int, 3> middle = grid_.of(place);
  std::array<int, 3> at{};
  for (at[2] = middle[2] - cells; at[2] <= middle[2] + cells; ++at[2]) {
    for (at[1] = middle[1] - cells; at[1] <= middle[1] + cells; ++at[1]) {
      for (at[0] = middle[0] - cells; at[0] <= middle[0] + cells; ++at[0]) {
        if (grid_.contains(at) && room_[grid_.number(at)] > 0.0) visit(grid_.number(at));
      }
    }
  }
}

}  // namespace avo::space
