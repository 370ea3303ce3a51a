// SPDX-License-Identifier: Apache-2.0
#include "core/neighbor_columns.h"

#include <algorithm>

namespace avo::inline core {

void NeighborColumns::grow(std::size_t size) {
  size = std::max(size, motion.size() + motion.size() / 2);
  for (auto* column :
       {&x, &y, &v_x, &v_y, &radius, &max_acceleration, &max_braking, &kinds, &priority}) {
    column->resize(size, 1.0);
  }
  age.resize(size), position_error.resize(size);
  loiter.resize(size), parting.resize(size), covers.resize(size);
  motion.resize(size);
}

void list(const Neighbors& neighbors, std::vector<Neighbor>& listed) {
  listed.clear();
  for (std::size_t k = 0; k < neighbors.size(); ++k) listed.push_back(neighbors[k]);
}

Neighbors in_columns(std::span<const Neighbor> neighbors, NeighborColumns& columns) {
  columns.reserve(neighbors.size());
  columns.clear();
  for (const Neighbor& neighbor : neighbors) columns.add(neighbor);
  return {&columns, 0, neighbors.size()};
}

}  // namespace avo::inline core
