// SPDX-License-Identifier: Apache-2.0
// Builds a tree from what a parser finds in YAML text; it refuses everything that a scene does not
// need before the tree grows. The rules are here, so they do not depend on the parser.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/text/yaml_tree.h"

namespace avo_io {

/// The place where a value begins.
struct YamlPlace {
  std::int32_t line = 1;    ///< from 1
  std::int32_t column = 1;  ///< from 1, in characters
};

/// Holds the lists and maps that are not closed yet. All functions that add something may throw
/// what Document::fail() throws.
class YamlBuilder {
 public:
  YamlBuilder(Document& document, std::int32_t source)
      : document_(document), source_(source), first_(make(YamlNode::Kind::nothing, {})) {}

  void begin_document();
  void end_document();
  /// Adds no text, or a plain ~ or null. If it follows a key, it stands where the key stands.
  void add_nothing(YamlPlace place);
  void add_text(YamlPlace place, std::string text, bool quoted);
  void open_list(YamlPlace place) { open(make(YamlNode::Kind::list, place)); }
  void open_map(YamlPlace place) { open(make(YamlNode::Kind::map, place)); }
  void close();

  [[noreturn]] void refuse_alias(YamlPlace place) const;
  /// Refuses the anchor of the value at `place`, before the value is added.
  [[noreturn]] void refuse_anchor(YamlPlace place) const;
  [[noreturn]] void refuse_tag(YamlPlace place, std::string_view tag) const;
  /// Refuses text at that place that the parser cannot read.
  [[noreturn]] void refuse_text(YamlPlace place, std::string_view why) const;

  /// Returns the tree of the only document, once the text has ended; nothing if there is none.
  [[nodiscard]] YamlNode take() { return std::move(first_); }

 private:
  [[nodiscard]] YamlNode make(YamlNode::Kind kind, YamlPlace place) const;
  [[noreturn]] void refuse_reference(YamlPlace place, std::string_view what) const;
  [[nodiscard]] bool is_in_map() const;
  [[nodiscard]] bool next_is_key() const;
  void check_key(const YamlNode& node) const;
  void count(const YamlNode& node);
  void open(YamlNode node);
  void add(YamlNode node);
  void append(YamlNode node);

  Document& document_;
  std::int32_t source_;
  std::vector<YamlNode> open_;
  YamlNode root_;   // of the present document
  YamlNode first_;  // of the first one
  int documents_ = 0;
  std::size_t values_ = 0;
};

/// Reports the contents of `yaml` to the builder: text without control characters, with line ends
/// "\n". Each parser has its own version of this function.
void tell_events(const std::string& yaml, YamlBuilder& builder);

}  // namespace avo_io
