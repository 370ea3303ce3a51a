// SPDX-License-Identifier: Apache-2.0
#include "navigation/free_space.h"

#include <algorithm>

#include "walls/segment.h"

namespace avo::inline navigation {
namespace {

Segment line_of(const Wall& wall) {
  return {wall.a, wall.b};
}

// +1 where the piece crosses the ray from p to the right upwards, -1 downwards. Each piece has its
// lower end and not its upper one, so that each crossing counts exactly once.
std::int32_t crossing(Vec2 a, Vec2 b, Vec2 p) {
  const bool up = a.y <= p.y && p.y < b.y, down = b.y <= p.y && p.y < a.y;
  if (!up && !down) return 0;
  const double side = cross(b - a, p - a);  // > 0: p lies left of the piece
  if (up) return side > 0.0 ? 1 : 0;
  return side < 0.0 ? -1 : 0;
}

}  // namespace

FreeSpace::FreeSpace(std::span<const Wall> walls, double radius)
    : radius_(radius), grid_(walls, 2.0 * radius + widest_of(walls)) {
  // walls between which the disc does not fit
  const auto for_each_link = [&](std::uint32_t from, std::vector<std::uint32_t>& last_from,
                                 const auto& visit) {
    const Wall& wall = walls[from];
    grid_.all_near(wall.a, wall.b, [&](std::size_t k) {
      const auto to = static_cast<std::uint32_t>(k);
      if (to == from || last_from[to] == from + 1) return true;
      last_from[to] = from + 1;
      const NearestPoints nearest = nearest_points(line_of(wall), line_of(walls[to]));
      if (nearest.distance < 2.0 * radius + wall.radius + walls[to].radius)
        visit(Link{from, to, nearest.on_first, nearest.on_second});
      return true;
    });
  };
  std::vector<char> is_linked(walls.size(), 0);
  std::vector<std::uint32_t> tree_from(walls.size()), last_from(walls.size(), 0), open;
  for (std::uint32_t root = 0; root < walls.size(); ++root) {
    if (is_linked[root] != 0) continue;
    is_linked[root] = 1;
    tree_from[root] = root;
    open.push_back(root);
    while (!open.empty()) {
      const std::uint32_t from = open.back();
      open.pop_back();
      for_each_link(from, last_from, [&](const Link& link) {
        if (is_linked[link.to] == 0) {
          is_linked[link.to] = 1;
          tree_from[link.to] = from;
          tree_.push_back(link);
          open.push_back(link.to);
        } else if (from < link.to && tree_from[link.to] != from && tree_from[from] != link.to) {
          rings_.push_back(link);
        }
      });
    }
  }
}

bool FreeSpace::is_free(Vec2 p) const {
  return grid_.clearance(p) >= radius_;
}

std::int32_t FreeSpace::crossings(const Link& link, Vec2 p) const {
  return crossing(grid_.walls()[link.from].a, link.leaves, p) +
         crossing(link.leaves, link.meets, p) + crossing(link.meets, grid_.walls()[link.to].a, p);
}

std::vector<FreeSpace::Winding> FreeSpace::windings(Vec2 p) const {
  std::vector<std::int32_t> from_root(grid_.walls().size(), 0);
  for (const Link& link : tree_) from_root[link.to] = from_root[link.from] + crossings(link, p);
  std::vector<Winding> windings;
  for (std::uint32_t k = 0; k < rings_.size(); ++k) {
    const Link& link = rings_[k];
    const std::int32_t times = from_root[link.from] + crossings(link, p) - from_root[link.to];
    if (times != 0) windings.push_back({k, times});
  }
  return windings;
}

}  // namespace avo::inline navigation
