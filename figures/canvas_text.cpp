// SPDX-License-Identifier: Apache-2.0
// Text with subscripts, superscripts and bold symbols: enough for the paper's notation.
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
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

// A piece and where it begins, relative to the anchor of the text.
struct PlacedPiece {
  const Piece* piece;
  Vec2 at;       // pt, y down
  double width;  // pt
};

std::vector<PlacedPiece> placed(cairo_t* cairo, const std::vector<Piece>& pieces,
                                const TextStyle& style) {
  const double left = -style.align_x * total_width(cairo, pieces, style.size);
  const double baseline = style.align_y * kCapitalHeight * style.size;
  std::vector<PlacedPiece> all;
  double end = left;
  double start = left;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    if (i == 0 || !stacked(pieces[i - 1], piece)) start = end;
    const double width = advance(cairo, piece, style.size);
    end = std::fmax(end, start + width);
    const double drop = piece.script == Script::subscript     ? kSubscriptDrop * style.size
                        : piece.script == Script::superscript ? -kSuperscriptRise * style.size
                                                              : 0.0;
    all.push_back({&piece, {start, baseline + drop}, width});
  }
  return all;
}

void draw(cairo_t* cairo, const std::vector<Piece>& pieces, const TextStyle& style, Vec2 at) {
  cairo_save(cairo);
  cairo_new_path(cairo);
  cairo_translate(cairo, at.x + style.offset.x, at.y - style.offset.y);
  cairo_rotate(cairo, -style.angle);
  for (const PlacedPiece& part : placed(cairo, pieces, style)) {
    select_font(cairo, *part.piece, style.size);
    cairo_move_to(cairo, part.at.x, part.at.y);
    cairo_text_path(cairo, part.piece->text.c_str());
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

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", std::fabs(value) < 1e-9 ? 0.0 : value);
  return text.data();
}

std::string color_text(Color color) {
  const auto byte = [](double part) { return static_cast<unsigned>(std::lround(255.0 * part)); };
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(color.red), byte(color.green),
                byte(color.blue));
  return text.data();
}

// As the text of an element of XML, which may have no control characters.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '&')
      result += "&amp;";
    else if (letter == '<')
      result += "&lt;";
    else if (letter == '>')
      result += "&gt;";
    else
      result += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
  }
  return result;
}

// Text for an SVG, where Cairo itself would draw the shapes of letters, which a reader cannot
// search, copy or edit. Pieces have their places and widths by the font's own metrics, so that
// another font does not spread.
std::string svg_text(cairo_t* cairo, const std::vector<Piece>& pieces, const TextStyle& style,
                     Vec2 at) {
  std::string text = "<text xml:space=\"preserve\" transform=\"translate(" +
                     number(at.x + style.offset.x) + " " + number(at.y - style.offset.y) + ")";
  if (style.angle != 0.0)
    text += " rotate(" + number(-style.angle * 180.0 / std::numbers::pi) + ")";
  text += std::string("\" font-family=\"'") + kFontFamily + "', Verdana, sans-serif\" fill=\"" +
          color_text(style.color) + "\"";
  if (style.color.alpha < 1.0) text += " fill-opacity=\"" + number(style.color.alpha) + "\"";
  if (style.halo)
    text += " stroke=\"#fff\" stroke-opacity=\"0.8\" stroke-linejoin=\"round\" stroke-width=\"" +
            number(0.25 * style.size) + "\" paint-order=\"stroke\"";
  text += ">";
  for (const PlacedPiece& part : placed(cairo, pieces, style)) {
    const double size = part.piece->script == Script::none ? style.size : kScriptSize * style.size;
    text += "<tspan x=\"" + number(part.at.x) + "\" y=\"" + number(part.at.y) + "\" font-size=\"" +
            number(size) + "\" textLength=\"" + number(part.width) +
            "\" lengthAdjust=\"spacingAndGlyphs\"" +
            (part.piece->bold ? " font-weight=\"bold\">" : ">") + escaped(part.piece->text) +
            "</tspan>";
  }
  return text + "</text>\n";
}

void put(cairo_t* cairo, std::string* svg_texts, const std::vector<Piece>& pieces,
         const TextStyle& style, Vec2 at) {
  if (svg_texts != nullptr)
    *svg_texts += svg_text(cairo, pieces, style, at);
  else
    draw(cairo, pieces, style, at);
}

}  // namespace

void Canvas::text(Vec2 at, const std::string& markup, const TextStyle& style) {
  page_text(to_page(at), markup, style);
}

void Canvas::page_text(Vec2 at, const std::string& markup, const TextStyle& style) {
  put(state_->cairo.get(), state_->svg_texts(), parse(markup, style.bold), style, at);
}

void Canvas::plain_page_text(Vec2 at, const std::string& text, const TextStyle& style) {
  put(state_->cairo.get(), state_->svg_texts(), {{text, Script::none, style.bold}}, style, at);
}

double Canvas::text_width(const std::string& markup, const TextStyle& style) const {
  return total_width(state_->cairo.get(), parse(markup, style.bold), style.size);
}

double Canvas::plain_text_width(const std::string& text, const TextStyle& style) const {
  return total_width(state_->cairo.get(), {{text, Script::none, style.bold}}, style.size);
}

}  // namespace avo::figures
