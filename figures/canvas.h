// SPDX-License-Identifier: Apache-2.0
// A page to draw on: one drawing code for .svg, .png and .pdf, by the file's extension.
//
// There are two coordinate systems. The page has points, with y down from the upper left corner.
// The world (m or m/s) has y up; one rectangle of the page at a time shows it. Lengths of the pen,
// of text and of marks are always in points.
#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "avo/geometry.h"
#include "avo/vec.h"

namespace avo::figures {

/// Components in [0, 1].
struct Color {
  double red = 0.0, green = 0.0, blue = 0.0, alpha = 1.0;
};

constexpr Color gray(double level) {
  return {level, level, level, 1.0};
}
inline constexpr Color kBlack{};
inline constexpr Color kWhite = gray(1.0);

/// Returns the color at fraction `part` between `from` (0) and `to` (1).
Color mix(Color from, Color to, double part);

/// Axis-parallel rectangle, lower <= upper.
struct Box {
  Vec2 lower, upper;
};
Box enclosing(const Box& a, const Box& b);
Box enclosing(const Disc& disc);
Box grown(const Box& box, double margin);

struct Stroke {
  Color color;
  double width = 1.0;  ///< pt
  double dash = 0.0;   ///< pt, 0: solid
  /// pt, drawn and left out in turn; it replaces `dash` if its first value is not 0.
  std::array<double, 4> pattern = {};
};

struct TextStyle {
  double size = 9.0;  ///< pt
  Color color{};
  double align_x = 0.0;  ///< 0: starts at the anchor, 0.5: centered, 1: ends there
  double align_y = 0.0;  ///< 0: baseline at the anchor, 0.5: middle of a capital, 1: below it
  Vec2 offset{};         ///< pt, y up, added to the anchor
  bool bold = false;
  bool halo = false;   ///< with a white rim, so that it is readable on any background
  double angle = 0.0;  ///< rad, counter-clockwise
};

enum class FillRule { nonzero, even_odd };

/// The property that the world rectangle of a page keeps if its shape does not fit.
enum class Aspect {
  equal,    ///< one unit is as long in x as in y; the visible world grows to fill the page box
  stretch,  ///< each axis has its own scale
};

/// Throws Error unless the name ends in .svg, .png or .pdf.
void check_figure_path(const std::string& path);

/// Draws into memory; the caller writes the file. The bytes depend on the drawing only (no date, no
/// random id).
class Canvas {
 public:
  /// Sizes are in pt; a PNG has two pixels per point. The extension of `path` gives the format; no
  /// file is opened. Throws Error for an unknown extension, or if Cairo cannot make the page.
  Canvas(const std::string& path, double width, double height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Returns the contents of the file; call it once, at the end. Throws Error with the file name
  /// and Cairo's reason.
  [[nodiscard]] std::string finish();

  /// Returns the present picture of a PNG: for each pixel, row by row, blue, green, red and an
  /// unused byte. The bytes are valid until something else is drawn.
  [[nodiscard]] std::string_view pixels();

  [[nodiscard]] double width() const;
  [[nodiscard]] double height() const;

  /// Shows `world` in the rectangle `page` (pt, y down).
  void set_view(const Box& page, const Box& world, Aspect aspect = Aspect::equal);
  [[nodiscard]] Box view_page() const;   ///< pt
  [[nodiscard]] Box view_world() const;  ///< the visible part; with Aspect::equal at least `world`
  [[nodiscard]] double scale() const;    ///< pt per unit of x
  [[nodiscard]] Vec2 to_page(Vec2 world) const;

  /// These add parts to the path that the next fill(), stroke() or clip() uses up. Coordinates are
  /// those of the world.
  Canvas& add_disc(const Disc& disc);
  Canvas& add_box(const Box& box);
  Canvas& add_polyline(std::span<const Vec2> points);
  Canvas& add_polygon(std::span<const Vec2> points);
  /// Adds a dot with its radius in pt; a cross has that half-width.
  Canvas& add_dot(Vec2 at, double radius);
  Canvas& add_cross(Vec2 at, double half_width);
  /// These do the same with page coordinates.
  Canvas& add_page_box(const Box& page);
  Canvas& add_page_line(Vec2 from, Vec2 to);

  void fill(Color color, FillRule rule = FillRule::nonzero);
  void stroke(const Stroke& stroke);
  void fill_and_stroke(Color color, const Stroke& stroke);

  /// Clips that are added by clip() hold during its lifetime, and end with it.
  class [[nodiscard]] ClipScope {
   public:
    explicit ClipScope(Canvas& canvas);
    ~ClipScope();
    ClipScope(const ClipScope&) = delete;
    ClipScope& operator=(const ClipScope&) = delete;

   private:
    Canvas& canvas_;
  };
  void clip(FillRule rule = FillRule::nonzero);
  void clip_to_view();

  /// Draws an arrow from `from` to `to` (world); the head length is in pt.
  void arrow(Vec2 from, Vec2 to, const Stroke& stroke, double head = 6.0);

  /// Draws text at a point of the world. `_x` or `_{xy}` is a subscript, `^` a superscript, and `*`
  /// switches bold on and off; plain_text draws every character verbatim.
  void text(Vec2 at, const std::string& markup, const TextStyle& style);
  void page_text(Vec2 at, const std::string& markup, const TextStyle& style);
  void plain_page_text(Vec2 at, const std::string& text, const TextStyle& style);
  /// Returns the width of the marked-up text in pt.
  [[nodiscard]] double text_width(const std::string& markup, const TextStyle& style) const;
  [[nodiscard]] double plain_text_width(const std::string& text, const TextStyle& style) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace avo::figures
