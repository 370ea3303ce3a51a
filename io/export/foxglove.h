// SPDX-License-Identifier: Apache-2.0
// The messages of Foxglove that a recording becomes, and the schema of them all.
#pragma once
#include <string>

namespace avo_io {

/// Returns a FileDescriptorSet of foxglove.SceneUpdate, foxglove.PosesInFrame and all their parts.
std::string foxglove_schema();

}  // namespace avo_io
