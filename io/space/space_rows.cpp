// SPDX-License-Identifier: Apache-2.0
#include "io/space/space_rows.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <system_error>

#include "avo_io/errors.h"

namespace avo_io {
namespace {

constexpr std::size_t kColumns = 8;

}  // namespace

void append_number(double value, std::string& line) {
  std::array<char, 32> buffer{};  // a double has at most 24 characters
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  line.append(buffer.data(), end);
}

SpaceRows::SpaceRows(const std::string& path) : lines_(path) {
  const auto first = lines_.next();
  if (!first || *first != kSpaceColumns)
    fail(fmt::format("found \"{}\", must be \"{}\"", first.value_or(""), kSpaceColumns));
  ahead_ = read();
}

const SpaceMoment* SpaceRows::next() {
  if (!ahead_) return nullptr;
  moment_.time = ahead_->time;
  moment_.rows.clear();
  while (ahead_ && ahead_->time == moment_.time) {
    moment_.rows.push_back(ahead_->state);
    ahead_ = read();
  }
  return &moment_;
}

void SpaceRows::fail(const std::string& what) const {
  throw RecordingError(fmt::format("{}:{}: {}", lines_.name(), lines_.number(), what));
}

double SpaceRows::number_of(std::string_view field) const {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value))
    fail(fmt::format("found \"{}\", must be a finite number", field));
  return value;
}

std::optional<SpaceRows::Row> SpaceRows::read() {
  const auto text = lines_.next();
  if (!text) return std::nullopt;
  std::string_view line = *text;
  std::array<double, kColumns> numbers{};
  std::size_t count = 0;
  for (;;) {
    const std::size_t comma = line.find(',');
    if (count < kColumns) numbers[count] = number_of(line.substr(0, comma));
    ++count;
    if (comma == std::string_view::npos) break;
    line.remove_prefix(comma + 1);
  }
  if (count != kColumns)
    fail(fmt::format("found {} columns, must be {}: {}", count, kColumns, kSpaceColumns));
  constexpr double kMostRobots = 1e9;
  if (numbers[1] != std::floor(numbers[1]) || numbers[1] < 0.0 || numbers[1] > kMostRobots)
    fail(fmt::format("found robot {}, must be a whole number", numbers[1]));
  return Row{numbers[0],
             {static_cast<std::int64_t>(numbers[1]),
              {numbers[2], numbers[3], numbers[4]},
              {numbers[5], numbers[6], numbers[7]}}};
}

}  // namespace avo_io
