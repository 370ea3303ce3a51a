// SPDX-License-Identifier: Apache-2.0
// What the robots of worlds for learning observe.
#include <algorithm>
#include <fmt/format.h>
#include <utility>
#include <vector>

#include "avo/wall.h"
#include "worlds_arrays.h"

namespace avo_python {
namespace {

/// Returns the displacement from a point to the surface of a wall; 0 from a point within it.
avo::Vec2 vector_to(const avo::Wall& wall, avo::Vec2 from) {
  const avo::Vec2 along = wall.b - wall.a;
  const double squared = norm_squared(along);
  const double part =
      squared > 0.0 ? std::clamp(dot(from - wall.a, along) / squared, 0.0, 1.0) : 0.0;
  const avo::Vec2 vector = wall.a + part * along - from;
  const double distance = norm(vector);
  return distance > wall.radius ? (1.0 - wall.radius / distance) * vector : avo::Vec2{};
}

}  // namespace

/// Returns the displacements to the k nearest walls and 1 for each; 0 for missing walls.
py::array_t<float> nearest_walls(const Worlds& self, std::size_t k) {
  const double radius = self.sensing_radius();
  return rows_of_nearest(
      self, k, 3,
      [radius](const World& world, std::size_t i, auto& near) {
        find_within(world.walls, world.robots[i].position, radius, vector_to, near);
      },
      [](const World& world, std::size_t i, std::size_t wall, float* row) {
        const avo::Vec2 vector = vector_to(world.walls[wall], world.robots[i].position);
        row[0] = static_cast<float>(vector.x), row[1] = static_cast<float>(vector.y), row[2] = 1.0F;
      });
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
  return rows_of_nearest(
      self, k, kNumbers,
      [&self](const World& world, std::size_t i, auto& near) { self.find_near(world, i, near); },
      [&self](const World& world, std::size_t i, std::size_t other, float* out) {
        const avo::Robot& a = world.robots[i];
        const avo::Neighbor b = self.neighbor(world, other);
        const avo::Vec2 p = b.position - a.position, v = b.velocity - a.velocity;
        const double kind = shares(b) ? 1.0 : -1.0;
        const double row[kNumbers] = {p.x, p.y, v.x, v.y, a.radius + b.radius, kind};
        std::transform(row, row + kNumbers, out,
                       [](double number) { return static_cast<float>(number); });
      });
}

}  // namespace avo_python
