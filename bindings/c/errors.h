// SPDX-License-Identifier: Apache-2.0
// How a call reports failure: a result, and a message of this thread.
#pragma once
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>

#include "avo_c/avo.h"

namespace avo_c {

/// The exception of the functions of this folder.
struct Failure {
  avo_result result;
  std::string message;
};

[[noreturn]] void fail(avo_result result, std::string message);

/// Throws Failure if the pointer of the argument with that name is null.
template <typename T>
T& at(T* pointer, const char* name) {
  if (pointer == nullptr)
    fail(AVO_ERROR_INVALID_ARGUMENT, std::string(name) + ": found null, must point to one");
  return *pointer;
}

/// A larger count was most likely never set.
inline constexpr std::size_t kMostEntries = 10'000'000;

/// The same for an array, which may be null if it is empty.
template <typename T>
void require_array(const T* array, std::size_t count, const char* name) {
  if (array == nullptr && count > 0)
    fail(AVO_ERROR_INVALID_ARGUMENT,
         std::string(name) + ": found null, must point to " + std::to_string(count));
  if (count > kMostEntries)
    fail(AVO_ERROR_INVALID_ARGUMENT, std::string(name) + ": found " + std::to_string(count) +
                                         ", must be at most " + std::to_string(kMostEntries));
}

/// Throws Failure if a buffer of the caller has no room for all.
inline void require_room(std::size_t capacity, std::size_t needed) {
  if (capacity < needed)
    fail(AVO_ERROR_BUFFER_TOO_SMALL,
         "capacity: found " + std::to_string(capacity) + ", must be >= " + std::to_string(needed));
}

/// Writes the bytes into the caller's buffer if there is one, and their number in any case.
inline void write_bytes(const void* bytes, std::size_t size, void* buffer, std::size_t capacity,
                        std::size_t& written) {
  written = size;
  if (buffer == nullptr) return;
  require_room(capacity, size);
  std::memcpy(buffer, bytes, size);
}

/// The result for the exception that is being handled; stores its message.
avo_result handle_exception() noexcept;

/// The result of a call that does `body`: no exception leaves it.
template <typename Body>
avo_result guarded(const Body& body) noexcept {
  try {
    body();
    return AVO_OK;
  } catch (...) {
    return handle_exception();
  }
}

}  // namespace avo_c
