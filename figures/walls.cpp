// SPDX-License-Identifier: Apache-2.0
// Static obstacles in a figure of the workspace.
#include "figures/walls.h"

#include <array>

namespace avo::figures {
namespace {

constexpr Color kInside = gray(0.72);
constexpr Color kWall = gray(0.25);
constexpr double kThinnest = 1.0;  // pt, of a line without thickness

// Adds all points within the wall's radius: a disc at each end and a box between them.
void add_wall(Canvas& canvas, const Wall& wall) {
  canvas.add_disc({wall.a, wall.radius});
  const double length = norm(wall.b - wall.a);
  if (!(length > 0.0)) return;
  canvas.add_disc({wall.b, wall.radius});
  // in the same orientation as the discs, so that their common part is filled
  const Vec2 side = (wall.radius / length) * perpendicular(wall.b - wall.a);
  canvas.add_polygon(std::array{wall.a + side, wall.b + side, wall.b - side, wall.a - side});
}

void fill_inside(Canvas& canvas, const StaticObstacle& obstacle) {
  if (obstacle.fill == Fill::none) return;
  if (obstacle.fill == Fill::bounds) canvas.add_page_box(canvas.view_page());
  for (const Chain& chain : obstacle.chains)
    if (chain.closed) canvas.add_polygon(chain.points);
  canvas.fill(kInside, FillRule::even_odd);
}

}  // namespace

std::optional<Box> covered(std::span<const StaticObstacle> obstacles) {
  std::optional<Box> box;
  for (const Wall& wall : walls_of(obstacles)) {
    const Box part =
        enclosing(enclosing(Disc{wall.a, wall.radius}), enclosing(Disc{wall.b, wall.radius}));
    box = box ? enclosing(*box, part) : part;
  }
  return box;
}

void draw_walls(Canvas& canvas, std::span<const StaticObstacle> obstacles) {
  for (const StaticObstacle& obstacle : obstacles) fill_inside(canvas, obstacle);
  for (const Wall& wall : walls_of(obstacles)) {
    if (2.0 * wall.radius * canvas.scale() < kThinnest) {
      canvas.add_polyline(std::array{wall.a, wall.b});
      canvas.stroke({kWall, kThinnest});
    } else {
      add_wall(canvas, wall);
      canvas.fill(kWall);
    }
  }
}

}  // namespace avo::figures
