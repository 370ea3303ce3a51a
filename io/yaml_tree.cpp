// SPDX-License-Identifier: Apache-2.0
// Events of yaml-cpp become a tree; whatever a scene does not need is refused before it grows.
#include "yaml_tree.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <sstream>
#include <utility>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "avo_io/errors.h"
#include "avo_io/printable.h"
#include "utf8.h"

namespace avo_io {
namespace {

constexpr std::size_t kDeepest = 64;
constexpr std::size_t kMostValues = 2'000'000;

/// Collects the tree bottom-up; open_ holds the lists and maps that are not closed yet.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(Document& document, std::int32_t source) : document_(document), source_(source) {}

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    YamlNode node = make(YamlNode::Kind::nothing, mark, "", anchor);
    if (!next_is_key() && !open_.empty() && open_.back().kind == YamlNode::Kind::map) {
      node.line = open_.back().children.back().line;  // the mark is that of the next line
      node.column = open_.back().children.back().column;
    }
    add(std::move(node));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse_reference(make(YamlNode::Kind::nothing, mark, "", 0), "an alias");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    YamlNode node = make(YamlNode::Kind::text, mark, tag, anchor);
    node.quoted = tag == "!";
    node.text = value;
    if (!node.quoted && (value == "~" || value == "null")) node.kind = YamlNode::Kind::nothing;
    add(std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(make(YamlNode::Kind::list, mark, tag, anchor));
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(make(YamlNode::Kind::map, mark, tag, anchor));
  }
  void OnMapEnd() override { close(); }

  std::optional<YamlNode> root;

 private:
  YamlNode make(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag,
                YAML::anchor_t anchor) const {
    YamlNode node;
    node.kind = kind;
    node.line = mark.line + 1;
    node.column = mark.column + 1;
    node.source = source_;
    if (anchor != 0) refuse_reference(node, "an anchor");
    if (!tag.empty() && tag != "?" && tag != "!")
      document_.fail(node,
                     fmt::format("found the tag {}, tags are not allowed", printable(tag, 40)));
    return node;
  }
  [[noreturn]] void refuse_reference(const YamlNode& node, std::string_view what) const {
    document_.fail(node,
                   fmt::format("found {}, anchors, aliases and merge keys are not allowed", what));
  }
  bool next_is_key() const {
    return !open_.empty() && open_.back().kind == YamlNode::Kind::map &&
           open_.back().children.size() % 2 == 0;
  }
  void check_key(const YamlNode& node) const {
    if (!next_is_key()) return;
    const bool nested = node.kind == YamlNode::Kind::list || node.kind == YamlNode::Kind::map;
    if (nested)  // also what yaml-cpp makes of "key: [1, 2" at the end of the text
      document_.fail(node, fmt::format("found a {} as a key or one that is not closed, keys must "
                                       "be words such as time_step",
                                       node.kind == YamlNode::Kind::list ? "list" : "map"));
    if (node.kind != YamlNode::Kind::text)
      document_.fail(node, "found an empty key, keys must be words such as time_step");
    if (node.text == "<<" && !node.quoted) refuse_reference(node, "a merge key");
  }
  void count(const YamlNode& node) {
    if (++values_ > kMostValues)
      document_.fail(node, fmt::format("found more than {} values", kMostValues));
  }
  void open(YamlNode node) {
    check_key(node);
    count(node);
    if (open_.size() >= kDeepest)
      document_.fail(node, fmt::format("found more than {} levels of nesting", kDeepest));
    open_.push_back(std::move(node));
  }
  void close() {
    YamlNode node = std::move(open_.back());
    open_.pop_back();
    append(std::move(node));
  }
  void add(YamlNode node) {
    check_key(node);
    count(node);
    append(std::move(node));
  }
  void append(YamlNode node) {
    if (open_.empty())
      root = std::move(node);
    else
      open_.back().children.push_back(std::move(node));
  }

  Document& document_;
  std::int32_t source_;
  std::vector<YamlNode> open_;
  std::size_t values_ = 0;
};

/// Line ends become "\n"; anything that is not text is refused with its place.
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
  // yaml-cpp takes a line end at the end of the text for a missing closing quote.
  result.erase(result.find_last_not_of(" \n") + 1);
  return result;
}

}  // namespace

const YamlNode* YamlNode::find(std::string_view key) const {
  if (kind != Kind::map) return nullptr;
  for (std::size_t i = 0; i < children.size(); i += 2)
    if (children[i].text == key) return &children[i + 1];
  return nullptr;
}

YamlNode* YamlNode::find(std::string_view key) {
  return const_cast<YamlNode*>(std::as_const(*this).find(key));
}

std::string Document::where(const YamlNode& node) const {
  const std::string& name = sources[static_cast<std::size_t>(node.source)];
  if (node.source > 0) return name;
  return fmt::format("{}:{}:{}", name, node.line, node.column);
}

void Document::fail(const YamlNode& node, const std::string& message) const {
  const std::string line = where(node) + ": " + message;
  if (node.source > 0) throw OverrideError(line);
  throw SceneError(line);
}

YamlNode parse_yaml(std::string_view yaml, const std::string& name, Document& document) {
  const auto source = static_cast<std::int32_t>(document.sources.size());
  document.sources.push_back(name);
  std::istringstream stream(checked_text(yaml, document, source));
  YamlNode place;
  place.source = source;
  place.line = place.column = 1;
  TreeBuilder builder(document, source);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder) || !builder.root) return place;  // empty
    YamlNode root = std::move(*builder.root);
    TreeBuilder second(document, source);
    if (parser.HandleNextDocument(second)) {
      if (second.root) place = *second.root;
      document.fail(place, "found a second document, a scene is one document");
    }
    return root;
  } catch (const YAML::Exception& error) {
    place.line = error.mark.line + 1;
    place.column = error.mark.column + 1;
    document.fail(place, "found text that is not YAML: " + error.msg);
  }
}

}  // namespace avo_io
