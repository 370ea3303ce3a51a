// SPDX-License-Identifier: Apache-2.0
#include "io/space/space_rows.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <system_error>

#include "avo/planner.h"
#include "avo_io/errors.h"
#include "avo_io/space.h"
#include "io/recording/block_source.h"
#include "io/recording/csv_lines.h"
#include "io/recording/row_source.h"
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
  [[nodiscard]] double number_of(std::string_view field) const;
  [[nodiscard]] std::int64_t whole_number_of(double value, const char* what) const;
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

double SpaceCsvRows::number_of(std::string_view field) const {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value))
    fail(fmt::format("found \"{}\", must be a finite number", field));
  return value;
}

std::int64_t SpaceCsvRows::whole_number_of(double value, const char* what) const {
  constexpr double kMost = 1e9;
  if (value != std::floor(value) || value < 0.0 || value > kMost)
    fail(fmt::format("found {} {}, must be a whole number", what, value));
  return static_cast<std::int64_t>(value);
}

std::optional<SpaceCsvRows::Row> SpaceCsvRows::read() {
  const auto text = lines_.next();
  if (!text) return std::nullopt;
  std::string_view line = *text;
  std::array<double, kEveryColumns> numbers{};
  std::size_t count = 0;
  for (;;) {
    const std::size_t comma = line.find(',');
    if (count < columns_) numbers[count] = number_of(line.substr(0, comma));
    ++count;
    if (comma == std::string_view::npos) break;
    line.remove_prefix(comma + 1);
  }
  if (count != columns_)
    fail(fmt::format("found {} columns, must be {}: {}{}", count, columns_, kSpaceCsvHeader,
                     columns_ == kEveryColumns ? kEveryColumn : ""));
  Row row{numbers[0],
          {whole_number_of(numbers[1], "robot"),
           {numbers[2], numbers[3], numbers[4]},
           {numbers[5], numbers[6], numbers[7]}}};
  if (columns_ == kEveryColumns)
    row.every = std::max<std::int64_t>(whole_number_of(numbers[8], "every"), 1);
  return row;
}

/// The rows of an HDF5 file or a spool.
class SpaceBlockRows final : public SpaceRowSource {
 public:
  explicit SpaceBlockRows(const std::string& path) : path_(path), source_(path) {
    if (!source_.header().space)
      throw RecordingError(path + ": found a recording of the plane, must be one of space here");
    moment_.every = source_.header().every;
  }
  const SpaceMoment* next() override;
  [[nodiscard]] std::string place() const override {
    return fmt::format("{}: time {} s", path_, moment_.time);
  }

 private:
  std::string path_;
  BlockSource source_;
  std::size_t next_ = 0, count_ = 0;  // in the block: the next time, and the number of times
  SpaceMoment moment_;
};

const SpaceMoment* SpaceBlockRows::next() {
  if (next_ == count_) {
    if (!source_.next()) return nullptr;
    next_ = 0;
    count_ = source_.block().times;
  }
  const BlockShape& shape = source_.shape();
  const RecordingBlock& block = source_.block();
  moment_.time = block.time[next_];
  moment_.rows.clear();
  for (std::size_t i = 0; i < shape.robots; ++i) {
    if (block.status[next_ * shape.robots + i] == kAbsent) continue;
    const auto value = [&](std::size_t column) { return block.row(shape, column, next_)[i]; };
    moment_.rows.push_back({static_cast<std::int64_t>(i),
                            {value(0), value(1), value(2)},
                            {value(3), value(4), value(5)}});
  }
  ++next_;
  return &moment_;
}

bool is_hdf5_or_spool(const std::string& path) {
  const RecordingFormat format = format_of(path);
  return format == RecordingFormat::hdf5 || format == RecordingFormat::spool;
}

std::unique_ptr<SpaceRowSource> source_of(const std::string& path) {
  if (is_hdf5_or_spool(path)) return std::make_unique<SpaceBlockRows>(path);
  return std::make_unique<SpaceCsvRows>(path);
}

}  // namespace

void append_number(double value, std::string& line) {
  std::array<char, 32> buffer{};  // a double has at most 24 characters
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  line.append(buffer.data(), end);
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

void append_moment(const SpaceMoment& moment, const BlockShape& shape, RecordingBlock& block) {
  const std::size_t k = block.times++;
  block.time[k] = moment.time;
  std::uint8_t* status = block.status.data() + k * shape.robots;
  std::fill_n(status, shape.robots, kAbsent);
  for (std::size_t c = 0; c < shape.columns(); ++c)
    std::fill_n(block.row(shape, c, k), shape.robots, std::numeric_limits<double>::quiet_NaN());
  for (const CheckedState& row : moment.rows) {
    const auto i = static_cast<std::size_t>(row.robot);
    status[i] = static_cast<std::uint8_t>(avo::PlanStatus::optimal);
    const double values[] = {row.position.x, row.position.y, row.position.z,
                             row.velocity.x, row.velocity.y, row.velocity.z};
    for (std::size_t c = 0; c < shape.columns(); ++c) block.row(shape, c, k)[i] = values[c];
  }
}

SpaceRows::SpaceRows(const std::string& path) : source_(source_of(path)) {}

void SpaceRows::fail(const std::string& what) const {
  throw RecordingError(fmt::format("{}: {}", source_->place(), what));
}

bool is_space_recording(const std::string& path) {
  // the bytes of a pipe cannot be read again
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  if (is_hdf5_or_spool(path)) return BlockSource(path).header().space;
  if (format_of(path) != RecordingFormat::csv) return false;
  LineReader lines(path);
  const auto first = lines.next();
  return first && first->starts_with(kSpaceCsvHeader);
}

}  // namespace avo_io
