// SPDX-License-Identifier: Apache-2.0
// Fig. 6(b): the accelerations that a car can turn into controls.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "figures/axes.h"
#include "figures/canvas.h"
#include "figures_of_the_paper.h"
#include "panels.h"

namespace avo::paper {
namespace {

using figures::Canvas;
using figures::gray;

constexpr double kHeading = 0.5;  // [θ] rad
constexpr double kMost = 1.0;     // [a_max] m/s²

// Returns the corners of |h·a| <= along and |n·a| <= across.
std::array<Vec2, 4> rotated_box(double along, double across) {
  const Vec2 h{std::cos(kHeading), std::sin(kHeading)}, n = perpendicular(h);
  return {along * h + across * n, along * h - across * n, -along * h - across * n,
          -along * h + across * n};
}

void draw_car(Canvas& canvas, const figures::Box& panel) {
  canvas.set_view(panel, {{-1.2, -1.2}, {2.4, 2.4}});
  const Vec2 h{std::cos(kHeading), std::sin(kHeading)}, n = perpendicular(h);
  const Vec2 front = 1.2 * h;
  canvas.add_disc({0.6 * h, 1.0});
  canvas.stroke({gray(0.6), 0.7});
  const std::array<Vec2, 4> body{-0.3 * h - 0.5 * n, 1.5 * h - 0.5 * n, 1.5 * h + 0.5 * n,
                                 -0.3 * h + 0.5 * n};
  canvas.add_polygon(body);
  canvas.fill_and_stroke(gray(0.93), {gray(0.3), 0.8});
  canvas.arrow({}, front, {kRobotColor, 1.0}, 5.0);
  canvas.add_dot({}, 2.0);
  canvas.fill(gray(0.1));
  canvas.text({}, "*p*", {.size = 8.5, .align_y = 1.0, .offset = {-6.0, 8.0}});
  canvas.text(0.6 * front, "d", {.size = 8.5, .offset = {0.0, -8.0}});
}

void draw_set(Canvas& canvas, const figures::Box& panel) {
  canvas.set_view(panel, {{-1.6, -1.6}, {1.6, 1.6}});
  canvas.add_polygon(rotated_box(kMost, kMost));
  canvas.fill_and_stroke({0.80, 0.88, 0.96, 1.0}, {kRobotColor, 1.0});
  canvas.add_disc({{}, kMost});
  canvas.fill_and_stroke({0.62, 0.77, 0.92, 1.0}, {kRobotColor, 0.8});
  canvas.add_polygon(rotated_box(kMost, 0.35));
  canvas.stroke({gray(0.35), 0.7});
  canvas.arrow({}, rotated_box(kMost, 0.0)[0], {gray(0.1), 0.9}, 5.0);
  canvas.text(rotated_box(kMost, 0.0)[0], "a_{lin}", {.size = 8.5, .offset = {3.0, 3.0}});
  figures::draw_axes(canvas, {.x_label = "along x (m/s^2)", .y_label = "along y (m/s^2)"});
}

}  // namespace

Caption draw_car_accelerations(const std::string& folder) {
  const Row row{.width = 430.0};
  const std::string path = folder + "/fig-06b.png";
  Canvas canvas(path, row.width, row.height());
  draw_car(canvas, row.box(0));
  write_title(canvas, row.box(0), "(a) the car and its disc");
  draw_set(canvas, row.box(1));
  write_title(canvas, row.box(1), "(b) its accelerations");
  save(path, canvas.finish());
  return {"6(b)",
          "fig-06b.png",
          "What a car can do",
          "A car with heading 0.5 rad, and the accelerations that Eqs. (24), (25) turn into "
          "controls: the square |a_lin| <= a_max, |v^2 κ| <= a_max (`acceleration_set: exact`) "
          "and the disc D(0, a_max) inside it (`incircle`). Thin: the part of the square that is "
          "left where v^2 κ_max = 0.35 a_max. ",
          "The square is turned by the heading, and its incircle is what holonomic robots choose "
          "from.",
          "The bound κ_max on the curvature and the disc ahead of the rear axle are ours."};
}

}  // namespace avo::paper
