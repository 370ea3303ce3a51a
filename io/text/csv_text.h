// SPDX-License-Identifier: Apache-2.0
// Lines of CSV with texts, quoted by RFC 4180 where necessary.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace avo_io {

/// Returns the line without its end.
std::string csv_line(const std::vector<std::string>& fields);
/// Returns none if the quotes are wrong. Texts that contain line ends are not read.
std::optional<std::vector<std::string>> csv_fields(std::string_view line);

}  // namespace avo_io
