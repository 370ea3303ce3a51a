// SPDX-License-Identifier: Apache-2.0
// The page: Cairo surfaces for three formats, the view transform, paths.
#include "figures/canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "figures/canvas_state.h"

namespace avo::figures {
namespace {

// Cairo keeps coordinates in 24.8 fixed point; a path with larger coordinates would wrap around.
constexpr double kLargestCoordinate = 4.0e6;

double bounded(double coordinate) {
  return std::clamp(coordinate, -kLargestCoordinate, kLargestCoordinate);
}

}  // namespace

Color mix(Color from, Color to, double part) {
  const auto between = [part](double a, double b) { return a + part * (b - a); };
  return {between(from.red, to.red), between(from.green, to.green), between(from.blue, to.blue),
          between(from.alpha, to.alpha)};
}

Box enclosing(const Box& a, const Box& b) {
  return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y)},
          {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y)}};
}

Box enclosing(const Disc& disc) {
  const Vec2 half{disc.radius, disc.radius};
  return {disc.center - half, disc.center + half};
}

Box grown(const Box& box, double margin) {
  const Vec2 by{margin, margin};
  return {box.lower - by, box.upper + by};
}

Canvas::Canvas(const std::string& path, double width, double height)
    : state_(std::make_unique<State>(path, width, height)) {
  set_view({{0.0, 0.0}, {width, height}}, {{0.0, 0.0}, {width, height}}, Aspect::stretch);
}

Canvas::~Canvas() = default;

std::string Canvas::finish() {
  return state_->finish();
}

std::string_view Canvas::pixels() {
  return state_->pixels();
}

double Canvas::width() const {
  return state_->width;
}
double Canvas::height() const {
  return state_->height;
}

void Canvas::set_view(const Box& page, const Box& world, Aspect aspect) {
  const Vec2 page_size = page.upper - page.lower;
  Vec2 world_size = world.upper - world.lower;
  world_size = {std::max(world_size.x, 1e-9), std::max(world_size.y, 1e-9)};
  const Vec2 middle = 0.5 * (world.lower + world.upper);
  Vec2 scale{page_size.x / world_size.x, page_size.y / world_size.y};
  if (aspect == Aspect::equal) scale = {std::min(scale.x, scale.y), std::min(scale.x, scale.y)};
  const Vec2 half{0.5 * page_size.x / scale.x, 0.5 * page_size.y / scale.y};
  state_->page = page;
  state_->world = {middle - half, middle + half};
  state_->scale = scale;
}

Box Canvas::view_page() const {
  return state_->page;
}
Box Canvas::view_world() const {
  return state_->world;
}
double Canvas::scale() const {
  return state_->scale.x;
}

Vec2 Canvas::to_page(Vec2 world) const {
  const State& state = *state_;
  return {bounded(state.page.lower.x + state.scale.x * (world.x - state.world.lower.x)),
          bounded(state.page.upper.y - state.scale.y * (world.y - state.world.lower.y))};
}

Canvas& Canvas::add_disc(const Disc& disc) {
  const Vec2 center = to_page(disc.center);
  cairo_new_sub_path(state_->cairo.get());
  cairo_arc(state_->cairo.get(), center.x, center.y, bounded(disc.radius * state_->scale.x), 0.0,
            2.0 * std::numbers::pi);
  cairo_close_path(state_->cairo.get());
  return *this;
}

Canvas& Canvas::add_box(const Box& box) {
  const Vec2 a = to_page(box.lower);
  const Vec2 b = to_page(box.upper);
  return add_page_box({{a.x, b.y}, {b.x, a.y}});
}

Canvas& Canvas::add_polyline(std::span<const Vec2> points) {
  cairo_new_sub_path(state_->cairo.get());
  for (const Vec2 point : points) {
    const Vec2 at = to_page(point);
    cairo_line_to(state_->cairo.get(), at.x, at.y);
  }
  return *this;
}

Canvas& Canvas::add_polygon(std::span<const Vec2> points) {
  if (points.empty()) return *this;
  add_polyline(points);
  cairo_close_path(state_->cairo.get());
  return *this;
}

Canvas& Canvas::add_dot(Vec2 at, double radius) {
  const Vec2 center = to_page(at);
  cairo_new_sub_path(state_->cairo.get());
  cairo_arc(state_->cairo.get(), center.x, center.y, radius, 0.0, 2.0 * std::numbers::pi);
  cairo_close_path(state_->cairo.get());
  return *this;
}

Canvas& Canvas::add_cross(Vec2 at, double half_width) {
  const Vec2 p = to_page(at);
  add_page_line({p.x - half_width, p.y - half_width}, {p.x + half_width, p.y + half_width});
  return add_page_line({p.x - half_width, p.y + half_width}, {p.x + half_width, p.y - half_width});
}

Canvas& Canvas::add_page_box(const Box& page) {
  cairo_rectangle(state_->cairo.get(), page.lower.x, page.lower.y, page.upper.x - page.lower.x,
                  page.upper.y - page.lower.y);
  return *this;
}

Canvas& Canvas::add_page_line(Vec2 from, Vec2 to) {
  cairo_move_to(state_->cairo.get(), from.x, from.y);
  cairo_line_to(state_->cairo.get(), to.x, to.y);
  return *this;
}

void Canvas::fill(Color color, FillRule rule) {
  cairo_t* cairo = state_->cairo.get();
  cairo_set_fill_rule(
      cairo, rule == FillRule::even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
  state_->set_color(color);
  cairo_fill(cairo);
}

void Canvas::stroke(const Stroke& stroke) {
  state_->set_pen(stroke);
  cairo_stroke(state_->cairo.get());
}

void Canvas::fill_and_stroke(Color color, const Stroke& stroke) {
  state_->set_color(color);
  cairo_set_fill_rule(state_->cairo.get(), CAIRO_FILL_RULE_WINDING);
  cairo_fill_preserve(state_->cairo.get());
  this->stroke(stroke);
}

Canvas::ClipScope::ClipScope(Canvas& canvas) : canvas_(canvas) {
  cairo_save(canvas_.state_->cairo.get());
}
Canvas::ClipScope::~ClipScope() {
  cairo_restore(canvas_.state_->cairo.get());
}

void Canvas::clip(FillRule rule) {
  cairo_t* cairo = state_->cairo.get();
  cairo_set_fill_rule(
      cairo, rule == FillRule::even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
  cairo_clip(cairo);
}

void Canvas::clip_to_view() {
  add_page_box(state_->page);
  clip();
}

void Canvas::arrow(Vec2 from, Vec2 to, const Stroke& stroke, double head) {
  const Vec2 start = to_page(from);
  const Vec2 end = to_page(to);
  const double length = norm(end - start);
  if (!(length > 0.0)) return;
  const Vec2 along = (end - start) / length;
  const double head_length = std::min(head, 0.8 * length);
  const Vec2 neck = end - head_length * along;
  const Vec2 side = 0.38 * head_length * perpendicular(along);
  add_page_line(start, neck + 0.2 * head_length * along);
  this->stroke(stroke);
  cairo_t* cairo = state_->cairo.get();
  cairo_move_to(cairo, end.x, end.y);
  for (const Vec2 corner : {neck + side, neck + 0.2 * head_length * along, neck - side}) {
    cairo_line_to(cairo, corner.x, corner.y);
  }
  cairo_close_path(cairo);
  fill(stroke.color);
}

}  // namespace avo::figures
