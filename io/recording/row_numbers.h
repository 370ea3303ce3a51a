// SPDX-License-Identifier: Apache-2.0
// Numbers in the rows of recordings that are text, whatever the locale.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace avo_io {

/// A number in any range, infinities and NaN too; what is too small for a double is zero.
std::optional<double> parsed(std::string_view text);

/// A non-negative integer, also one that is written as 3.0.
std::optional<std::int64_t> whole_number(std::string_view text);

}  // namespace avo_io
