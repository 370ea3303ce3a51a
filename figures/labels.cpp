// SPDX-License-Identifier: Apache-2.0
// Places labels such that they cover as little as possible.
#include "figures/labels.h"

#include <algorithm>
#include <array>
#include <limits>

namespace avo::figures {
namespace {

constexpr std::array<Vec2, 8> kSides{
    {{1, 1}, {-1, 1}, {1, -1}, {-1, -1}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
constexpr int kRings = 3;  // rings of places around a point, each farther away

double overlap(const Box& a, const Box& b) {
  const double x = std::min(a.upper.x, b.upper.x) - std::max(a.lower.x, b.lower.x);
  const double y = std::min(a.upper.y, b.upper.y) - std::max(a.lower.y, b.lower.y);
  return x > 0.0 && y > 0.0 ? x * y : 0.0;
}

}  // namespace

void Labels::keep_free(Vec2 world, double half_width) {
  const Vec2 at = canvas_.to_page(world);
  taken_.push_back(grown({at, at}, half_width));
}

Box Labels::place(Vec2 world, const std::string& markup, const TextStyle& style, double distance) {
  const Vec2 size{canvas_.text_width(markup, style), 1.1 * style.size};
  const Vec2 anchor = canvas_.to_page(world);
  Box best{};
  double least = std::numeric_limits<double>::infinity();
  for (int ring = 0; ring < kRings; ++ring) {
    const double away = distance + ring * 0.8 * style.size;
    for (const Vec2 side : kSides) {
      const Vec2 middle{anchor.x + side.x * (away + 0.5 * size.x),
                        anchor.y - side.y * (away + 0.5 * size.y)};
      const Box box{middle - 0.5 * size, middle + 0.5 * size};
      const double cost = hidden(box) + ring * 0.1 * style.size;
      if (cost < least) {
        least = cost;
        best = box;
      }
    }
  }
  TextStyle centered = style;
  centered.align_x = 0.5;
  centered.align_y = 0.5;
  canvas_.page_text(0.5 * (best.lower + best.upper), markup, centered);
  taken_.push_back(best);
  return best;
}

double Labels::hidden(const Box& box) const {
  const double area = (box.upper.x - box.lower.x) * (box.upper.y - box.lower.y);
  double sum = area - overlap(box, grown(canvas_.view_page(), -1.0));
  for (const Box& other : taken_) sum += overlap(box, other);
  return sum;
}

}  // namespace avo::figures
