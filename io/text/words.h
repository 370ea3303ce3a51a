// SPDX-License-Identifier: Apache-2.0
// Reads and shows words and numbers of scene files, and guesses intended words.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo_io/nearest.h"

namespace avo_io {

/// Returns printable() text of at most 40 characters, in quotes.
std::string in_quotes(std::string_view text);

/// Returns "a, b, c".
std::string joined(const std::vector<std::string_view>& words);

/// Returns whether the text looks like a number of YAML: [-+] digits [. digits] [e [-+] digits].
bool is_number(std::string_view text);

/// Returns the value of a text that looks like a number, whatever the locale. It returns none for
/// values beyond the range of double, also for values too near 0. -0 becomes 0.
std::optional<double> to_double(std::string_view text);

}  // namespace avo_io
