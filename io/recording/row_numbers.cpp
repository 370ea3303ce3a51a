// SPDX-License-Identifier: Apache-2.0
// Numbers as from_chars() reads them, and the cases that it does not cover.
#include "io/recording/row_numbers.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <system_error>

#include "core/ranges.h"
#include "io/text/decimal.h"
#include "io/text/words.h"

namespace avo_io {

std::optional<double> parsed(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const std::errc error = read_decimal(text, value);
  if (error == std::errc::result_out_of_range) {
    const std::size_t exponent = text.find_first_of("eE");
    const bool small = exponent != std::string_view::npos && text.substr(exponent + 1)[0] == '-';
    return small ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (error != std::errc()) return std::nullopt;
  return value;
}

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size())
    return number >= 0 ? std::optional(number) : std::nullopt;
  const std::optional<double> value = parsed(text);
  constexpr double kExact = 0x1p53;
  if (!value || !(*value >= 0.0 && *value < kExact) || std::floor(*value) != *value)
    return std::nullopt;
  return static_cast<std::int64_t>(*value);
}

std::optional<double> recorded_number(std::string_view column, std::string_view text,
                                      std::string& why) {
  const std::optional<double> value = parsed(text);
  if (value && avo::kAnyValue.contains(*value)) return value;
  const bool large = value && !std::isnan(*value) && text.find_first_of("0123456789") < text.size();
  why = fmt::format("{}: found {}, must be {}", column, in_quotes(text),
                    large ? fmt::format("from -{0:g} to {0:g}", avo::kLargest) : "a finite number");
  return std::nullopt;
}

std::optional<std::int64_t> recorded_integer(std::string_view column, std::string_view text,
                                             std::int64_t least, std::string& why) {
  const std::optional<std::int64_t> value = whole_number(text);
  if (value && *value >= least) return value;
  why = fmt::format("{}: found {}, must be an integer >= {}", column, in_quotes(text), least);
  return std::nullopt;
}

}  // namespace avo_io
