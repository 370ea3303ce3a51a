// SPDX-License-Identifier: Apache-2.0
// A value that several Python threads may use: one at a time, the others wait.
#pragma once
#include <mutex>
#include <pybind11/pybind11.h>
#include <utility>

namespace avo_python {

template <typename T>
class Shared {
 public:
  explicit Shared(T value) : value_(std::move(value)) {}

  /// f(value), without Python's lock; f must not touch Python. Nobody who holds the mutex ever
  /// waits for Python's lock, so that these two cannot wait for each other.
  template <typename F>
  auto alone(F f) {
    const pybind11::gil_scoped_release release;
    const std::lock_guard lock(mutex_);
    return f(value_);
  }

  /// The same for what takes less time than giving up Python's lock.
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
