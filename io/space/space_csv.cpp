// SPDX-License-Identifier: Apache-2.0
// Recordings of space as CSV: read row by row, and written.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "avo_io/errors.h"
#include "io/recording/csv_lines.h"
#include "io/recording/recording_blocks.h"
#include "io/recording/row_numbers.h"
#include "io/space/space_rows.h"
#include "io/text/line_reader.h"

namespace avo_io {
namespace {

using avo::space::CheckedState;

constexpr std::size_t kColumns = 8, kEveryColumns = 9;

/// The rows of a CSV.
class SpaceCsvRows final : public SpaceRowSource {
 public:
  explicit SpaceCsvRows(const std::string& path) : lines_(path) {
    const std::string first(lines_.next().value_or(""));
    columns_ = first == std::string(kSpaceCsvHeader) + std::string(kEveryColumn) ? kEveryColumns
                                                                                 : kColumns;
    if (columns_ == kColumns && first != kSpaceCsvHeader)
      fail(1, fmt::format("found \"{}\", must be \"{}\"", first, kSpaceCsvHeader));
    ahead_ = read();
  }
  const SpaceMoment* next() override;
  [[nodiscard]] std::string place(std::optional<std::int64_t> robot) const override;

 private:
  struct Row {
    double time = 0.0;  // s
    CheckedState state;
    std::int64_t every = 1, line = 0;
  };
  [[nodiscard]] std::string line_now() const {
    return fmt::format("{}:{}", lines_.name(), lines_.number());
  }
  [[noreturn]] void fail(std::int64_t line, const std::string& what) const {
    throw RecordingError(fmt::format("{}:{}: {}", lines_.name(), line, what));
  }
  std::optional<Row> read();
  void read_group();
  void sort_group();

  LineReader lines_;
  std::size_t columns_ = kColumns;
  std::optional<Row> ahead_;  // the first row of the next time
  std::vector<Row> group_;    // the rows of the last time
  std::int64_t last_line_ = 1;
  SpaceMoment moment_;
};

std::string SpaceCsvRows::place(std::optional<std::int64_t> robot) const {
  const auto row = std::find_if(group_.begin(), group_.end(),
                                [&](const Row& own) { return own.state.robot == robot; });
  return fmt::format("{}:{}", lines_.name(), row == group_.end() ? last_line_ : row->line);
}

// Sorts the rows by ascending robot, and refuses a robot that occurs twice.
void SpaceCsvRows::sort_group() {
  const auto lower = [](const Row& a, const Row& b) { return a.state.robot < b.state.robot; };
  if (!std::is_sorted(group_.begin(), group_.end(), lower))
    std::stable_sort(group_.begin(), group_.end(), lower);
  const auto twice =
      std::adjacent_find(group_.begin(), group_.end(),
                         [](const Row& a, const Row& b) { return a.state.robot == b.state.robot; });
  if (twice == group_.end()) return;
  const Row &first = twice[0], &second = twice[1];
  fail(second.line, fmt::format("robot: found {} again at {} s, must be once a time (line {})",
                                second.state.robot, second.time, first.line));
}

void SpaceCsvRows::read_group() {
  group_.clear();
  for (; ahead_ && (group_.empty() || ahead_->time == group_[0].time); ahead_ = read())
    group_.push_back(*ahead_);
  if (group_.empty()) return;
  if (ahead_ && ahead_->time < group_[0].time)
    fail(ahead_->line, fmt::format("time: found {} s, must be >= {} s, the time before",
                                   ahead_->time, group_[0].time));
  last_line_ = group_.back().line;
  sort_group();
}

const SpaceMoment* SpaceCsvRows::next() {
  if (!ahead_) return nullptr;
  read_group();
  moment_.time = group_[0].time;
  moment_.every = group_[0].every;
  moment_.rows.clear();
  for (const Row& row : group_) moment_.rows.push_back(row.state);
  return &moment_;
}

std::optional<SpaceCsvRows::Row> SpaceCsvRows::read() {
  const auto text = lines_.next();
  if (!text) return std::nullopt;
  std::string_view line = *text;
  std::array<std::string_view, kEveryColumns> fields;
  std::size_t count = 0;
  for (;;) {
    const std::size_t comma = line.find(',');
    if (count < columns_) fields[count] = line.substr(0, comma);
    ++count;
    if (comma == std::string_view::npos) break;
    line.remove_prefix(comma + 1);
  }
  if (count != columns_)
    fail(lines_.number(),
         fmt::format("found {} columns, must be {}: {}{}", count, columns_, kSpaceCsvHeader,
                     columns_ == kEveryColumns ? kEveryColumn : ""));
  const auto here = [this] { return line_now(); };
  std::array<double, kSpaceColumns.count> state;
  for (std::size_t c = 0; c < state.size(); ++c)
    state[c] = field_number(kSpaceColumns.names[c], fields[2 + c], here);
  Row row{field_number("time", fields[0], here),
          {field_integer("robot", fields[1], 0, here),
           {state[0], state[1], state[2]},
           {state[3], state[4], state[5]}}};
  if (columns_ == kEveryColumns) row.every = field_integer("every", fields[8], 1, here);
  row.line = lines_.number();
  return row;
}

}  // namespace

std::unique_ptr<SpaceRowSource> space_csv_rows(const std::string& path) {
  return std::make_unique<SpaceCsvRows>(path);
}

void append_number(double value, std::string& line) {
  std::array<char, 32> buffer{};  // a double has at most 24 characters
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  line.append(buffer.data(), end);
}

std::string space_csv_header(std::int64_t every) {
  return std::string(kSpaceCsvHeader) + std::string(every > 1 ? kEveryColumn : "") + "\n";
}

void append_csv_lines(const SpaceMoment& moment, std::string& lines) {
  const std::string time = csv_time(moment.time);
  for (const CheckedState& row : moment.rows) {
    lines += time;
    lines += ',';
    lines += std::to_string(row.robot);
    for (const double x : {row.position.x, row.position.y, row.position.z, row.velocity.x,
                           row.velocity.y, row.velocity.z}) {
      lines += ',';
      append_number(x, lines);
    }
    if (moment.every > 1) lines += fmt::format(",{}", moment.every);
    lines += '\n';
  }
}

}  // namespace avo_io
