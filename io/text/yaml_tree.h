// SPDX-License-Identifier: Apache-2.0
// YAML text as a small tree in which every value has its position.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace avo_io {

struct YamlNode {
  enum class Kind : std::uint8_t { nothing, text, list, map };
  Kind kind = Kind::nothing;
  bool quoted = false;
  std::int32_t line = 0;    ///< from 1
  std::int32_t column = 0;  ///< from 1, in characters
  std::int32_t source = 0;  ///< index into Document::sources
  std::string text;
  std::vector<YamlNode> children;  ///< the items of a list; for a map its keys and values in turn

  [[nodiscard]] std::size_t size() const {
    return kind == Kind::map ? children.size() / 2 : children.size();
  }
  /// Returns the value of the first entry with this key, or null.
  [[nodiscard]] const YamlNode* find(std::string_view key) const;
  [[nodiscard]] YamlNode* find(std::string_view key);
};

/// A scene's tree, and the name of each text that contributes values: the file first, then the
/// overrides.
struct Document {
  YamlNode root;
  std::vector<std::string> sources;

  /// Returns "file:line:column" or "--set key=value".
  [[nodiscard]] std::string where(const YamlNode& node) const;
  /// Throws SceneError, or OverrideError if the value comes from an override.
  [[noreturn]] void fail(const YamlNode& node, const std::string& message) const;
};

/// Appends `name` to the sources and parses `yaml`. It refuses anything but one document of valid
/// UTF-8. It also refuses control characters, anchors, aliases, merge keys, tags, and nesting
/// deeper than 64. Keys must be plain words, and there may be at most two million values. It
/// accepts a byte order mark and CRLF, and reads them as intended.
YamlNode parse_yaml(std::string_view yaml, const std::string& name, Document& document);

}  // namespace avo_io
