// SPDX-License-Identifier: Apache-2.0
// Scenes by name, from files and from text. One of two sources implements it: with avo_io or
// without.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "avo/scenario.h"
#include "avo/space/scenario.h"

namespace avo_c {

/// Throw Failure.
avo::Scenario load_scene(const std::string& name_or_path,
                         const std::vector<std::string>& overrides);
avo::Scenario parse_scene(std::string_view yaml, const std::string& file,
                          const std::vector<std::string>& overrides);

/// A scene with `space: 3`, from a file.
avo::space::Scenario load_space_scene(const std::string& path,
                                      const std::vector<std::string>& overrides);

}  // namespace avo_c
