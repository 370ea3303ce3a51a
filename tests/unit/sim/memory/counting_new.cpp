// SPDX-License-Identifier: Apache-2.0
#include "unit/sim/counting_new.h"

#include <cstddef>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace avo::test {

std::atomic<long> allocations{0};
std::atomic<long> bytes{0};
std::atomic<long> left{-1};

}  // namespace avo::test

namespace {

using avo::test::allocations;
using avo::test::bytes;
using avo::test::left;

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  if (left == 0) throw std::bad_alloc();
  if (left > 0) --left;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  void* memory = alignment > alignof(std::max_align_t)
                     ? std::aligned_alloc(alignment, rounded)
                     : std::malloc(size > 0 ? size : 1);  // NOLINT
  if (memory == nullptr) throw std::bad_alloc();
  bytes += static_cast<long>(malloc_usable_size(memory));
  return memory;
}

void release(void* memory) {
  bytes -= static_cast<long>(malloc_usable_size(memory));
  std::free(memory);  // NOLINT
}

}  // namespace

// The other forms of new and delete call these.
void* operator new(std::size_t size) {
  return counted(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  release(memory);
}
