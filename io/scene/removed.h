// SPDX-License-Identifier: Apache-2.0
// Removed keys and values in the tree of a scene: refused by name, but read in scenes of
// recordings.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "avo_io/scene.h"

namespace avo_io {

class Reader;
struct YamlNode;

/// Refuses a scene with a removed key or value, and says what replaces it.
void refuse_removed(const Reader& reader, const YamlNode& root);

/// Puts what replaces them in place of removed keys and values.
void replace_removed(YamlNode& root);

/// Refuses overrides that set a removed key or value. They must not be part of a recording.
void refuse_removed(const std::vector<std::string>& overrides);

/// Returns the removed setting of a recorded scene, in words, without which a simulation is another
/// one; none where the scene simulates as it did.
std::optional<std::string> lost_setting(const SceneSource& source);

}  // namespace avo_io
