// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string>

#include "io/space/space_parts.h"

namespace avo_io {

/// Appends the robots of a group, the i-th of its scene. Returns the trouble in words if there is
/// no room for all of them, with the key in front; empty: none.
std::string append_group(const SpaceGroup& group, std::size_t i, avo::space::Scenario& scenario);

}  // namespace avo_io
