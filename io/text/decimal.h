// SPDX-License-Identifier: Apache-2.0
// Numbers as text, whatever the locale.
#pragma once
#include <string_view>
#include <system_error>

namespace avo_io {

/// Reads a whole text as a number, as std::from_chars() does: without a space or "+" in front.
/// Returns result_out_of_range for a number to which no double is near, and invalid_argument for
/// any other text. Infinities and NaN are numbers only where the standard library reads them.
std::errc read_decimal(std::string_view text, double& value);

}  // namespace avo_io
