// SPDX-License-Identifier: Apache-2.0
// Attributes and arguments by the tables of fields.
#pragma once
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <variant>

#include "avo_io/fields.h"
#include "bind.h"

namespace avo_python {

/// Calls action(field, member) for each field.
template <class Fields, class Action>
void for_each_field(const Fields& fields, const Action& action) {
  for (const auto& field : fields)
    std::visit([&](auto member) { action(field, member); }, field.member);
}

/// Returns the unit of a field, its text, and its default where that is not the struct's.
template <class Field>
std::string described(const Field& field) {
  std::string text(field.unit);
  text.append(text.empty() ? "" : ", ").append(field.doc);
  if (!field.default_text.empty()) text.append("; by default ").append(field.default_text);
  return text;
}

/// Returns an argument of that name as a Value; TypeError for another type.
template <class Value>
Value value_of(std::string_view function, std::string_view key, const py::handle& given) {
  try {
    return given.cast<Value>();
  } catch (const py::cast_error&) {
    throw py::type_error(fmt::format("{}: {}: found {}, must be of another type", function, key,
                                     py::repr(given).cast<std::string>()));
  }
}

/// Adds a read-only attribute for each field, except for a field that is bound elsewhere.
template <class Fields, class T>
void bind_fields(py::class_<T>& bound, const Fields& fields, std::string_view elsewhere) {
  for_each_field(fields, [&](const auto& field, auto member) {
    if (field.key != elsewhere)
      bound.def_readonly(std::string(field.key).c_str(), member, described(field).c_str());
  });
}

}  // namespace avo_python
