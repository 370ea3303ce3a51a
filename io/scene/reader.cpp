// SPDX-License-Identifier: Apache-2.0
// Reads single values of scene files, and makes the messages about wrong values.
#include "io/scene/reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <system_error>

#include "avo_io/printable.h"

namespace avo_io {

std::string path_to(const std::string& parent, std::string_view key) {
  return parent.empty() ? std::string(key) : fmt::format("{}.{}", parent, key);
}

std::string in_front(const std::string& path) {
  constexpr std::size_t kLongest = 60;  // --set may name keys of any length
  return path.empty() ? "" : printable(path, kLongest) + ": ";
}

std::string shown(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::nothing:
      return "nothing";
    case YamlNode::Kind::list:
      return node.children.empty() ? "an empty list" : "a list";
    case YamlNode::Kind::map:
      return "a map";
    case YamlNode::Kind::text:
      break;
  }
  const bool bare = !node.quoted && is_number(node.text) && node.text.size() <= 40;
  return bare ? node.text : in_quotes(node.text);
}

void Reader::fail(const YamlNode& node, const std::string& path, const std::string& given,
                  const std::string& allowed) const {
  document_.fail(node, fmt::format("{}found {}, {}", in_front(path), given, allowed));
}

void Reader::check_keys(const YamlNode& map, const std::string& path,
                        const std::vector<std::string_view>& allowed) const {
  if (map.kind != YamlNode::Kind::map)
    fail(map, path, shown(map),
         allowed.empty() ? "must be an empty map {}"
                         : fmt::format("must be a map with keys {}", joined(allowed)));
  for (std::size_t i = 0; i < map.children.size(); i += 2) {
    const YamlNode& key = map.children[i];
    if (std::find(allowed.begin(), allowed.end(), key.text) == allowed.end()) {
      fail(key, path, "the unknown key " + in_quotes(key.text),
           allowed.empty() ? "no key is allowed" : allowed_words(key.text, allowed, "allowed are"));
    }
    for (std::size_t j = 0; j < i; j += 2)
      if (map.children[j].text == key.text)
        fail(key, path, "the key " + in_quotes(key.text) + " twice",
             fmt::format("allowed is once, the first is in line {}", map.children[j].line));
  }
}

void Reader::require_list(const YamlNode& node, const std::string& path) const {
  if (node.kind != YamlNode::Kind::list) fail(node, path, shown(node), "must be a list");
}

