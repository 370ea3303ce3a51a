// SPDX-License-Identifier: Apache-2.0
// The page of the lab, with its input embedded.
#include "lab_page/lab_page.h"

#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reports/html.h"

namespace avo_cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kMark = "<script id=\"avo-input\" type=\"application/json\">";
constexpr std::string_view kNothing = "null";

/// Returns ASCII text that neither ends a script nor begins a comment in it.
std::string script_text(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

bool is_utf8(const std::string& text) {
  try {
    (void)Json(text).dump();
    return true;
  } catch (const Json::type_error&) {
    return false;
  }
}

/// Returns the file as JSON. Images become graymaps, the only images that the page reads; a raw
/// graymap is not text.
Json json_of(const avo_io::SceneFile& scene_file) {
  avo_io::SceneFile file = scene_file;
  if (auto graymap = avo_io::as_graymap(file)) file.text = std::move(*graymap);
  Json json{{"path", file.path}, {"builtin", file.builtin}};
  if (is_utf8(file.text))
    json["text"] = file.text;
  else
    json["base64"] = base64(file.text);
  return json;
}

Json json_of(const avo_io::SceneSource& source) {
  Json files = Json::array();
  for (const avo_io::SceneFile& file : source.files) files.push_back(json_of(file));
  return {{"kind", "scene"},
          {"name", source.name},
          {"yaml", source.yaml},
          {"overrides", source.overrides},
          {"files", files},
          {"start_at_rest", source.start_at_rest},
          {"limit_speed", source.limit_speed}};
}

}  // namespace

std::string scene_input(const avo_io::SceneSource& source, bool embedded) {
  Json json = json_of(source);
  if (embedded) json["embedded"] = true;
  return script_text(json);
}

std::string recording_input(const std::string& name, std::string_view bytes,
                            const avo_io::SceneSource* scene, bool embedded) {
  Json json{{"kind", "recording"}, {"name", name}};
  if (scene != nullptr) json["scene"] = json_of(*scene);
  if (embedded) json["embedded"] = true;
  std::string text = script_text(json);
  text.pop_back();  // JSON would process every single character of the bytes
  return text + ",\"base64\":\"" + base64(bytes) + "\"}";
}

std::string lab_page_with(std::string_view input) {
  const std::string_view page = lab_page();
  const std::size_t mark = page.find(kMark), from = mark + kMark.size();
  if (mark == std::string_view::npos || !page.substr(from).starts_with(kNothing))
    throw std::logic_error("the page of the lab has no place for what it opens");
  std::string text(page.substr(0, from));
  text += input;
  return text += page.substr(from + kNothing.size());
}

bool is_lab_page(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return text.find(kMark) != std::string::npos;
}

}  // namespace avo_cli
