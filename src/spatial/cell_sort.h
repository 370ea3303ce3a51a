// SPDX-License-Identifier: Apache-2.0
// Counting sort of points by cell: stable, and independent of the thread that sorts each part.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace avo::inline spatial {

/// Points by slot of the table, then by index; points with key `table` come last.
struct CellSort {
  std::vector<std::uint32_t> begin;  ///< points of slot s: order[begin[s]] to order[begin[s + 1]]
  std::vector<std::uint32_t> order;  ///< indices of points

  void resize(std::size_t table, std::size_t count);
};

/// The result of one part of the sort.
struct SortedPart {
  std::size_t first = 0, last = 0;  ///< places in the order
  std::uint64_t crowding = 0;       ///< sum over its slots of the square of the number of points
};

/// Sorts the points with keys in one of `parts` equal intervals of the table. Parts share nothing
/// and may be sorted at the same time: each reads all keys, and writes its own.
SortedPart sort_part(std::span<const std::uint32_t> keys, std::size_t part, std::size_t parts,
                     CellSort& sort);

}  // namespace avo::inline spatial
