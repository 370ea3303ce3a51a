// SPDX-License-Identifier: Apache-2.0
#include "space/look.h"

#include <algorithm>
#include <numeric>

#include "space/kernels.h"

namespace avo::space {
namespace {

void grow(std::size_t size, std::initializer_list<std::vector<double>*> columns) {
  for (std::vector<double>* column : columns) column->resize(size, 1.0);
}

// Limits the half-spaces to those of the nearest `most` bodies that are seen.
void limit_to_nearest(std::size_t most, const Bodies& bodies, const SeenColumns& seen,
                      std::vector<std::uint32_t>& order, Look& look) {
  if (seen.count <= most) return;
  look.farthest_squared = -1.0;
  if (most == 0) return;
  order.resize(seen.count);
  std::iota(order.begin(), order.end(), 0U);
  const auto number = [&](std::uint32_t k) {
    return bodies.number[static_cast<std::size_t>(seen.place[k])];
  };
  const auto last = order.begin() + static_cast<std::ptrdiff_t>(most - 1);
  std::nth_element(order.begin(), last, order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return seen.squared[a] != seen.squared[b] ? seen.squared[a] < seen.squared[b]
                                              : number(a) < number(b);
  });
  look.farthest_squared = seen.squared[*last], look.farthest_number = number(*last);
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
  if (squared.size() >= size) return;  // this column grows last
  grow(size, {&place, &p[0], &p[1], &p[2], &v[0], &v[1], &v[2], &squared});
}

void SpacePairs::reserve(std::size_t pairs) {
  const std::size_t size = pairs + Bodies::kSpare;
  if (number.size() >= size) return;  // this column grows last
  grow(size, {&p[0], &p[1], &p[2], &v[0], &v[1], &v[2], &radius, &reach, &share, &number});
}

void look_at(Look look, const Bodies& bodies, std::span<const Run> runs,
             std::optional<int> max_neighbors, Looked& looked) {
  std::size_t most = 0;
  for (const Run& run : runs) most += run.last - run.first;
  looked.seen.reserve(most);
  looked.pairs.reserve(most);
  looked.near.clear(), looked.beside.clear();
  looked.pairs.count = 0;
  kernels().find_seen(look, bodies, runs, looked.seen);
  if (max_neighbors)
    limit_to_nearest(static_cast<std::size_t>(*max_neighbors), bodies, looked.seen, looked.places,
                     look);
  kernels().judge_seen(look, bodies, looked);
  put_in_order(bodies, looked);
}

}  // namespace avo::space
