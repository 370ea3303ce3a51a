// SPDX-License-Identifier: Apache-2.0
// The facts that a recording stores about itself, as named fields.
#include "io/recording/recording_fields.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <utility>

#include "core/ranges.h"

namespace avo_io {
namespace {

constexpr std::string_view kOverride = "override.", kFile = "file.", kBuiltinFile = "builtin_file.";
constexpr std::string_view kPart = "part.";

std::string part_of(std::string_view name, std::size_t k) {
  return fmt::format("{}{}.{}", kPart, k, name);
}

void append_number(std::uint64_t number, std::string& bytes) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof number);
}

void append_text(std::string_view text, std::string& bytes) {
  append_number(text.size(), bytes);
  bytes.append(text);
}

std::optional<std::uint64_t> take_number(std::string_view& bytes) {
  std::uint64_t number = 0;
  if (bytes.size() < sizeof number) return std::nullopt;
  std::memcpy(&number, bytes.data(), sizeof number);
  bytes.remove_prefix(sizeof number);
  return number;
}

std::optional<std::string> take_text(std::string_view& bytes) {
  const std::optional<std::uint64_t> size = take_number(bytes);
  if (!size || *size > bytes.size()) return std::nullopt;
  std::string text(bytes.substr(0, static_cast<std::size_t>(*size)));
  bytes.remove_prefix(text.size());
  return text;
}

template <typename Value>
const Value& value_of(const std::vector<RecordingField>& fields, std::string_view name) {
  const auto field = std::find_if(fields.begin(), fields.end(),
                                  [name](const RecordingField& own) { return own.name == name; });
  if (field == fields.end()) throw avo::Error(fmt::format("found no attribute \"{}\"", name));
  if (const Value* value = std::get_if<Value>(&field->value)) return *value;
  throw avo::Error(fmt::format("{}: found another type, must be {}", name,
                               std::is_same_v<Value, std::string> ? "a text" : "a whole number"));
}

std::int64_t number_within(const std::vector<RecordingField>& fields, std::string_view name,
                           std::int64_t least, std::int64_t most) {
  const auto value = value_of<std::uint64_t>(fields, name);
  if (value < static_cast<std::uint64_t>(least) || value > static_cast<std::uint64_t>(most))
    throw avo::Error(fmt::format("{}: found {}, must be {} to {}", name, value, least, most));
  return static_cast<std::int64_t>(value);
}

void add_scene(const SceneSource& scene, std::vector<RecordingField>& fields) {
  fields.push_back({"scene_name", scene.name});
  fields.push_back({"scene", scene.yaml});
  for (std::size_t k = 0; k < scene.overrides.size(); ++k)
    fields.push_back({fmt::format("{}{}", kOverride, k), scene.overrides[k]});
  for (const SceneFile& file : scene.files)
    fields.push_back({std::string(file.builtin ? kBuiltinFile : kFile) + file.path, file.text});
  fields.push_back({"start_at_rest", std::uint64_t{scene.start_at_rest}});
  fields.push_back({"limit_speed", std::uint64_t{scene.limit_speed}});
}

SceneSource scene_from(const std::vector<RecordingField>& fields) {
  SceneSource scene;
  scene.recorded = true;
  scene.name = value_of<std::string>(fields, "scene_name");
  scene.yaml = value_of<std::string>(fields, "scene");
  for (const RecordingField& field : fields) {
    const auto* text = std::get_if<std::string>(&field.value);
    const std::string_view name = field.name;
    if (text == nullptr) continue;
    if (name.starts_with(kFile)) scene.files.push_back({field.name.substr(kFile.size()), *text});
    if (name.starts_with(kBuiltinFile))
      scene.files.push_back({field.name.substr(kBuiltinFile.size()), *text, true});
  }
  // attributes may come in any order
  const auto is_override = [](const RecordingField& field) {
    return field.name.starts_with(kOverride);
  };
  const auto count = std::count_if(fields.begin(), fields.end(), is_override);
  for (std::int64_t k = 0; k < count; ++k)
    scene.overrides.push_back(value_of<std::string>(fields, fmt::format("{}{}", kOverride, k)));
  scene.start_at_rest = number_within(fields, "start_at_rest", 0, 1) == 1;
  scene.limit_speed = number_within(fields, "limit_speed", 0, 1) == 1;
  return scene;
}

}  // namespace

