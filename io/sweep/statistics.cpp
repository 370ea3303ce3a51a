// SPDX-License-Identifier: Apache-2.0
// Statistics of several values of the same quantity.
#include "io/sweep/statistics.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/elementary.h"

namespace avo_io {
namespace {

constexpr double kNormal95 = 1.959963984540054;  // |Z| <= this with probability 0.95
// From here on, t comes from its expansion; the next term of it is below 1e-15.
constexpr std::int64_t kManyDegrees = 1000;

/// Returns the probability of |T| <= t: Abramowitz & Stegun, 26.7.3 for odd degrees of freedom and
/// 26.7.4 for even degrees.
double student_within(double t, std::int64_t freedom) {
  constexpr double kPi = 3.14159265358979323846;
  const double root = std::sqrt(static_cast<double>(freedom));
  const double length = std::sqrt(t * t + static_cast<double>(freedom));
  const double sine = t / length, cosine = root / length;
  const bool odd = freedom % 2 != 0;
  double term = odd ? cosine : 1.0, sum = freedom == 1 ? 0.0 : term;
  for (std::int64_t k = odd ? 3 : 2; k <= freedom - 2; k += 2) {
    term *= cosine * cosine * static_cast<double>(k - 1) / static_cast<double>(k);
    sum += term;
  }
  return odd ? 2.0 / kPi * (avo::elementary::atan2(t, root) + sine * sum) : sine * sum;
}

}  // namespace

double quantile(const std::vector<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), sorted.size() - 1);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double rest = place - static_cast<double>(below);
  return sorted[below] + rest * (sorted[above] - sorted[below]);
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;  // of differences, so that the mean of equal values is exact
  for (const double value : values) sum += value - values.front();
  return values.front() + sum / static_cast<double>(values.size());
}

double student_95(std::int64_t freedom) {
  if (freedom >= kManyDegrees) {
    // Abramowitz & Stegun, 26.7.5
    const double z = kNormal95, v = static_cast<double>(freedom), z2 = z * z;
    return z + z * (z2 + 1.0) / (4.0 * v) + z * ((5.0 * z2 + 16.0) * z2 + 3.0) / (96.0 * v * v) +
           z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / (384.0 * v * v * v);
  }
  double low = 1.0, high = 13.0;  // t is 12.7 for one degree of freedom, and less for more
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (student_within(middle, freedom) < 0.95 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::optional<Interval> mean_interval(const std::vector<double>& values) {
  if (values.size() < 2) return std::nullopt;
  const double mean = mean_of(values), n = static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double half = student_95(std::ssize(values) - 1) * std::sqrt(squares / (n - 1.0) / n);
  return Interval{mean - half, mean + half};
}

Interval share_interval(std::int64_t number, std::int64_t of) {
  const double n = static_cast<double>(of), share = static_cast<double>(number) / n;
  const double z2 = kNormal95 * kNormal95;
  const double middle = (share + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half =
      kNormal95 / (1.0 + z2 / n) * std::sqrt(share * (1.0 - share) / n + z2 / (4.0 * n * n));
  // apart from rounding, 0 and 1 are ends of their own intervals
  return {number == 0 ? 0.0 : middle - half, number == of ? 1.0 : middle + half};
}

}  // namespace avo_io
