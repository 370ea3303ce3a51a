// SPDX-License-Identifier: Apache-2.0
// JSON objects whose keys keep their order.
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

/// Robot I, or moving obstacle K, whose source is -1 - K, as "moving_obstacles.K".
inline Json name_of(std::int64_t source) {
  if (source >= 0) return source;
  return fmt::format("moving_obstacles.{}", -1 - source);
}

}  // namespace avo_io
