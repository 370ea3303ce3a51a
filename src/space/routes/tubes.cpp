// SPDX-License-Identifier: Apache-2.0
#include "space/routes/tubes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace avo::space {
namespace {

constexpr double kSameAxis = 1e-9;  // the sine between axes that are one
constexpr double kTouches = 1e-9;   // m, relative to the width: of faces that meet
constexpr double kInLine = 0.25;    // of the width: tubes in line are one

/// The interval of an axis.
struct AxisRange {
  double low = 0.0, high = 0.0;

  [[nodiscard]] double length() const { return high - low; }
  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
  [[nodiscard]] bool is_finite() const { return std::isfinite(low) && std::isfinite(high); }
  [[nodiscard]] bool contains(double x) const { return low <= x && x <= high; }
};
// What both contain: one point where they are no farther apart than `rounding`, m. Thin boxes that
// are turned by a right angle are in line up to rounding.
AxisRange common(AxisRange a, AxisRange b, double rounding) {
  const AxisRange both{std::max(a.low, b.low), std::min(a.high, b.high)};
  if (both.low > both.high && both.low - both.high <= rounding)
    return {both.middle(), both.middle()};
  return both;
}

using Extents = std::array<AxisRange, 3>;  // along x, y and z of a frame

/// Boxes that share axes.
struct Aligned {
  Vec2 axis;  ///< of x, in the first quadrant
  std::vector<Extents> boxes;

