// SPDX-License-Identifier: Apache-2.0
// How near a body comes to a segment over one step, and when.
//
// The points within some distance of a segment are two discs around its ends and a rectangle. The
// discs are those of two bodies. In the rectangle, the distance is that from the segment's line.
// This is a cubic in time. It is least at an end of the step, where it turns, or where it is zero.
#include "check/wall_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace avo::judge {
namespace {

// A number over the step, by its four coefficients in Bernstein form.
using Cubic = std::array<double, 4>;

Vec2 point_at(const RelativePath& path, double u) {
  const auto& c = path.control;
  return {value_at(Cubic{c[0].x, c[1].x, c[2].x, c[3].x}, u),
          value_at(Cubic{c[0].y, c[1].y, c[2].y, c[3].y}, u)};
}

RelativePath from_other_end(const WallPath& path) {
  RelativePath result = path.from_start;
  for (Vec2& point : result.control) point = point - path.segment;
  return result;
}

bool is_point(const WallPath& path) {
  return !(norm(path.segment) > 0.0);
}

// The path along the segment, from its start on, and across it.
struct Frame {
  double length;  // m
  Cubic along, across;
};

Frame frame_of(const WallPath& path) {
  Frame frame{norm(path.segment), {}, {}};
  const Vec2 direction = path.segment / frame.length;
  for (std::size_t k = 0; k < 4; ++k) {
    frame.along[k] = dot(direction, path.from_start.control[k]);
    frame.across[k] = cross(direction, path.from_start.control[k]);
  }
  return frame;
}

bool is_beside(const Frame& frame, double u) {
  const double along = value_at(frame.along, u);
  return along >= 0.0 && along <= frame.length;
}

// 0, the turning points of the cubic, 1; ascending. In between it rises or falls.
struct Turns {
  std::array<double, 4> at{};
  std::size_t count = 1;
};

// The derivative is 3 (d0 (1-u)² + 2 d1 u (1-u) + d2 u²).
Turns turns_of(const Cubic& b) {
  const double d0 = b[1] - b[0], d1 = b[2] - b[1], d2 = b[3] - b[2];
  Turns turns;
  const double discriminant = d1 * d1 - d0 * d2;
  if (discriminant > 0.0) {
    const double half = d0 - d1, leading = (d0 - d1) - (d1 - d2);
    const double sum = half + std::copysign(std::sqrt(discriminant), half);
    const double one = d0 / sum, other = leading != 0.0 ? sum / leading : 1.0;
    for (const double root : {std::min(one, other), std::max(one, other)})
      if (root > 0.0 && root < 1.0) turns.at[turns.count++] = root;
  }
  turns.at[turns.count++] = 1.0;
  return turns;
}

// Calls visit(u), ascending, where the cubic passes `level`.
template <typename Visit>
void visit_passes(const Cubic& b, double level, const Visit& visit) {
  const Turns turns = turns_of(b);
  for (std::size_t k = 0; k + 1 < turns.count; ++k) {
    double low = turns.at[k], high = turns.at[k + 1];
    const bool below = value_at(b, low) < level;
    if (below == (value_at(b, high) < level)) continue;
    for (int i = 0; i < 60; ++i) {
      const double half = 0.5 * (low + high);
      ((value_at(b, half) < level) == below ? low : high) = half;
    }
    visit(high);
  }
}

// The first fraction at which the path is in the rectangle beside the segment.
std::optional<double> first_beside(const Frame& frame, double limit) {
  std::vector<double> borders{0.0, 1.0};
  const auto add = [&borders](double u) { borders.push_back(u); };
  visit_passes(frame.across, limit, add);
  visit_passes(frame.across, -limit, add);
  visit_passes(frame.along, 0.0, add);
  visit_passes(frame.along, frame.length, add);
  std::sort(borders.begin(), borders.end());
  for (std::size_t k = 0; k + 1 < borders.size(); ++k) {
    const double between = 0.5 * (borders[k] + borders[k + 1]);
    if (is_beside(frame, between) && std::abs(value_at(frame.across, between)) < limit)
      return borders[k];
  }
  return std::nullopt;
}

double distance_from_segment(Vec2 point, const WallPath& path) {
  const double length = norm(path.segment);
  if (length > 0.0) {
    const Vec2 direction = path.segment / length;
    const double along = dot(direction, point);
    if (along >= 0.0 && along <= length) return std::abs(cross(direction, point));
  }
  return std::min(norm(point), norm(point - path.segment));
}

}  // namespace

Instant nearest_instant(const WallPath& path) {
  Instant nearest = nearest_instant(path.from_start);
  if (is_point(path)) return nearest;
  const auto consider = [&nearest](const Instant& instant) {
    if (std::tie(instant.distance, instant.fraction) < std::tie(nearest.distance, nearest.fraction))
      nearest = instant;
  };
  consider(nearest_instant(from_other_end(path)));
  const Frame frame = frame_of(path);
  const Turns turns = turns_of(frame.across);
  for (std::size_t k = 0; k < turns.count; ++k)
    if (is_beside(frame, turns.at[k]))
      consider({turns.at[k], std::abs(value_at(frame.across, turns.at[k]))});
  visit_passes(frame.across, 0.0, [&](double u) {
    if (is_beside(frame, u)) consider({u, 0.0});
  });
  return nearest;
}

double distance_at(const WallPath& path, double fraction) {
  return distance_from_segment(point_at(path.from_start, fraction), path);
}

std::optional<double> first_below(const WallPath& path, double limit) {
  std::optional<double> first = first_below(path.from_start, limit);
  if (is_point(path)) return first;
  const auto consider = [&first](const std::optional<double>& other) {
    if (other && (!first || *other < *first)) first = other;
  };
  consider(first_below(from_other_end(path), limit));
  consider(first_beside(frame_of(path), limit));
  return first;
}

double lower_bound(const WallPath& path) {
  const auto& c = path.from_start.control;
  const Vec2 center = 0.5 * (c[0] + c[3]);
  double spread = 0.0;
  for (const Vec2 point : c) spread = std::max(spread, norm_squared(point - center));
  return distance_from_segment(center, path) - std::sqrt(spread);
}

}  // namespace avo::judge
