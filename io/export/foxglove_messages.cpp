// SPDX-License-Identifier: Apache-2.0
// The parts of Foxglove's messages that recordings of the plane and of space share.
#include <cmath>
#include <fmt/format.h>

#include "avo_io/errors.h"
#include "io/export/foxglove.h"

namespace avo_io {
namespace {

constexpr double kLatest = 1e9;       // s: whole nanoseconds of twice this time fit into 64 bits
constexpr double kHeadLength = 0.25;  // of an arrow's length
constexpr double kShaftDiameter = 0.1, kHeadDiameter = 0.2;  // of a robot's radius

}  // namespace

FoxgloveChannels add_foxglove_channels(McapFile& file) {
  const std::string descriptors = foxglove_schema();
  FoxgloveChannels channels;
  channels.scene_update = file.add_schema("foxglove.SceneUpdate", descriptors);
  const std::uint16_t poses = file.add_schema("foxglove.PosesInFrame", descriptors);
  channels.walls = file.add_channel("/walls", channels.scene_update);
  channels.robots = file.add_channel("/robots", channels.scene_update);
  channels.poses = file.add_channel("/poses", poses);
  return channels;
}

std::uint64_t nanoseconds_of(double seconds) {
  if (!(seconds >= 0.0 && seconds <= kLatest))
    throw RecordingError(fmt::format("found time {} s, must be from 0 to {} s", seconds, kLatest));
  return static_cast<std::uint64_t>(std::llround(seconds * 1e9));
}

std::string timestamp_of(std::uint64_t nanoseconds) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  ProtoBytes timestamp;
  timestamp.whole(1, nanoseconds / kSecond);
  timestamp.whole(2, nanoseconds % kSecond);
  return timestamp.bytes();
}

std::string numbers_of(std::initializer_list<double> numbers) {
  ProtoBytes bytes;
  int field = 1;
  for (const double x : numbers) bytes.number(field++, x);
  return bytes.bytes();
}

ProtoBytes entity_of(std::string_view timestamp, std::string_view id) {
  ProtoBytes entity;
  entity.text(1, timestamp);
  entity.text(2, kFrameId);
  entity.text(3, id);
  return entity;
}

std::string arrow_of(std::string_view pose, double speed, double radius) {
  ProtoBytes arrow;
  arrow.text(1, pose);
  arrow.number(2, (1.0 - kHeadLength) * speed);
  arrow.number(3, kShaftDiameter * radius);
  arrow.number(4, kHeadLength * speed);
  arrow.number(5, kHeadDiameter * radius);
  arrow.text(6, numbers_of({0.9, 0.5, 0.1, 1.0}));
  return arrow.bytes();
}

}  // namespace avo_io
