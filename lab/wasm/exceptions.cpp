// SPDX-License-Identifier: Apache-2.0
// What becomes of a throw: the standard library for WebAssembly has nothing that unwinds. The
// message goes to the host, which leaves by an exception of its own. Nothing is released, so the
// host discards the instance. No catch is ever reached, but retelling() is told.
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <typeinfo>

#include "core/retell.h"

/// Told of `length` bytes at `message`; never returns.
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

// All that the library throws are std::exceptions, each the first base of its class, so that the
// object begins with one.
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