std::vector<RecordingField> fields_of(const RecordingHeader& header) {
  std::vector<RecordingField> fields{
      {"version", header.version},
      {"build", header.build},
      {"seed", header.seed},
      {"robots", static_cast<std::uint64_t>(header.robots)},
      {"every", static_cast<std::uint64_t>(header.every)},
      {"headings", std::uint64_t{header.headings}},
      {"until_arrived", std::uint64_t{header.until_arrived}},
  };
  if (header.space) fields.push_back({"space", std::uint64_t{3}});
  if (header.state_hash) fields.push_back({"state_hash", *header.state_hash});
  add_scene(header.scene, fields);
  return fields;
}

RecordingHeader header_from(const std::vector<RecordingField>& fields) {
  RecordingHeader header;
  header.version = value_of<std::string>(fields, "version");
  header.build = value_of<std::string>(fields, "build");
  header.seed = value_of<std::uint64_t>(fields, "seed");
  header.robots = number_within(fields, "robots", 1, avo::kMostRobots);
  header.every = number_within(fields, "every", 1, avo::kMostSteps);
  header.headings = number_within(fields, "headings", 0, 1) == 1;
  const auto has = [&fields](std::string_view name) {
    return std::any_of(fields.begin(), fields.end(),
                       [name](const RecordingField& field) { return field.name == name; });
  };
  if (has("until_arrived"))  // older recordings lack it
    header.until_arrived = number_within(fields, "until_arrived", 0, 1) == 1;
  if (has("space")) header.space = number_within(fields, "space", 2, 3) == 3;
  if (has("state_hash")) header.state_hash = value_of<std::uint64_t>(fields, "state_hash");
  header.scene = scene_from(fields);
  return header;
}

BlockShape shape_of(const RecordingHeader& header) {
  return {static_cast<std::size_t>(header.robots), header.space      ? &kSpaceColumns
                                                   : header.headings ? &kHeadingColumns
                                                                     : &kPlainColumns};
}

std::vector<RecordingField> in_parts(std::vector<RecordingField> fields) {
  constexpr std::size_t kLongest = 60'000;  // of an attribute in a header: 64 KiB with its name
  std::vector<RecordingField> parts;
  for (RecordingField& field : fields) {
    const auto* text = std::get_if<std::string>(&field.value);
    if (text == nullptr || text->size() <= kLongest) {
      parts.push_back(std::move(field));
      continue;
    }
    for (std::size_t k = 0; k * kLongest < text->size(); ++k)
      parts.push_back({part_of(field.name, k), text->substr(k * kLongest, kLongest)});
  }
  return parts;
}

std::vector<RecordingField> from_parts(std::vector<RecordingField> fields) {
  std::map<std::string, std::string, std::less<>> parts;
  std::vector<RecordingField> whole;
  for (RecordingField& field : fields) {
    auto* text = std::get_if<std::string>(&field.value);
    if (text != nullptr && field.name.starts_with(kPart))
      parts.emplace(std::move(field.name), std::move(*text));
    else
      whole.push_back(std::move(field));
  }
  const std::string first = part_of("", 0);
  for (const auto& [name, text] : parts) {
    if (!name.starts_with(first)) continue;
    RecordingField field{name.substr(first.size()), text};
    for (std::size_t k = 1;; ++k) {
      const auto part = parts.find(part_of(field.name, k));
      if (part == parts.end()) break;
      std::get<std::string>(field.value) += part->second;
    }
    whole.push_back(std::move(field));
  }
  return whole;
}

std::string packed(const std::vector<RecordingField>& fields) {
  std::string bytes;
  for (const RecordingField& field : fields) {
    append_text(field.name, bytes);
    append_number(field.value.index(), bytes);
    if (const auto* number = std::get_if<std::uint64_t>(&field.value))
      append_number(*number, bytes);
    else
      append_text(std::get<std::string>(field.value), bytes);
  }
  return bytes;
}

std::optional<std::vector<RecordingField>> unpacked(std::string_view bytes) {
  std::vector<RecordingField> fields;
  while (!bytes.empty()) {
    std::optional<std::string> name = take_text(bytes);
    const std::optional<std::uint64_t> kind = take_number(bytes);
    if (!name || !kind || *kind > 1) return std::nullopt;
    RecordingField field{std::move(*name), {}};
    if (*kind == 0) {
      const std::optional<std::uint64_t> number = take_number(bytes);
      if (!number) return std::nullopt;
      field.value = *number;
    } else {
      std::optional<std::string> text = take_text(bytes);
      if (!text) return std::nullopt;
      field.value = std::move(*text);
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

}  // namespace avo_io
