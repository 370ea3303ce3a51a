// SPDX-License-Identifier: Apache-2.0
#include "unit/space/shortest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "space/boxes.h"

namespace avo::space::tests {
namespace {

constexpr double kRounding = 1e-9;

Vec3 turned(Vec3 a, const Box& box) {
  const double c = std::cos(box.heading), s = std::sin(box.heading);
  return {c * a.x - s * a.y, s * a.x + c * a.y, a.z};
}

bool is_clear(std::span<const Box> boxes, Vec3 a, Vec3 b, double room) {
  return std::all_of(boxes.begin(), boxes.end(), [&](const Box& box) {
    return nearest(a, b, box).distance - box.radius >= room - kRounding;
  });
}

double part(Vec3 a, int axis) {
  return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

// Around the edge along that axis, on the sides of the other two: outside of the quarter circle,
// so that lines between neighbors touch it.
void append_edge(const Box& box, int axis, std::array<double, 2> side, double room, double spacing,
                 std::vector<Vec3>& points) {
  constexpr double kEighth = 0.39269908169872414;  // rad, π/8
  const double low = part(box.min, axis) - room, high = part(box.max, axis) + room;
  const int count = std::max(2, static_cast<int>((high - low) / spacing) + 1);
  for (const double angle : {0.0, 2.0 * kEighth, 4.0 * kEighth}) {
    const double reach = (room + box.radius) / std::cos(kEighth);
    const std::array<double, 2> off{reach * std::cos(angle), reach * std::sin(angle)};
    for (int k = 0; k <= count; ++k) {
      std::array<double, 3> p{};
      for (int i = 0, across = 0; i < 3; ++i) {
        if (i == axis) {
          p[static_cast<std::size_t>(i)] = low + (high - low) * k / count;
          continue;
        }
        const auto one = static_cast<std::size_t>(across++);
        p[static_cast<std::size_t>(i)] =
            (side[one] > 0 ? part(box.max, i) : part(box.min, i)) + side[one] * off[one];
      }
      points.push_back(turned({p[0], p[1], p[2]}, box));
    }
  }
}

}  // namespace

double distance_of(Vec3 a, const Box& box) {
  const double c = std::cos(box.heading), s = std::sin(box.heading);
  const Vec3 in{c * a.x + s * a.y, c * a.y - s * a.x, a.z};
  return norm(in - Vec3{std::clamp(in.x, box.min.x, box.max.x),
                        std::clamp(in.y, box.min.y, box.max.y),
                        std::clamp(in.z, box.min.z, box.max.z)}) -
         box.radius;
}

double shortest_length(std::span<const Box> boxes, Vec3 a, Vec3 b, double room, double spacing) {
  std::vector<Vec3> points{a, b};
  for (const Box& box : boxes) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double one : {-1.0, 1.0}) {
        for (const double two : {-1.0, 1.0})
          append_edge(box, axis, {one, two}, room, spacing, points);
      }
    }
  }
  std::erase_if(points,
                [&](Vec3 p) { return !(p == a) && !(p == b) && !is_clear(boxes, p, p, room); });
  std::vector<double> length(points.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> is_settled(points.size(), false);
  length[0] = 0.0;
  for (;;) {  // Dijkstra's algorithm, towards b
    std::size_t at = points.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double bound = length[k] + norm(points[k] - b);
      if (!is_settled[k] && bound < least) at = k, least = bound;
    }
    if (at >= points.size() || at == 1) return length[1];
    is_settled[at] = true;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double offered = length[at] + norm(points[k] - points[at]);
      if (!is_settled[k] && offered < length[k] && is_clear(boxes, points[at], points[k], room))
        length[k] = offered;
    }
  }
}

}  // namespace avo::space::tests
