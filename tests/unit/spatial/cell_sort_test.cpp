// SPDX-License-Identifier: Apache-2.0
// The sort by cell: stable, and the same in any number of parts.
#include "spatial/cell_sort.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace avo {
namespace {

struct Sorted {
  CellSort sort;
  std::uint64_t crowding = 0;
};

Sorted sorted_in(std::size_t parts, const std::vector<std::uint32_t>& keys, std::size_t table) {
  Sorted result;
  result.sort.resize(table, keys.size());
  std::fill(result.sort.order.begin(), result.sort.order.end(), ~0U);
  std::size_t next = keys.size();
  for (std::size_t k = parts; k-- > 0;) {  // in any order
    const SortedPart part = sort_part(keys, k, parts, result.sort);
    EXPECT_EQ(part.last, next);
    next = part.first;
    result.crowding += part.crowding;
  }
  EXPECT_EQ(next, 0u);
  return result;
}

TEST(CellSort, parts_make_the_stable_order) {
  std::mt19937 random(3);
  for (const std::size_t table : {1, 8, 64, 1024}) {
    for (const std::size_t count : {0, 1, 5, 700}) {
      std::vector<std::uint32_t> keys(count);
      for (std::uint32_t& key : keys) key = static_cast<std::uint32_t>(random() % (table + 1));
      std::vector<std::uint32_t> expected(count);
      std::iota(expected.begin(), expected.end(), 0U);
      std::stable_sort(expected.begin(), expected.end(),
                       [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
      for (const std::size_t parts : {1, 2, 3, 7, 16}) {
        const Sorted result = sorted_in(parts, keys, table);
        EXPECT_EQ(result.sort.order, expected) << parts;
        std::uint64_t crowding = 0;
        for (std::uint32_t s = 0; s <= table; ++s) {
          const auto inside = std::count(keys.begin(), keys.end(), s);
          EXPECT_EQ(result.sort.begin[s + 1] - result.sort.begin[s], inside);
          crowding += static_cast<std::uint64_t>(inside * inside);
        }
        EXPECT_EQ(result.crowding, crowding);
      }
    }
  }
}

}  // namespace
}  // namespace avo
