// SPDX-License-Identifier: Apache-2.0
// The facts that a recording stores about itself, as named fields: attributes of an HDF5 file,
// bytes of a spool.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "avo_io/recording.h"
#include "io/recording/recording_blocks.h"

namespace avo_io {

struct RecordingField {
  std::string name;
  std::variant<std::uint64_t, std::string> value;
};

std::vector<RecordingField> fields_of(const RecordingHeader& header);
/// Throws avo::Error, which names the missing or wrong field.
RecordingHeader header_from(const std::vector<RecordingField>& fields);
/// Returns the shape of the blocks that have these facts.
BlockShape shape_of(const RecordingHeader& header);

/// Splits texts that are too long for an attribute in the header of an HDF5 file: "scene" becomes
/// "part.0.scene", "part.1.scene" and so on.
std::vector<RecordingField> in_parts(std::vector<RecordingField> fields);
/// Joins the parts again, in whatever order they come.
std::vector<RecordingField> from_parts(std::vector<RecordingField> fields);

/// Converts fields to bytes, and back. Returns none if the bytes are not such fields.
std::string packed(const std::vector<RecordingField>& fields);
std::optional<std::vector<RecordingField>> unpacked(std::string_view bytes);

}  // namespace avo_io
