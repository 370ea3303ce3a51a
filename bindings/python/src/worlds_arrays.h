// SPDX-License-Identifier: Apache-2.0
// Arrays of worlds for learning, of the plane and of space. AnyWorlds is Worlds or space's own.
#pragma once
#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <utility>
#include <vector>

#include "worlds.h"

namespace avo_python {

/// For each robot k rows of so many numbers, all 0.
template <class AnyWorlds>
py::array_t<float> zeros(const AnyWorlds& self, std::size_t k, std::size_t numbers) {
  constexpr std::size_t kMost = 1000;
  if (k > kMost) throw avo::Error(fmt::format("k: found {}, must be 0 to {}", k, kMost));
  py::array_t<float> array({self.worlds(), self.robots(), k, numbers});
  std::fill_n(array.mutable_data(), array.size(), 0.0F);
  return array;
}

/// Rows of so many numbers for each robot and each of its k nearest. The call find(world, robot,
/// near) lists squared distances, m^2, and numbers, nearest first. The call put(world, robot,
/// number, row) writes a row.
template <class AnyWorlds, class Find, class Put>
py::array_t<float> rows_of_nearest(const AnyWorlds& self, std::size_t k, std::size_t numbers,
                                   const Find& find, const Put& put) {
  py::array_t<float> array = zeros(self, k, numbers);
  float* out = array.mutable_data();
  const InUse use(self.used());
  const py::gil_scoped_release release;
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t e = 0; e < self.worlds(); ++e) {
    for (std::size_t i = 0; i < self.robots(); ++i, out += k * numbers) {
      near.clear();
      find(self.world(e), i, near);
      for (std::size_t n = 0; n < std::min(k, near.size()); ++n)
        put(self.world(e), i, near[n].second, out + n * numbers);
    }
  }
  return array;
}

/// Lists the obstacles within the radius, m, of a place: see rows_of_nearest().
template <class Obstacle, class Vector, class To>
void find_within(const std::vector<Obstacle>& obstacles, const Vector& place, double radius,
                 const To& displacement_to, std::vector<std::pair<double, std::size_t>>& near) {
  for (std::size_t k = 0; k < obstacles.size(); ++k) {
    const double squared = norm_squared(displacement_to(obstacles[k], place));
    if (squared <= radius * radius) near.emplace_back(squared, k);
  }
  std::sort(near.begin(), near.end());
}

/// A column of one number for each robot: double of(world, robot).
template <class AnyWorlds, class Of>
auto per_robot(Of of) {
  return [of](const AnyWorlds& self) {
    const InUse use(self.used());
    py::array_t<double> array({self.worlds(), self.robots()});
    auto rows = array.template mutable_unchecked<2>();
    for (py::ssize_t i = 0; i < rows.shape(0); ++i)
      for (py::ssize_t k = 0; k < rows.shape(1); ++k)
        rows(i, k) = of(self.world(static_cast<std::size_t>(i)), static_cast<std::size_t>(k));
    return array;
  };
}

}  // namespace avo_python
