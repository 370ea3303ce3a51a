// SPDX-License-Identifier: Apache-2.0
// Statistics of several values of the same quantity.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

namespace avo_io {

/// Both ends of an interval.
struct Interval {
  double low = 0.0, high = 0.0;
};

/// Returns the value below which `part` in [0, 1] of the values lie. It interpolates linearly
/// between the two neighbors of place part (n - 1), counted from 0 (Hyndman & Fan 1996, definition
/// 7). `sorted`: ascending, not empty.
double quantile(const std::vector<double>& sorted, double part);

/// Returns the mean; `values` must not be empty.
double mean_of(const std::vector<double>& values);

/// Returns t such that |T| <= t with probability 0.95, for Student's T with `freedom` >= 1 degrees
/// of freedom. Its error is at most 1e-12.
double student_95(std::int64_t freedom);

/// Returns the 95 % interval of the mean: mean ± t s / √n; none for fewer than two values.
std::optional<Interval> mean_interval(const std::vector<double>& values);

/// Returns the 95 % interval of a share. Wilson's score interval (1927) stays within [0, 1] and is
/// useful for shares of 0 and 1 too. `of` >= 1.
Interval share_interval(std::int64_t number, std::int64_t of);

}  // namespace avo_io
