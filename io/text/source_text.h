// SPDX-License-Identifier: Apache-2.0
// Texts other than YAML, read word by word; every word has its position.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "io/text/yaml_tree.h"

namespace avo_io {

/// The text of a file, or of a value in a scene.
class SourceText {
 public:
  /// Messages begin with "name:line:column: ".
  SourceText(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}
  /// Messages begin with the value's place and path, and then "line:column: " within its text. The
  /// document and the node must outlive this object.
  SourceText(const Document& document, const YamlNode& node, std::string path)
      : name_(std::move(path)), text_(node.text), document_(&document), node_(&node) {}

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Throws SceneError or OverrideError.
  [[noreturn]] void fail(std::size_t offset, const std::string& message) const;

 private:
  std::string name_, text_;
  const Document* document_ = nullptr;
  const YamlNode* node_ = nullptr;
};

/// A part of a text without white space, empty at its end.
struct Word {
  std::string_view text;
  std::size_t offset = 0;
};

/// The words of a text, one after the other.
class Words {
 public:
  /// Each character of `marks` is a word by itself.
  explicit Words(const SourceText& source, std::string_view marks = "")
      : source_(source), marks_(marks) {}

  Word next();
  [[nodiscard]] Word peek() const { return Words(*this).next(); }
  /// Returns the offset behind the last word.
  [[nodiscard]] std::size_t offset() const { return offset_; }
  void skip_to(std::size_t offset) { offset_ = offset; }

  [[nodiscard]] const SourceText& source() const { return source_; }
  /// Fails with "found WORD, ALLOWED", or "found the end" for an empty word.
  [[noreturn]] void fail(const Word& word, const std::string& allowed) const;
  /// Returns the next word as a whole number in [min, max]; `what` names it in messages.
  std::int64_t whole_number(std::string_view what, std::int64_t min, std::int64_t max);

 private:
  const SourceText& source_;
  std::string_view marks_;
  std::size_t offset_ = 0;
};

bool is_space(char c);

}  // namespace avo_io
