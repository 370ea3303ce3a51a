// SPDX-License-Identifier: Apache-2.0
// What a parser finds in YAML text, one thing after the other, becomes a tree; whatever a scene
// does not need is refused before the tree grows. The rules are here, whichever parser it is.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/text/yaml_tree.h"

namespace avo_io {

/// Where something begins.
struct YamlPlace {
  std::int32_t line = 1;    ///< from 1
  std::int32_t column = 1;  ///< from 1, in characters
};

/// Holds the lists and maps that are not closed yet. All that tells it something may throw what
/// Document::fail() throws.
class YamlBuilder {
 public:
  YamlBuilder(Document& document, std::int32_t source)
      : document_(document), source_(source), first_(make(YamlNode::Kind::nothing, {})) {}

  void begin_document();
  void end_document();
  /// No text at all, or a plain ~ or null. One after a key stands where the key does.
  void add_nothing(YamlPlace place);
  void add_text(YamlPlace place, std::string text, bool quoted);
  void open_list(YamlPlace place) { open(make(YamlNode::Kind::list, place)); }
  void open_map(YamlPlace place) { open(make(YamlNode::Kind::map, place)); }
  void close();

  [[noreturn]] void refuse_alias(YamlPlace place) const;
  /// Of the value at `place`, before it is added.
  [[noreturn]] void refuse_anchor(YamlPlace place) const;
  [[noreturn]] void refuse_tag(YamlPlace place, std::string_view tag) const;
  /// There the parser can make nothing of the text.
  [[noreturn]] void refuse_text(YamlPlace place, std::string_view why) const;

  /// The tree of the one document, once the text has ended; nothing where there is none.
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

/// Tells the builder what is in `yaml`: text without control characters, whose line ends are "\n".
/// There is one for each parser.
void tell_events(const std::string& yaml, YamlBuilder& builder);

}  // namespace avo_io
