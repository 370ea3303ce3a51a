// SPDX-License-Identifier: Apache-2.0
// Foxglove's messages that a recording becomes, and the schema of them all.
#pragma once
#include <string>

namespace avo_io {

/// A FileDescriptorSet of foxglove.SceneUpdate, foxglove.PosesInFrame and all that is in them.
std::string foxglove_schema();

}  // namespace avo_io
