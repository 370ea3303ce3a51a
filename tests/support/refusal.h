// SPDX-License-Identifier: Apache-2.0
// What Error says.
#pragma once
#include <string>

#include "avo/error.h"
#include "avo/scenario.h"

namespace avo::test {

/// Empty where there is none.
template <typename Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// Of a scene that cannot be simulated.
inline std::string refusal(const Scenario& scene) {
  return refusal([&] { validate(scene); });
}

}  // namespace avo::test
