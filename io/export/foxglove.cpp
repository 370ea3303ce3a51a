// SPDX-License-Identifier: Apache-2.0
// Names, numbers and types of fields are those of https://docs.foxglove.dev/docs/sdk/schemas, and
// of google.protobuf.Timestamp and Duration. Readers require all fields, including fields that avo
// leaves unset.
#include "io/export/foxglove.h"

#include <cstdint>
#include <string_view>
#include <vector>

#include "io/export/protobuf.h"

namespace avo_io {
namespace {

// FieldDescriptorProto.Type
enum FieldType : std::uint8_t {
  type_double = 1,
  type_int64 = 3,
  type_int32 = 5,
  type_fixed32 = 7,
  type_bool = 8,
  type_string = 9,
  type_message = 11,
  type_bytes = 12,
  type_enum = 14
};

struct ProtoField {
  std::string_view name;
  int number;
  FieldType type;
  std::string_view of = {};  // message or enumeration
  bool repeated = false;
};

struct ProtoMessage {
  std::string_view name;
  std::vector<ProtoField> fields;
  std::vector<std::string_view> type_values = {};  // of an enumeration named Type in it, from 0 on
};

constexpr std::string_view kTimestamp = ".google.protobuf.Timestamp";
constexpr std::string_view kDuration = ".google.protobuf.Duration";
constexpr std::string_view kColor = ".foxglove.Color";
constexpr std::string_view kPose = ".foxglove.Pose";
constexpr std::string_view kVector3 = ".foxglove.Vector3";
constexpr std::string_view kPoint3 = ".foxglove.Point3";

ProtoField pose_field(int number) {
  return {"pose", number, type_message, kPose};
}
ProtoField color_field(int number) {
  return {"color", number, type_message, kColor};
}
ProtoField colors_field(int number) {
  return {"colors", number, type_message, kColor, true};
}
ProtoField size_field(int number) {
  return {"size", number, type_message, kVector3};
}

std::vector<ProtoMessage> plain_messages() {
  const std::vector<ProtoField> xyz{
      {"x", 1, type_double}, {"y", 2, type_double}, {"z", 3, type_double}};
  std::vector<ProtoField> xyzw = xyz;
  xyzw.push_back({"w", 4, type_double});
  return {{"Vector3", xyz},
          {"Point3", xyz},
          {"Quaternion", xyzw},
          {"Color",
           {{"r", 1, type_double},
            {"g", 2, type_double},
            {"b", 3, type_double},
            {"a", 4, type_double}}},
          {"KeyValuePair", {{"key", 1, type_string}, {"value", 2, type_string}}},
          {"Pose",
           {{"position", 1, type_message, kVector3},
            {"orientation", 2, type_message, ".foxglove.Quaternion"}}},
          {"PosesInFrame",
           {{"timestamp", 1, type_message, kTimestamp},
            {"frame_id", 2, type_string},
            {"poses", 3, type_message, kPose, true}}}};
}

std::vector<ProtoMessage> primitives() {
  return {
      {"ArrowPrimitive",
       {pose_field(1),
        {"shaft_length", 2, type_double},
        {"shaft_diameter", 3, type_double},
        {"head_length", 4, type_double},
        {"head_diameter", 5, type_double},
        color_field(6)}},
      {"CubePrimitive", {pose_field(1), size_field(2), color_field(3)}},
      {"SpherePrimitive", {pose_field(1), size_field(2), color_field(3)}},
      {"CylinderPrimitive",
       {pose_field(1),
        size_field(2),
        {"bottom_scale", 3, type_double},
        {"top_scale", 4, type_double},
        color_field(5)}},
      {"LinePrimitive",
       {{"type", 1, type_enum, ".foxglove.LinePrimitive.Type"},
        pose_field(2),
        {"thickness", 3, type_double},
        {"scale_invariant", 4, type_bool},
        {"points", 5, type_message, kPoint3, true},
        color_field(6),
        colors_field(7),
        {"indices", 8, type_fixed32, {}, true}},
       {"LINE_STRIP", "LINE_LOOP", "LINE_LIST"}},
      {"TriangleListPrimitive",
       {pose_field(1),
        {"points", 2, type_message, kPoint3, true},
        color_field(3),
        colors_field(4),
        {"indices", 5, type_fixed32, {}, true}}},
      {"TextPrimitive",
       {pose_field(1),
        {"billboard", 2, type_bool},
        {"font_size", 3, type_double},
        {"scale_invariant", 4, type_bool},
        color_field(5),
        {"text", 6, type_string}}},
      {"ModelPrimitive",
       {pose_field(1),
        {"scale", 2, type_message, kVector3},
        color_field(3),
        {"override_color", 4, type_bool},
        {"url", 5, type_string},
        {"media_type", 6, type_string},
        {"data", 7, type_bytes}}},
  };
}

std::vector<ProtoMessage> scene_messages() {
  return {
      {"SceneEntity",
       {{"timestamp", 1, type_message, kTimestamp},
        {"frame_id", 2, type_string},
        {"id", 3, type_string},
        {"lifetime", 4, type_message, kDuration},
        {"frame_locked", 5, type_bool},
        {"metadata", 6, type_message, ".foxglove.KeyValuePair", true},
        {"arrows", 7, type_message, ".foxglove.ArrowPrimitive", true},
        {"cubes", 8, type_message, ".foxglove.CubePrimitive", true},
        {"spheres", 9, type_message, ".foxglove.SpherePrimitive", true},
        {"cylinders", 10, type_message, ".foxglove.CylinderPrimitive", true},
        {"lines", 11, type_message, ".foxglove.LinePrimitive", true},
        {"triangles", 12, type_message, ".foxglove.TriangleListPrimitive", true},
        {"texts", 13, type_message, ".foxglove.TextPrimitive", true},
        {"models", 14, type_message, ".foxglove.ModelPrimitive", true}}},
      {"SceneEntityDeletion",
       {{"timestamp", 1, type_message, kTimestamp},
        {"type", 2, type_enum, ".foxglove.SceneEntityDeletion.Type"},
        {"id", 3, type_string}},
       {"MATCHING_ID", "ALL"}},
      {"SceneUpdate",
       {{"deletions", 1, type_message, ".foxglove.SceneEntityDeletion", true},
        {"entities", 2, type_message, ".foxglove.SceneEntity", true}}},
  };
}

/// Returns a FieldDescriptorProto.
std::string descriptor_of(const ProtoField& field) {
  ProtoBytes bytes;
  bytes.text(1, field.name);
  bytes.whole(3, static_cast<unsigned>(field.number));
  bytes.whole(4, field.repeated ? 3 : 1);
  bytes.whole(5, field.type);
  if (!field.of.empty()) bytes.text(6, field.of);
  return bytes.bytes();
}

/// Returns a DescriptorProto.
std::string descriptor_of(const ProtoMessage& message) {
  ProtoBytes bytes;
  bytes.text(1, message.name);
  for (const ProtoField& field : message.fields) bytes.text(2, descriptor_of(field));
  if (message.type_values.empty()) return bytes.bytes();
  ProtoBytes type;
  type.text(1, "Type");
  for (std::size_t k = 0; k < message.type_values.size(); ++k) {
    ProtoBytes value;
    value.text(1, message.type_values[k]);
    value.whole(2, k);
    type.text(2, value.bytes());
  }
  bytes.text(4, type.bytes());
  return bytes.bytes();
}

/// Adds a FileDescriptorProto as a field of the set.
void add_file(ProtoBytes& set, std::string_view name, std::string_view package,
              const std::vector<std::string_view>& dependencies,
              const std::vector<ProtoMessage>& messages) {
  ProtoBytes file;
  file.text(1, name);
  file.text(2, package);
  for (const std::string_view dependency : dependencies) file.text(3, dependency);
  for (const ProtoMessage& message : messages) file.text(4, descriptor_of(message));
  file.text(12, "proto3");
  set.text(1, file.bytes());
}

}  // namespace

std::string foxglove_schema() {
  constexpr std::string_view kTimestampFile = "google/protobuf/timestamp.proto";
  constexpr std::string_view kDurationFile = "google/protobuf/duration.proto";
  const std::vector<ProtoField> instant{{"seconds", 1, type_int64}, {"nanos", 2, type_int32}};
  ProtoBytes set;
  add_file(set, kTimestampFile, "google.protobuf", {}, {{"Timestamp", instant}});
  add_file(set, kDurationFile, "google.protobuf", {}, {{"Duration", instant}});
  std::vector<ProtoMessage> messages = plain_messages();
  for (const auto& more : {primitives(), scene_messages()})
    messages.insert(messages.end(), more.begin(), more.end());
  add_file(set, "foxglove/SceneUpdate.proto", "foxglove", {kTimestampFile, kDurationFile},
           messages);
  return set.bytes();
}

}  // namespace avo_io
