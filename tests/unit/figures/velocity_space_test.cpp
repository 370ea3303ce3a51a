// SPDX-License-Identifier: Apache-2.0
// The picture against the sets: white exactly where a velocity may be chosen.
#include "figures/velocity_space.h"

#include <cmath>

#include "picture.h"

namespace avo::figures {
namespace {

class VelocitySpaceFile : public FigureFile {};

constexpr double kPage = 200.0;  // pt

VelocitySpace some_space() {
  VelocitySpace space;
  space.acceleration_disc = Disc{{0.4, 0.3}, 2.0};
  space.speed_disc = Disc{{0.0, 0.0}, 1.9};
  const Pair ahead{{-3.0, -2.0}, {1.1, 0.4}, 1.0};
  const Pair behind{{2.5, -1.0}, {-0.2, 0.6}, 0.9};
  space.obstacles = {{{ahead, Response::proportional(2.0), 4.0}, {-0.3, 0.1}, ""},
                     {{behind, Response::velocity(), 2.0}, {0.2, -0.4}, ""}};
  space.half_planes = {{{{0.6, 0.8}, -1.2}, ""}};
  space.view = Box{{-2.5, -2.5}, {2.5, 2.5}};
  return space;
}

// m/s: how far inside what may be chosen, at least; negative outside.
double depth(const VelocitySpace& space, Vec2 u) {
  double least = 1e9;
  for (const auto& disc : {space.acceleration_disc, space.speed_disc}) {
    if (disc) least = std::fmin(least, disc->radius - norm(u - disc->center));
  }
  for (const LabeledPlane& labeled : space.half_planes) {
    least = std::fmin(least, -violation(labeled.plane, u));
  }
  for (const LabeledObstacle& labeled : space.obstacles) {
    const Obstacle& obstacle = labeled.obstacle;
    const double gap =
        closest_approach(obstacle, u - labeled.offset).distance - obstacle.pair.radius;
    least = std::fmin(least, gap / obstacle.response.gain(obstacle.time_horizon));
  }
  return least;
}

TEST_F(VelocitySpaceFile, white_is_what_may_be_chosen) {
  const VelocitySpace space = some_space();
  Canvas canvas(path("a.png"), kPage, kPage);
  draw_velocity_space(canvas, {{0.0, 0.0}, {kPage, kPage}}, space, {.axes = false});
  const double pixel = 0.5 / canvas.scale();
  std::vector<Vec2> samples;
  for (double x = -2.4; x <= 2.4; x += 0.0731) {
    for (double y = -2.4; y <= 2.4; y += 0.0689) {
      const bool near_axis = std::fmin(std::fabs(x), std::fabs(y)) < 3.0 * pixel;
      if (!near_axis && std::fabs(depth(space, {x, y})) > 3.0 * pixel) samples.push_back({x, y});
    }
  }
  std::vector<Vec2> page;
  for (const Vec2 u : samples) page.push_back(canvas.to_page(u));
  write_bytes(path("a.png"), canvas.finish());

  const Picture picture = read_png(path("a.png"));
  int white = 0, gray_shades = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const int brightness = picture.brightness(page[i].x, page[i].y);
    const bool allowed = depth(space, samples[i]) > 0.0;
    EXPECT_EQ(brightness > 250, allowed)
        << samples[i].x << ", " << samples[i].y << ": " << brightness;
    ++(allowed ? white : gray_shades);
  }
  EXPECT_GT(white, 200);
  EXPECT_GT(gray_shades, 1000);
}

TEST_F(VelocitySpaceFile, the_outline_lies_on_the_boundary) {
  const VelocitySpace space = some_space();
  for (const LabeledObstacle& labeled : space.obstacles) {
    const Box view{{-2.5, -2.5}, {2.5, 2.5}};
    const auto polygons = obstacle_outline(labeled, view);
    ASSERT_FALSE(polygons.empty());
    int on_boundary = 0;
    for (const auto& polygon : polygons) {
      for (const Vec2 u : polygon) {
        const bool at_edge = std::fmax(std::fabs(u.x), std::fabs(u.y)) > 2.4999;
        if (at_edge) continue;
        const double off = closest_approach(labeled.obstacle, u - labeled.offset).distance -
                           labeled.obstacle.pair.radius;
        EXPECT_NEAR(off, 0.0, 0.01);
        ++on_boundary;
      }
    }
    EXPECT_GT(on_boundary, 50);
  }
}

TEST_F(VelocitySpaceFile, an_empty_space_can_be_drawn) {
  EXPECT_TRUE(draw_velocity_space(VelocitySpace{}, "a.svg").ends_with("</svg>\n"));
  VelocitySpace space;
  space.half_planes = {{{{0.0, 1.0}, 1e6}, "far"}, {{{1.0, 0.0}, -1e6}, "far"}};
  space.points = {{{0.0, 0.0}, "rest", kBlack, true}};
  EXPECT_TRUE(draw_velocity_space(space, "b.svg", {.title = "nothing may be chosen"})
                  .ends_with("</svg>\n"));
}

}  // namespace
}  // namespace avo::figures
