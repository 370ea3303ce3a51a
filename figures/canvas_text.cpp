// SPDX-License-Identifier: Apache-2.0
// Text with subscripts, superscripts and bold symbols: enough for the paper's notation.
#include <cmath>
#include <vector>

#include "figures/canvas_state.h"

namespace avo::figures {
namespace {

// Debian's libcairo depends on fontconfig, which depends on this font: it is always installed.
constexpr const char* kFontFamily = "DejaVu Sans";
constexpr double kScriptSize = 0.72;  // of the text's size
constexpr double kSubscriptDrop = 0.25;
constexpr double kSuperscriptRise = 0.38;
constexpr double kCapitalHeight = 0.73;  // of DejaVu Sans

enum class Script { none, subscript, superscript };

struct Piece {
  std::string text;
  Script script = Script::none;
  bool bold = false;
};

std::size_t character_length(char first) {
  const auto byte = static_cast<unsigned char>(first);
  if (byte >= 0xF0) return 4;
  if (byte >= 0xE0) return 3;
  if (byte >= 0xC0) return 2;
  return 1;
}

std::vector<Piece> parse(const std::string& markup, bool bold) {
  std::vector<Piece> pieces;
  const auto add = [&pieces, &bold](const std::string& text, Script script) {
    if (pieces.empty() || pieces.back().script != script || pieces.back().bold != bold) {
      pieces.push_back({"", script, bold});
    }
    pieces.back().text += text;
  };
  for (std::size_t i = 0; i < markup.size();) {
    const char letter = markup[i];
    if (letter == '*') {
      bold = !bold;
      ++i;
      continue;
    }
    if ((letter != '_' && letter != '^') || i + 1 >= markup.size()) {
      const std::size_t length = character_length(letter);
      add(markup.substr(i, length), Script::none);
      i += length;
      continue;
    }
    const Script script = letter == '_' ? Script::subscript : Script::superscript;
    const std::size_t close = markup[i + 1] == '{' ? markup.find('}', i) : std::string::npos;
    const std::size_t start = close == std::string::npos ? i + 1 : i + 2;
    const std::size_t length =
        close == std::string::npos ? character_length(markup[start]) : close - start;
    add(markup.substr(start, length), script);
    i = close == std::string::npos ? start + length : close + 1;
  }
  return pieces;
}

void select_font(cairo_t* cairo, const Piece& piece, double size) {
  cairo_select_font_face(cairo, kFontFamily, CAIRO_FONT_SLANT_NORMAL,
                         piece.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, piece.script == Script::none ? size : kScriptSize * size);
}

double advance(cairo_t* cairo, const Piece& piece, double size) {
  select_font(cairo, piece, size);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, piece.text.c_str(), &extents);
  return extents.x_advance;
}

// Returns whether a subscript directly after a superscript, or the reverse, stands in the same
// column.
bool stacked(const Piece& before, const Piece& piece) {
  return before.script != Script::none && piece.script != Script::none &&
         before.script != piece.script;
}

double total_width(cairo_t* cairo, const std::vector<Piece>& pieces, double size) {
  double end = 0.0;
  double start = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i == 0 || !stacked(pieces[i - 1], pieces[i])) start = end;
    end = std::fmax(end, start + advance(cairo, pieces[i], size));
  }
  return end;
}

void draw(cairo_t* cairo, const std::vector<Piece>& pieces, const TextStyle& style, Vec2 at) {
  cairo_save(cairo);
  cairo_new_path(cairo);
  cairo_translate(cairo, at.x + style.offset.x, at.y - style.offset.y);
  cairo_rotate(cairo, -style.angle);
  const double left = -style.align_x * total_width(cairo, pieces, style.size);
  const double baseline = style.align_y * kCapitalHeight * style.size;
  double end = left;
  double start = left;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    if (i == 0 || !stacked(pieces[i - 1], piece)) start = end;
    end = std::fmax(end, start + advance(cairo, piece, style.size));
    const double drop = piece.script == Script::subscript     ? kSubscriptDrop * style.size
                        : piece.script == Script::superscript ? -kSuperscriptRise * style.size
                                                              : 0.0;
    cairo_move_to(cairo, start, baseline + drop);
    cairo_text_path(cairo, piece.text.c_str());
  }
  if (style.halo) {
    cairo_set_source_rgba(cairo, 1.0, 1.0, 1.0, 0.8);
    cairo_set_line_width(cairo, 0.25 * style.size);
    cairo_set_dash(cairo, nullptr, 0, 0.0);
    cairo_stroke_preserve(cairo);
  }
  cairo_set_source_rgba(cairo, style.color.red, style.color.green, style.color.blue,
                        style.color.alpha);
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_WINDING);
  cairo_fill(cairo);
  cairo_restore(cairo);
}

}  // namespace

void Canvas::text(Vec2 at, const std::string& markup, const TextStyle& style) {
  page_text(to_page(at), markup, style);
}

void Canvas::page_text(Vec2 at, const std::string& markup, const TextStyle& style) {
  draw(state_->cairo.get(), parse(markup, style.bold), style, at);
}

void Canvas::plain_page_text(Vec2 at, const std::string& text, const TextStyle& style) {
  draw(state_->cairo.get(), {{text, Script::none, style.bold}}, style, at);
}

double Canvas::text_width(const std::string& markup, const TextStyle& style) const {
  return total_width(state_->cairo.get(), parse(markup, style.bold), style.size);
}

double Canvas::plain_text_width(const std::string& text, const TextStyle& style) const {
  return total_width(state_->cairo.get(), {{text, Script::none, style.bold}}, style.size);
}

}  // namespace avo::figures
