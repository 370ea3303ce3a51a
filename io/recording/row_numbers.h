// SPDX-License-Identifier: Apache-2.0
// Numbers in the rows of text recordings, whatever the locale.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "avo_io/errors.h"

namespace avo_io {

/// Returns a number of any magnitude, also infinities and NaN; a number too small for a double is
/// 0.
std::optional<double> parsed(std::string_view text);

/// Returns a non-negative integer; it may be written as 3.0.
std::optional<std::int64_t> whole_number(std::string_view text);

/// Returns the number in a column, of at most kLargest; none for any other text. `why`: then set to
/// the reason.
std::optional<double> recorded_number(std::string_view column, std::string_view text,
                                      std::string& why);
/// The same of an integer in a column, at least `least`.
std::optional<std::int64_t> recorded_integer(std::string_view column, std::string_view text,
                                             std::int64_t least, std::string& why);

/// Reads the fields of rows of text, in the plane and in space. place(): the line of a wrong field.
template <class Place>
double field_number(std::string_view column, std::string_view text, const Place& place) {
  std::string why;
  if (const std::optional<double> value = recorded_number(column, text, why)) return *value;
  throw RecordingError(place() + ": " + why);
}
template <class Place>
std::int64_t field_integer(std::string_view column, std::string_view text, std::int64_t least,
                           const Place& place) {
  std::string why;
  if (const auto value = recorded_integer(column, text, least, why)) return *value;
  throw RecordingError(place() + ": " + why);
}

}  // namespace avo_io
