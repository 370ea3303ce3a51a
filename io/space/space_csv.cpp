// SPDX-License-Identifier: Apache-2.0
// Recordings of space as CSV: read row by row, and written.
#include <array>
#include <charconv>
#include <cstddef>
#include <fmt/format.h>
#include <optional>

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
      fail(fmt::format("found \"{}\", must be \"{}\"", first, kSpaceCsvHeader));
    ahead_ = read();
  }
  const SpaceMoment* next() override;
  [[nodiscard]] std::string place() const override {
    return fmt::format("{}:{}", lines_.name(), lines_.number());
  }

 private:
  struct Row {
    double time = 0.0;  // s
    CheckedState state;
    std::int64_t every = 1;
  };
  [[noreturn]] void fail(const std::string& what) const {
    throw RecordingError(fmt::format("{}: {}", place(), what));
  }
  std::optional<Row> read();

  LineReader lines_;
  std::size_t columns_ = kColumns;
  std::optional<Row> ahead_;  // the first row of the next time
  SpaceMoment moment_;
};

const SpaceMoment* SpaceCsvRows::next() {
  if (!ahead_) return nullptr;
  moment_.time = ahead_->time;
  moment_.every = ahead_->every;
  moment_.rows.clear();
  while (ahead_ && ahead_->time == moment_.time) {
    moment_.rows.push_back(ahead_->state);
    ahead_ = read();
  }
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
    fail(fmt::format("found {} columns, must be {}: {}{}", count, columns_, kSpaceCsvHeader,
                     columns_ == kEveryColumns ? kEveryColumn : ""));
  const auto here = [this] { return place(); };
  std::array<double, kSpaceColumns.count> state;
  for (std::size_t c = 0; c < state.size(); ++c)
    state[c] = field_number(kSpaceColumns.names[c], fields[2 + c], here);
  Row row{field_number("time", fields[0], here),
          {field_integer("robot", fields[1], 0, here),
           {state[0], state[1], state[2]},
           {state[3], state[4], state[5]}}};
  if (columns_ == kEveryColumns) row.every = field_integer("every", fields[8], 1, here);
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
