// SPDX-License-Identifier: Apache-2.0
// Wrong configuration is reported by exception, at the boundary only (constructors, setters,
// loaders). Outcomes of a situation are values: see PlanStatus.
#pragma once
#include <stdexcept>
#include <string>

#include "avo/export.h"

namespace avo {

/// One line that says where the error is, what was found and what is allowed.
class AVO_API Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace avo
