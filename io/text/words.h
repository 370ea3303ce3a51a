// SPDX-License-Identifier: Apache-2.0
// Words and numbers of scene files: read, shown and guessed.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo_io/nearest.h"

namespace avo_io {

/// printable() with at most 40 characters, in quotes.
std::string in_quotes(std::string_view text);

/// "a, b, c".
std::string joined(const std::vector<std::string_view>& words);

/// Does the text look like a number of YAML: [-+] digits [. digits] [e [-+] digits]?
bool is_number(std::string_view text);

/// The value of a text that looks like a number, whatever the locale; none beyond the range of
/// double, towards zero as well. -0 becomes 0.
std::optional<double> to_double(std::string_view text);

}  // namespace avo_io
