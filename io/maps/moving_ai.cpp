// SPDX-License-Identifier: Apache-2.0
// Maps and scenarios of the MovingAI benchmarks, read word by word; maps are read row by row.
#include "io/maps/moving_ai.h"

#include <algorithm>
#include <fmt/format.h>

#include "io/text/words.h"

namespace avo_io {
namespace {

constexpr std::string_view kFree = ".GS", kBlocked = "@OTW";
constexpr std::int64_t kMostCells = 1'000'000'000;  // cells

void expect(Words& words, std::string_view expected) {
  const Word word = words.next();
  if (word.text != expected) words.fail(word, fmt::format("must be \"{}\"", expected));
}

/// Returns a row without its end, LF or CR LF, and moves the offset behind the end.
std::string_view next_row(std::string_view text, std::size_t& offset) {
  const std::size_t end = std::min(text.find('\n', offset), text.size());
  std::string_view row = text.substr(offset, end - offset);
  offset = std::min(end + 1, text.size());
  if (row.ends_with('\r')) row.remove_suffix(1);
  return row;
}

void append_row(const SourceText& source, std::string_view row, std::size_t offset,
                OccupancyGrid& grid) {
  if (static_cast<std::int64_t>(row.size()) != grid.width)
    source.fail(offset, fmt::format("found a row of {} cells, must be {}, the width", row.size(),
                                    grid.width));
  for (std::size_t x = 0; x < row.size(); ++x) {
    const bool free = kFree.find(row[x]) != std::string_view::npos;
    if (!free && kBlocked.find(row[x]) == std::string_view::npos)
      source.fail(offset + x,
                  fmt::format("found {}, must be one of . G S (free), @ O T W (blocked)",
                              in_quotes(row.substr(x, 1))));
    grid.free.push_back(free);
  }
}

}  // namespace

OccupancyGrid read_moving_ai_map(const SourceText& source) {
  Words words(source);
  expect(words, "type");
  words.next();  // the word "octile"
  OccupancyGrid grid;
  expect(words, "height");
  grid.height = words.whole_number("the height", 1, kMostCells);
  expect(words, "width");
  grid.width = words.whole_number("the width", 1, kMostCells);
  expect(words, "map");
  const std::string_view text = source.text();
  std::size_t offset = words.offset();
  next_row(text, offset);
  for (std::int64_t row = 0; row < grid.height; ++row) {
    const std::size_t start = offset;
    if (start == text.size())
      source.fail(start, fmt::format("found {} rows, must be {}, the height", row, grid.height));
    append_row(source, next_row(text, offset), start, grid);
  }
  words.skip_to(offset);
  if (const Word more = words.next(); !more.text.empty())
    words.fail(more, fmt::format("must end after {} rows, the height", grid.height));
  return grid;
}

std::vector<ScenRow> read_scen(const SourceText& source) {
  Words words(source);
  expect(words, "version");
  const Word version = words.next();
  if (version.text != "1" && version.text != "1.0") words.fail(version, "must be 1");
  std::vector<ScenRow> rows;
  while (!words.peek().text.empty()) {
    ScenRow row;
    row.offset = words.peek().offset;
    words.whole_number("the bucket", 0, kMostCells);
    row.map = words.next().text;
    row.width = words.whole_number("the width", 1, kMostCells);
    row.height = words.whole_number("the height", 1, kMostCells);
    row.start_x = words.whole_number("the start's x", 0, row.width - 1);
    row.start_y = words.whole_number("the start's y", 0, row.height - 1);
    row.goal_x = words.whole_number("the goal's x", 0, row.width - 1);
    row.goal_y = words.whole_number("the goal's y", 0, row.height - 1);
    const Word length = words.next();
    if (!is_number(length.text) || !to_double(length.text))
      words.fail(length, "the optimal length must be a number");
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace avo_io