namespace {

constexpr std::string_view kNotFinite[] = {".nan",  ".NaN",  ".NAN", "nan",  "NaN",
                                           ".inf",  ".Inf",  ".INF", "inf",  "-.inf",
                                           "-.Inf", "-.INF", "-inf", "+.inf"};

std::string with_unit(std::string text, std::string_view unit) {
  return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

}  // namespace

double Reader::number(const YamlNode& node, const std::string& path, const avo::Range& range,
                      std::string_view unit) const {
  const bool text = node.kind == YamlNode::Kind::text;
  if (text && !node.quoted &&
      std::find(std::begin(kNotFinite), std::end(kNotFinite), node.text) != std::end(kNotFinite))
    fail(node, path, node.text, "must be a finite number");
  if (!text || node.quoted || !is_number(node.text))
    fail(node, path, shown(node),
         unit.empty() ? "must be a number" : fmt::format("must be a number ({})", unit));
  const std::optional<double> value = to_double(node.text);
  if (!value) fail(node, path, shown(node), "must be within the range of a double");
  if (range.below(*value))
    fail(node, path, shown(node),
         with_unit(fmt::format("must be {} {:g}",
                               range.is_open_to(*value) ? ">" : ">=", range.least(*value)),
                   unit));
  if (*value > range.max)
    fail(node, path, shown(node), with_unit(fmt::format("must be <= {:g}", range.max), unit));
  return *value;
}

std::uint64_t Reader::whole_number(const YamlNode& node, const std::string& path,
                                   const avo::Range& range) const {
  const std::string_view text = node.text;
  const bool digits =
      node.kind == YamlNode::Kind::text && !node.quoted && !text.empty() &&
      text.find_first_not_of("0123456789", text[0] == '-' ? 1 : 0) == std::string_view::npos &&
      text != "-";
  if (!digits) fail(node, path, shown(node), "must be a whole number");
  std::uint64_t value = 0;
  const auto error = std::from_chars(text.data(), text.data() + text.size(), value).ec;
  if (text[0] == '-' || (error == std::errc() && range.below(static_cast<double>(value))))
    fail(node, path, shown(node), fmt::format("must be >= {:.0f}", range.min));
  const double largest64 = static_cast<double>(std::numeric_limits<std::uint64_t>::max());
  const bool too_large = range.max<largest64&& static_cast<double>(value)> range.max;
  if (error != std::errc() || too_large)
    fail(node, path, shown(node),
         range.max < largest64 ? fmt::format("must be <= {:.0f}", range.max)
                               : "must be < 2^64 = 18446744073709551616");
  return value;
}

void Reader::require_version(const YamlNode& root) const {
  const YamlNode* version = root.find("version");
  if (version == nullptr) fail_missing(root, "", "version", "version: 1");
  if (version->kind != YamlNode::Kind::text || version->quoted || version->text != "1")
    fail(*version, "version", shown(*version), "must be 1");
}

template <std::size_t N>
std::array<double, N> Reader::coordinates(const YamlNode& node, const std::string& path,
                                          const avo::Range& range, std::string_view unit,
                                          std::string_view form) const {
  const bool is_list = node.kind == YamlNode::Kind::list;
  if (!is_list || node.children.size() != N)
    fail(node, path,
         is_list && !node.children.empty() ? fmt::format("a list of {}", node.children.size())
                                           : shown(node),
         fmt::format("must be {} in {}", form, unit));
  constexpr const char* kIndices[] = {"0", "1", "2"};
  std::array<double, N> numbers;
  for (std::size_t k = 0; k < N; ++k)
    numbers[k] = number(node.children[k], path_to(path, kIndices[k]), range, unit);
  return numbers;
}

avo::Vec2 Reader::point(const YamlNode& node, const std::string& path, const avo::Range& range,
                        std::string_view unit) const {
  const auto [x, y] = coordinates<2>(node, path, range, unit, "[x, y]");
  return {x, y};
}

avo::Vec3 Reader::place(const YamlNode& node, const std::string& path, const avo::Range& range,
                        std::string_view unit) const {
  const auto [x, y, z] = coordinates<3>(node, path, range, unit, "[x, y, z]");
  return {x, y, z};
}

std::vector<avo::Vec2> Reader::points(const YamlNode& node, const std::string& path,
                                      const avo::Range& range, std::string_view unit) const {
  require_list(node, path);
  std::vector<avo::Vec2> result;
  result.reserve(node.children.size());
  for (const YamlNode& child : node.children)
    result.push_back(point(child, path_to(path, fmt::format("{}", result.size())), range, unit));
  return result;
}

std::vector<avo::TimedPlace> Reader::places(const YamlNode& node, const std::string& path,
                                            const avo::Range& range) const {
  require_list(node, path);
  std::vector<avo::TimedPlace> result;
  result.reserve(node.children.size());
  for (const YamlNode& child : node.children) {
    const std::string place = path_to(path, fmt::format("{}", result.size()));
    const bool is_list = child.kind == YamlNode::Kind::list;
    if (!is_list || child.children.size() != 3)
      fail(child, place,
           is_list && !child.children.empty() ? fmt::format("a list of {}", child.children.size())
                                              : shown(child),
           "must be [time, x, y] in s and m");
    result.push_back({number(child.children[0], path_to(place, "0"), range, "s"),
                      {number(child.children[1], path_to(place, "1"), range, "m"),
                       number(child.children[2], path_to(place, "2"), range, "m")}});
  }
  return result;
}

avo::LayerSet Reader::layers(const YamlNode& node, const std::string& path,
                             const avo::Range& range) const {
  require_list(node, path);
  avo::LayerSet result;
  std::size_t index = 0;
  for (const YamlNode& child : node.children) {
    const std::string place = path_to(path, fmt::format("{}", index++));
    const std::uint32_t bit = std::uint32_t{1} << whole_number(child, place, range);
    if ((result.bits & bit) != 0) fail(child, place, shown(child) + " twice", "must be there once");
    result.bits |= bit;
  }
  return result;
}

bool Reader::truth(const YamlNode& node, const std::string& path) const {
  const bool bare = node.kind == YamlNode::Kind::text && !node.quoted;
  if (!bare || (node.text != "true" && node.text != "false"))
    fail(node, path, shown(node), "must be true or false");
  return node.text == "true";
}

std::string Reader::name(const YamlNode& node, const std::string& path,
                         const avo::Range& bytes) const {
  if (node.kind != YamlNode::Kind::text || node.text.empty())
    fail(node, path, shown(node), "must be a text");
  const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  if (std::any_of(node.text.begin(), node.text.end(), control))
    fail(node, path, shown(node), "must have no control characters");
  if (static_cast<double>(node.text.size()) > bytes.max)
    fail(node, path, fmt::format("a text of {} bytes", node.text.size()),
         fmt::format("must have at most {}", bytes.max));
  return node.text;
}

void Reader::set(double& value, const YamlNode& node, const Path& path, const Rule& rule) const {
  value = number(node, path, rule.range, rule.unit);
}
void Reader::set(int& value, const YamlNode& node, const Path& path, const Rule& rule) const {
  value = static_cast<int>(whole_number(node, path, rule.range));
}
void Reader::set(std::uint64_t& value, const YamlNode& node, const Path& path,
                 const Rule& rule) const {
  value = whole_number(node, path, rule.range);
}
void Reader::set(std::string& value, const YamlNode& node, const Path& path,
                 const Rule& rule) const {
  value = name(node, path, rule.range);
}
void Reader::set(avo::Vec2& value, const YamlNode& node, const Path& path, const Rule& rule) const {
  value = point(node, path, rule.range, rule.unit);
}
void Reader::set(avo::Vec3& value, const YamlNode& node, const Path& path, const Rule& rule) const {
  value = place(node, path, rule.range, rule.unit);
}
void Reader::set(avo::LayerSet& value, const YamlNode& node, const Path& path,
                 const Rule& rule) const {
  value = layers(node, path, rule.range);
}
void Reader::set(bool& value, const YamlNode& node, const Path& path, const Rule&) const {
  value = truth(node, path);
}
void Reader::set(std::vector<avo::Vec2>& value, const YamlNode& node, const Path& path,
                 const Rule& rule) const {
  value = points(node, path, rule.range, rule.unit);
}
void Reader::set(std::vector<avo::TimedPlace>& value, const YamlNode& node, const Path& path,
                 const Rule& rule) const {
  value = places(node, path, rule.range);
}

void Reader::fail_choice(const YamlNode& node, const std::string& path,
                         const std::vector<std::string_view>& words) const {
  fail(node, path, shown(node),
       allowed_words(node.kind == YamlNode::Kind::text ? node.text : "", words));
}

void Reader::fail_missing(const YamlNode& map, const std::string& path, std::string_view key,
                          std::string_view doc) const {
  fail(map, path, fmt::format("no \"{}\"", key), fmt::format("must be given: {}", doc));
}

}  // namespace avo_io
