// SPDX-License-Identifier: Apache-2.0
// Converts a page to the bytes of a file: the extension selects the surface.
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cmath>
#include <cstring>
#include <png.h>
#include <utility>

#include "avo/error.h"
#include "figures/canvas_state.h"
#include "figures/palette.h"

namespace avo::figures {
namespace {

constexpr double kPixelsPerPoint = 2.0;  // of a PNG

std::string extension_of(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] == '/') return "";
  std::string extension = path.substr(dot);
  for (char& letter : extension) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return extension;
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* make_surface(const std::string& extension, double width, double height,
                              std::string* bytes) {
  if (extension == ".svg") {
    cairo_surface_t* svg = cairo_svg_surface_create_for_stream(append, bytes, width, height);
    cairo_svg_surface_set_document_unit(svg, CAIRO_SVG_UNIT_PT);
    return svg;
  }
  if (extension == ".pdf") {
    cairo_surface_t* pdf = cairo_pdf_surface_create_for_stream(append, bytes, width, height);
    // with a creation date, two equal figures would differ
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATE_DATE, "");
    return pdf;
  }
  const auto pixels = [](double points) {
    return static_cast<int>(std::lround(kPixelsPerPoint * points));
  };
  cairo_surface_t* png =
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(width), pixels(height));
  cairo_surface_set_device_scale(png, kPixelsPerPoint, kPixelsPerPoint);
  return png;
}

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw Error(path + ": cannot draw the figure: " + reason);
}

void check(const std::string& path, cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) fail(path, cairo_status_to_string(status));
}

// Returns the picture with a palette; Cairo's own writer supports true color only.
std::string png_bytes(const std::string& path, cairo_surface_t* surface) {
  const auto width = static_cast<std::size_t>(cairo_image_surface_get_width(surface));
  const auto height = static_cast<std::size_t>(cairo_image_surface_get_height(surface));
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  const unsigned char* data = cairo_image_surface_get_data(surface);
  std::vector<std::uint32_t> pixels(width * height);
  for (std::size_t row = 0; row < height; ++row) {
    std::memcpy(&pixels[row * width], data + row * stride, width * sizeof(std::uint32_t));
  }
  const IndexedImage picture = reduce_colors(pixels);
  std::vector<png_byte> colors;
  for (const std::uint32_t color : picture.palette) {
    for (const int shift : {16, 8, 0}) colors.push_back(static_cast<png_byte>(color >> shift));
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB_COLORMAP;
  image.colormap_entries = static_cast<png_uint_32>(picture.palette.size());
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.index.data(), 0,
                                colors.data()) == 0) {
    fail(path, image.message);
  }
  bytes.resize(size);
  return bytes;
}

// Renames the page of an SVG: Cairo names it by the number of surfaces that this process has made
// so far.
void name_page(std::string& svg) {
  const std::string start = "<g id=\"surface";
  const std::size_t from = svg.find(start);
  if (from == std::string::npos) return;
  const std::size_t to = svg.find('"', from + start.size());
  svg.replace(from, to - from, "<g id=\"page");
}

}  // namespace

void check_figure_path(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension != ".svg" && extension != ".png" && extension != ".pdf") {
    throw Error(path + ": found the extension '" + extension + "', allowed: .svg, .png, .pdf");
  }
  const std::size_t before = path.size() - extension.size();
  if (before == 0 || path[before - 1] == '/') {
    throw Error(path + ": found an extension without a name, must be such as figure" + extension);
  }
}

Canvas::State::State(std::string name, double page_width, double page_height)
    : path(std::move(name)), width(page_width), height(page_height) {
  check_figure_path(path);
  const std::string extension = extension_of(path);
  png = extension == ".png";
  svg = extension == ".svg";
  surface.reset(make_surface(extension, width, height, &bytes));
  check(path, cairo_surface_status(surface.get()));
  cairo.reset(cairo_create(surface.get()));
  // no hinting of outlines: the same shapes at every size, in every format
  const std::unique_ptr<cairo_font_options_t, CairoDelete> options(cairo_font_options_create());
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(cairo.get(), options.get());
  cairo_set_line_join(cairo.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_source_rgb(cairo.get(), 1.0, 1.0, 1.0);
  cairo_paint(cairo.get());
  check(path, cairo_status(cairo.get()));
}

std::string Canvas::State::finish() {
  check(path, cairo_status(cairo.get()));
  if (png) {
    cairo_surface_flush(surface.get());
    bytes = png_bytes(path, surface.get());
  } else {
    cairo_show_page(cairo.get());
    cairo_surface_finish(surface.get());
    check(path, cairo_surface_status(surface.get()));
    if (svg) name_page(bytes);
    if (svg) bytes.insert(bytes.rfind("</svg>"), texts);
  }
  return std::move(bytes);
}

// Rows of 32-bit pixels have no gaps between them.
std::string_view Canvas::State::pixels() const {
  check(path, cairo_status(cairo.get()));
  cairo_surface_flush(surface.get());
  const auto rows = static_cast<std::size_t>(cairo_image_surface_get_height(surface.get()));
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  return {reinterpret_cast<const char*>(cairo_image_surface_get_data(surface.get())),
          rows * stride};
}

void Canvas::State::set_color(Color color) const {
  cairo_set_source_rgba(cairo.get(), color.red, color.green, color.blue, color.alpha);
}

void Canvas::State::set_pen(const Stroke& stroke) const {
  set_color(stroke.color);
  cairo_set_line_width(cairo.get(), stroke.width);
  if (stroke.pattern[0] > 0.0)
    cairo_set_dash(cairo.get(), stroke.pattern.data(), static_cast<int>(stroke.pattern.size()),
                   0.0);
  else
    cairo_set_dash(cairo.get(), &stroke.dash, stroke.dash > 0.0 ? 1 : 0, 0.0);
}

}  // namespace avo::figures
