// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "avo/space/scenario.h"
#include "io/scene/scene_files.h"

namespace avo_io {

/// Makes a scenario of text with `space: 3`; none if it is a scene of the plane. Throws SceneError,
/// before it places more than `most_robots` robots.
std::optional<avo::space::Scenario> scenario_if_in_space(const std::string& yaml,
                                                         const std::string& file,
                                                         const std::vector<std::string>& overrides,
                                                         SceneFiles& files,
                                                         std::int64_t most_robots);

}  // namespace avo_io
