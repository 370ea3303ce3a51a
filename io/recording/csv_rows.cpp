// SPDX-License-Identifier: Apache-2.0
// Reads recordings back, one time after the other: CSV.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <span>
#include <string_view>

#include "avo_io/errors.h"
#include "avo_io/recording.h"
#include "core/ranges.h"
#include "io/recording/row_numbers.h"
#include "io/recording/row_source.h"
#include "io/text/line_reader.h"
#include "io/text/words.h"

namespace avo_io {
namespace {

constexpr std::array<std::string_view, 8> kAllColumns{"time", "robot", "x",       "y",
                                                      "vx",   "vy",    "heading", "speed"};
constexpr std::string_view kEvery = "every";          // of thinned recordings
constexpr std::string_view kEstimated = "estimated";  // of recordings without velocities
constexpr std::size_t kRequired = 6;                  // the last two may both be missing
constexpr std::span<const std::string_view> kColumns(kAllColumns.data(), kRequired);
enum Column : std::size_t {
  time_column,
  robot_column,
  x_column,
  y_column,
  vx_column,
  vy_column,
  heading_column,
  speed_column
};

/// One line; `line` is its number.
struct Row {
  double time = 0.0;
  avo::CheckedState state;
  std::int64_t every = 1;
  bool estimated = false;
  std::int64_t line = 0;
};

/// Returns the text without the blanks around it, and without the quotes within them.
std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
    text = text.substr(1, text.size() - 2);
  return text;
}

void split(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  while (true) {
    const std::size_t comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return;
    line.remove_prefix(comma + 1);
  }
}

/// The rows of a table of text.
struct CsvRows final : RowSource {
  CsvRows(const std::string& path, std::optional<std::int64_t> most) : lines(path), robots(most) {
    read_header();
  }
  bool next(RecordedTime& moment) override;
  [[nodiscard]] std::string place(std::optional<std::int64_t> robot) const override;

  LineReader lines;
  std::optional<std::int64_t> robots;
  std::vector<std::string_view> fields;
  std::size_t columns = 0;             // in the first line
  std::array<std::size_t, 8> at = {};  // columns in which kAllColumns stand
  bool headings = false;               // whether the last two of them are there
  std::optional<std::size_t> every_at, estimated_at;
  std::optional<Row> pending;  // the first row of the next time
  std::vector<Row> group;
  std::int64_t times = 0, last_line = 0;

