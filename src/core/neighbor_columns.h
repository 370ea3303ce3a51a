// SPDX-License-Identifier: Apache-2.0
// What robots sense of others, in columns.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/robot.h"

namespace avo {

/// Columns have room for so many more entries than there are, which are read but do not count.
inline constexpr std::size_t kSpareNeighbors = 16;

/// Neighbors of one robot or of several; allocates only while it grows.
struct NeighborColumns {
  std::size_t count = 0;
  bool has_movers = false;                       // some do not decide
  std::vector<double> x, y, v_x, v_y;            // m, m/s
  std::vector<double> radius, max_acceleration;  // m, m/s²
  std::vector<Vec2> acceleration;                // m/s², of those that do not decide

  /// Room for so many.
  void reserve(std::size_t neighbors) {
    // the last to grow: where memory runs out, some others may have grown already
    if (acceleration.size() < neighbors + kSpareNeighbors) grow(neighbors + kSpareNeighbors);
  }
  void add(const Neighbor& of) {
    x[count] = of.position.x, y[count] = of.position.y;
    v_x[count] = of.velocity.x, v_y[count] = of.velocity.y;
    radius[count] = of.radius, max_acceleration[count] = of.max_acceleration;
    acceleration[count++] = of.acceleration;
    has_movers = has_movers || !(of.max_acceleration > 0.0);
  }
  void clear() {
    count = 0;
    has_movers = false;
  }
  Neighbor operator[](std::size_t i) const {
    const bool decides = max_acceleration[i] > 0.0;
    return {{x[i], y[i]},
            {v_x[i], v_y[i]},
            radius[i],
            max_acceleration[i],
            decides ? Vec2{} : acceleration[i]};
  }

 private:
  void grow(std::size_t size);
};

/// Those of one robot: neighbors [first, first + count) of the columns.
struct Neighbors {
  const NeighborColumns* columns = nullptr;
  std::size_t first = 0, count = 0;

  std::size_t size() const { return count; }
  Neighbor operator[](std::size_t k) const { return (*columns)[first + k]; }
};

/// What a robot senses: views of what others own.
struct Sensing {
  const Robot* robot = nullptr;
  Neighbors neighbors;
  bool trusted = false;  ///< its neighbors are known to be finite and in range
};

/// One after the other.
void list(const Neighbors& neighbors, std::vector<Neighbor>& listed);

/// The neighbors given become the columns' only ones.
Neighbors in_columns(std::span<const Neighbor> neighbors, NeighborColumns& columns);

}  // namespace avo
