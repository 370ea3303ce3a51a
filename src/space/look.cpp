// SPDX-License-Identifier: Apache-2.0
#include "space/look.h"

#include <algorithm>
#include <numeric>

#include "space/kernels.h"

namespace avo::space {
namespace {

void sort_by_number(const Bodies& bodies, std::vector<std::uint32_t>& places) {
  std::sort(places.begin(), places.end(),
            [&](std::uint32_t a, std::uint32_t b) { return bodies.number[a] < bodies.number[b]; });
}

std::size_t size_of(std::span<const Run> runs) {
  std::size_t size = 0;
  for (const Run& run : runs) size += run.last - run.first;
  return size;
}

}  // namespace

void SpacePairs::reserve(std::size_t pairs) {
  const std::size_t size = pairs + Bodies::kSpare;
  if (number.size() >= size) return;  // this column grows last
  for (auto* vectors : {&p, &v}) {
    for (Column& column : *vectors) column.resize(size, 1.0);
  }
  for (Column* column : {&radius, &reach, &share, &number}) column->resize(size, 1.0);
}

void look_at(const Look& look, const Bodies& bodies, std::span<const Run> runs, Looked& looked) {
  looked.near.clear();
  looked.traffic.clear();
  looked.pairs.count = 0;
  looked.pairs.reserve(size_of(runs));
  kernels().look_at(look, bodies, runs, looked);
  sort_by_number(bodies, looked.near);
  sort_by_number(bodies, looked.traffic);
}

void limit_to_nearest(std::size_t most, const Bodies& bodies, std::span<const Run> runs, Look& look,
                      Looked& looked) {
  const std::size_t size = size_of(runs) + Bodies::kSpare;
  if (looked.number.size() < size) {
    looked.distance_squared.resize(size), looked.order.resize(size);
    looked.number.resize(size);  // this column grows last
  }
  kernels().measure(look, bodies, runs, looked);
  if (looked.found <= most) return;
  if (most == 0) {
    look.farthest_squared = -1.0;
    return;
  }
  const auto begin = looked.order.begin(), end = begin + static_cast<std::ptrdiff_t>(looked.found);
  std::iota(begin, end, std::size_t{0});
  const auto last = begin + static_cast<std::ptrdiff_t>(most - 1);
  const std::vector<double>&squared = looked.distance_squared, &number = looked.number;
  std::nth_element(begin, last, end, [&](std::size_t a, std::size_t b) {
    return squared[a] != squared[b] ? squared[a] < squared[b] : number[a] < number[b];
  });
  look.farthest_squared = squared[*last], look.farthest_number = number[*last];
}

}  // namespace avo::space
