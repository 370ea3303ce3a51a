// SPDX-License-Identifier: Apache-2.0
// Reads and returns numpy arrays. A returned array is a copy, or the caller's `out`.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "avo/vec.h"
#include "bind.h"

namespace avo_python {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Out = std::optional<py::array>;

/// Returns e.g. "(3, 2)".
std::string shape_of(const py::array& array);

/// Returns float64 of anything that numpy accepts as real numbers. Throws Error for everything
/// else.
Numbers numbers(const char* name, const py::object& given);

/// Returns `out` itself if it is given and is a writable float64 array of that shape; without `out`
/// it returns a new array. Throws Error for any other `out`.
py::array_t<double> target(const Out& out, const std::vector<py::ssize_t>& shape);

void fill(py::array_t<double>& array, std::span<const avo::Vec2> values);
/// Returns a new array of n rows of three numbers; vector(k) is a Vec3.
template <typename Vector>
py::array_t<double> rows_of_space(std::size_t n, Vector vector) {
  py::array_t<double> array({static_cast<py::ssize_t>(n), py::ssize_t{3}});
  auto rows = array.mutable_unchecked<2>();
  for (std::size_t k = 0; k < n; ++k) {
    const avo::Vec3 own = vector(k);
    const auto row = static_cast<py::ssize_t>(k);
    rows(row, 0) = own.x, rows(row, 1) = own.y, rows(row, 2) = own.z;
  }
  return array;
}
void fill(py::array_t<double>& array, std::span<const double> values);

/// Returns rows (n, 2), or (..., 2) with a leading shape of n in all. Throws Error for other
/// shapes. The array owns the rows.
std::span<const avo::Vec2> rows(const char* name, const Numbers& array);

/// One number for each of n, or one number for all. Throws Error for any other shape.
class PerRobot {
 public:
  PerRobot(const char* name, const py::object& given, std::size_t n);
  double operator[](std::size_t k) const { return numbers_[each_ ? k : 0]; }

 private:
  Numbers array_;  // owns the numbers
  const double* numbers_;
  bool each_;
};

}  // namespace avo_python
