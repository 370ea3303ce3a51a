// SPDX-License-Identifier: Apache-2.0
// Parts of pages.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace avo_cli {

/// Returns the text such that HTML shows it verbatim.
std::string as_html(std::string_view text);
std::string base64(std::string_view bytes);
/// Returns an SVG figure as an image that needs no other file.
std::string image_of(const std::string& svg, const std::string& words);
/// Returns rows of a name and a value.
std::string table_of(const std::vector<std::pair<std::string, std::string>>& rows);
/// Returns all numbers and words of an object. Members of inner objects have both names, and lists
/// appear as their lengths. Missing values are left out.
std::string table_of(const nlohmann::ordered_json& object);
/// Returns the page with the replacement of each "@name@".
std::string filled(std::string_view page,
                   const std::vector<std::pair<std::string, std::string>>& parts);

}  // namespace avo_cli
