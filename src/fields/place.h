// SPDX-License-Identifier: Apache-2.0
// The names of values in messages, which are made only where there is a message.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace avo::inline fields {

/// A value's place in a list of the scene, or in a part of an entry, such as "car.body.".
struct Place {
  std::string_view list;
  std::size_t index;
  std::string_view field;
  std::string_view part = {};

  explicit operator std::string() const {
    return std::string(list) + "." + std::to_string(index) + "." + std::string(part) +
           std::string(field);
  }
};

/// The places of an entry's fields, for require_ranges().
struct PlaceOf {
  std::string_view list;
  std::size_t index;
  std::string_view part = {};

  Place operator()(std::string_view field) const { return {list, index, field, part}; }
};

/// The names of fields behind a prefix such as "sensing.noise.", for require_ranges().
struct Behind {
  std::string_view prefix = {};
  std::string_view field = {};

  Behind operator()(std::string_view key) const { return {prefix, key}; }
  explicit operator std::string() const { return std::string(prefix) + std::string(field); }
};

}  // namespace avo::inline fields
