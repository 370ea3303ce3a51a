// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

#include "avo/vec3.h"
#include "core/ranges.h"

namespace avo::space {

/// Throws Error that names the first component which is not a number of the usual size.
inline void require_vector(const std::string& key, Vec3 value, std::string_view unit) {
  require(key + ".0", value.x, kAnyValue, unit);
  require(key + ".1", value.y, kAnyValue, unit);
  require(key + ".2", value.z, kAnyValue, unit);
}

}  // namespace avo::space
