// SPDX-License-Identifier: Apache-2.0
// One number with the interface of many. Kernels written over a pack of lanes run on these one at a
// time. core/lanes.h has the same names for Highway's vectors.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "avo/vec.h"

// Every part of a kernel has AVO_KERNEL: a call would cost more than the work. AVO_RARE_KERNEL is
// for rare code that would slow down the common code if it were inlined.
#if defined(_MSC_VER)
#define AVO_KERNEL __forceinline
#define AVO_RARE_KERNEL static __declspec(noinline)
#else
#define AVO_KERNEL inline __attribute__((always_inline))
#define AVO_RARE_KERNEL static __attribute__((noinline))
#endif

// A kernel header, *_kernel.h, is compiled once per pass: first for the pack above, then once for
// each instruction set, beginning with core/lanes.h. The latter undefines the guards of all kernel
// headers (core/kernel_guards.h, written by CMake). The header opens the namespace of the pass
// itself. So a file with several passes includes the same kernel headers in each of them.
#define AVO_BEGIN_KERNELS namespace avo::scalar {
#define AVO_END_KERNELS }

namespace avo::inline core {
/// As many doubles as any vector has.
inline constexpr std::array<double, 8> kLaneNumbers{0, 1, 2, 3, 4, 5, 6, 7};
}  // namespace avo::inline core

namespace avo::scalar {

struct Mask {
  bool bit;
  friend Mask operator&(Mask a, Mask b) { return {a.bit && b.bit}; }
  friend Mask operator|(Mask a, Mask b) { return {a.bit || b.bit}; }
  friend Mask operator!(Mask a) { return {!a.bit}; }
};
inline bool any(Mask mask) {
  return mask.bit;
}
/// Bit k is the bit of lane k.
inline std::uint32_t bits(Mask mask) {
  return mask.bit ? 1U : 0U;
}

template <typename T>
struct Pack {
  using Number = T;
  static constexpr std::size_t kLanes = 1;
  T value;

  Pack() = default;
  Pack(double constant) : value(static_cast<T>(constant)) {}  // NOLINT: as literals are

  static Pack load(const T* from) { return make(*from); }
  void store(T* to) const { *to = value; }
  /// first, first + 1, ...
  static Pack numbers_from(std::size_t first) { return Pack(static_cast<double>(first)); }

  friend Pack operator+(Pack a, Pack b) { return make(a.value + b.value); }
  friend Pack operator-(Pack a, Pack b) { return make(a.value - b.value); }
  friend Pack operator*(Pack a, Pack b) { return make(a.value * b.value); }
  friend Pack operator/(Pack a, Pack b) { return make(a.value / b.value); }
  friend Pack operator-(Pack a) { return make(-a.value); }
  friend Mask operator<(Pack a, Pack b) { return {a.value < b.value}; }
  friend Mask operator<=(Pack a, Pack b) { return {a.value <= b.value}; }
  friend Mask operator>(Pack a, Pack b) { return {a.value > b.value}; }
  friend Mask operator>=(Pack a, Pack b) { return {a.value >= b.value}; }
  friend Mask operator!=(Pack a, Pack b) { return {a.value != b.value}; }
  friend Pack sqrt(Pack a) { return make(std::sqrt(a.value)); }
  friend Pack abs(Pack a) { return make(std::abs(a.value)); }
  friend Pack select(Mask mask, Pack yes, Pack no) { return mask.bit ? yes : no; }
  /// table[a] of an integer a, 0 <= a < 2^31
  friend Pack lookup(const T* table, Pack a) {
    return make(table[static_cast<std::size_t>(a.value)]);
  }
  friend Pack floor(Pack a) { return make(static_cast<T>(static_cast<std::int32_t>(a.value))); }

  static Pack make(T number) {
    Pack pack;
    pack.value = number;
    return pack;
  }
};

/// One number has no latency to hide, see core/lanes.h.
using TwoPacks = Pack<double>;

template <typename T>
T sum_of(Pack<T> a) {
  return a.value;
}

template <typename T>
std::size_t store_chosen(Mask chosen, Pack<T> a, T* to) {
  a.store(to);
  return chosen.bit ? 1 : 0;
}

// Both functions return the second operand where the comparison fails, as a blend does.
template <typename T>
Pack<T> min(Pack<T> a, Pack<T> b) {
  return select(a < b, a, b);
}
template <typename T>
Pack<T> max(Pack<T> a, Pack<T> b) {
  return select(a > b, a, b);
}

}  // namespace avo::scalar

#include "core/vec_kernel.h"
