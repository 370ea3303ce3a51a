// SPDX-License-Identifier: Apache-2.0
// A value that several Python threads may use: one thread at a time, while the others wait.
#pragma once
#include <atomic>
#include <mutex>
#include <pybind11/pybind11.h>
#include <thread>
#include <utility>

#include "avo/error.h"

namespace avo_python {

template <typename T>
class Shared {
 public:
  explicit Shared(T value) : value_(std::move(value)) {}

  /// Returns f(value), without Python's lock; f must not touch Python, except to call the function
  /// of an external method. No thread waits for the mutex with Python's lock, so there is no
  /// deadlock. Throws Error for a call by that function.
  template <typename F>
  auto alone(F f) {
    require_other_thread();
    const pybind11::gil_scoped_release release;
    const Owned owned(*this);
    return f(value_);
  }

  /// Does the same for work that takes less time than releasing Python's lock.
  template <typename F>
  auto briefly(F f) {
    require_other_thread();
    if (const std::unique_lock lock(mutex_, std::try_to_lock); lock.owns_lock())
      return f(std::as_const(value_));
    return alone([&f](const T& value) { return f(value); });
  }

 private:
  /// Holds the mutex, for a call that may come back by a function of Python.
  struct Owned {
    explicit Owned(Shared& shared) : lock(shared.mutex_), owner(shared.owner_) {
      owner = std::this_thread::get_id();
    }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;
    ~Owned() { owner = std::thread::id(); }

    std::lock_guard<std::mutex> lock;
    std::atomic<std::thread::id>& owner;
  };
  void require_other_thread() const {
    if (owner_ == std::this_thread::get_id())
      throw avo::Error("simulation: found a call within its step, must be after the step");
  }

  std::mutex mutex_;
  std::atomic<std::thread::id> owner_ = {};
  T value_;
};

}  // namespace avo_python
