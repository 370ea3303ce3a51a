// SPDX-License-Identifier: Apache-2.0
// Passes the events of yaml-cpp to the builder of a scene's tree.
#include <sstream>
#include <string>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "io/text/yaml_builder.h"

namespace avo_io {
namespace {

YamlPlace place_of(const YAML::Mark& mark) {
  return {mark.line + 1, mark.column + 1};
}

class Events final : public YAML::EventHandler {
 public:
  explicit Events(YamlBuilder& builder) : builder_(builder) {}

  void OnDocumentStart(const YAML::Mark&) override { builder_.begin_document(); }
  void OnDocumentEnd() override { builder_.end_document(); }
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    check(mark, "", anchor);
    builder_.add_nothing(place_of(mark));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    builder_.refuse_alias(place_of(mark));
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check(mark, tag, anchor);
    builder_.add_text(place_of(mark), value, tag == "!");
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    check(mark, tag, anchor);
    builder_.open_list(place_of(mark));
  }
  void OnSequenceEnd() override { builder_.close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    check(mark, tag, anchor);
    builder_.open_map(place_of(mark));
  }
  void OnMapEnd() override { builder_.close(); }

 private:
  // "?" and "!" are yaml-cpp's own tags of plain and quoted text.
  void check(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) const {
    if (anchor != 0) builder_.refuse_anchor(place_of(mark));
    if (!tag.empty() && tag != "?" && tag != "!") builder_.refuse_tag(place_of(mark), tag);
  }

  YamlBuilder& builder_;
};

}  // namespace

void tell_events(const std::string& yaml, YamlBuilder& builder) {
  std::istringstream stream(yaml);
  Events events(builder);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(events)) {
    }
  } catch (const YAML::Exception& error) {
    builder.refuse_text(place_of(error.mark), error.msg);
  }
}

}  // namespace avo_io