  [[nodiscard]] Vec3 out(const std::array<double, 3>& a) const {
    return {axis.x * a[0] - axis.y * a[1], axis.y * a[0] + axis.x * a[1], a[2]};
  }
  [[nodiscard]] Vec3 unit(std::size_t k) const {
    std::array<double, 3> a{};
    a[k] = 1.0;
    return out(a);
  }
};

// The axis turned by right angles into the first quadrant, and the number of turns.
Vec2 turned(Vec2 axis, int& turns) {
  turns = 0;
  while (!(axis.x > kSameAxis && axis.y > -kSameAxis)) {
    axis = {axis.y, -axis.x};
    if (++turns == 4) break;
  }
  return axis;
}

Extents extents_of(const Solid& solid, int turns) {
  const Box& box = solid.box;
  const double r = box.radius;
  AxisRange x{box.min.x - r, box.max.x + r}, y{box.min.y - r, box.max.y + r};
  for (; turns > 0; --turns) {  // the frame has turned clockwise: x is what was -y
    const AxisRange before = x;
    x = {-y.high, -y.low}, y = before;
  }
  return {x, y, {box.min.z - r, box.max.z + r}};
}

bool is_level(const Solid& solid) {
  const Box& box = solid.box;
  return std::isinf(box.min.x) && std::isinf(box.max.x) && std::isinf(box.min.y) &&
         std::isinf(box.max.y);
}

// The boxes by their axes. Floors and ceilings without end have all axes.
std::vector<Aligned> by_axes(const Solids& solids) {
  std::vector<Aligned> all;
  for (std::size_t k = 0; k < solids.size(); ++k) {
    if (is_level(solids[k])) continue;
    int turns = 0;
    const Vec2 axis = turned(solids[k].axis, turns);
    auto same = std::find_if(all.begin(), all.end(), [&](const Aligned& other) {
      return std::abs(other.axis.x * axis.y - other.axis.y * axis.x) < kSameAxis;
    });
    if (same == all.end()) same = all.insert(same, {axis, {}});
    same->boxes.push_back(extents_of(solids[k], turns));
  }
  for (Aligned& aligned : all) {
    for (std::size_t k = 0; k < solids.size(); ++k) {
      if (is_level(solids[k])) aligned.boxes.push_back(extents_of(solids[k], 0));
    }
  }
  return all;
}

/// What is between two faces.
struct FacesApart {
  Extents room;  ///< along one axis from face to face, along the others what both boxes cover
};

std::vector<FacesApart> faces_apart(const Aligned& aligned, std::size_t along, double narrowest,
                                    double widest) {
  std::vector<std::size_t> order(aligned.boxes.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto low = [&](std::size_t k) { return aligned.boxes[k][along].low; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
  std::vector<FacesApart> found;
  for (const Extents& a : aligned.boxes) {
    const double face = a[along].high;
    if (!std::isfinite(face)) continue;
    auto b = std::lower_bound(order.begin(), order.end(), face + (1.0 - kTouches) * narrowest,
                              [&](std::size_t k, double x) { return low(k) < x; });
    for (; b != order.end() && low(*b) <= face + (1.0 + kTouches) * widest; ++b) {
      FacesApart between;
      for (std::size_t k = 0; k < 3; ++k)
        between.room[k] = common(a[k], aligned.boxes[*b][k], kTouches * narrowest);
      between.room[along] = {face, low(*b)};
      const bool meet = std::all_of(between.room.begin(), between.room.end(),
                                    [](AxisRange i) { return i.low <= i.high; });
      if (meet) found.push_back(between);
    }
  }
  return found;
}

// Returns whether nothing is nearer to the middle of the axis than the faces.
bool is_open(const Solids& solids, const Tube& tube) {
  const Vec3 middle = tube.begin + (0.5 * tube.length) * tube.axis;
  const double half = std::min(tube.half_1, tube.half_2);
  if (solids.away(middle, half).distance < (1.0 - 1e-6) * half) return false;
  const auto reaches = [&](Vec3 direction, double to) {
    return solids.free_length(middle, direction, 2.0 * to) >= (1.0 - 1e-6) * to;
  };
  return reaches(tube.across_1, tube.half_1) && reaches(-tube.across_1, tube.half_1) &&
         reaches(tube.across_2, tube.half_2) && reaches(-tube.across_2, tube.half_2);
}

std::optional<Tube> tube_of(const Aligned& aligned, std::size_t first, std::size_t second,
                            const Extents& a, const Extents& b) {
  const std::size_t along = 3 - first - second;
  const AxisRange width = a[first], height = b[second];
  const AxisRange length = common(a[along], b[along], kTouches * width.length());
  if (!(length.low <= length.high) || !length.is_finite()) return std::nullopt;
  if (!b[first].contains(width.middle()) || !a[second].contains(height.middle()))
    return std::nullopt;
  std::array<double, 3> begin{};
  begin[first] = width.middle(), begin[second] = height.middle(), begin[along] = length.low;
  return Tube{.begin = aligned.out(begin),
              .axis = aligned.unit(along),
              .length = length.length(),
              .across_1 = aligned.unit(first),
              .across_2 = aligned.unit(second),
              .half_1 = 0.5 * width.length(),
              .half_2 = 0.5 * height.length()};
}

// Makes one tube of two in line, where they touch.
bool join(Tube& one, const Tube& other) {
  if (!(one.axis == other.axis) || !(one.across_1 == other.across_1)) return false;
  const double width = 2.0 * std::min({one.half_1, one.half_2, other.half_1, other.half_2});
  if (std::abs(one.half_1 - other.half_1) > kInLine * width ||
      std::abs(one.half_2 - other.half_2) > kInLine * width)
    return false;
  const Vec3 off = other.begin - one.begin;
  const double along = dot(off, one.axis);
  if (norm(off - along * one.axis) > kInLine * width) return false;
  const double end = std::max(one.length, along + other.length), begin = std::min(0.0, along);
  if (end - begin > one.length + other.length + kInLine * width) return false;
  one.begin = one.begin + begin * one.axis, one.length = end - begin;
  one.half_1 = std::min(one.half_1, other.half_1), one.half_2 = std::min(one.half_2, other.half_2);
  return true;
}

void take(std::vector<Tube>& tubes, Tube tube) {
  for (std::size_t k = 0; k < tubes.size();) {
    if (!join(tube, tubes[k])) {
      ++k;
      continue;
    }
    tubes.erase(tubes.begin() + static_cast<std::ptrdiff_t>(k));
    k = 0;  // the tube is longer now
  }
  tubes.push_back(tube);
}

}  // namespace

std::vector<Slot> find_slots(const Solids& solids, double narrowest, double widest) {
  std::vector<Slot> slots;
  for (const Aligned& aligned : by_axes(solids)) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t first = (k + 1) % 3, second = (k + 2) % 3;
      for (const FacesApart& between : faces_apart(aligned, k, narrowest, widest)) {
        std::array<double, 3> middle{};
        middle[k] = between.room[k].middle();
        const AxisRange one = between.room[first], two = between.room[second];
        slots.push_back({aligned.out(middle), aligned.unit(k), aligned.unit(first),
                         aligned.unit(second), one.low, one.high, two.low, two.high});
      }
    }
  }
  return slots;
}

std::vector<Tube> find_tubes(const Solids& solids, double narrowest, double widest) {
  std::vector<Tube> tubes;
  for (const Aligned& aligned : by_axes(solids)) {
    std::array<std::vector<FacesApart>, 3> between;
    for (std::size_t k = 0; k < 3; ++k) between[k] = faces_apart(aligned, k, narrowest, widest);
    for (const auto& [first, second] : {std::pair(0U, 1U), {0U, 2U}, {1U, 2U}}) {
      for (const FacesApart& a : between[first]) {
        for (const FacesApart& b : between[second]) {
          const auto tube = tube_of(aligned, first, second, a.room, b.room);
          if (tube && is_open(solids, *tube)) take(tubes, *tube);
        }
      }
    }
  }
  return tubes;
}

}  // namespace avo::space
