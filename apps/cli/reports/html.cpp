// SPDX-License-Identifier: Apache-2.0
// Parts of pages.
#include "reports/html.h"

#include <cstdint>
#include <fmt/format.h>

#include "avo_io/printable.h"

namespace avo_cli {
namespace {

void add_rows(const nlohmann::ordered_json& object, const std::string& in_front,
              std::vector<std::pair<std::string, std::string>>& rows) {
  for (const auto& [key, value] : object.items()) {
    const std::string name = in_front + key;
    if (value.is_object())
      add_rows(value, name + ".", rows);
    else if (value.is_array())
      rows.emplace_back(name, fmt::format("{} entries", value.size()));
    else if (value.is_number_float())
      rows.emplace_back(name, fmt::format("{:.6g}", value.get<double>()));
    else if (value.is_string())
      rows.emplace_back(name, value.get<std::string>());
    else if (!value.is_null())
      rows.emplace_back(name, value.dump());
  }
}

}  // namespace

std::string as_html(std::string_view text) {
  std::string html;
  std::size_t line_begin = 0;
  while (true) {  // line by line: the page may have many lines, and has no control characters
    const std::size_t end = text.find('\n', line_begin);
    for (const char c : avo_io::printable(text.substr(line_begin, end - line_begin))) {
      switch (c) {
        case '&':
          html += "&amp;";
          break;
        case '<':
          html += "&lt;";
          break;
        case '>':
          html += "&gt;";
          break;
        case '"':
          html += "&quot;";
          break;
        default:
          html += c;
      }
    }
    if (end == std::string_view::npos) return html;
    html += '\n';
    line_begin = end + 1;
  }
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8U | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text += k + j > bytes.size() ? '=' : kDigits[group >> (18 - 6 * j) & 63U];
  }
  return text;
}

std::string image_of(const std::string& svg, const std::string& words) {
  return fmt::format("<img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\">", as_html(words),
                     base64(svg));
}

std::string table_of(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::string html = "<table>\n";
  for (const auto& [name, value] : rows)
    html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", as_html(name), as_html(value));
  return html + "</table>";
}

std::string table_of(const nlohmann::ordered_json& object) {
  std::vector<std::pair<std::string, std::string>> rows;
  add_rows(object, "", rows);
  return table_of(rows);
}

std::string filled(std::string_view page,
                   const std::vector<std::pair<std::string, std::string>>& parts) {
  std::string text;
  while (!page.empty()) {
    const std::size_t mark = page.find('@');
    text += page.substr(0, mark);
    if (mark == std::string_view::npos) break;
    page.remove_prefix(mark);
    const std::string* part = nullptr;
    for (const auto& [name, value] : parts) {
      const std::string token = '@' + name + '@';
      if (!page.starts_with(token)) continue;
      part = &value;
      page.remove_prefix(token.size());
      break;
    }
    if (part != nullptr) {
      text += *part;
    } else {
      text += '@';
      page.remove_prefix(1);
    }
  }
  return text;
}

}  // namespace avo_cli
