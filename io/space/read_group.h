// SPDX-License-Identifier: Apache-2.0
// Reads groups of robots of space from the tree of a scene file.
#pragma once
#include <string>

#include "io/scene/reader.h"

namespace avo_io {

SpaceGroup read_group_in_space(const Reader& reader, const YamlNode& node, const std::string& path);

}  // namespace avo_io
