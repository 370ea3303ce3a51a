// SPDX-License-Identifier: Apache-2.0
#include "space/look.h"

#include <algorithm>
#include <utility>

#include "space/kernels.h"

namespace avo::space {
namespace {

void grow(std::size_t size, std::initializer_list<std::vector<double>*> columns) {
  for (std::vector<double>* column : columns) column->resize(size, 1.0);
}

// Limits the half-spaces to those of the nearest `most` bodies that are seen.
void limit_to_nearest(std::size_t most, const Bodies& bodies, const SeenColumns& seen,
                      std::vector<std::pair<double, double>>& nearest, Viewer& look) {
  if (seen.count <= most) return;
  look.farthest_squared = -1.0;
  if (most == 0) return;
  nearest.clear();
  for (std::size_t k = 0; k < seen.count; ++k)
    nearest.emplace_back(norm_squared({seen.p[0][k], seen.p[1][k], seen.p[2][k]}),
                         bodies.number[static_cast<std::size_t>(seen.place[k])]);
  const auto last = nearest.begin() + static_cast<std::ptrdiff_t>(most - 1);
  std::nth_element(nearest.begin(), last, nearest.end());
  look.farthest_squared = last->first, look.farthest_number = last->second;
}

void put_in_order(const Bodies& bodies, Looked& looked) {
  std::sort(looked.near.begin(), looked.near.end(),
            [](const NearBody& a, const NearBody& b) { return a.number < b.number; });
  std::sort(looked.beside.begin(), looked.beside.end(),
            [&](std::uint32_t a, std::uint32_t b) { return bodies.number[a] < bodies.number[b]; });
}

}  // namespace

void SeenColumns::reserve(std::size_t bodies) {
  const std::size_t size = bodies + Bodies::kSpare;
  if (place.size() >= size) return;  // this column grows last
  grow(size, {&p[0], &p[1], &p[2], &v[0], &v[1], &v[2], &place});
}

void SpacePairs::reserve(std::size_t pairs) {
  const std::size_t size = pairs + Bodies::kSpare;
  if (number.size() >= size) return;  // this column grows last
  grow(size, {&p[0], &p[1], &p[2], &v[0], &v[1], &v[2], &radius, &reach, &share, &number});
}

void look_at(Viewer& look, const Bodies& bodies, std::span<const Run> runs,
             std::optional<int> max_neighbors, Looked& looked) {
  std::size_t most = 0;
  for (const Run& run : runs) most += run.last - run.first;
  looked.seen.reserve(most), looked.close.reserve(most);
  looked.places.resize(looked.close.place.size());
  looked.near.clear(), looked.beside.clear();
  kernels().find_seen(look, bodies, runs, looked.seen);
  if (max_neighbors)
    limit_to_nearest(static_cast<std::size_t>(*max_neighbors), bodies, looked.seen, looked.nearest,
                     look);
  kernels().examine_seen(look, bodies, looked);
  put_in_order(bodies, looked);
}

void pairs_that_cut(const Viewer& look, const Bodies& bodies, Looked& looked) {
  looked.pairs.reserve(looked.seen.count);
  kernels().find_pairs(look, nullptr, bodies, looked);
}

void pairs_without(const Viewer& look, Vec3 velocity, const Bodies& bodies, Looked& looked) {
  looked.pairs.reserve(looked.seen.count);
  kernels().find_pairs(look, &velocity, bodies, looked);
}

}  // namespace avo::space
