// SPDX-License-Identifier: Apache-2.0
// Attributes of earlier builds: reading one is an error that says the name of today.
#pragma once
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

#include "bind.h"

namespace avo_python {

/// An attribute's name in earlier builds, and its name today.
using Renamed = std::pair<std::string, std::string>;

/// Python calls __getattr__ for attributes that the class does not have.
template <typename Class>
void refuse_renamed(Class& type, std::vector<Renamed> names) {
  type.def(
      "__getattr__",
      [names = std::move(names)](const py::object& self, const std::string& name) -> py::object {
        const auto own = py::type::of(self).attr("__name__").cast<std::string>();
        for (const auto& [before, now] : names)
          if (name == before)
            throw py::attribute_error(
                fmt::format("{}.{}: found a renamed attribute, must be {}", own, name, now));
        throw py::attribute_error(fmt::format("'{}' object has no attribute '{}'", own, name));
      });
}

}  // namespace avo_python
