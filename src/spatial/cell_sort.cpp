// SPDX-License-Identifier: Apache-2.0
#include "spatial/cell_sort.h"

#include <algorithm>

namespace avo::inline spatial {

void CellSort::resize(std::size_t table, std::size_t count) {
  begin.resize(table + 2);
  begin[0] = 0;
  order.resize(count);
}

SortedPart sort_part(std::span<const std::uint32_t> keys, std::size_t part, std::size_t parts,
                     CellSort& sort) {
  const std::size_t slots = sort.begin.size() - 1;
  const auto low = static_cast<std::uint32_t>(slots * part / parts);
  const auto high = static_cast<std::uint32_t>(slots * (part + 1) / parts);
  // begin[s + 1] counts slot s, then becomes its start, and then its end
  std::uint32_t* const next = sort.begin.data() + 1;
  std::fill(next + low, next + high, 0U);
  std::uint32_t before = 0;
  for (const std::uint32_t key : keys) {
    before += key < low ? 1 : 0;
    if (key - low < high - low) ++next[key];
  }
  SortedPart result{before, before, 0};
  for (std::uint32_t s = low; s < high; ++s) {
    const std::uint32_t count = next[s];
    result.crowding += static_cast<std::uint64_t>(count) * count;
    next[s] = before;
    before += count;
  }
  result.last = before;
  for (std::uint32_t i = 0; i < keys.size(); ++i) {
    if (keys[i] - low < high - low) sort.order[next[keys[i]]++] = i;
  }
  return result;
}

}  // namespace avo::inline spatial
