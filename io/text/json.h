// SPDX-License-Identifier: Apache-2.0
// JSON objects with keys that keep their order.
#pragma once
#include <cstdint>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace avo_io {

using Json = nlohmann::ordered_json;

template <typename Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

/// Returns robot I, or for a source -1 - K moving obstacle K as "moving_obstacles.K".
inline Json name_of(std::int64_t source) {
  if (source >= 0) return source;
  return fmt::format("moving_obstacles.{}", -1 - source);
}

}  // namespace avo_io
