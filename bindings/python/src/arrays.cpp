// SPDX-License-Identifier: Apache-2.0
#include "arrays.h"

#include <fmt/format.h>
#include <string_view>

namespace avo_python {

static_assert(sizeof(avo::Vec2) == 2 * sizeof(double));

namespace {

std::string text_of(const std::vector<py::ssize_t>& shape) {
  std::string text = "(";
  for (std::size_t k = 0; k < shape.size(); ++k)
    text += fmt::format("{}{}", k > 0 ? ", " : "", shape[k]);
  return text + (shape.size() == 1 ? ",)" : ")");
}

}  // namespace

std::string shape_of(const py::array& array) {
  return text_of({array.shape(), array.shape() + array.ndim()});
}

Numbers numbers(const char* name, const py::object& given) {
  constexpr std::string_view kReal = "biuf";  // the kinds of numpy
  const py::array array = py::array::ensure(given);
  if (array && kReal.find(array.dtype().kind()) != kReal.npos) return Numbers(array);
  throw avo::Error(fmt::format(
      "{}: found {}, must be real numbers", name,
      array ? "an array of " + std::string(py::str(array.dtype())) : "what is no array"));
}

py::array_t<double> target(const Out& out, const std::vector<py::ssize_t>& shape) {
  if (!out) return py::array_t<double>(shape);
  const bool same = std::vector(out->shape(), out->shape() + out->ndim()) == shape;
  if (same && py::isinstance<py::array_t<double>>(*out) && out->writeable())
    return py::reinterpret_borrow<py::array_t<double>>(*out);
  throw avo::Error(fmt::format("out: found {} of {}{}, must be {} of float64 that can be written",
                               shape_of(*out), std::string(py::str(out->dtype())),
                               out->writeable() ? "" : " that cannot be written", text_of(shape)));
}

void fill(py::array_t<double>& array, std::span<const avo::Vec2> values) {
  auto rows = array.mutable_unchecked<2>();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto row = static_cast<py::ssize_t>(k);
    rows(row, 0) = values[k].x;
    rows(row, 1) = values[k].y;
  }
}

void fill(py::array_t<double>& array, std::span<const double> values) {
  auto numbers = array.mutable_unchecked<1>();
  for (std::size_t k = 0; k < values.size(); ++k) numbers(static_cast<py::ssize_t>(k)) = values[k];
}

std::span<const avo::Vec2> rows(const char* name, const Numbers& array) {
  if (array.ndim() == 1 && array.size() == 0) return {};  // an empty list has no second dimension
  if (array.ndim() < 2 || array.shape(array.ndim() - 1) != 2)
    throw avo::Error(fmt::format("{}: found shape {}, must be (n, 2)", name, shape_of(array)));
  return {reinterpret_cast<const avo::Vec2*>(array.data()),
          static_cast<std::size_t>(array.size() / 2)};
}

PerRobot::PerRobot(const char* name, const py::object& given, std::size_t n)
    : array_(numbers(name, given)), numbers_(array_.data()), each_(array_.ndim() > 0) {
  if (each_ && static_cast<std::size_t>(array_.size()) != n)
    throw avo::Error(fmt::format("{}: found shape {}, must be one number, or {} of them", name,
                                 shape_of(array_), n));
}

}  // namespace avo_python
