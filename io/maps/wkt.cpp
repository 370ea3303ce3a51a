// SPDX-License-Identifier: Apache-2.0
// Well-known text by recursive descent; only collections nest.
#include "io/maps/wkt.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/ranges.h"
#include "io/text/words.h"

namespace avo_io {
namespace {

using avo::Chain;

constexpr int kDeepest = 16;  // depth of nested collections

std::string upper(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return result;
}

struct State {
  Words words;
  int depth = 0;     // of collections
  Chain chain = {};  // the chain being read
  std::vector<Chain> chains = {};
};
using Part = void (*)(State&);

void expect(State& state, std::string_view mark) {
  const Word word = state.words.next();
  if (word.text != mark) state.words.fail(word, fmt::format("must be \"{}\"", mark));
}

/// Takes the word EMPTY, if it is there: it stands for a kind, or a member of one, without points.
bool take_empty(State& state) {
  const bool empty = upper(state.words.peek().text) == "EMPTY";
  if (empty) state.words.next();
  return empty;
}

/// Reads EMPTY, or "(" part, part, ... ")".
void read_list(State& state, Part read_part) {
  if (take_empty(state)) return;
  expect(state, "(");
  while (true) {
    read_part(state);
    const Word word = state.words.next();
    if (word.text == ")") return;
    if (word.text != ",") state.words.fail(word, "must be \",\" or \")\"");
  }
}

double read_coordinate(State& state) {
  const Word word = state.words.next();
  const std::optional<double> value = is_number(word.text) ? to_double(word.text) : std::nullopt;
  if (!value || !avo::kAnyValue.contains(*value))
    state.words.fail(word, fmt::format("must be a number from -{0:g} to {0:g} (m)", avo::kLargest));
  return *value;
}

void read_point(State& state) {
  const double x = read_coordinate(state);
  const double y = read_coordinate(state);
  state.chain.points.push_back({x, y});
  const Word word = state.words.peek();
  if (is_number(word.text)) state.words.fail(word, "coordinates must be x y alone");
}

void read_line(State& state) {
  const std::size_t start = state.words.peek().offset;
  state.chain = {};
  read_list(state, read_point);
  if (state.chain.points.empty()) return;
  if (state.chain.points.size() < 2)
    state.words.source().fail(start, "found a line of one point, must have at least two");
  state.chains.push_back(std::move(state.chain));
}

void read_ring(State& state) {
  const std::size_t start = state.words.peek().offset;
  state.chain = {{}, true};
  read_list(state, read_point);
  std::vector<avo::Vec2>& points = state.chain.points;
  if (points.empty()) return;
  const avo::Vec2 first = points.front(), last = points.back();
  if (!(first == last))
    state.words.source().fail(
        start, fmt::format("found a ring from [{}, {}] to [{}, {}], must end where it begins",
                           first.x, first.y, last.x, last.y));
  points.pop_back();
  if (points.size() < 3)
    state.words.source().fail(
        start, fmt::format("found a ring of {} points, must be at least 3", points.size()));
  state.chains.push_back(std::move(state.chain));
}

void read_geometry(State& state);

void read_polygon(State& state) {
  read_list(state, read_ring);
}
void read_lines(State& state) {
  read_list(state, read_line);
}
void read_polygons(State& state) {
  read_list(state, read_polygon);
}
void read_collection(State& state) {
  if (++state.depth > kDeepest)
    state.words.fail(state.words.peek(),
                     fmt::format("collections must nest at most {} deep", kDeepest));
  read_list(state, read_geometry);
  --state.depth;
}

constexpr std::array<std::pair<std::string_view, Part>, 6> kKinds{{
    {"LINESTRING", read_line},
    {"LINEARRING", read_ring},
    {"POLYGON", read_polygon},
    {"MULTILINESTRING", read_lines},
    {"MULTIPOLYGON", read_polygons},
    {"GEOMETRYCOLLECTION", read_collection},
}};

/// Skips Z, M or ZM in front of EMPTY; it refuses them in front of coordinates.
void pass_dimensions(State& state) {
  const Word word = state.words.peek();
  const std::string text = upper(word.text);
  if (text != "Z" && text != "M" && text != "ZM") return;
  state.words.next();
  if (upper(state.words.peek().text) != "EMPTY")
    state.words.fail(word, "coordinates must be x y alone");
}

void read_geometry(State& state) {
  const Word word = state.words.next();
  const std::string kind = upper(word.text);
  if (kind == "POINT" || kind == "MULTIPOINT") {
    pass_dimensions(state);
    if (take_empty(state)) return;
    state.words.fail(word, "a point has no size; a pillar is {disc: {center: [x, y], radius: r}}");
  }
  std::vector<std::string_view> names;
  for (const auto& [name, read_kind] : kKinds) {
    names.push_back(name);
    if (kind != name) continue;
    pass_dimensions(state);
    read_kind(state);
    return;
  }
  state.words.fail(word, allowed_words(kind, names));
}

}  // namespace

std::vector<Chain> read_wkt(const SourceText& source) {
  State state{Words(source, "(),")};
  do {
    read_geometry(state);
  } while (!state.words.peek().text.empty());
  return std::move(state.chains);
}

}  // namespace avo_io
