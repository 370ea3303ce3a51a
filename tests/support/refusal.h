// SPDX-License-Identifier: Apache-2.0
// The message of an Error.
#pragma once
#include <string>

#include "avo/error.h"
#include "avo/scenario.h"

namespace avo::test {

/// Returns an empty text if there is none.
template <typename Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// Returns the message about a scene that cannot be simulated.
inline std::string refusal(const Scenario& scene) {
  return refusal([&] { validate(scene); });
}

}  // namespace avo::test
