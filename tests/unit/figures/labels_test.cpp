// SPDX-License-Identifier: Apache-2.0
#include "figures/labels.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace avo::figures {
namespace {

bool meet(const Box& a, const Box& b) {
  return a.lower.x < b.upper.x && b.lower.x < a.upper.x && a.lower.y < b.upper.y &&
         b.lower.y < a.upper.y;
}

TEST(Labels, stand_apart_beside_their_points_and_inside_the_view) {
  Canvas canvas("labels.svg", 200.0, 200.0);  // never finished: no file
  const Box page{{20.0, 10.0}, {190.0, 180.0}};
  canvas.set_view(page, {{-1.0, -1.0}, {1.0, 1.0}});
  const std::vector<Vec2> points{{0.0, 0.0}, {0.03, 0.02}, {0.0, -0.05}, {0.98, 0.97}, {-1.0, 0.0}};
  Labels labels(canvas);
  for (const Vec2 point : points) labels.keep_free(point, 3.0);
  std::vector<Box> boxes;
  for (const Vec2 point : points) {
    boxes.push_back(labels.place(point, "*v*_A", {.size = 9.0}, 3.0));
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_GE(boxes[i].lower.x, page.lower.x);
    EXPECT_GE(boxes[i].lower.y, page.lower.y);
    EXPECT_LE(boxes[i].upper.x, page.upper.x);
    EXPECT_LE(boxes[i].upper.y, page.upper.y);
    const Vec2 own = canvas.to_page(points[i]);
    EXPECT_TRUE(meet(grown(boxes[i], 20.0), {own, own}));  // still near its point
    for (const Vec2 point : points) {
      const Vec2 at = canvas.to_page(point);
      EXPECT_FALSE(meet(boxes[i], grown({at, at}, 2.9))) << i;
    }
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(meet(boxes[i], boxes[j])) << i << ", " << j;
  }
}

TEST(Labels, a_lonely_label_stands_above_to_the_right) {
  Canvas canvas("labels.svg", 200.0, 200.0);
  canvas.set_view({{0.0, 0.0}, {200.0, 200.0}}, {{-1.0, -1.0}, {1.0, 1.0}});
  const Box box = Labels(canvas).place({0.0, 0.0}, "a", {.size = 10.0}, 4.0);
  EXPECT_EQ(box.lower.x, 104.0);
  EXPECT_EQ(box.upper.y, 96.0);
}

}  // namespace
}  // namespace avo::figures
