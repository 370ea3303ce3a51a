// SPDX-License-Identifier: Apache-2.0
// The compiler's own vectors of 16 bytes under the names of core/scalar.h, for WebAssembly, for
// which Highway has no vectors of double. It replaces core/lanes.h and is as exact: min and max
// return the second operand where the comparison fails.
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/scalar.h"

// this allows every kernel header to be included once more
#include "core/kernel_guards.h"

#undef AVO_BEGIN_KERNELS
#undef AVO_END_KERNELS
#define AVO_BEGIN_KERNELS namespace avo::simd128 {
#define AVO_END_KERNELS }

namespace avo::simd128 {

template <typename T>
struct VectorOf {
  using Type __attribute__((vector_size(16))) = T;
};
template <typename T>
using Vector = typename VectorOf<T>::Type;

/// Lanes are all ones or all zeros.
template <typename T>
struct MaskOf {
  using Lanes = decltype(Vector<T>() < Vector<T>());
  Lanes raw;
  friend AVO_KERNEL MaskOf operator&(MaskOf a, MaskOf b) { return {a.raw & b.raw}; }
  friend AVO_KERNEL MaskOf operator|(MaskOf a, MaskOf b) { return {a.raw | b.raw}; }
  friend AVO_KERNEL MaskOf operator!(MaskOf a) { return {~a.raw}; }
  friend AVO_KERNEL std::uint32_t bits(MaskOf mask) {
#ifdef __wasm_simd128__
    if constexpr (sizeof(T) == 8) return __builtin_wasm_bitmask_i64x2(mask.raw);
    if constexpr (sizeof(T) == 4) return __builtin_wasm_bitmask_i32x4(mask.raw);
#else  // elsewhere only for tests
    std::uint32_t result = 0;
    for (std::size_t k = 0; k < 16 / sizeof(T); ++k) result |= (mask.raw[k] & 1U) << k;
    return result;
#endif
  }
  friend AVO_KERNEL bool any(MaskOf mask) {
    return bits(mask) != 0;
  }
};

template <typename T>
struct Pack {
  using Number = T;
  using Mask = MaskOf<T>;
  static constexpr std::size_t kLanes = 16 / sizeof(T);
  Vector<T> raw;

  Pack() = default;
  AVO_KERNEL Pack(double constant) : raw(Vector<T>() + static_cast<T>(constant)) {}  // NOLINT
  AVO_KERNEL explicit Pack(Vector<T> vector) : raw(vector) {}

  static AVO_KERNEL Pack load(const T* from) {
    Pack pack;
    __builtin_memcpy(&pack.raw, from, sizeof(pack.raw));
    return pack;
  }
  AVO_KERNEL void store(T* to) const { __builtin_memcpy(to, &raw, sizeof(raw)); }
  static AVO_KERNEL Pack numbers_from(std::size_t first) {
    Pack numbers(static_cast<double>(first));
    for (std::size_t k = 0; k < kLanes; ++k) numbers.raw[k] += static_cast<T>(k);
    return numbers;
  }

  friend AVO_KERNEL Pack operator+(Pack a, Pack b) { return Pack(a.raw + b.raw); }
  friend AVO_KERNEL Pack operator-(Pack a, Pack b) { return Pack(a.raw - b.raw); }
  friend AVO_KERNEL Pack operator*(Pack a, Pack b) { return Pack(a.raw * b.raw); }
  friend AVO_KERNEL Pack operator/(Pack a, Pack b) { return Pack(a.raw / b.raw); }
  friend AVO_KERNEL Pack operator-(Pack a) { return Pack(-a.raw); }
  friend AVO_KERNEL Mask operator<(Pack a, Pack b) { return {a.raw < b.raw}; }
  friend AVO_KERNEL Mask operator<=(Pack a, Pack b) { return {a.raw <= b.raw}; }
  friend AVO_KERNEL Mask operator>(Pack a, Pack b) { return {a.raw > b.raw}; }
  friend AVO_KERNEL Mask operator>=(Pack a, Pack b) { return {a.raw >= b.raw}; }
  friend AVO_KERNEL Mask operator!=(Pack a, Pack b) { return {a.raw != b.raw}; }
  friend AVO_KERNEL Pack sqrt(Pack a) { return Pack(__builtin_elementwise_sqrt(a.raw)); }
  friend AVO_KERNEL Pack abs(Pack a) { return Pack(__builtin_elementwise_abs(a.raw)); }
  friend AVO_KERNEL Pack floor(Pack a) { return Pack(__builtin_elementwise_trunc(a.raw)); }
  friend AVO_KERNEL Pack select(Mask mask, Pack yes, Pack no) {
    return Pack(mask.raw ? yes.raw : no.raw);
  }
  friend AVO_KERNEL Pack min(Pack a, Pack b) { return select(a < b, a, b); }
  friend AVO_KERNEL Pack max(Pack a, Pack b) { return select(a > b, a, b); }
};

/// table[a] of an integer a, 0 <= a < 2^32: added to 2^52, it is in the last bits.
AVO_KERNEL Pack<double> lookup(const double* table, Pack<double> a) {
  const auto whole = std::bit_cast<Vector<std::uint32_t>>(a.raw + 0x1p52);
  return Pack<double>(Vector<double>{table[whole[0]], table[whole[2]]});
}

/// The sum of all lanes, for numbers with an exact sum.
template <typename T>
AVO_KERNEL T sum_of(Pack<T> a) {
  T sum = 0;
  for (std::size_t k = 0; k < Pack<T>::kLanes; ++k) sum += a.raw[k];
  return sum;
}

/// Stores the chosen lanes side by side and returns their number; may write all lanes.
AVO_KERNEL std::size_t store_chosen(MaskOf<double> chosen, Pack<double> a, double* to) {
  const std::uint32_t lanes = bits(chosen);
  to[0] = a.raw[0];
  to[lanes & 1U] = a.raw[1];
  return static_cast<std::size_t>(std::popcount(lanes));
}

}  // namespace avo::simd128

#include "core/two_packs.h"
#include "core/vec_kernel.h"
