// SPDX-License-Identifier: Apache-2.0
// What is said of several values of the same quantity.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

namespace avo_io {

/// Both ends.
struct Interval {
  double low = 0.0, high = 0.0;
};

/// The value below which `part` in [0, 1] of the values are: between the two neighbors of place
/// part (n - 1), counted from 0, on a straight line (Hyndman & Fan 1996, definition 7).
/// `sorted`: ascending, not empty.
double quantile(const std::vector<double>& sorted, double part);

/// Not empty.
double mean_of(const std::vector<double>& values);

/// t such that |T| <= t with probability 0.95, of Student's T with so many degrees of freedom, >=
/// 1; to 1e-12 of it.
double student_95(std::int64_t freedom);

/// Of the mean, with 95 %: mean ± t s / √n; none for fewer than two values.
std::optional<Interval> mean_interval(const std::vector<double>& values);

/// Of a share, with 95 %: Wilson's score interval (1927), which stays within [0, 1] and is of use
/// for shares of 0 and 1 too. `of` >= 1.
Interval share_interval(std::int64_t number, std::int64_t of);

}  // namespace avo_io
