// SPDX-License-Identifier: Apache-2.0
// A value that several Python threads may use: one thread at a time, while the others wait.
#pragma once
#include <mutex>
#include <pybind11/pybind11.h>
#include <utility>

namespace avo_python {

template <typename T>
class Shared {
 public:
  explicit Shared(T value) : value_(std::move(value)) {}

  /// Returns f(value), without Python's lock; f must not touch Python. A thread that holds the
  /// mutex never waits for Python's lock, so there is no deadlock.
  template <typename F>
  auto alone(F f) {
    const pybind11::gil_scoped_release release;
    const std::lock_guard lock(mutex_);
    return f(value_);
  }

  /// Does the same for work that takes less time than releasing Python's lock.
  template <typename F>
  auto briefly(F f) {
    if (const std::unique_lock lock(mutex_, std::try_to_lock); lock.owns_lock())
      return f(std::as_const(value_));
    return alone([&f](const T& value) { return f(value); });
  }

 private:
  std::mutex mutex_;
  T value_;
};

}  // namespace avo_python
