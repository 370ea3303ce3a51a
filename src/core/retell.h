// SPDX-License-Identifier: Apache-2.0
// Extends an error with more context: the place of the refused value.
#pragma once
#ifdef AVO_CANNOT_UNWIND
#include <functional>
#endif
#include <utility>

#include "avo/error.h"

namespace avo::inline core {

#ifndef AVO_CANNOT_UNWIND

/// Does `action`. If it throws an E, `tell` is called with it. `tell` throws an error with more
/// context, or returns: the E then propagates.
template <class E, class Action, class Tell>
auto retelling(Action&& action, Tell&& tell) {
  try {
    return std::forward<Action>(action)();
  } catch (const E& error) {
    tell(error);
    throw;
  }
}

#else

/// Code that throws calls these first, the innermost one first, and calls none while one runs. With
/// them errors have the same text where no catch is ever reached.
class Retelling {
 public:
  explicit Retelling(std::function<void(const Error&)> tell)
      : tell_(std::move(tell)), outer_(innermost) {
    innermost = this;
  }
  ~Retelling() { innermost = outer_; }
  Retelling(const Retelling&) = delete;
  Retelling& operator=(const Retelling&) = delete;

  /// Call it with an error that is about to be thrown.
  static void tell(const Error& error) {
    while (innermost != nullptr) {
      const Retelling& present = *innermost;
      innermost = present.outer_;
      present.tell_(error);
    }
  }

 private:
  static inline Retelling* innermost = nullptr;

  std::function<void(const Error&)> tell_;
  Retelling* outer_;
};

template <class E, class Action, class Tell>
auto retelling(Action&& action, Tell&& tell) {
  const Retelling inside([&tell](const Error& error) {
    if (const auto* meant = dynamic_cast<const E*>(&error)) tell(*meant);
  });
  return std::forward<Action>(action)();
}

#endif

}  // namespace avo::inline core
