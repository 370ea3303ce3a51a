// SPDX-License-Identifier: Apache-2.0
// What becomes of a throw: the standard library for WebAssembly has nothing that unwinds. The
// message goes to the host, which leaves by an exception of its own. Nothing is released, so the
// host discards the instance. No catch of the library is ever reached.
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <typeinfo>

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
  fail_with(static_cast<std::exception*>(thrown)->what());
}

[[noreturn]] void __cxa_rethrow() {
  fail_with("an exception");
}

void* __cxa_begin_catch(void*) noexcept {
  std::abort();
}

void __cxa_end_catch() {}

}  // extern "C"
