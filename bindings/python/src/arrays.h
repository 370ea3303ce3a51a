// SPDX-License-Identifier: Apache-2.0
// numpy arrays in and out. What goes out is a copy, or lies in the caller's `out`.
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

/// "(3, 2)".
std::string shape_of(const py::array& array);

/// float64 of anything that numpy takes for real numbers. Throws Error on all else.
Numbers numbers(const char* name, const py::object& given);

/// `out` itself where it is given, and a float64 array of that shape that can be written; else a
/// new one. Throws Error on any other.
py::array_t<double> target(const Out& out, const std::vector<py::ssize_t>& shape);

void fill(py::array_t<double>& array, std::span<const avo::Vec2> values);
void fill(py::array_t<double>& array, std::span<const double> values);

/// Rows (n, 2), or (..., 2) with a leading shape of n in all. Throws Error where it is none. The
/// array keeps them.
std::span<const avo::Vec2> rows(const char* name, const Numbers& array);

/// One number for each of n, or the same for all. Throws Error on any other shape.
class PerRobot {
 public:
  PerRobot(const char* name, const py::object& given, std::size_t n);
  double operator[](std::size_t k) const { return numbers_[each_ ? k : 0]; }

 private:
  Numbers array_;  // keeps the numbers
  const double* numbers_;
  bool each_;
};

}  // namespace avo_python
