// SPDX-License-Identifier: Apache-2.0
// What the robots of worlds for learning observe.
#include <algorithm>
#include <fmt/format.h>
#include <utility>
#include <vector>

#include "avo/wall.h"
#include "worlds.h"

namespace avo_python {
namespace {

/// Returns the way from a point to the surface of a wall; 0 from a point within it.
avo::Vec2 way_to(const avo::Wall& wall, avo::Vec2 from) {
  const avo::Vec2 along = wall.b - wall.a;
  const double squared = norm_squared(along);
  const double part =
      squared > 0.0 ? std::clamp(dot(from - wall.a, along) / squared, 0.0, 1.0) : 0.0;
  const avo::Vec2 way = wall.a + part * along - from;
  const double distance = norm(way);
  return distance > wall.radius ? (1.0 - wall.radius / distance) * way : avo::Vec2{};
}

// For each robot k rows of so many numbers, all 0.
py::array_t<float> zeros(const Worlds& self, std::size_t k, std::size_t numbers) {
  constexpr std::size_t kMost = 1000;
  if (k > kMost) throw avo::Error(fmt::format("k: found {}, must be 0 to {}", k, kMost));
  py::array_t<float> array({self.worlds(), self.robots(), k, numbers});
  std::fill_n(array.mutable_data(), array.size(), 0.0F);
  return array;
}

}  // namespace

/// Returns the ways to the k nearest walls and 1 for each; 0 for missing walls.
py::array_t<float> nearest_walls(const Worlds& self, std::size_t k) {
  constexpr std::size_t kNumbers = 3;
  py::array_t<float> array = zeros(self, k, kNumbers);
  float* out = array.mutable_data();
  const InUse use(self.used());
  const py::gil_scoped_release release;
  std::vector<std::pair<double, std::size_t>> near;  // m^2, and numbers
  for (std::size_t e = 0; e < self.worlds(); ++e) {
    const World& world = self.world(e);
    for (std::size_t i = 0; i < self.robots(); ++i, out += k * kNumbers) {
      near.clear();
      for (std::size_t w = 0; w < world.walls.size(); ++w) {
        const double squared = norm_squared(way_to(world.walls[w], world.robots[i].position));
        if (squared <= self.sensing_radius() * self.sensing_radius()) near.emplace_back(squared, w);
      }
      std::sort(near.begin(), near.end());
      for (std::size_t n = 0; n < std::min(k, near.size()); ++n) {
        const avo::Vec2 way = way_to(world.walls[near[n].second], world.robots[i].position);
        float* const row = out + n * kNumbers;
        row[0] = static_cast<float>(way.x), row[1] = static_cast<float>(way.y), row[2] = 1.0F;
      }
    }
  }
  return array;
}

/// Returns the moving obstacles of a world: position and radius, m.
py::array_t<double> movers_of(const Worlds& self, std::size_t world) {
  if (world >= self.worlds())
    throw avo::Error(fmt::format("world: found {}, must be 0 to {}", world, self.worlds() - 1));
  const InUse use(self.used());
  const std::vector<avo::MovingObstacle>& movers = self.world(world).movers;
  py::array_t<double> array({static_cast<py::ssize_t>(movers.size()), py::ssize_t{3}});
  auto rows = array.mutable_unchecked<2>();
  for (py::ssize_t k = 0; k < rows.shape(0); ++k) {
    const avo::MovingObstacle& mover = movers[static_cast<std::size_t>(k)];
    rows(k, 0) = mover.position.x, rows(k, 1) = mover.position.y, rows(k, 2) = mover.radius;
  }
  return array;
}

/// Returns relative position and velocity, sum of radii, and 1 or -1 for each of the k nearest; 0
/// for missing neighbors.
py::array_t<float> nearest(const Worlds& self, std::size_t k) {
  constexpr std::size_t kNumbers = 6;
  py::array_t<float> array = zeros(self, k, kNumbers);
  float* out = array.mutable_data();
  const InUse use(self.used());
  const py::gil_scoped_release release;
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t e = 0; e < self.worlds(); ++e) {
    const World& world = self.world(e);
    for (std::size_t i = 0; i < self.robots(); ++i, out += k * kNumbers) {
      self.find_near(world, i, near);
      for (std::size_t n = 0; n < std::min(k, near.size()); ++n) {
        const avo::Robot& a = world.robots[i];
        const avo::Neighbor b = self.neighbor(world, near[n].second);
        const avo::Vec2 p = b.position - a.position, v = b.velocity - a.velocity;
        const double kind = b.behavior == avo::Behavior::moves_on ? -1.0 : 1.0;
        const double row[kNumbers] = {p.x, p.y, v.x, v.y, a.radius + b.radius, kind};
        std::transform(row, row + kNumbers, out + n * kNumbers,
                       [](double number) { return static_cast<float>(number); });
      }
    }
  }
  return array;
}

}  // namespace avo_python
