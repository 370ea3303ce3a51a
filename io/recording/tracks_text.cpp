// SPDX-License-Identifier: Apache-2.0
// Trajectories as text, in two formats: that of the Pedestrian Dynamics Data Archive, as PedPy
// reads it, and that of ETH and UCY (obsmat.txt).
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "avo_io/errors.h"
#include "io/recording/row_numbers.h"
#include "io/recording/tracks.h"
#include "io/text/line_reader.h"
#include "io/text/source_text.h"
#include "io/text/words.h"

namespace avo_io {
namespace {

constexpr std::string_view kByteOrder = "\xEF\xBB\xBF";
// id, frame, x, y, and perhaps z and others
constexpr std::size_t kLeastColumns = 4, kMostColumns = 7;
// frame, id, x, z, y, vx, vz, vy: the plane is that of x and y, also for the velocities
constexpr std::size_t kObsmatColumns = 8;

void split_at_spaces(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  for (std::size_t at = 0; at < line.size();) {
    std::size_t end = at;
    while (end < line.size() && !is_space(line[end])) ++end;
    if (end > at) words.push_back(line.substr(at, end - at));
    at = end + 1;
  }
}

std::string lowercase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

struct TrackText {
  LineReader lines;
  TrackTable table;
  double meters = 1.0;      // the length of a unit of the coordinates
  std::size_t columns = 0;  // 0: before the first row
  std::vector<std::string_view> words = {};

  explicit TrackText(const std::string& path) : lines(path) { table.path = path; }

  [[noreturn]] void refuse(const std::string& what) const {
    throw RecordingError(fmt::format("{}:{}: {}", lines.name(), lines.number(), what));
  }
  void read_comment(std::string_view line);
  void read_row(std::string_view line);
  [[nodiscard]] std::int64_t count(std::size_t column, const char* name) const;
  [[nodiscard]] double number(std::size_t column, const char* name) const;
};

// Reads "# framerate: 16 fps", and the unit as "x/cm" or "in cm".
void TrackText::read_comment(std::string_view line) {
  const std::string text = lowercase(line);
  if (columns > 0) return;
  if (text.find("x/cm") != std::string::npos || text.find("in cm") != std::string::npos)
    meters = 0.01;
  const std::size_t name = std::min(text.find("framerate"), text.find("frame rate"));
  if (name == std::string::npos) return;
  const std::size_t begin = text.find_first_of("0123456789.-", name);
  const std::size_t end =
      std::min(begin == std::string::npos ? begin : text.find_first_not_of("0123456789.e+-", begin),
               text.size());
  const auto rate =
      begin == std::string::npos ? std::nullopt : parsed(text.substr(begin, end - begin));
  if (!rate || !(*rate > 0.0 && *rate <= 1e9))
    refuse(fmt::format("found {}, must be a frame rate, such as \"# framerate: 16\"",
                       in_quotes(line)));
  table.frames_per_second = *rate;
}

std::int64_t TrackText::count(std::size_t column, const char* name) const {
  const auto value = whole_number(words[column]);
  constexpr std::int64_t kMost = std::int64_t{1} << 53U;
  if (!value || *value > kMost)
    refuse(fmt::format("{}: found {}, must be an integer >= 0", name, in_quotes(words[column])));
  return *value;
}

double TrackText::number(std::size_t column, const char* name) const {
  const auto value = parsed(words[column]);
  if (!value || !std::isfinite(*value))
    refuse(fmt::format("{}: found {}, must be a finite number", name, in_quotes(words[column])));
  return *value;
}

void TrackText::read_row(std::string_view line) {
  split_at_spaces(line, words);
  if (words.empty()) return;
  if (columns == 0) {
    columns = words.size();
    if (columns < kLeastColumns || columns > kObsmatColumns)
      refuse(
          fmt::format("found {} columns, must be id, frame, x, y and at most {} more, or frame, "
                      "id, x, z, y, vx, vz, vy",
                      columns, kMostColumns - kLeastColumns));
    if (columns < kObsmatColumns && table.frames_per_second == 0.0)
      refuse("found no frame rate, must be in a line before, such as \"# framerate: 16\"");
  }
  if (words.size() != columns)
    refuse(
        fmt::format("found {} columns, must be {} as in the rows before", words.size(), columns));
  const bool obsmat = columns == kObsmatColumns;
  const std::size_t y = obsmat ? 4 : 3;
  TrackRow row{count(obsmat ? 1 : 0, "id"),
               count(obsmat ? 0 : 1, "frame"),
               {meters * number(2, "x"), meters * number(y, "y")}};
  row.line = lines.number();
  add_track_row(table, row);
}

}  // namespace

bool is_pedestrian_text(std::string_view begin) {
  if (begin.starts_with(kByteOrder)) begin.remove_prefix(kByteOrder.size());
  while (!begin.empty() && is_space(begin.front())) begin.remove_prefix(1);
  if (begin.starts_with('#')) return true;
  const std::string_view line = begin.substr(0, begin.find('\n'));
  std::vector<std::string_view> words;
  split_at_spaces(line, words);
  return words.size() >= kLeastColumns &&
         std::all_of(words.begin(), words.end(),
                     [](std::string_view word) { return parsed(word).has_value(); });
}

TrackTable read_pedestrian_text(const std::string& path) {
  TrackText text(path);
  while (std::optional<std::string_view> line = text.lines.next()) {
    if (text.lines.number() == 1 && line->starts_with(kByteOrder))
      line->remove_prefix(kByteOrder.size());
    const std::size_t begin = std::min(line->find_first_not_of(" \t"), line->size());
    line->remove_prefix(begin);
    if (line->starts_with('#'))
      text.read_comment(*line);
    else
      text.read_row(*line);
  }
  return std::move(text.table);
}

}  // namespace avo_io
