// SPDX-License-Identifier: Apache-2.0
#include "io/scene/trajectory.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <fmt/format.h>
#include <string_view>

#include "core/ranges.h"
#include "io/text/words.h"

namespace avo_io {
namespace {

constexpr std::size_t kPlaceFields = 3;

/// Returns a field without the blanks around it, and the place where it begins.
Word next_field(std::string_view line, std::size_t begin, std::size_t& offset) {
  const std::size_t end = std::min(line.find(',', offset), line.size());
  std::size_t first = offset, last = end;
  while (first < last && is_space(line[first])) ++first;
  while (last > first && is_space(line[last - 1])) --last;
  offset = end + 1;
  return {line.substr(first, last - first), begin + first};
}

double number_in(const SourceText& source, const Word& field, const char* unit) {
  const auto value = is_number(field.text) ? to_double(field.text) : std::nullopt;
  if (!value || !avo::kAnyValue.contains(*value))
    source.fail(field.offset, fmt::format("found {}, must be a number ({}) of at most {:g}",
                                          in_quotes(field.text), unit, avo::kLargest));
  return *value;
}

}  // namespace

std::vector<avo::TimedPlace> read_trajectory(const SourceText& source) {
  const std::string_view text = source.text();
  std::vector<avo::TimedPlace> places;
  bool is_first = true;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
    end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (std::all_of(line.begin(), line.end(), is_space)) continue;
    std::array<Word, kPlaceFields> fields;
    std::size_t count = 0, offset = 0;
    for (; offset <= line.size(); ++count) {
      const Word field = next_field(line, begin, offset);
      if (count < kPlaceFields) fields[count] = field;
    }
    if (count != kPlaceFields)
      source.fail(begin, fmt::format("found {} fields, must be 3: time, x, y", count));
    const bool is_header =
        is_first && fields[0].text == "time" && fields[1].text == "x" && fields[2].text == "y";
    is_first = false;
    if (is_header) continue;
    const avo::TimedPlace place{
        number_in(source, fields[0], "s"),
        {number_in(source, fields[1], "m"), number_in(source, fields[2], "m")}};
    if (!places.empty() && !(place.time > places.back().time))
      source.fail(begin, fmt::format("found the time {:g} s behind {:g} s, must be later",
                                     place.time, places.back().time));
    places.push_back(place);
  }
  if (places.empty()) source.fail(text.size(), "found no place, must have at least one");
  return places;
}

}  // namespace avo_io
