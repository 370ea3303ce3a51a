// SPDX-License-Identifier: Apache-2.0
// Parts of pages.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace avo_cli {

/// Text as HTML shows it, whatever is in it.
std::string as_html(std::string_view text);
std::string base64(std::string_view bytes);
/// An SVG figure as an image that needs no other file.
std::string image_of(const std::string& svg, const std::string& words);
/// Rows of a name and a value.
std::string table_of(const std::vector<std::pair<std::string, std::string>>& rows);
/// All numbers and words of an object, those of inner objects with both names; lists by their
/// lengths. What there is not is left out.
std::string table_of(const nlohmann::ordered_json& object);
/// The page with what stands for each "@name@".
std::string filled(std::string_view page,
                   const std::vector<std::pair<std::string, std::string>>& parts);

}  // namespace avo_cli
