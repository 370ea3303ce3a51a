// SPDX-License-Identifier: Apache-2.0
// Handles a throw: the standard library for WebAssembly cannot unwind. The message goes to the
// host, which throws its own exception. Nothing is released, so the host discards the instance. No
// catch is ever reached, but retelling() gets the message.
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <typeinfo>

#include "core/retell.h"

/// The host receives `length` bytes at `message`; the call never returns.
extern "C" [[noreturn]] __attribute__((import_module("avo"), import_name("fail"))) void
avo_fail_in_host(const char* message, std::size_t length);

namespace {

[[noreturn]] void fail_with(const char* message) {
  avo_fail_in_host(message, std::strlen(message));
}

}  // namespace

extern "C" {

void* __cxa_allocate_exception(std::size_t size) noexcept {
  void* const memory = std::malloc(size);
  if (memory == nullptr) fail_with("out of memory");
  return memory;
}

void __cxa_free_exception(void* memory) noexcept {
  std::free(memory);
}

// Everything that the library throws is a std::exception, which is the first base of its class, so
// the object begins with it.
[[noreturn]] void __cxa_throw(void* thrown, std::type_info*, void (*)(void*)) {
  const auto* const exception = static_cast<const std::exception*>(thrown);
  if (const auto* error = dynamic_cast<const avo::Error*>(exception)) avo::Retelling::tell(*error);
  fail_with(exception->what());
}

[[noreturn]] void __cxa_rethrow() {
  fail_with("an exception");
}

void* __cxa_begin_catch(void*) noexcept {
  std::abort();
}

void __cxa_end_catch() {}

}  // extern "C"
