// SPDX-License-Identifier: Apache-2.0
// The messages of Foxglove that a recording becomes, in the plane and in space, and the schema of
// them all.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "io/export/mcap_file.h"
#include "io/export/protobuf.h"

namespace avo_io {

inline constexpr std::string_view kFrameId = "world";

/// The numbers of the channels that every recording has, and of their schema of scenes.
struct FoxgloveChannels {
  std::uint16_t scene_update = 0, walls = 0, robots = 0, poses = 0;
};
/// Adds the schema and these channels.
FoxgloveChannels add_foxglove_channels(McapFile& file);

/// Returns whole nanoseconds. Throws RecordingError for a time that is negative or too late.
std::uint64_t nanoseconds_of(double seconds);
std::string timestamp_of(std::uint64_t nanoseconds);

/// Returns a vector, a point, a quaternion or a color: numbers in the order of their fields.
std::string numbers_of(std::initializer_list<double> numbers);
/// Returns the beginning of a scene's entity.
ProtoBytes entity_of(std::string_view timestamp, std::string_view id);
/// Returns an arrow from a pose, as long as the distance that a robot of that speed and radius
/// travels in a second.
std::string arrow_of(std::string_view pose, double speed, double radius);

/// Returns a FileDescriptorSet of foxglove.SceneUpdate, foxglove.PosesInFrame and all their parts.
std::string foxglove_schema();

}  // namespace avo_io
