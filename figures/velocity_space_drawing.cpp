// SPDX-License-Identifier: Apache-2.0
// Draws sets of velocities on a page: white is allowed, and gray is forbidden.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "figures/axes.h"
#include "figures/labels.h"
#include "figures/velocity_space.h"

namespace avo::figures {
namespace {

constexpr Color kBeyond = gray(0.91);  // outside the discs
constexpr Color kForbiddenBeyond = gray(0.82);
constexpr Color kForbidden = gray(0.66);
constexpr Color kDarkInk = gray(0.2);
constexpr double kLabelSize = 9.0;  // pt

using Polygons = std::vector<std::vector<Vec2>>;

Box default_view(const VelocitySpace& space) {
  Box box{{-1e-3, -1e-3}, {1e-3, 1e-3}};  // around the origin
  if (space.speed_disc) box = enclosing(box, enclosing(*space.speed_disc));
  // if the speed limit binds first, the far rim of the other disc is irrelevant
  const double speed =
      space.speed_disc ? space.speed_disc->radius : std::numeric_limits<double>::infinity();
  if (space.acceleration_disc && space.acceleration_disc->radius < 1.5 * speed) {
    box = enclosing(box, enclosing(*space.acceleration_disc));
  }
  for (const LabeledPoint& point : space.points) box = enclosing(box, {point.at, point.at});
  const Vec2 size = box.upper - box.lower;
  return grown(box, 0.08 * std::max(size.x, size.y));
}

// Clips to the set that both discs allow.
void clip_to_discs(Canvas& canvas, const VelocitySpace& space) {
  for (const auto& disc : {space.acceleration_disc, space.speed_disc}) {
    if (!disc) continue;
    canvas.add_disc(*disc);
    canvas.clip();
  }
}

// The rectangle on the forbidden side of the line, large enough for any view.
std::array<Vec2, 4> forbidden_side(const HalfPlane& plane, const Box& view) {
  const Vec2 middle = 0.5 * (view.lower + view.upper);
  const double far = 2.0 * norm(view.upper - view.lower);
  const Vec2 foot = middle + violation(plane, middle) * plane.normal;
  const double reach = far + std::fabs(violation(plane, middle));
  const Vec2 along = reach * perpendicular(plane.normal);
  const Vec2 back = -reach * plane.normal;
  return {foot - along, foot + along, foot + along + back, foot - along + back};
}

void fill_forbidden(Canvas& canvas, const VelocitySpace& space, const Polygons& outlines,
                    Color color) {
  for (const auto& polygon : outlines) canvas.add_polygon(polygon);
  canvas.fill(color);
  for (const LabeledPlane& labeled : space.half_planes) {
    if (!labeled.forbids) continue;
    canvas.add_polygon(forbidden_side(labeled.plane, canvas.view_world()));
    canvas.fill(color);
  }
}

void draw_regions(Canvas& canvas, const VelocitySpace& space, const Polygons& outlines) {
  const bool bounded = space.acceleration_disc || space.speed_disc;
  canvas.add_page_box(canvas.view_page());
  canvas.fill(bounded ? kBeyond : kWhite);
  if (bounded) {
    for (const auto& polygon : outlines) canvas.add_polygon(polygon);
    canvas.fill(kForbiddenBeyond);
  }
  const Canvas::ClipScope scope(canvas);
  clip_to_discs(canvas, space);
  canvas.add_page_box(canvas.view_page());
  canvas.fill(kWhite);
  fill_forbidden(canvas, space, outlines, kForbidden);
}

void draw_disc_family(Canvas& canvas, const LabeledObstacle& labeled) {
  const Box view = canvas.view_world();
  const double largest = 20.0 * norm(view.upper - view.lower);
  for (int k = 1; k <= labeled.discs; ++k) {
    const double t = labeled.obstacle.time_horizon * k / labeled.discs;
    const Disc at = disc(labeled.obstacle, t);
    if (at.radius > largest) continue;
    canvas.add_disc({at.center + labeled.offset, at.radius});
    canvas.stroke({gray(0.45), 0.35});
  }
}

void draw_lines(Canvas& canvas, const VelocitySpace& space, const Polygons& outlines) {
  for (const LabeledObstacle& labeled : space.obstacles) draw_disc_family(canvas, labeled);
  for (const auto& polygon : outlines) canvas.add_polygon(polygon);
  canvas.stroke({gray(0.3), 0.7});
  for (const LabeledPlane& labeled : space.half_planes) {
    const auto side = forbidden_side(labeled.plane, canvas.view_world());
    canvas.add_polyline(std::span(side).first(2));
    if (labeled.forbids) {
      canvas.stroke({gray(labeled.binding ? 0.05 : 0.35), labeled.binding ? 1.3 : 0.7});
    } else {
      canvas.stroke({gray(0.35), 0.7, 2.0});
    }
  }
  if (space.acceleration_disc) {
    canvas.add_disc(*space.acceleration_disc);
    canvas.stroke({kDarkInk, 0.9});
  }
  if (space.speed_disc) {
    canvas.add_disc(*space.speed_disc);
    canvas.stroke({kDarkInk, 0.9, 3.5});
  }
  for (const auto& outline : space.outlines) canvas.add_polygon(outline);
  canvas.stroke({gray(0.15), 0.8, 2.5});
}

void draw_origin(Canvas& canvas) {
  const Box page = canvas.view_page();
  const Vec2 origin = canvas.to_page({});
  canvas.add_page_line({page.lower.x, origin.y}, {page.upper.x, origin.y});
  canvas.add_page_line({origin.x, page.lower.y}, {origin.x, page.upper.y});
  canvas.stroke({gray(0.45), 0.35});
}

// Returns the point where the line of a half-plane leaves the view, a little inside it.
std::optional<Vec2> line_end(const HalfPlane& plane, const Box& view, double inset) {
  const Box inner = grown(view, -inset);
  const auto side = forbidden_side(plane, view);
  const Vec2 from = side[0];
  const Vec2 along = side[1] - side[0];
  double enter = 0.0;
  double leave = 1.0;
  const auto cut = [&](double start, double step, double lower, double upper) {
    if (step == 0.0) {
      if (start < lower || start > upper) leave = -1.0;
      return;
    }
    const double a = (lower - start) / step;
    const double b = (upper - start) / step;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  };
  cut(from.x, along.x, inner.lower.x, inner.upper.x);
  cut(from.y, along.y, inner.lower.y, inner.upper.y);
  if (enter > leave) return std::nullopt;
  return from + leave * along;
}

// Returns the center of the earliest disc that is well inside the view. It is near the rim, where
// the obstacles of different neighbors lie apart.
std::optional<Vec2> label_place(const LabeledObstacle& labeled, const Box& view) {
  const Vec2 size = view.upper - view.lower;
  const Box inner = grown(view, -0.07 * std::min(size.x, size.y));
  constexpr int kTimes = 400;
  for (int k = 1; k <= kTimes; ++k) {
    const double t = labeled.obstacle.time_horizon * k / kTimes;
    const Vec2 at = disc(labeled.obstacle, t).center + labeled.offset;
    if (at.x > inner.lower.x && at.x < inner.upper.x && at.y > inner.lower.y &&
        at.y < inner.upper.y) {
      return at;
    }
  }
  return std::nullopt;
}

void draw_points(Canvas& canvas, const VelocitySpace& space) {
  Labels labels(canvas);
  for (const LabeledPoint& point : space.points) {
    labels.keep_free(point.at, 4.0);
    if (point.arrow) {
      labels.keep_free(0.5 * point.at, 3.0);
      canvas.arrow({}, point.at, {point.color, 1.1}, 7.0);
    }
  }
  for (const LabeledPoint& point : space.points) {
    if (point.arrow) continue;
    canvas.add_dot(point.at, 3.0);
    canvas.fill_and_stroke(point.color, {kWhite, 0.6});
  }
  for (const LabeledPoint& point : space.points) {
    labels.place(point.at, point.label,
                 {.size = kLabelSize + 1.0, .color = point.color, .halo = true}, 3.5);
  }
  for (const LabeledPlane& labeled : space.half_planes) {
    const auto end = line_end(labeled.plane, canvas.view_world(), 9.0 / canvas.scale());
    if (!end || labeled.label.empty()) continue;
    // beside its line, on the forbidden side
    const Vec2 beside = *end - 7.0 / canvas.scale() * labeled.plane.normal;
    labels.place(beside, labeled.label, {.size = kLabelSize - 1.0, .color = kDarkInk}, -4.0);
  }
  for (const LabeledObstacle& labeled : space.obstacles) {
    const auto at = label_place(labeled, canvas.view_world());
    if (!at || labeled.label.empty()) continue;
    labels.place(*at, labeled.label, {.size = kLabelSize, .color = kDarkInk}, -4.0);
  }
}

}  // namespace

void draw_velocity_space(Canvas& canvas, const Box& page, const VelocitySpace& space,
                         const FigureOptions& options) {
  canvas.set_view(page, space.view ? *space.view : default_view(space));
  Polygons outlines, explaining;
  for (const LabeledObstacle& labeled : space.obstacles) {
    for (auto& polygon : obstacle_outline(labeled, canvas.view_world())) {
      (labeled.forbids ? outlines : explaining).push_back(std::move(polygon));
    }
  }
  {
    const Canvas::ClipScope scope(canvas);
    canvas.clip_to_view();
    draw_regions(canvas, space, outlines);
    draw_origin(canvas);
    for (const auto& polygon : explaining) canvas.add_polygon(polygon);
    canvas.stroke({gray(0.3), 0.5, 1.5});
    draw_lines(canvas, space, outlines);
    draw_points(canvas, space);
  }
  if (options.axes) {
    const auto ticks = [](double length) {
      return std::clamp(static_cast<int>(length / 20.0), 2, kMostTicks);
    };
    draw_axes(canvas, {.x_label = "*v*_x (m/s)",
                       .y_label = "*v*_y (m/s)",
                       .most_ticks_x = ticks(page.upper.x - page.lower.x),
                       .most_ticks_y = ticks(page.upper.y - page.lower.y)});
  }
  if (!options.title.empty()) {
    canvas.plain_page_text({0.5 * (page.lower.x + page.upper.x), page.lower.y - 6.0}, options.title,
                           {.size = 9.5, .color = gray(0.1), .align_x = 0.5});
  }
}

std::string draw_velocity_space(const VelocitySpace& space, const std::string& path,
                                const FigureOptions& options) {
  const Box world = space.view ? *space.view : default_view(space);
  const double left = options.axes ? axes_left(path, world, {.most_ticks_y = kMostTicks}) : kMargin;
  const double bottom = options.axes ? kAxesBottom : kMargin;
  const double top = options.title.empty() ? kMargin : kTitleHeight;
  const Vec2 size = world.upper - world.lower;
  const double width = options.width - left - kMargin;
  const double height = width * std::clamp(size.y / size.x, 0.4, 1.3);
  Canvas canvas(path, options.width, top + height + bottom);
  draw_velocity_space(canvas, {{left, top}, {left + width, top + height}}, space, options);
  return canvas.finish();
}

}  // namespace avo::figures
