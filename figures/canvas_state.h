// SPDX-License-Identifier: Apache-2.0
// The state of a Canvas; only canvas.cpp, canvas_file.cpp and canvas_text.cpp see it.
#pragma once
#include <cairo.h>
#include <memory>
#include <string>

#include "figures/canvas.h"

namespace avo::figures {

struct CairoDelete {
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};

struct Canvas::State {
  State(std::string name, double page_width, double page_height);
  std::string finish();
  std::string_view pixels() const;
  void set_color(Color color) const;
  void set_pen(const Stroke& stroke) const;
  /// Returns where texts of an SVG go; null in other formats, where Cairo draws the texts.
  std::string* svg_texts() { return svg ? &texts : nullptr; }

  std::string path;      // its extension gives the format; it is never opened
  double width, height;  // pt
  bool png = false;
  bool svg = false;
  std::string texts;  // elements of an SVG, above everything else
  std::string bytes;  // the file, complete in finish(); outlives the surface that writes to it
  std::unique_ptr<cairo_surface_t, CairoDelete> surface;
  std::unique_ptr<cairo_t, CairoDelete> cairo;
  Box page, world;
  Vec2 scale;  // pt per unit of the world
};

}  // namespace avo::figures
