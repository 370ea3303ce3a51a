// SPDX-License-Identifier: Apache-2.0
// Numbers in the rows of text recordings, whatever the locale.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace avo_io {

/// Returns a number of any magnitude, also infinities and NaN; a number too small for a double is
/// 0.
std::optional<double> parsed(std::string_view text);

/// Returns a non-negative integer; it may be written as 3.0.
std::optional<std::int64_t> whole_number(std::string_view text);

}  // namespace avo_io
