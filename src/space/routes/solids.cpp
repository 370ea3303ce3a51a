// SPDX-License-Identifier: Apache-2.0
#include "space/routes/solids.h"

#include <array>
#include <cmath>
#include <numeric>

#include "core/elementary.h"
#include "space/boxes.h"

namespace avo::space {
namespace {

constexpr std::uint32_t kLeaf = 4;    // boxes
constexpr std::size_t kDeepest = 64;  // levels of the tree, far more than there are

Solid solid_of(const Box& box) {
  Solid solid{box, {1.0, 0.0}};
  if (box.heading != 0.0) solid.axis = elementary::direction(box.heading);
  solid.box.heading = 0.0;
  return solid;
}

// The bounds in the scene of what is between two corners of the frame.
Bounds bounds_of(const Solid& solid) {
  const Box& box = solid.box;
  Bounds bounds;
  const bool is_turned = solid.axis.y != 0.0;
  const bool is_far = std::isinf(box.min.x) || std::isinf(box.max.x) || std::isinf(box.min.y) ||
                      std::isinf(box.max.y);
  if (is_turned && is_far) {
    bounds = {{-Box::kFar, -Box::kFar, box.min.z}, {Box::kFar, Box::kFar, box.max.z}};
  } else if (!is_turned) {
    bounds = {box.min, box.max};
  } else {
    for (const double x : {box.min.x, box.max.x}) {
      for (const double y : {box.min.y, box.max.y}) {
        const Vec3 corner = solid.out({x, y, 0.0});
        bounds.include(Vec3{corner.x, corner.y, box.min.z});
        bounds.include(Vec3{corner.x, corner.y, box.max.z});
      }
    }
  }
  return bounds.grown(box.radius);
}

// The middle of an interval, or what is finite of it.
double middle_of(double low, double high) {
  if (std::isinf(low)) return std::isinf(high) ? 0.0 : high;
  return std::isinf(high) ? low : 0.5 * (low + high);
}
Vec3 middle_of(const Bounds& bounds) {
  return {middle_of(bounds.low.x, bounds.high.x), middle_of(bounds.low.y, bounds.high.y),
          middle_of(bounds.low.z, bounds.high.z)};
}

double part_of(Vec3 a, int axis) {
  return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

// The axis along which the middles spread most.
int widest_axis(const Bounds& middles) {
  const Vec3 size = middles.high - middles.low;
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

// m: from the surface of the box to a place inside of it, negative, and the evasive maneuver.
Away inside(Vec3 place, const Solid& solid) {
  const Box& box = solid.box;
  const std::array<double, 6> out{place.x - box.min.x, box.max.x - place.x, place.y - box.min.y,
                                  box.max.y - place.y, place.z - box.min.z, box.max.z - place.z};
  const auto nearest_side = std::min_element(out.begin(), out.end()) - out.begin();
  const double sign = nearest_side % 2 == 0 ? -1.0 : 1.0;
  Vec3 normal;
  (nearest_side < 2 ? normal.x : nearest_side < 4 ? normal.y : normal.z) = sign;
  return {-out[static_cast<std::size_t>(nearest_side)] - box.radius, solid.out(normal)};
}

Away away_from(Vec3 place, const Solid& solid) {
  const Box& box = solid.box;
  const Vec3 in = solid.in(place);
  const Vec3 nearest = least_of(most_of(in, box.min), box.max);
  const double distance = norm(in - nearest);
  if (!(distance > 0.0)) return inside(in, solid);
  return {distance - box.radius, solid.out((in - nearest) / distance)};
}

/// A line a + t d, with what divides by d: a component 0 counts as a very small one.
struct Line {
  std::array<double, 3> from, per_length;

  Line(Vec3 a, Vec3 d)
      : from{a.x, a.y, a.z}, per_length{inverse(d.x), inverse(d.y), inverse(d.z)} {}

 private:
  static double inverse(double x) { return x == 0.0 ? 1e300 : 1.0 / x; }
};

// Where the line gets between the bounds, grown by `room`, for t in [0, most]; infinite where it
// does not.
double entry_of(const Line& line, double most, const Bounds& bounds, double room) {
  const std::array<double, 3> low{bounds.low.x, bounds.low.y, bounds.low.z};
  const std::array<double, 3> high{bounds.high.x, bounds.high.y, bounds.high.z};
  double begin = 0.0, end = most;
  for (std::size_t k = 0; k < 3; ++k) {
    const double first = (low[k] - room - line.from[k]) * line.per_length[k];
    const double second = (high[k] + room - line.from[k]) * line.per_length[k];
    begin = std::max(begin, std::min(first, second));
    end = std::min(end, std::max(first, second));
  }
  return begin <= end ? begin : Bounds::kFar;
}

// m: more than bounds and places differ by rounding.
double rounding_of(Vec3 a, Vec3 b) {
  return 1e-9 * (1.0 + norm(a) + norm(b));
}

double distance_to(Vec3 place, const Bounds& bounds) {
  return norm(place - least_of(most_of(place, bounds.low), bounds.high));
}

}  // namespace

Solids::Solids(std::span<const Box> boxes) : order_(boxes.size()) {
  for (const Box& box : boxes) {
    all_.push_back(solid_of(box));
    bounds_.push_back(bounds_of(all_.back()));
  }
  std::iota(order_.begin(), order_.end(), std::uint32_t{0});
  if (!boxes.empty()) build(0, static_cast<std::uint32_t>(boxes.size()));
}

std::uint32_t Solids::build(std::uint32_t first, std::uint32_t count) {
  const std::uint32_t number = static_cast<std::uint32_t>(nodes_.size());
  Node node{.bounds = {}, .first = first, .count = count};
  Bounds middles;
  for (std::uint32_t k = first; k < first + count; ++k) {
    node.bounds.include(bounds_[order_[k]]);
    middles.include(middle_of(bounds_[order_[k]]));
  }
  nodes_.push_back(node);
  if (count <= kLeaf) return number;
  const int axis = widest_axis(middles);
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(begin, begin + static_cast<std::ptrdiff_t>(count),
            [&](std::uint32_t a, std::uint32_t b) {
              const double x = part_of(middle_of(bounds_[a]), axis);
              const double y = part_of(middle_of(bounds_[b]), axis);
              return x < y || (x == y && a < b);
            });
  build(first, count / 2);
  const std::uint32_t right = build(first + count / 2, count - count / 2);
  nodes_[number].right = right;
  return number;
}

template <typename Enters, typename Visit>
bool Solids::all_of(const Enters& enters, const Visit& visit) const {
  if (nodes_.empty()) return true;
  std::array<std::uint32_t, kDeepest> open{};
  std::size_t left = 1;
  while (left > 0) {
    const std::uint32_t number = open[--left];
    const Node& node = nodes_[number];
    if (!enters(node.bounds)) continue;
    if (node.right != 0) {
      open[left++] = node.right, open[left++] = number + 1;
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      if (enters(bounds_[order_[k]]) && !visit(order_[k])) return false;
    }
  }
  return true;
}

void Solids::find_near(Vec3 place, double distance, std::vector<std::uint32_t>& numbers) const {
  numbers.clear();
  const double most = distance + rounding_of(place, place);
  all_of([&](const Bounds& bounds) { return distance_to(place, bounds) <= most; },
         [&](std::uint32_t k) {
           numbers.push_back(k);
           return true;
         });
  std::sort(numbers.begin(), numbers.end());
}

bool Solids::are_apart(Vec3 a, Vec3 b, std::span<const Box> boxes) const {
  const Line line(a, b - a);
  const double room = rounding_of(a, b);
  return all_of(
      [&](const Bounds& bounds) { return entry_of(line, 1.0, bounds, room) <= 1.0 + 1e-9; },
      [&](std::uint32_t k) { return nearest(a, b, boxes[k]).distance > boxes[k].radius; });
}

Away Solids::away(Vec3 place, double most) const {
  Away nearest{most, {}};
  all_of(
      [&](const Bounds& bounds) {
        return distance_to(place, bounds) < nearest.distance || bounds.contain(place);
      },
      [&](std::uint32_t k) {
        const Away found = away_from(place, all_[k]);
        if (found.distance < nearest.distance) nearest = found;
        return true;
      });
  return nearest;
}

bool Solids::is_clear(Vec3 a, Vec3 b, double room) const {
  const Line line(a, b - a);
  return all_of([&](const Bounds& bounds) { return entry_of(line, 1.0, bounds, room) <= 1.0; },
                [&](std::uint32_t k) {
                  const Solid& solid = all_[k];
                  return nearest(solid.in(a), solid.in(b), solid.box).distance >
                         room + solid.box.radius;
                });
}

double Solids::free_length(Vec3 from, Vec3 direction, double most) const {
  double free = most;
  const Line line(from, direction);
  all_of([&](const Bounds& bounds) { return entry_of(line, free, bounds, 0.0) < free; },
         [&](std::uint32_t k) {
           const Solid& solid = all_[k];
           const Line own(solid.in(from), solid.in(direction));
           free = std::min(free,
                           entry_of(own, free, {solid.box.min, solid.box.max}, solid.box.radius));
           return true;
         });
  return free;
}

}  // namespace avo::space
