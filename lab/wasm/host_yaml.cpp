// SPDX-License-Identifier: Apache-2.0
// Passes the events of the host's YAML parser to the builder of a scene's tree.
#include <cstdint>
#include <string>

#include "host.h"
#include "io/text/yaml_builder.h"

/// Parses `length` bytes at `text`, and puts the events into the room.
extern "C" __attribute__((import_module("avo"), import_name("parse_yaml"))) void
avo_parse_yaml_in_host(const char* text, std::size_t length);

namespace avo_io {
namespace {

/// The numbers are those of scene_tree.ts.
enum class Event : std::uint32_t {
  begin_document,
  end_document,
  nothing,
  plain_text,
  quoted_text,
  list,
  map,
  close,
  alias,
  anchor,
  tag,
  fault,
};

void tell(Event event, YamlPlace place, std::string text, YamlBuilder& builder) {
  switch (event) {
    case Event::begin_document:
      return builder.begin_document();
    case Event::end_document:
      return builder.end_document();
    case Event::nothing:
      return builder.add_nothing(place);
    case Event::plain_text:
    case Event::quoted_text:
      return builder.add_text(place, std::move(text), event == Event::quoted_text);
    case Event::list:
      return builder.open_list(place);
    case Event::map:
      return builder.open_map(place);
    case Event::close:
      return builder.close();
    case Event::alias:
      builder.refuse_alias(place);
    case Event::anchor:
      builder.refuse_anchor(place);
    case Event::tag:
      builder.refuse_tag(place, text);
    case Event::fault:
      builder.refuse_text(place, text);
  }
}

}  // namespace

void tell_events(const std::string& yaml, YamlBuilder& builder) {
  avo_parse_yaml_in_host(yaml.data(), yaml.size());
  avo_lab::Input input(avo_lab::taken_from_room());
  while (!input.has_ended()) {
    const auto event = static_cast<Event>(input.whole());
    const auto line = static_cast<std::int32_t>(input.whole());
    const auto column = static_cast<std::int32_t>(input.whole());
    tell(event, {line, column}, input.text(), builder);
  }
}

}  // namespace avo_io
