// SPDX-License-Identifier: Apache-2.0
// Parts that several of the paper's figures share.
#include "panels.h"

#include <algorithm>

#include "figures/axes.h"

namespace avo::paper {

using figures::Box;
using figures::Canvas;
using figures::gray;

namespace {

constexpr double kTop = 20.0;   // pt, for the title of a panel
constexpr double kRight = 8.0;  // pt
constexpr double kGap = 46.0;   // pt, with the axis of the next panel

}  // namespace

double Row::panel() const {
  return (width - figures::kAxesLeft - kRight - (panels - 1) * kGap) / panels;
}
double Row::height() const {
  return kTop + panel() + figures::kAxesBottom;
}
Box Row::box(int index) const {
  const double x = figures::kAxesLeft + index * (panel() + kGap);
  return {{x, kTop}, {x + panel(), kTop + panel()}};
}

void write_title(Canvas& canvas, const Box& panel, const std::string& markup) {
  canvas.page_text({0.5 * (panel.lower.x + panel.upper.x), panel.lower.y - 6.0}, markup,
                   {.size = 8.5, .color = gray(0.1), .align_x = 0.5});
}

void draw_bodies(Canvas& canvas, const Box& panel, const Box& world,
                 const std::vector<Body>& bodies) {
  canvas.set_view(panel, world);
  {
    const Canvas::ClipScope scope(canvas);
    canvas.clip_to_view();
    for (const Body& body : bodies) {
      const figures::Color color = body.decides ? kRobotColor : gray(0.45);
      canvas.add_disc(body.disc);
      canvas.fill_and_stroke(figures::mix(figures::kWhite, color, 0.35),
                             {figures::mix(color, figures::kBlack, 0.3), 0.8});
    }
    for (const Body& body : bodies) {
      canvas.arrow(body.disc.center, body.disc.center + body.velocity, {gray(0.1), 1.0}, 5.5);
      canvas.add_dot(body.disc.center, 1.3);
      canvas.fill(gray(0.1));
      const bool below = body.velocity.y > 0.0;
      const Vec2 rim{0.0, below ? -body.disc.radius : body.disc.radius};
      canvas.text(body.disc.center + rim, body.label,
                  {.size = 8.5,
                   .color = gray(0.05),
                   .align_x = 0.5,
                   .align_y = below ? 1.0 : 0.0,
                   .offset = {0.0, below ? -3.0 : 4.0}});
    }
  }
  figures::draw_axes(
      canvas, {.x_label = "x (m)", .y_label = "y (m)", .most_ticks_x = 6, .most_ticks_y = 6});
}

}  // namespace avo::paper