  [[noreturn]] void refuse(std::int64_t line, const std::string& what) const {
    throw RecordingError(fmt::format("{}:{}: {}", lines.name(), line, what));
  }
  [[nodiscard]] std::string line_now() const {
    return fmt::format("{}:{}", lines.name(), lines.number());
  }
  void read_header();
  std::size_t find_column(std::string_view name) const;
  bool has_column(std::string_view name) const;
  double number(Column column) const;
  std::optional<avo::CheckedHeading> heading() const;
  std::int64_t every() const;
  bool estimated() const;
  std::optional<Row> read_row();
  void read_group();
  void sort_group();
};

// Returns the column of that name in the first line, which has these fields.
std::size_t CsvRows::find_column(std::string_view name) const {
  const auto is_name = [name](std::string_view field) { return field == name; };
  const auto match = std::find_if(fields.begin(), fields.end(), is_name);
  const std::string allowed = fmt::format("the first line must name {}", fmt::join(kColumns, ", "));
  if (match == fields.end()) {
    std::vector<std::string_view> others;
    for (const std::string_view field : fields)
      if (std::find(kColumns.begin(), kColumns.end(), field) == kColumns.end())
        others.push_back(field);
    const auto meant = nearest(name, others);
    refuse(1, fmt::format("found no column \"{}\", {}{}", name, allowed,
                          meant ? fmt::format("; is {} meant?", in_quotes(*meant)) : ""));
  }
  if (std::count_if(fields.begin(), fields.end(), is_name) > 1)
    refuse(1, fmt::format("found column \"{}\" more than once, {}", name, allowed));
  return static_cast<std::size_t>(match - fields.begin());
}

bool CsvRows::has_column(std::string_view name) const {
  return std::find(fields.begin(), fields.end(), name) != fields.end();
}

void CsvRows::read_header() {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::optional<std::string_view> line = lines.next();
  if (!line)
    refuse(1, fmt::format("found nothing, the first line must name {}", fmt::join(kColumns, ", ")));
  if (line->starts_with(kByteOrderMark)) line->remove_prefix(kByteOrderMark.size());
  split(*line, fields);
  columns = fields.size();
  headings = has_column(kAllColumns[heading_column]) && has_column(kAllColumns[speed_column]);
  if (has_column("z") && has_column("vz"))
    refuse(1,
           "found the columns z and vz of space, must be a recording of the plane here: a scene "
           "with space: 3 judges those of space");
  const std::size_t count = headings ? kAllColumns.size() : kRequired;
  for (std::size_t k = 0; k < count; ++k) at[k] = find_column(kAllColumns[k]);
  if (has_column(kEvery)) every_at = find_column(kEvery);
  if (has_column(kEstimated)) estimated_at = find_column(kEstimated);
}

double CsvRows::number(Column column) const {
  return field_number(kAllColumns[column], fields[at[column]], [this] { return line_now(); });
}

// Returns none for a robot without a heading.
std::optional<avo::CheckedHeading> CsvRows::heading() const {
  if (!headings || (fields[at[heading_column]].empty() && fields[at[speed_column]].empty()))
    return std::nullopt;
  return avo::CheckedHeading{number(heading_column), number(speed_column)};
}

// Returns 1 if the recording gives no larger number.
std::int64_t CsvRows::every() const {
  if (!every_at) return 1;
  return field_integer(kEvery, fields[*every_at], 1, [this] { return line_now(); });
}

bool CsvRows::estimated() const {
  if (!estimated_at) return false;
  const std::string_view text = fields[*estimated_at];
  if (text == "0" || text == "1") return text == "1";
  refuse(lines.number(), fmt::format("{}: found {}, must be 0 or 1", kEstimated, in_quotes(text)));
}

// Returns none at the end of the file.
std::optional<Row> CsvRows::read_row() {
  std::optional<std::string_view> line = lines.next();
  while (line && line->empty()) line = lines.next();
  if (!line) return std::nullopt;
  split(*line, fields);
  if (fields.size() != columns)
    refuse(lines.number(), fmt::format("found {} columns, must be {} as in the first line",
                                       fields.size(), columns));
  Row row;
  row.line = lines.number();
  row.time = number(time_column);
  const std::int64_t robot = field_integer(kAllColumns[robot_column], fields[at[robot_column]], 0,
                                           [this] { return line_now(); });
  if (robots && robot >= *robots)
    refuse(row.line, fmt::format("robot: found {}, must be 0 to {}, the robots of the scene", robot,
                                 *robots - 1));
  row.state = {robot,
               {number(x_column), number(y_column)},
               {number(vx_column), number(vy_column)},
               heading()};
  row.every = every();
  row.estimated = estimated();
  return row;
}

// Sorts the rows by ascending robot, and refuses a robot that occurs twice.
void CsvRows::sort_group() {
  const auto lower = [](const Row& a, const Row& b) { return a.state.robot < b.state.robot; };
  if (!std::is_sorted(group.begin(), group.end(), lower))
    std::stable_sort(group.begin(), group.end(), lower);
  const auto twice = std::adjacent_find(group.begin(), group.end(), [](const Row& a, const Row& b) {
    return a.state.robot == b.state.robot;
  });
  if (twice == group.end()) return;
  const Row &first = twice[0], &second = twice[1];
  refuse(second.line, fmt::format("robot: found {} again at {} s, must be once a time (line {})",
                                  second.state.robot, second.time, first.line));
}

void CsvRows::read_group() {
  group.clear();
  std::optional<Row> row = pending ? pending : read_row();
  pending.reset();
  for (; row; row = read_row()) {
    if (!group.empty() && row->time != group[0].time) {
      if (row->time < group[0].time)
        refuse(row->line, fmt::format("time: found {} s, must be >= {} s, the time before",
                                      row->time, group[0].time));
      pending = row;
      break;
    }
    if (static_cast<std::int64_t>(group.size()) >= avo::kMostRobots)
      refuse(row->line, fmt::format("found more than {} robots at {} s, the most there can be",
                                    avo::kMostRobots, row->time));
    group.push_back(*row);
  }
  if (group.empty()) return;
  last_line = group.back().line;
  sort_group();
}

bool CsvRows::next(RecordedTime& moment) {
  read_group();
  moment.rows.clear();
  moment.every = 1;
  moment.estimated = false;
  if (group.empty()) {
    if (times > 1) return false;
    refuse(lines.number(), fmt::format("found rows of {} time{}, must be of two or more",
                                       times == 0 ? "no" : "one", times == 0 ? "" : " only"));
  }
  moment.time = group[0].time;
  for (const Row& row : group) {
    moment.rows.push_back(row.state);
    moment.every = std::max(moment.every, row.every);
    moment.estimated = moment.estimated || row.estimated;
  }
  ++times;
  return true;
}

std::string CsvRows::place(std::optional<std::int64_t> robot) const {
  const auto row = std::find_if(group.begin(), group.end(),
                                [&](const Row& own) { return own.state.robot == robot; });
  return fmt::format("{}:{}", lines.name(), row == group.end() ? last_line : row->line);
}

}  // namespace

std::unique_ptr<RowSource> csv_rows(const std::string& path, std::optional<std::int64_t> robots) {
  return std::make_unique<CsvRows>(path, robots);
}

}  // namespace avo_io
