// SPDX-License-Identifier: Apache-2.0
// Lines of CSV with texts, quoted by RFC 4180 where necessary.
#include "io/text/csv_text.h"

#include <algorithm>

namespace avo_io {
namespace {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Takes a quoted field, behind its first quote, from the front of `rest`; returns false if it has
/// no end.
bool take_quoted(std::string_view& rest, std::string& field) {
  while (true) {
    const std::size_t quote = rest.find('"');
    if (quote == std::string_view::npos) return false;
    field += rest.substr(0, quote);
    rest.remove_prefix(quote + 1);
    if (!rest.starts_with('"')) return rest.empty() || rest.front() == ',';
    field += '"';
    rest.remove_prefix(1);
  }
}

}  // namespace

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) line += (i > 0 ? "," : "") + csv_field(fields[i]);
  return line;
}

std::optional<std::vector<std::string>> csv_fields(std::string_view line) {
  std::vector<std::string> fields;
  while (true) {
    std::string& field = fields.emplace_back();
    if (line.starts_with('"')) {
      line.remove_prefix(1);
      if (!take_quoted(line, field)) return std::nullopt;
    } else {
      const std::size_t end = std::min(line.find(','), line.size());
      field = line.substr(0, end);
      if (field.find('"') != std::string::npos) return std::nullopt;
      line.remove_prefix(end);
    }
    if (line.empty()) return fields;
    line.remove_prefix(1);
  }
}

}  // namespace avo_io
