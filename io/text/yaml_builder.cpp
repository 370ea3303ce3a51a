// SPDX-License-Identifier: Apache-2.0
// The rules about the text and the tree of a scene file.
#include "io/text/yaml_builder.h"

#include <fmt/format.h>
#include <utility>

#include "avo_io/printable.h"
#include "io/text/utf8.h"

namespace avo_io {
namespace {

constexpr std::size_t kDeepest = 64;
constexpr std::size_t kMostValues = 2'000'000;

/// Replaces line ends by "\n"; it refuses anything that is not text, and tells its place.
std::string checked_text(std::string_view yaml, const Document& document, std::int32_t source) {
  if (yaml.substr(0, 3) == "\xEF\xBB\xBF") yaml.remove_prefix(3);
  std::string result;
  result.reserve(yaml.size());
  YamlNode place;
  place.source = source;
  place.line = place.column = 1;
  while (!yaml.empty()) {
    const std::size_t length = character_length(yaml);
    const auto byte = static_cast<unsigned char>(yaml[0]);
    if (length == 0)
      document.fail(place, fmt::format("found the byte 0x{:02x}, must be UTF-8 text", byte));
    if ((byte < 0x20 && byte != '\n' && byte != '\r' && byte != '\t') || byte == 0x7F)
      document.fail(place, fmt::format("found the control character 0x{:02x}, must be text", byte));
    if (byte == '\r' || byte == '\n') {
      yaml.remove_prefix(yaml.substr(0, 2) == "\r\n" ? 2 : 1);
      result += '\n';
      ++place.line;
      place.column = 1;
      continue;
    }
    result.append(yaml.substr(0, length));
    yaml.remove_prefix(length);
    ++place.column;
  }
  // yaml-cpp mistakes a line end at the end of the text for a missing closing quote.
  result.erase(result.find_last_not_of(" \n") + 1);
  return result;
}

}  // namespace

void YamlBuilder::begin_document() {
  root_ = make(YamlNode::Kind::nothing, {});
  values_ = 0;
}

void YamlBuilder::end_document() {
  if (documents_++ > 0) document_.fail(root_, "found a second document, a scene is one document");
  first_ = std::move(root_);
}

void YamlBuilder::add_nothing(YamlPlace place) {
  YamlNode node = make(YamlNode::Kind::nothing, place);
  if (is_in_map() && !next_is_key()) {
    node.line = open_.back().children.back().line;  // parsers report the line after it
    node.column = open_.back().children.back().column;
  }
  add(std::move(node));
}

void YamlBuilder::add_text(YamlPlace place, std::string text, bool quoted) {
  YamlNode node = make(YamlNode::Kind::text, place);
  node.quoted = quoted;
  node.text = std::move(text);
  if (!quoted && (node.text == "~" || node.text == "null")) node.kind = YamlNode::Kind::nothing;
  add(std::move(node));
}

void YamlBuilder::close() {
  YamlNode node = std::move(open_.back());
  open_.pop_back();
  append(std::move(node));
}

void YamlBuilder::refuse_alias(YamlPlace place) const {
  refuse_reference(place, "an alias");
}

void YamlBuilder::refuse_anchor(YamlPlace place) const {
  refuse_reference(place, "an anchor");
}

void YamlBuilder::refuse_tag(YamlPlace place, std::string_view tag) const {
  document_.fail(make(YamlNode::Kind::nothing, place),
                 fmt::format("found the tag {}, tags are not allowed", printable(tag, 40)));
}

void YamlBuilder::refuse_text(YamlPlace place, std::string_view why) const {
  document_.fail(make(YamlNode::Kind::nothing, place),
                 fmt::format("found text that is not YAML: {}", why));
}

YamlNode YamlBuilder::make(YamlNode::Kind kind, YamlPlace place) const {
  YamlNode node;
  node.kind = kind;
  node.line = place.line;
  node.column = place.column;
  node.source = source_;
  return node;
}

void YamlBuilder::refuse_reference(YamlPlace place, std::string_view what) const {
  document_.fail(make(YamlNode::Kind::nothing, place),
                 fmt::format("found {}, anchors, aliases and merge keys are not allowed", what));
}

bool YamlBuilder::is_in_map() const {
  return !open_.empty() && open_.back().kind == YamlNode::Kind::map;
}

bool YamlBuilder::next_is_key() const {
  return is_in_map() && open_.back().children.size() % 2 == 0;
}

void YamlBuilder::check_key(const YamlNode& node) const {
  if (!next_is_key()) return;
  const bool nested = node.kind == YamlNode::Kind::list || node.kind == YamlNode::Kind::map;
  if (nested)  // yaml-cpp reports this also for "key: [1, 2" at the end of the text
    document_.fail(node, fmt::format("found a {} as a key or one that is not closed, keys must "
                                     "be words such as time_step",
                                     node.kind == YamlNode::Kind::list ? "list" : "map"));
  if (node.kind != YamlNode::Kind::text)
    document_.fail(node, "found an empty key, keys must be words such as time_step");
  if (node.text == "<<" && !node.quoted) refuse_reference({node.line, node.column}, "a merge key");
}

void YamlBuilder::count(const YamlNode& node) {
  if (++values_ > kMostValues)
    document_.fail(node, fmt::format("found more than {} values", kMostValues));
}

void YamlBuilder::open(YamlNode node) {
  check_key(node);
  count(node);
  if (open_.size() >= kDeepest)
    document_.fail(node, fmt::format("found more than {} levels of nesting", kDeepest));
  open_.push_back(std::move(node));
}

void YamlBuilder::add(YamlNode node) {
  check_key(node);
  count(node);
  append(std::move(node));
}

void YamlBuilder::append(YamlNode node) {
  if (open_.empty())
    root_ = std::move(node);
  else
    open_.back().children.push_back(std::move(node));
}

YamlNode parse_yaml(std::string_view yaml, const std::string& name, Document& document) {
  const auto source = static_cast<std::int32_t>(document.sources.size());
  document.sources.push_back(name);
  YamlBuilder builder(document, source);
  tell_events(checked_text(yaml, document, source), builder);
  return builder.take();
}

}  // namespace avo_io
