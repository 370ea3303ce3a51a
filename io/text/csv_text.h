// SPDX-License-Identifier: Apache-2.0
// Lines of CSV with texts in them, which RFC 4180 quotes where they need it.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace avo_io {

/// Without the end of the line.
std::string csv_line(const std::vector<std::string>& fields);
/// None where its quotes are wrong. Texts with ends of lines are not read.
std::optional<std::vector<std::string>> csv_fields(std::string_view line);

}  // namespace avo_io
